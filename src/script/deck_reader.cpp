#include "script/deck_reader.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/nearest_name.hpp"
#include "io/mesh_file.hpp"
#include "model/in_time.hpp"

namespace ashlar {
namespace {

constexpr const char* reader_key = "ashlar deck reader";

/// Nouns whose names become regions share one family.
std::string family(const std::string& noun) {
  return noun == "box" || noun == "extrude" || noun == "solid" ? "region" : noun;
}

template <class Map>
std::vector<std::string> keys_of(const Map& map) {
  std::vector<std::string> keys;
  for (const auto& entry : map) keys.push_back(entry.first);
  return keys;
}

/// Text of an argument's value in the argument's unit.
std::string argument_text(const Quantity& value, const std::string& unit) {
  for (const auto& u : units())
    if (u.name == unit) return decimal_text(value.value / u.scale) + " " + unit;
  return quantity_text(value);
}

std::string unit_name(const Quantity& unit) {
  for (const auto& u : units())
    if (unit.dimension == u.dimension && unit.value == u.scale && unit.celsius == (u.name == "degC")) return u.name;
  return unit.dimension ? unit_symbol(*unit.dimension, unit.celsius) : "";
}

/// Names in expects: histories, their columns, stages.
void check_expects(const Deck& deck) {
  const auto names = [](const auto& items) {
    std::vector<std::string> all;
    for (const auto& item : items) all.push_back(item.name);
    return all;
  };
  const auto check = [&](const Expect& e, const char* what, const std::string& name,
                         const std::vector<std::string>& valid) {
    if (std::find(valid.begin(), valid.end(), name) == valid.end())
      deck.sandbox->complaints.add(
          e.where, "expect '" + e.name + "': there is no " + what + " '" + name + "'" + suggest_name(name, valid));
  };
  for (const auto& e : deck.expects) {
    if (!e.stage.empty()) check(e, "stage", e.stage, names(deck.model.stages));
    if (e.history.empty()) continue;
    check(e, "history", e.history, names(deck.model.histories));
    for (const auto& h : deck.model.histories)
      if (h.name == e.history) check(e, "component", e.component, columns_of(h));
  }
}

}  // namespace

DeckReader::DeckReader(Deck& deck, const std::map<std::string, std::string>& settings)
    : deck_(deck), settings_(settings) {
  lua_State* L = deck.sandbox->state();
  lua_pushlightuserdata(L, this);
  lua_setfield(L, LUA_REGISTRYINDEX, reader_key);
  lua_getfield(L, LUA_REGISTRYINDEX, "names");
  for (const auto& noun : nouns()) {
    lua_pushlightuserdata(L, const_cast<NounRule*>(&noun));
    lua_pushcclosure(L, guarded<noun_called>, 1);
    lua_setfield(L, -2, noun.name.c_str());
  }
  lua_newtable(L);
  lua_pushcfunction(L, guarded<arguments_declared>);
  lua_setfield(L, -2, "args");
  lua_pushcfunction(L, guarded<table_read>);
  lua_setfield(L, -2, "read_table");
  lua_setfield(L, -2, "deck");
  lua_pop(L, 1);
}

DeckReader& DeckReader::of(lua_State* L) {
  lua_getfield(L, LUA_REGISTRYINDEX, reader_key);
  void* reader = lua_touserdata(L, -1);
  lua_pop(L, 1);
  if (!reader) throw ScriptError("the deck has been read: a function of the results cannot declare anything");
  return *static_cast<DeckReader*>(reader);
}

/// noun "name" {...} or noun {...}
int DeckReader::noun_called(lua_State* L) {
  DeckReader& reader = of(L);
  const auto& noun = *static_cast<const NounRule*>(lua_touserdata(L, lua_upvalueindex(1)));
  const std::string form = noun.name + (noun.naming == Naming::none ? " { ... }" : " \"name\" { ... }");
  if (lua_type(L, 1) == LUA_TTABLE && noun.naming != Naming::required) return reader.declare(noun, "", 1);
  if (lua_type(L, 1) != LUA_TSTRING || noun.naming == Naming::none)
    throw ScriptError(noun.name +
                      (noun.naming == Naming::none    ? " takes no name"
                       : lua_type(L, 1) == LUA_TTABLE ? " needs a name"
                                                      : " needs a name and a table") +
                      ": write " + form);
  const std::string name = text_at(L, 1);
  if (name.empty()) throw ScriptError(noun.name + ": the name is empty");
  const int id = reader.next_open_++;
  reader.open_[id] = {title(noun.name, name), reader.deck_.sandbox->where()};
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_pushvalue(L, 1);
  lua_pushinteger(L, id);
  lua_pushcclosure(L, guarded<table_given>, 3);
  return 1;
}

int DeckReader::table_given(lua_State* L) {
  DeckReader& reader = of(L);
  const auto& noun = *static_cast<const NounRule*>(lua_touserdata(L, lua_upvalueindex(1)));
  const std::string name = text_at(L, lua_upvalueindex(2));
  if (lua_type(L, 1) != LUA_TTABLE)
    throw ScriptError(title(noun.name, name) + " needs a table of keys: " + noun.name + " \"" + name + "\" { ... }");
  reader.open_.erase(static_cast<int>(lua_tointeger(L, lua_upvalueindex(3))));
  return reader.declare(noun, name, 1);
}

int DeckReader::declare(const NounRule& noun, const std::string& name, int index) {
  Sandbox& sandbox = *deck_.sandbox;
  const Where here = sandbox.where();
  if (!name.empty() || noun.name == "model") {
    const auto [first, fresh] = declared_.emplace(std::pair(family(noun.name), noun.name == "model" ? "" : name), here);
    if (!fresh)
      sandbox.complaints.add(here, title(noun.name, name) + " is declared a second time; the first is on line " +
                                       std::to_string(first->second.line));
  }
  int number = -1;
  if (const auto fields = read_fields(sandbox, noun, name, index)) {
    if (noun.name == "import_mesh" || noun.name == "solid")
      files_.push_back({noun.name, name, *fields});
    else
      number = add_to_deck(deck_, solves_, noun, name, *fields);
  }
  if (noun.kind == NounKind::declaration) return 0;
  push_handle(sandbox.state(), {noun.kind, number});
  return 1;
}

/// deck.args { water = { default = 150, unit = m, range = {0, 200}, doc = "..." }, ... } returns { water = 150*m, ... }
int DeckReader::arguments_declared(lua_State* L) {
  DeckReader& reader = of(L);
  if (lua_type(L, 1) != LUA_TTABLE)
    throw ScriptError("deck.args needs a table: deck.args { size = { default = 4, unit = m, doc = \"...\" } }");
  lua_settop(L, 1);
  lua_newtable(L);
  std::vector<std::string> names;
  lua_pushnil(L);
  while (lua_next(L, 1)) {
    lua_pop(L, 1);
    if (lua_type(L, -1) != LUA_TSTRING)
      throw ScriptError("deck.args: every argument needs a name: size = { default = ... }");
    names.push_back(text_at(L, -1));
  }
  std::sort(names.begin(), names.end());
  for (const auto& name : names) {
    lua_getfield(L, 1, name.c_str());
    reader.add_argument(name, 3, 2);
    lua_settop(L, 2);
  }
  lua_getfield(L, LUA_REGISTRYINDEX, "names");
  lua_getfield(L, -1, "strict");
  lua_pushvalue(L, 2);
  lua_pushliteral(L, "argument");
  lua_call(L, 2, 1);
  return 1;
}

void DeckReader::add_argument(const std::string& name, int spec, int values) {
  lua_State* L = deck_.sandbox->state();
  const Where where = deck_.sandbox->where("args", "", name);
  const auto refuse = [&](const std::string& message) {
    throw DeckError(where, "deck.args: argument '" + name + "' " + message);
  };
  const std::vector<std::string> valid = {"default", "unit", "range", "doc"};
  if (lua_type(L, spec) != LUA_TTABLE) refuse("needs a table: { default = 4, unit = m, doc = \"...\" }");
  lua_pushnil(L);
  while (lua_next(L, spec)) {
    lua_pop(L, 1);
    const std::string key = lua_type(L, -1) == LUA_TSTRING ? text_at(L, -1) : "";
    if (std::find(valid.begin(), valid.end(), key) == valid.end())
      refuse("has an unknown key '" + key + "'" + suggest_name(key, valid));
  }
  if (!argument_names_.insert(name).second) refuse("is declared a second time");
  Argument argument;
  argument.name = name;
  lua_getfield(L, spec, "doc");
  if (lua_type(L, -1) != LUA_TSTRING) refuse("needs a doc = \"what it is\"");
  argument.doc = text_at(L, -1);

  lua_getfield(L, spec, "unit");
  Quantity unit{1, {}, false};
  if (!lua_isnil(L, -1)) {
    if (!to_quantity(L, -1)) refuse("has a 'unit' that is no unit; write unit = m");
    unit = *to_quantity(L, -1);
    argument.unit = unit_name(unit);
  }
  // Bare numbers are in the argument's unit.
  const auto in_unit = [&](const Quantity& q) {
    if (!q.dimension) return Quantity{q.value * unit.value, unit.dimension, unit.celsius};
    if (q.dimension != unit.dimension)
      refuse("is " + quantity_text(q) + "; expected " + dimension_advice(unit.dimension.value_or(Dimension{})));
    return q;
  };
  lua_getfield(L, spec, "default");
  const int type = lua_type(L, -1);
  const auto number = to_quantity(L, -1);
  if (!number && type != LUA_TSTRING && type != LUA_TBOOLEAN)
    refuse("needs a default: a number, a text, true or false");
  const auto show = [&](int index) {
    if (auto q = to_quantity(L, index)) return argument_text(*q, argument.unit);
    return lua_isboolean(L, index) ? std::string(lua_toboolean(L, index) ? "true" : "false") : text_at(L, index);
  };
  if (number) push_quantity(L, in_unit(*number));
  argument.fallback = show(-1);
  if (const auto setting = settings_.find(name); setting != settings_.end()) {
    taken_.insert(name);
    argument.set = true;
    push_setting(name, setting->second, number ? LUA_TNUMBER : type);
    if (number) push_quantity(L, in_unit(*to_quantity(L, -1)));
  }
  argument.value = show(-1);
  const int value = lua_gettop(L);
  lua_getfield(L, spec, "range");
  if (!lua_isnil(L, -1)) {
    double ends[2];
    for (int i = 0; i < 2; ++i) {
      if (!number || lua_type(L, value + 1) != LUA_TTABLE) refuse("has a 'range' that is not { lowest, highest }");
      lua_geti(L, value + 1, i + 1);
      if (!to_quantity(L, -1)) refuse("has a 'range' that is not { lowest, highest }");
      ends[i] = in_unit(*to_quantity(L, -1)).value;
    }
    const double found = to_quantity(L, value)->value;
    if (!(found >= ends[0] && found <= ends[1]))
      refuse("is " + argument.value + "; its range is " +
             argument_text({ends[0], unit.dimension, unit.celsius}, argument.unit) + " to " +
             argument_text({ends[1], unit.dimension, unit.celsius}, argument.unit));
  }
  deck_.arguments.push_back(argument);
  lua_pushvalue(L, value);
  lua_setfield(L, values, name.c_str());
}

void DeckReader::push_setting(const std::string& name, const std::string& text, int type) {
  lua_State* L = deck_.sandbox->state();
  const std::string given = "--set " + name + "=" + text;
  if (type == LUA_TSTRING) return push(L, text);
  const std::string expression = "return " + text;
  if (luaL_loadbufferx(L, expression.data(), expression.size(), ("=" + given).c_str(), "t") != LUA_OK)
    throw DeckError({}, given + ": the value is not an expression such as 155 or 2*m");
  lua_call(L, 0, 1);
  if (type == LUA_TBOOLEAN ? !lua_isboolean(L, -1) : !to_quantity(L, -1))
    throw DeckError(
        {}, given + ": expected " + (type == LUA_TBOOLEAN ? "true or false" : "a number or a quantity such as 2*m"));
}

/// deck.read_table("air.csv", { time = days }): columns by the names of the first line, { time = {...}, air = {...} };
/// time, value, value_2, ... where that holds numbers. Columns with a unit become quantities.
int DeckReader::table_read(lua_State* L) {
  DeckReader& reader = of(L);
  const std::string path = reader.deck_.sandbox->data_file(luaL_checkstring(L, 1));
  lua_settop(L, 2);
  if (!lua_isnil(L, 2) && !lua_istable(L, 2))
    throw ScriptError(
        "deck.read_table takes units as a table by column: deck.read_table(\"air.csv\", { time = days })");
  reader.deck_.files.push_back(path);
  std::ifstream file(path);
  std::vector<std::string> names;
  std::vector<Quantity> units;
  lua_newtable(L);
  const int table = lua_gettop(L);
  const auto add_column = [&](const std::string& name) {
    names.push_back(name);
    Quantity unit{1, {}, false};
    if (lua_istable(L, 2)) {
      push(L, name);
      lua_rawget(L, 2);
      if (const auto given = to_quantity(L, -1))
        unit = *given;
      else if (!lua_isnil(L, -1))
        throw ScriptError("deck.read_table: the unit of column '" + name + "' is no unit; write " + name + " = days");
      lua_pop(L, 1);
    }
    units.push_back(unit);
    lua_newtable(L);
    lua_setfield(L, table, name.c_str());
  };
  const auto number = [](const std::string& cell) {
    char* end = nullptr;
    const double value = std::strtod(cell.c_str(), &end);
    return cell.empty() || *end || !std::isfinite(value) ? std::nullopt : std::optional(value);
  };
  int line_number = 0, row = 0;
  for (std::string line; std::getline(file, line);) {
    ++line_number;
    if (line.empty() || line[0] == '#' || line == "\r") continue;
    const Where where{path, line_number};
    std::vector<std::string> cells;
    std::istringstream split(line);
    for (std::string cell; std::getline(split, cell, ',');) {
      cell.erase(0, cell.find_first_not_of(" \t\r\""));
      cell.erase(cell.find_last_not_of(" \t\r\"") + 1);
      cells.push_back(cell);
    }
    if (names.empty()) {
      const bool unnamed = number(cells[0]).has_value();
      for (std::size_t i = 0; i < cells.size(); ++i)
        add_column(!unnamed ? cells[i] : i == 0 ? "time" : i == 1 ? "value" : "value_" + std::to_string(i));
      if (!unnamed) continue;
    }
    if (cells.size() != names.size())
      throw DeckError(where, std::string(cells.size() > names.size() ? "more" : "fewer") + " values than the " +
                                 std::to_string(names.size()) + " columns of the first line");
    ++row;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const auto value = number(cells[i]);
      if (!value) throw DeckError(where, "column '" + names[i] + "': '" + cells[i] + "' is not a number");
      lua_getfield(L, table, names[i].c_str());
      if (units[i].dimension)
        push_quantity(L, {*value * units[i].value, units[i].dimension, units[i].celsius});
      else
        lua_pushnumber(L, *value * units[i].value);
      lua_rawseti(L, -2, row);
      lua_pop(L, 1);
    }
  }
  if (row == 0)
    throw DeckError({path, 1}, "no rows; expected rows of numbers, separated by commas, below a line of column names");
  if (lua_istable(L, 2)) {
    lua_pushnil(L);
    while (lua_next(L, 2)) {
      lua_pop(L, 1);
      const std::string name = lua_type(L, -1) == LUA_TSTRING ? text_at(L, -1) : "";
      if (std::find(names.begin(), names.end(), name) == names.end())
        throw ScriptError("deck.read_table: there is no column '" + name + "'" + suggest_name(name, names));
    }
  }
  return 1;
}

void DeckReader::finish() {
  Complaints& complaints = deck_.sandbox->complaints;
  check_expects(deck_);
  for (const auto& [id, call] : open_)
    complaints.add(call.second, call.first + ": no table follows the name; write { ... } after it");
  const std::vector<std::string> names(argument_names_.begin(), argument_names_.end());
  for (const auto& [name, text] : settings_)
    if (!taken_.contains(name))
      complaints.add({}, "--set " + name + "=" + text + ": " +
                             (names.empty() ? "this deck has no arguments (deck.args)"
                                            : "no argument '" + name + "'" + suggest_name(name, names)));
  lua_State* L = deck_.sandbox->state();
  lua_pushnil(L);
  lua_setfield(L, LUA_REGISTRYINDEX, reader_key);
}

void DeckReader::read_files() {
  Complaints& complaints = deck_.sandbox->complaints;
  for (const auto& [noun, name, fields] : files_) {
    const std::filesystem::path given = fields.text("file");
    const Where where = fields.at("file");
    const std::string path = (std::filesystem::path(where.file).parent_path() / given).string();
    std::error_code ignored;
    if (given.is_absolute() || !std::filesystem::is_regular_file(path, ignored)) {
      complaints.add(
          where, title(noun, name) + ": " +
                     (given.is_absolute() ? "'" + given.string() + "' is an absolute path; give it relative to the deck"
                                          : std::string("there is no ") + (noun == "solid" ? "surface" : "mesh") +
                                                " file '" + path + "' (paths are relative to the deck)"));
      continue;
    }
    deck_.files.push_back(path);
    try {
      if (noun == "solid") {
        Solid solid{name,
                    fields.where,
                    path,
                    read_facets(path, where),
                    fields.number("size"),
                    fields.number("grow"),
                    fields.number("feature_angle")};
        for (auto& point : solid.surface.points) point = fields.number("unit") * point;
        deck_.model.solids.push_back(std::move(solid));
        continue;
      }
      ImportedMesh import{name, fields.where, path, read_mesh(path, where)};
      for (auto& point : import.mesh.points) point = fields.number("unit") * point;
      const auto rename = [&](const char* key, auto& items, auto name_of) {
        if (!fields.has(key)) return;
        std::vector<std::string> valid;
        for (auto& item : items) valid.push_back(name_of(item));
        for (const auto& [old, fresh] : fields.renames(key)) {
          const auto found = std::find(valid.begin(), valid.end(), old);
          if (found == valid.end())
            complaints.add(fields.at(key), title("import_mesh", name) + ": '" + key + "' renames '" + old +
                                               "', which " + path + " does not have" + suggest_name(old, valid));
          else
            name_of(items[found - valid.begin()]) = fresh;
        }
      };
      rename("regions", import.mesh.region_names, [](std::string& region) -> std::string& { return region; });
      rename("surfaces", import.mesh.surfaces, [](Surface& surface) -> std::string& { return surface.name; });
      deck_.model.imports.push_back(std::move(import));
    } catch (const DeckError& error) {
      for (const auto& line : error.lines()) complaints.add({}, line);
    }
  }
}

namespace {

/// A mistake in a loop must not bury the others.
void raise_first(const Complaints& complaints) {
  constexpr std::size_t most = 40;
  try {
    complaints.raise();
  } catch (const DeckError& error) {
    auto lines = error.lines();
    if (lines.size() <= most) throw;
    const std::string rest = "... and " + std::to_string(lines.size() - most) + " more mistakes";
    lines.resize(most);
    lines.push_back(rest);
    throw DeckError(lines);
  }
}

}  // namespace

Deck read_deck(const std::string& path, const std::map<std::string, std::string>& settings,
               const ScriptLimits& limits) {
  Deck deck;
  deck.path = path;
  deck.sandbox = std::make_shared<Sandbox>(path, limits);
  deck.model.where = {path, 1};
  DeckReader reader(deck, settings);
  try {
    deck.sandbox->run_deck();
    reader.finish();
    if (deck.sandbox->complaints.empty()) settle_times(deck.model);
  } catch (const DeckError& error) {
    for (const auto& line : error.lines()) deck.sandbox->complaints.add({}, line);
  }
  raise_first(deck.sandbox->complaints);
  const auto sources = deck.sandbox->sources();
  deck.files.insert(deck.files.begin(), sources.begin(), sources.end());
  deck.model.notes = deck.sandbox->hidden_names();
  reader.read_files();
  raise_first(deck.sandbox->complaints);
  return deck;
}

}  // namespace ashlar
