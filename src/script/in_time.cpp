#include "script/in_time.hpp"

namespace ashlar {

namespace {

constexpr const char* type_name = "ashlar in time";

/// in_time(function), in_time{ {time, value}, ... }, in_time(columns) or in_time(times, values).
template <bool from_stage>
int make(lua_State* L) {
  const char* form = from_stage ? "in_stage" : "in_time";
  const int type = lua_type(L, 1);
  if (type != LUA_TFUNCTION && type != LUA_TTABLE)
    throw ScriptError(std::string(form) +
                      " needs a function(t), rows { {0*days, value}, ... }, or two lists, times and " +
                      "values; not a " + luaL_typename(L, 1));
  if (lua_gettop(L) > 1) {
    if (type != LUA_TTABLE || lua_type(L, 2) != LUA_TTABLE || lua_rawlen(L, 1) != lua_rawlen(L, 2))
      throw ScriptError(std::string(form) + " with two arguments needs two lists of the same length, times and values");
    lua_newtable(L);
    lua_pushvalue(L, 1);
    lua_setfield(L, -2, "time");
    lua_pushvalue(L, 2);
    lua_setfield(L, -2, "value");
    lua_replace(L, 1);
  }
  *static_cast<bool*>(lua_newuserdatauv(L, sizeof(bool), 1)) = from_stage;
  lua_pushvalue(L, 1);
  lua_setiuservalue(L, -2, 1);
  luaL_newmetatable(L, type_name);
  lua_setmetatable(L, -2);
  return 1;
}

}  // namespace

void open_in_time(lua_State* L) {
  lua_pushcfunction(L, guarded<make<false>>);
  lua_setfield(L, -2, "in_time");
  lua_pushcfunction(L, guarded<make<true>>);
  lua_setfield(L, -2, "in_stage");
}

bool is_in_time(lua_State* L, int index) { return luaL_testudata(L, index, type_name) != nullptr; }
bool counts_from_stage(lua_State* L, int index) { return *static_cast<bool*>(lua_touserdata(L, index)); }

std::vector<std::array<Quantity, 2>> rows_in_time(lua_State* L, int index, std::string& complaint) {
  std::vector<std::array<Quantity, 2>> rows;
  const int top = lua_gettop(L);
  const auto number = [&](int at, const std::string& what) {
    const auto q = to_quantity(L, at);
    if (!q && complaint.empty()) complaint = "is a table in time, " + what + " is no number";
    return q.value_or(Quantity{});
  };
  lua_pushliteral(L, "time");
  lua_rawget(L, index);
  if (lua_istable(L, -1)) {
    std::vector<std::string> columns;
    lua_pushnil(L);
    while (lua_next(L, index)) {
      lua_pop(L, 1);
      if (lua_type(L, -1) == LUA_TSTRING && text_at(L, -1) != "time") columns.push_back(text_at(L, -1));
    }
    if (columns.size() != 1) {
      complaint = "is a table with " + std::to_string(columns.size()) +
                  " columns beside 'time'; choose one: in_time(air.time, air.temperature)";
    } else {
      lua_pushstring(L, columns[0].c_str());
      lua_rawget(L, index);
      const int times = top + 1, values = top + 2;
      for (int i = 1; lua_istable(L, values) && i <= static_cast<int>(lua_rawlen(L, times)); ++i) {
        const std::string row = "row " + std::to_string(i) + ": the ";
        lua_rawgeti(L, times, i);
        lua_rawgeti(L, values, i);
        rows.push_back({number(values + 1, row + "time"), number(values + 2, row + "value")});
        lua_settop(L, values);
      }
    }
  } else {
    for (int i = 1; i <= static_cast<int>(lua_rawlen(L, index)); ++i) {
      const std::string row = "row " + std::to_string(i);
      lua_rawgeti(L, index, i);
      if (!lua_istable(L, -1) || lua_rawlen(L, -1) != 2) {
        complaint = "is a table, but not one in time: " + row + " is not { time, value }";
        break;
      }
      const int pair = lua_gettop(L);
      lua_rawgeti(L, pair, 1);
      lua_rawgeti(L, pair, 2);
      rows.push_back({number(pair + 1, row + ": the time"), number(pair + 2, row + ": the value")});
      lua_settop(L, top);
    }
  }
  lua_settop(L, top);
  if (rows.empty() && complaint.empty()) complaint = "is an empty table; expected rows { {0*days, value}, ... }";
  return rows;
}

}  // namespace ashlar
