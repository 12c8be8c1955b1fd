#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/key.hpp"

struct lua_State;

/// Numbers with a dimension, as decks write them: `30*GPa`, `2400*kg/m^3`, `28.2*degC`.
namespace ashlar {

/// A number from a deck. Without `dimension` it is bare: taken as SI where a dimension is expected.
struct Quantity {
  double value = 0;  ///< SI, temperatures in degrees Celsius
  std::optional<Dimension> dimension;
  bool celsius = false;  ///< made with degC: a point on the Celsius scale or a difference
};

/// A unit constant of the deck language.
struct Unit {
  std::string name;
  double scale;
  Dimension dimension;
  std::string doc;
};
const std::vector<Unit>& units();

/// "Pa", "kg/m^3", "W/(m*K)"; "" for a plain number. `temperature`: "degC" instead of "K".
std::string unit_symbol(const Dimension& dimension, bool temperature = false);
/// "a pressure, such as 30*GPa": what to write for a dimension.
std::string dimension_advice(const Dimension& dimension);
/// Shortest decimal form that reads well in a message: "30", "0.25", "3e+10".
std::string decimal_text(double value);
/// "0.03 Pa" with the unit's symbol; bare numbers without.
std::string quantity_text(const Quantity& quantity);

/// The number or quantity at a stack index; nothing for any other type.
std::optional<Quantity> to_quantity(lua_State* L, int index);
void push_quantity(lua_State* L, const Quantity& quantity);
/// Registers the arithmetic of quantities and sets one global per unit in the table at the top of the stack.
void open_units(lua_State* L);

}  // namespace ashlar
