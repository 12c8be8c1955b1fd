#include "script/fields.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/nearest_name.hpp"
#include "script/in_time.hpp"

namespace ashlar {
namespace {

constexpr const char* handle_type = "ashlar handle";

std::string describe(lua_State* L, int index) {
  if (auto q = to_quantity(L, index)) return quantity_text(*q);
  if (lua_type(L, index) == LUA_TSTRING) return "\"" + text_at(L, index) + "\"";
  if (lua_type(L, index) == LUA_TBOOLEAN) return lua_toboolean(L, index) ? "true" : "false";
  if (luaL_testudata(L, index, handle_type)) return "a condition or solve";
  if (is_in_time(L, index)) return "values in time";
  if (lua_isnil(L, index)) return "nil, the value of what was not set or returned";
  return std::string("a ") + luaL_typename(L, index);
}

std::string range_text(const KeyRule& rule) {
  const std::string unit = unit_symbol(rule.dimension, rule.dimension == dimension::temperature);
  const auto with_unit = [&](double v) { return decimal_text(v) + (unit.empty() ? "" : " " + unit); };
  const bool low = std::isfinite(rule.range.low), high = std::isfinite(rule.range.high);
  if (low && high)
    return (rule.range.open_low ? "more than " : "at least ") + with_unit(rule.range.low) + " and at most " +
           with_unit(rule.range.high);
  if (low) return (rule.range.open_low ? "more than " : "at least ") + with_unit(rule.range.low);
  return "at most " + with_unit(rule.range.high);
}

std::string expected_at_once(const KeyRule& rule) {
  switch (rule.type) {
    case KeyType::number:
      return rule.any_dimension              ? "a number"
             : rule.dimension == Dimension{} ? "a number"
                                             : dimension_advice(rule.dimension);
    case KeyType::integer: return "a whole number";
    case KeyType::flag: return "true or false";
    case KeyType::text: return "a text in quotes";
    case KeyType::choice: return "a text in quotes";
    case KeyType::choices: return "a text or a list of texts: { \"a\", \"b\" }";
    case KeyType::names: return "a name or a list of names: { \"a\", \"b\" }";
    case KeyType::vector: return "{ x, y, z }";
    case KeyType::field:
      return dimension_advice(rule.dimension) + ", or a function(x, y, z)" + (rule.in_time ? ", or (x, y, z, t)" : "");
    case KeyType::outline: return "a list of at least three corners { x, z }";
    case KeyType::outlines: return "a list of outlines { {x, z}, {x, z}, {x, z}, ... }";
    case KeyType::vectors: return "two vectors { {x, y, z}, {x, y, z} }";
    case KeyType::integers: return "a list of whole numbers { 1, 2, 3 }";
    case KeyType::counts: return "whole numbers with whole keys: { [1] = 4 }";
    case KeyType::renames: return "a table { old = \"new\" }";
    case KeyType::interval: return "{ lowest, highest }";
    case KeyType::zero: return "0 (a given movement is what 'displacement' is for)";
    case KeyType::solve: return "static {...}, thermal {...}, fracture {...}, coupled {...}, dynamic {...} or strength_reduction {...}";
    case KeyType::conditions: return "a list of conditions such as convection {...}";
    case KeyType::function: return "a function(result)";
  }
  return "";
}

std::string expected(const KeyRule& rule) {
  return expected_at_once(rule) +
         (rule.in_time ? ", or values in time: { {0*days, ...}, {30*days, ...} } or in_time(function(t) ... end)" : "");
}

}  // namespace

void push_handle(lua_State* L, const Handle& handle) {
  new (lua_newuserdatauv(L, sizeof(Handle), 0)) Handle(handle);
  luaL_newmetatable(L, handle_type);
  lua_setmetatable(L, -2);
}

std::string title(const std::string& noun, const std::string& name) {
  return name.empty() ? noun : noun + " '" + name + "'";
}

std::optional<double> Fields::maybe(const std::string& key) const {
  return has(key) ? std::optional(number(key)) : std::nullopt;
}
std::vector<double> Fields::numbers(const std::string& key) const {
  std::vector<double> all;
  if (has(key))
    for (const auto& q : values_.at(key).quantities) all.push_back(q.value);
  return all;
}
Vec3<double> Fields::vector(const std::string& key, int i) const {
  const auto& q = values_.at(key).quantities;
  return {q.at(3 * i).value, q.at(3 * i + 1).value, q.at(3 * i + 2).value};
}
std::vector<std::string> Fields::texts(const std::string& key) const {
  return has(key) ? values_.at(key).texts : std::vector<std::string>{};
}
std::optional<Value> Fields::maybe_value(const std::string& key) const {
  return has(key) ? std::optional(value(key)) : std::nullopt;
}
std::vector<InTime> Fields::in_time() const {
  std::vector<InTime> all;
  for (const auto& [key, field] : values_)
    if (field.in_time) all.push_back(*field.in_time);
  return all;
}
Where Fields::at(const std::string& key) const { return has(key) ? values_.at(key).where : where; }

std::string number_complaint(const KeyRule& rule, const Quantity& q) {
  if (!std::isfinite(q.value)) return "is not a finite number (" + decimal_text(q.value) + ")";
  if (rule.any_dimension) return "";
  const std::string found = "is " + quantity_text(q);
  if (q.dimension && *q.dimension != rule.dimension) return found + "; expected " + dimension_advice(rule.dimension);
  if (rule.dimension == dimension::temperature && q.dimension && !q.celsius)
    return found + "; temperatures are in degrees Celsius: write " + decimal_text(q.value - 273.15) +
           "*degC for this absolute temperature";
  if (rule.range.contains(q.value)) return "";
  return found + "; expected " + range_text(rule) +
         (rule.is_angle() ? "; angles are in radians: write " + decimal_text(q.value) + "*deg" : "");
}

class FieldReader {
 public:
  FieldReader(Sandbox& sandbox, const NounRule& noun, const std::string& name)
      : sandbox_(sandbox), L_(sandbox.state()), noun_(noun), name_(name) {}

  std::optional<Fields> read(int table) {
    fields_.where = sandbox_.where();
    auto rules = noun_.keys;
    const auto laws = laws_of(noun_);
    const LawDoc* law = nullptr;
    if (!laws.empty()) {
      auto& choice = *std::find_if(rules.begin(), rules.end(), [](const KeyRule& r) { return r.name == "law"; });
      for (const auto& l : laws) choice.choices.push_back(l.name);
      choice.required = choice.fallback_text.empty();
      lua_getfield(L_, table, "law");
      const std::string chosen = lua_isnil(L_, -1)                 ? choice.fallback_text
                                 : lua_type(L_, -1) == LUA_TSTRING ? text_at(L_, -1)
                                                                   : "";
      lua_pop(L_, 1);
      for (const auto& l : laws)
        if (l.name == chosen) law = &l;
      if (law)
        for (const auto& key : law->keys) rules.push_back(rule_of(key));
    }
    unknown_keys(table, rules, laws, law);
    for (const auto& rule : rules) {
      lua_getfield(L_, table, rule.name.c_str());
      if (lua_isnil(L_, -1))
        absent(rule);
      else
        present(rule, lua_gettop(L_));
      lua_pop(L_, 1);
    }
    std::stable_sort(found_.begin(), found_.end(),
                     [](const auto& a, const auto& b) { return a.first.line < b.first.line; });
    for (const auto& [where, message] : found_) sandbox_.complaints.add(where, message);
    if (!found_.empty()) return std::nullopt;
    if (law)
      for (const auto& key : law->keys)
        if (fields_.has(key.name)) fields_.law_values[key.name] = law_value(key);
    return fields_;
  }

 private:
  /// The whole number at `index`, 3.0 as well as 3; 0 if there is none.
  long long whole_number(int index) const {
    int whole = 0;
    const lua_Integer value = lua_tointegerx(L_, index, &whole);
    return whole && lua_type(L_, index) == LUA_TNUMBER ? value : 0;
  }
  void complain(const std::string& key, const std::string& message) {
    const Where where = key.empty() ? fields_.where : sandbox_.where(noun_.name, name_, key);
    found_.emplace_back(where, title(noun_.name, name_) + ": " + message);
  }

  /// Words are given to laws by their number.
  double law_value(const Key& key) const {
    if (key.choices.empty()) return fields_.number(key.name);
    const auto word = std::find(key.choices.begin(), key.choices.end(), fields_.text(key.name));
    return static_cast<double>(word - key.choices.begin());
  }

  void unknown_keys(int table, const std::vector<KeyRule>& rules, const std::vector<LawDoc>& laws, const LawDoc* law) {
    std::vector<std::string> valid;
    for (const auto& rule : rules) valid.push_back(rule.name);
    std::set<std::string> keys;  // in an order that every run has
    lua_pushnil(L_);
    while (lua_next(L_, table)) {
      lua_pop(L_, 1);
      if (lua_type(L_, -1) == LUA_TSTRING) {
        keys.insert(text_at(L_, -1));
      } else {
        const auto position = to_quantity(L_, -1);
        complain(position ? decimal_text(position->value) : "",
                 "a value without a key; write key = value (keys: " + list(valid) + ")");
      }
    }
    for (const std::string& key : keys) {
      if (std::find(valid.begin(), valid.end(), key) != valid.end()) continue;
      std::string owners;
      for (const auto& l : laws)
        for (const auto& k : l.keys)
          if (k.name == key) owners += (owners.empty() ? "" : ", ") + ("\"" + l.name + "\"");
      if (!laws.empty() && !law) {
        if (!owners.empty()) continue;  // the law itself is missing or wrong: its keys cannot be judged
        complain(key, "unknown key '" + key + "'");
      } else if (!owners.empty()) {
        complain(key, "key '" + key + "' does not belong to law \"" + law->name + "\" but to " + owners);
      } else {
        const std::string meant = key_meant(key, valid);
        complain(key, "unknown key '" + key + "'" +
                          (meant.empty() ? suggest_name(key, valid) : ": did you mean '" + meant + "'?"));
        misspelt_.insert(meant);
      }
    }
  }

  static std::string list(const std::vector<std::string>& names) {
    std::string all;
    for (const auto& name : names) all += (all.empty() ? "" : ", ") + name;
    return all;
  }

  void absent(const KeyRule& rule) {
    if (rule.required) {
      if (misspelt_.contains(rule.name)) return;
      const std::string unit = unit_symbol(rule.dimension, rule.dimension == dimension::temperature);
      std::string what = rule.choices.empty() ? rule.doc : "one of " + list(rule.choices);
      complain("", "missing '" + rule.name + "'" + (unit.empty() ? "" : " [" + unit + "]") + ": " + what);
    } else if (rule.fallback) {
      auto& field = fields_.values_[rule.name];
      field.quantities = {{*rule.fallback, rule.dimension, false}};
      field.value.constant = *rule.fallback;
      field.where = fields_.where;
    } else if (!rule.fallback_text.empty()) {
      auto& field = fields_.values_[rule.name];
      field.texts = {rule.fallback_text};
      field.where = fields_.where;
    }
  }

  /// Complaint about the whole value of a key.
  void wrong(const KeyRule& rule, int index) {
    complain(rule.name, "'" + rule.name + "' is " + describe(L_, index) + "; expected " + expected(rule));
  }

  bool read_number(const KeyRule& rule, int index, const std::string& path, std::vector<Quantity>& into) {
    const auto q = to_quantity(L_, index);
    if (!q) {
      complain(path, "'" + path + "' is " + describe(L_, index) + "; expected " + expected(rule));
      return false;
    }
    const std::string complaint = number_complaint(rule, *q);
    if (!complaint.empty()) complain(path, "'" + path + "' " + complaint);
    into.push_back(*q);
    return complaint.empty();
  }

  bool read_whole(const KeyRule& rule, int index, const std::string& path, std::vector<Quantity>& into) {
    if (lua_type(L_, index) != LUA_TNUMBER || lua_tonumber(L_, index) != std::floor(lua_tonumber(L_, index))) {
      complain(path, "'" + path + "' is " + describe(L_, index) + "; expected a whole number");
      return false;
    }
    return read_number(rule, index, path, into);
  }

  /// Elements of a list of `count` numbers (any count if 0); complains and returns false if it is none.
  bool read_list(const KeyRule& rule, int index, const std::string& path, int count, bool whole,
                 std::vector<Quantity>& into) {
    KeyRule element = rule;
    element.type = KeyType::number;
    const int size = lua_type(L_, index) == LUA_TTABLE ? static_cast<int>(lua_rawlen(L_, index)) : -1;
    if (size < 0 || (count > 0 && size != count)) {
      complain(path, "'" + path + "' is " +
                         (size < 0 ? describe(L_, index) : "a table with " + std::to_string(size) + " values") +
                         "; expected " +
                         (count == 2   ? "two values"
                          : count == 3 ? "{ x, y, z }"
                                       : expected(rule)));
      return false;
    }
    bool good = true;
    for (int i = 1; i <= size; ++i) {
      lua_rawgeti(L_, index, i);
      const std::string place = path + "." + std::to_string(i);
      good &=
          whole ? read_whole(element, lua_gettop(L_), place, into) : read_number(element, lua_gettop(L_), place, into);
      lua_pop(L_, 1);
    }
    return good;
  }

  /// Whether the first entry is a pair of numbers, a corner.
  bool is_outline(int index) const {
    bool corner = false;
    if (lua_rawgeti(L_, index, 1) == LUA_TTABLE && lua_rawlen(L_, -1) == 2) {
      lua_rawgeti(L_, -1, 1);
      corner = to_quantity(L_, lua_gettop(L_)).has_value();
      lua_pop(L_, 1);
    }
    lua_pop(L_, 1);
    return corner;
  }

  void read_outlines(const KeyRule& rule, int index, std::vector<std::vector<std::array<double, 2>>>& into) {
    if (lua_type(L_, index) != LUA_TTABLE || lua_rawlen(L_, index) == 0) return wrong(rule, index);
    if (is_outline(index))
      return complain(rule.name, "'" + rule.name + "' is one outline; give a list of outlines, " + rule.name +
                                     " = { outline }, as in " + rule.name + " = { { {x, z}, {x, z}, {x, z} } }");
    for (int i = 1; i <= static_cast<int>(lua_rawlen(L_, index)); ++i) {
      lua_rawgeti(L_, index, i);
      const int outline = lua_gettop(L_);
      const std::string place = rule.name + "." + std::to_string(i);
      const int size = lua_type(L_, outline) == LUA_TTABLE ? static_cast<int>(lua_rawlen(L_, outline)) : 0;
      into.emplace_back();
      if (size < 3)
        complain(place, "'" + place + "' is " + describe(L_, outline) + "; expected an outline of at least three " +
                            "corners { x, z }; holes = { { {x, z}, {x, z}, {x, z} } } is one hole");
      for (int k = 1; size >= 3 && k <= size; ++k) {
        lua_rawgeti(L_, outline, k);
        std::vector<Quantity> corner;
        if (read_list(rule, lua_gettop(L_), place + "." + std::to_string(k), 2, false, corner))
          into.back().push_back({corner[0].value, corner[1].value});
        lua_pop(L_, 1);
      }
      lua_pop(L_, 1);
    }
  }

  bool read_texts(const KeyRule& rule, int index, std::vector<std::string>& into) {
    if (lua_type(L_, index) == LUA_TSTRING) {
      into.push_back(text_at(L_, index));
      return true;
    }
    if (lua_type(L_, index) != LUA_TTABLE || lua_rawlen(L_, index) == 0) return wrong(rule, index), false;
    for (int i = 1; i <= static_cast<int>(lua_rawlen(L_, index)); ++i) {
      lua_rawgeti(L_, index, i);
      const bool text = lua_type(L_, -1) == LUA_TSTRING;
      if (text)
        into.push_back(text_at(L_, -1));
      else
        complain(rule.name,
                 "'" + rule.name + "' holds " + describe(L_, lua_gettop(L_)) + "; expected " + expected(rule));
      lua_pop(L_, 1);
      if (!text) return false;
    }
    return true;
  }

  void check_choices(const KeyRule& rule, const std::vector<std::string>& texts) {
    for (const auto& text : texts)
      if (std::find(rule.choices.begin(), rule.choices.end(), text) == rule.choices.end())
        complain(rule.name, "'" + rule.name + "' has no choice \"" + text + "\"" + suggest_name(text, rule.choices));
  }

  /// Handles in a list, lists inside lists included.
  void read_handles(const KeyRule& rule, int index, NounKind kind, std::vector<int>& into, int depth = 0) {
    if (depth > 20) return complain(rule.name, "'" + rule.name + "' has lists inside lists without end");
    if (auto* handle = static_cast<Handle*>(luaL_testudata(L_, index, handle_type)); handle && handle->kind == kind) {
      if (handle->index >= 0) into.push_back(handle->index);
    } else if (kind == NounKind::condition && lua_type(L_, index) == LUA_TTABLE) {
      for (int i = 1; i <= static_cast<int>(lua_rawlen(L_, index)); ++i) {
        lua_rawgeti(L_, index, i);
        read_handles(rule, lua_gettop(L_), kind, into, depth + 1);
        lua_pop(L_, 1);
      }
    } else {
      wrong(rule, index);
    }
  }

  /// A deck function of numbers that gives a value of the key. `place`: how a message tells where it was called.
  template <std::size_t count>
  auto number_function(const KeyRule& rule, int index,
                       std::function<std::string(const std::array<double, count>&)> place, const std::string& reminder) {
    lua_pushvalue(L_, index);
    const int reference = luaL_ref(L_, LUA_REGISTRYINDEX);
    const std::string what = title(noun_.name, name_) + ": '" + rule.name + "'";
    return [sandbox = sandbox_.shared_from_this(), reference, rule, what, place, reminder,
            where = fields_.at(rule.name)](const std::array<double, count>& arguments) {
      const std::lock_guard lock(sandbox->busy);
      lua_State* L = sandbox->state();
      lua_rawgeti(L, LUA_REGISTRYINDEX, reference);
      for (const double argument : arguments) lua_pushnumber(L, argument);
      sandbox->call(static_cast<int>(count), 1, sandbox->limits.instructions / 10, where.prefix() + what);
      const auto q = to_quantity(L, -1);
      const std::string found =
          q ? number_complaint(rule, *q)
            : "is " + describe(L, lua_gettop(L)) + "; expected " + dimension_advice(rule.dimension);
      lua_pop(L, 1);
      if (!found.empty())
        throw DeckError(where, what + " at " + place(arguments) + " " + found + (q && q->dimension ? "; " + reminder : ""));
      return q->value;
    };
  }
  static std::string place_of(double x, double y, double z) {
    return "(" + decimal_text(x) + ", " + decimal_text(y) + ", " + decimal_text(z) + ")";
  }
  std::function<double(const Vec3<double>&)> function_of_place(const KeyRule& rule, int index) {
    const auto function = number_function<3>(
        rule, index, [](const auto& p) { return place_of(p[0], p[1], p[2]); },
        "x, y and z are plain numbers in metres (z*m is a length)");
    return [function](const Vec3<double>& p) { return function({p.x, p.y, p.z}); };
  }
  std::function<double(double)> function_of_time(const KeyRule& rule, int index) {
    const auto function = number_function<1>(
        rule, index, [](const auto& t) { return "t = " + decimal_text(t[0]) + " s"; },
        "t is a plain number of seconds (t*s is a time)");
    return [function](double t) { return function({t}); };
  }
  std::function<double(const Vec3<double>&, double)> function_of_place_and_time(const KeyRule& rule, int index) {
    const auto function = number_function<4>(
        rule, index,
        [](const auto& p) { return place_of(p[0], p[1], p[2]) + ", t = " + decimal_text(p[3]) + " s,"; },
        "x, y, z and t are plain numbers in metres and seconds (z*m is a length, t*s a time)");
    return [function](const Vec3<double>& p, double t) { return function({p.x, p.y, p.z, t}); };
  }

  /// Rows { time, value }, or two lists, or a function, as in_time(...) or as a bare table of rows.
  void read_in_time(const KeyRule& rule, int index) {
    auto& field = fields_.values_[rule.name];
    InTime number;
    number.key = rule.name;
    const auto refuse = [&](const std::string& message) { complain(rule.name, "'" + rule.name + "' " + message); };
    KeyRule time, value = rule;
    time.dimension = dimension::time;
    value.type = KeyType::number;
    value.in_time = false;
    if (is_in_time(L_, index)) {
      number.from_stage = counts_from_stage(L_, index);
      lua_getiuservalue(L_, index, 1);
    } else {
      lua_pushvalue(L_, index);
    }
    const int given = lua_gettop(L_);
    if (lua_type(L_, given) == LUA_TFUNCTION && parameters(given) > 1) {
      if (rule.type != KeyType::field)
        refuse("is one number for all places: write in_time(function(t) ... end)");
      else if (parameters(given) == 4)
        number.field = function_of_place_and_time(value, given);
      else
        refuse("is a function of " + std::to_string(parameters(given)) +
               " numbers; in time it is function(t), of place and time function(x, y, z, t)");
    } else if (lua_type(L_, given) == LUA_TFUNCTION) {
      number.function = function_of_time(value, given);
    } else {
      std::string complaint;
      const auto rows = rows_in_time(L_, given, complaint);
      const bool other_table = complaint.starts_with("is a table, but");
      if (!complaint.empty()) refuse(complaint + (other_table ? "; expected " + expected(rule) : ""));
      for (std::size_t i = 0; complaint.empty() && i < rows.size(); ++i) {
        const std::string row = "row " + std::to_string(i + 1) + ": the ";
        if (const auto found = number_complaint(time, rows[i][0]); !found.empty()) complaint = row + "time " + found;
        if (const auto found = number_complaint(value, rows[i][1]); !found.empty()) complaint = row + "value " + found;
        if (i > 0 && !(rows[i][0].value > rows[i - 1][0].value))
          complaint = row + "time " + quantity_text(rows[i][0]) + " does not come after " +
                      quantity_text(rows[i - 1][0]) + "; times ascend";
        number.table.time.push_back(rows[i][0].value);
        number.table.value.push_back(rows[i][1].value);
        if (!complaint.empty()) refuse("is a table in time, " + complaint);
      }
    }
    lua_settop(L_, given - 1);
    field.quantities = {{0, rule.dimension, false}};
    field.in_time = number;
  }

  int parameters(int index) {
    lua_Debug about;
    lua_pushvalue(L_, index);
    lua_getinfo(L_, ">u", &about);
    return about.nparams;
  }
  /// "t" where a plain function looks like one of time.
  std::string time_parameter(int index) {
    lua_pushvalue(L_, index);
    const char* first = lua_getlocal(L_, nullptr, 1);
    const std::string name = first ? first : "";
    lua_pop(L_, 1);
    return name == "t" || name == "time" ? name : "";
  }

  void present(const KeyRule& rule, int index) {
    auto& field = fields_.values_[rule.name];
    field.where = sandbox_.where(noun_.name, name_, rule.name);
    const int type = lua_type(L_, index);
    if (rule.in_time && (is_in_time(L_, index) || (type == LUA_TTABLE && rule.type != KeyType::vector)))
      return read_in_time(rule, index);
    if (rule.in_time && type == LUA_TFUNCTION)
      if (const std::string t = time_parameter(index); !t.empty())
        return complain(rule.name, "'" + rule.name + "' is a function of " + t +
                                       "; one of time is written in_time(function(" + t + ") ... end)" +
                                       (rule.type == KeyType::field
                                            ? ", one of position function(x, y, z), of both function(x, y, z, t)"
                                            : ""));
    if (rule.type == KeyType::field && type == LUA_TFUNCTION && parameters(index) == 4) {
      if (rule.in_time) return read_in_time(rule, index);
      return complain(rule.name, "'" + rule.name + "' does not change in time; write function(x, y, z)");
    }
    switch (rule.type) {
      case KeyType::number: read_number(rule, index, rule.name, field.quantities); break;
      case KeyType::integer: read_whole(rule, index, rule.name, field.quantities); break;
      case KeyType::flag:
        if (type != LUA_TBOOLEAN) wrong(rule, index);
        field.quantities = {{static_cast<double>(lua_toboolean(L_, index)), {}, false}};
        break;
      case KeyType::zero: {
        const auto q = to_quantity(L_, index);
        if ((!q || q->value != 0) && !(type == LUA_TBOOLEAN && lua_toboolean(L_, index))) wrong(rule, index);
        break;
      }
      case KeyType::text:
      case KeyType::choice:
        if (type != LUA_TSTRING) return wrong(rule, index);
        field.texts = {text_at(L_, index)};
        if (rule.type == KeyType::choice) check_choices(rule, field.texts);
        break;
      case KeyType::names: read_texts(rule, index, field.texts); break;
      case KeyType::choices:
        if (read_texts(rule, index, field.texts)) check_choices(rule, field.texts);
        break;
      case KeyType::field:
        if (type == LUA_TFUNCTION)
          field.value.at = function_of_place(rule, index);
        else if (read_number(rule, index, rule.name, field.quantities))
          field.value.constant = field.quantities[0].value;
        break;
      case KeyType::vector: read_list(rule, index, rule.name, 3, false, field.quantities); break;
      case KeyType::interval: read_list(rule, index, rule.name, 2, false, field.quantities); break;
      case KeyType::integers: read_list(rule, index, rule.name, 0, true, field.quantities); break;
      case KeyType::outline:
      case KeyType::vectors: {
        const bool outline = rule.type == KeyType::outline;
        const int size = type == LUA_TTABLE ? static_cast<int>(lua_rawlen(L_, index)) : 0;
        if (outline ? size < 3 : size != 2) return wrong(rule, index);
        KeyRule element = rule;
        for (int i = 1; i <= size; ++i) {
          lua_rawgeti(L_, index, i);
          // A plane is a point and a direction: the direction is a plain vector.
          if (rule.name == "plane" && i == 2) element.dimension = dimension::none;
          read_list(element, lua_gettop(L_), rule.name + "." + std::to_string(i), outline ? 2 : 3, false,
                    field.quantities);
          lua_pop(L_, 1);
        }
        break;
      }
      case KeyType::outlines: read_outlines(rule, index, field.outlines); break;
      case KeyType::counts:
      case KeyType::renames: {
        if (type != LUA_TTABLE) return wrong(rule, index);
        const bool counts = rule.type == KeyType::counts;
        lua_pushnil(L_);
        while (lua_next(L_, index)) {
          const bool right = counts ? whole_number(-2) > 0 && whole_number(-1) > 0
                                    : lua_type(L_, -2) == LUA_TSTRING && lua_type(L_, -1) == LUA_TSTRING;
          if (!right) {
            lua_pop(L_, 2);
            return wrong(rule, index);
          }
          if (counts) {
            field.renames[std::to_string(whole_number(-2))] = std::to_string(whole_number(-1));
          } else {
            field.renames[text_at(L_, -2)] = text_at(L_, -1);
          }
          lua_pop(L_, 1);
        }
        break;
      }
      case KeyType::solve: read_handles(rule, index, NounKind::solve, field.handles); break;
      case KeyType::conditions: read_handles(rule, index, NounKind::condition, field.handles); break;
      case KeyType::function:
        if (type != LUA_TFUNCTION) return wrong(rule, index);
        lua_pushvalue(L_, index);
        field.function.reference = luaL_ref(L_, LUA_REGISTRYINDEX);
        break;
    }
  }

  Sandbox& sandbox_;
  lua_State* L_;
  const NounRule& noun_;
  const std::string name_;
  Fields fields_;
  std::set<std::string> misspelt_;  ///< keys that a wrong one was probably meant to be
  std::vector<std::pair<Where, std::string>> found_;
};

std::optional<Fields> read_fields(Sandbox& sandbox, const NounRule& noun, const std::string& name, int index) {
  return FieldReader(sandbox, noun, name).read(index);
}

}  // namespace ashlar
