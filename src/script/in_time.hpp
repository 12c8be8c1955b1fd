#pragma once
#include <array>
#include <string>
#include <vector>

#include "script/quantity.hpp"
#include "script/sandbox.hpp"

/// Values in time as decks write them: rows { time, value }, a table read from a file, or a function.
namespace ashlar {

/// Adds in_time and in_stage to the table at the top of the stack.
void open_in_time(lua_State* L);
/// Whether the value was made by in_time or in_stage; what it holds is its first user value, a table or a function.
bool is_in_time(lua_State* L, int index);
bool counts_from_stage(lua_State* L, int index);
/// Times and values of a table of rows { {time, value}, ... } or of columns { time = {...}, ... } with one beside time.
/// Leaves nothing on the stack; `complaint` says what is wrong with it.
std::vector<std::array<Quantity, 2>> rows_in_time(lua_State* L, int index, std::string& complaint);

}  // namespace ashlar
