#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

#include "base/nearest_name.hpp"
#include "script/deck.hpp"
#include "script/fields.hpp"

namespace ashlar {
namespace {

/// The result object of `that = function(result)`; lives in the registry while the function runs.
constexpr const char* result_key = "ashlar result";

const RunResult& result_of(lua_State* L) {
  lua_getfield(L, LUA_REGISTRYINDEX, result_key);
  const auto* result = static_cast<const RunResult*>(lua_touserdata(L, -1));
  lua_pop(L, 1);
  if (!result) throw ScriptError("the result is only there while 'that' runs");
  return *result;
}

template <class List>
const auto& named(const List& list, const std::string& name, const char* what) {
  std::vector<std::string> names;
  for (const auto& item : list) {
    if (item.name == name) return item;
    names.push_back(item.name);
  }
  throw ScriptError(std::string("there is no ") + what + " '" + name + "'" + suggest_name(name, names));
}

void set_strict(lua_State* L, const char* what) {
  lua_getfield(L, LUA_REGISTRYINDEX, "names");
  lua_getfield(L, -1, "strict");
  lua_remove(L, -2);
  lua_insert(L, -2);
  lua_pushstring(L, what);
  lua_call(L, 2, 1);
}

/// result.stage(name)
int stage(lua_State* L) {
  const StageResult& s = named(result_of(L).stages, luaL_checkstring(L, 1), "finished stage");
  lua_newtable(L);
  const auto number = [&](const char* key, double value) {
    lua_pushnumber(L, value);
    lua_setfield(L, -2, key);
  };
  const auto text = [&](const char* key, const std::string& value) {
    push(L, value);
    lua_setfield(L, -2, key);
  };
  text("name", s.name);
  text("kind", s.kind);
  text("stop_reason", s.stop_reason);
  lua_pushboolean(L, s.converged);
  lua_setfield(L, -2, "converged");
  lua_pushboolean(L, s.balanced());
  lua_setfield(L, -2, "balanced");
  number("steps", static_cast<double>(s.steps));
  number("ratio", s.ratio);
  number("load_factor", s.load_factor);
  number("cracks", static_cast<double>(s.events.size()));
  number("first_crack", s.events.empty() ? std::numeric_limits<double>::infinity() : s.events.front().load_factor);
  lua_newtable(L);
  constexpr const char* axes[3] = {"x", "y", "z"};
  if (!s.events.empty())
    for (int i = 0; i < 3; ++i) {
      lua_pushnumber(L, s.events.front().place[i]);
      lua_setfield(L, -2, axes[i]);
    }
  lua_setfield(L, -2, "first_crack_place");
  number("cracked_area", s.cracked_area);
  number("dissipated_energy", s.dissipated_energy);
  number("plastic_work", s.plastic_work);
  number("fracture_work", s.fracture_work);
  number("safety_factor", s.safety_factor);
  number("falling_factor", s.falling_factor);
  number("free_blocks", static_cast<double>(s.free_blocks.size()));
  number("time_step", s.time_step);
  number("stable_step", s.stable_step);
  number("energy_drift", s.energy.drift);
  set_strict(L, "value of a stage");
  return 1;
}

/// result.history(name).at(column, stage)
int history_value(lua_State* L) {
  const HistoryTable& table = named(result_of(L).histories, text_at(L, lua_upvalueindex(1)), "history");
  const std::string column = luaL_checkstring(L, 1), stage = luaL_optstring(L, 2, "");
  try {
    lua_pushnumber(L, table.at(column, stage));
  } catch (const std::out_of_range& error) {
    throw ScriptError(error.what());
  }
  return 1;
}

/// result.history(name).values(column, stage)
int history_values(lua_State* L) {
  const HistoryTable& table = named(result_of(L).histories, text_at(L, lua_upvalueindex(1)), "history");
  try {
    const std::vector<double> values = table.values(luaL_checkstring(L, 1), luaL_optstring(L, 2, ""));
    lua_createtable(L, static_cast<int>(values.size()), 0);
    for (std::size_t i = 0; i < values.size(); ++i) {
      lua_pushnumber(L, values[i]);
      lua_rawseti(L, -2, static_cast<int>(i) + 1);
    }
  } catch (const std::out_of_range& error) {
    throw ScriptError(error.what());
  }
  return 1;
}

/// result.history(name)
int history(lua_State* L) {
  const HistoryTable& table = named(result_of(L).histories, luaL_checkstring(L, 1), "history");
  lua_newtable(L);
  push(L, table.name);
  lua_pushcclosure(L, guarded<history_value>, 1);
  lua_setfield(L, -2, "at");
  push(L, table.name);
  lua_pushcclosure(L, guarded<history_values>, 1);
  lua_setfield(L, -2, "values");
  lua_newtable(L);
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    push(L, table.columns[i]);
    lua_rawseti(L, -2, static_cast<int>(i) + 1);
  }
  lua_setfield(L, -2, "columns");
  set_strict(L, "value of a history");
  return 1;
}

/// A value of a history with a unit that suits its size.
std::string value_text(double value, std::string unit) {
  if (unit == "m" && std::abs(value) < 1) value *= 1e3, unit = "mm";
  if ((unit == "Pa" || unit == "N") && std::abs(value) >= 1e3) value *= 1e-6, unit = "M" + unit;
  char text[64];
  std::snprintf(text, sizeof text, "%.7g%s%s", value, unit.empty() ? "" : " ", unit.c_str());
  return text;
}

ExpectOutcome judge_function(const Expect& expect, const RunResult& result, Sandbox& sandbox) {
  ExpectOutcome outcome{expect.name, false, std::numeric_limits<double>::quiet_NaN(), {}, "function", ""};
  lua_State* L = sandbox.state();
  const int top = lua_gettop(L);
  lua_pushlightuserdata(L, const_cast<RunResult*>(&result));
  lua_setfield(L, LUA_REGISTRYINDEX, result_key);
  lua_rawgeti(L, LUA_REGISTRYINDEX, expect.function);
  lua_newtable(L);
  lua_pushcfunction(L, guarded<stage>);
  lua_setfield(L, -2, "stage");
  lua_pushcfunction(L, guarded<history>);
  lua_setfield(L, -2, "history");
  set_strict(L, "value of the result");
  try {
    sandbox.call(1, 2, sandbox.limits.instructions, expect.where.prefix() + "expect '" + expect.name + "'");
    outcome.passed = lua_toboolean(L, -2);
    outcome.message =
        lua_isnil(L, -1)
            ? (outcome.passed ? "true" : "its function returned " + std::string(luaL_tolstring(L, -2, nullptr)))
            : std::string(luaL_tolstring(L, -1, nullptr));
  } catch (const DeckError& error) {
    outcome.message = error.what();
  }
  lua_pushnil(L);
  lua_setfield(L, LUA_REGISTRYINDEX, result_key);
  lua_settop(L, top);
  return outcome;
}

ExpectOutcome judge(const Expect& expect, const RunResult& result) {
  ExpectOutcome outcome{expect.name, false, std::numeric_limits<double>::quiet_NaN(), expect.between, "", ""};
  try {
    const HistoryTable& table = named(result.histories, expect.history, "history");
    const auto column = std::find(table.columns.begin(), table.columns.end(), expect.component);
    const std::string unit = column == table.columns.end() ? "" : table.units[column - table.columns.begin()];
    outcome.wanted =
        "between " + value_text((*expect.between)[0], unit) + " and " + value_text((*expect.between)[1], unit);
    outcome.found = table.at(expect.component, expect.stage);
    outcome.passed = outcome.found >= (*expect.between)[0] && outcome.found <= (*expect.between)[1];
    outcome.message = expect.history + " " + expect.component + (expect.stage.empty() ? "" : " after " + expect.stage) +
                      " is " + value_text(outcome.found, unit) + (outcome.passed ? ", " : "; wanted ") + outcome.wanted;
  } catch (const std::exception& error) {  // no such history, column or stage row
    outcome.message = error.what();
  }
  return outcome;
}

}  // namespace

std::vector<ExpectOutcome> evaluate(const Deck& deck, const RunResult& result) {
  std::vector<ExpectOutcome> outcomes;
  for (const auto& expect : deck.expects)
    outcomes.push_back(expect.function ? judge_function(expect, result, *deck.sandbox) : judge(expect, result));
  return outcomes;
}

}  // namespace ashlar
