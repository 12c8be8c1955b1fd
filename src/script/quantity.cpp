#include "script/quantity.hpp"

#include <cmath>
#include <cstdio>
#include <numbers>

#include "script/sandbox.hpp"

namespace ashlar {
namespace {

constexpr const char* type_name = "ashlar quantity";

/// Throws where an exponent is beyond any quantity's, before sums of exponents leave the integers.
void check_exponent(double exponent) {
  constexpr double largest = 100;
  if (!(std::abs(exponent) <= largest)) throw ScriptError("a power of a unit beyond " + decimal_text(largest));
}

Dimension power(const Dimension& d, int n) { return {d.m * n, d.kg * n, d.s * n, d.K * n}; }
Dimension product(const Dimension& a, const Dimension& b) { return {a.m + b.m, a.kg + b.kg, a.s + b.s, a.K + b.K}; }

struct Named {
  Dimension dimension;
  const char* symbol;
  const char* advice;
};
const Named named[] = {
    {dimension::length, "m", "a length, such as 2*m"},
    {dimension::area, "m^2", "an area, such as 2*m^2"},
    {dimension::time, "s", "a time, such as 100*days"},
    {dimension::temperature, "K", "a temperature, such as 15*degC"},
    {dimension::pressure, "Pa", "a pressure or modulus, such as 30*GPa"},
    {dimension::density, "kg/m^3", "a density, such as 2400*kg/m^3"},
    {dimension::acceleration, "m/s^2", "an acceleration, such as 9.81*m/s^2"},
    {dimension::force, "N", "a force, such as 5*kN"},
    {dimension::stiffness_per_area, "Pa/m", "a stiffness per area (100*GPa/m) or a unit weight (26*kN/m^3)"},
    {dimension::fracture_energy, "J/m^2", "a fracture energy, such as 400*J/m^2"},
    {dimension::conductivity, "W/(m*K)", "a conductivity, such as 2.6*W/(m*K)"},
    {dimension::film, "W/(m^2*K)", "a film coefficient, such as 15*W/(m^2*K)"},
    {dimension::heat_flux, "W/m^2", "a heat flux, such as 20*W/m^2"},
    {dimension::heat_source, "W/m^3", "heat per volume and time, such as 300*W/m^3"},
    {dimension::heat_capacity, "J/(kg*K)", "a heat capacity, such as 960*J/(kg*K)"},
    {dimension::expansion, "1/K", "an expansion coefficient, such as 9e-6/K"},
    {Dimension{2, 1, -2, 0}, "J", "an energy or a moment, such as 1*kN*m"},
    {Dimension{2, 1, -3, 0}, "W", "a power, such as 1*kW"},
    {Dimension{0, 1, 0, 0}, "kg", "a mass, such as 1*t"},
    {Dimension{1, 0, -1, 0}, "m/s", "a velocity, such as 1*m/s"},
    {Dimension{3, 0, 0, 0}, "m^3", "a volume, such as 1*m^3"},
};

std::string operand_text(lua_State* L, int index, const std::optional<Quantity>& q) {
  return q ? quantity_text(*q) : std::string("a ") + luaL_typename(L, index);
}

enum class Operation { add, subtract, multiply, divide, power };

[[noreturn]] void refuse(lua_State* L, const char* what, const std::optional<Quantity>& a,
                         const std::optional<Quantity>& b, const char* why) {
  throw ScriptError(std::string("cannot ") + what + " " + operand_text(L, 1, a) + " and " + operand_text(L, 2, b) +
                    why);
}

/// Bare numbers are SI, so they may be added to and compared with anything.
Quantity aligned(lua_State* L, const char* what, const std::optional<Quantity>& a, const std::optional<Quantity>& b) {
  if (!a || !b) refuse(L, what, a, b, "");
  if (a->dimension && b->dimension && *a->dimension != *b->dimension)
    refuse(L, what, a, b, ": their dimensions differ");
  return {0, a->dimension ? a->dimension : b->dimension, a->celsius || b->celsius};
}

template <Operation operation>
int arithmetic(lua_State* L) {
  auto a = to_quantity(L, 1), b = to_quantity(L, 2);
  Quantity result;
  if constexpr (operation == Operation::add || operation == Operation::subtract) {
    result = aligned(L, operation == Operation::add ? "add" : "subtract", a, b);
    result.value = operation == Operation::add ? a->value + b->value : a->value - b->value;
  } else if constexpr (operation == Operation::power) {
    if (!a || !b || b->dimension) refuse(L, "raise to a power:", a, b, "");
    const Dimension d = a->dimension.value_or(Dimension{});
    const double exponents[] = {d.m * b->value, d.kg * b->value, d.s * b->value, d.K * b->value};
    for (double e : exponents) {
      check_exponent(e);
      if (e != std::round(e))
        throw ScriptError("a power of " + quantity_text(*a) + " that leaves a fraction of a unit");
    }
    result.value = std::pow(a->value, b->value);
    result.dimension = Dimension{int(exponents[0]), int(exponents[1]), int(exponents[2]), int(exponents[3])};
  } else {
    constexpr bool divide = operation == Operation::divide;
    if (!a || !b) refuse(L, divide ? "divide" : "multiply", a, b, "");
    result.value = divide ? a->value / b->value : a->value * b->value;
    result.dimension =
        product(a->dimension.value_or(Dimension{}), power(b->dimension.value_or(Dimension{}), divide ? -1 : 1));
    for (const int e : {result.dimension->m, result.dimension->kg, result.dimension->s, result.dimension->K})
      check_exponent(e);
    result.celsius = (a->celsius && !b->dimension) || (b->celsius && !a->dimension && !divide);
  }
  push_quantity(L, result);
  return 1;
}

int negate(lua_State* L) {
  Quantity q = *to_quantity(L, 1);
  q.value = -q.value;
  push_quantity(L, q);
  return 1;
}

template <int relation>
int compare(lua_State* L) {
  auto a = to_quantity(L, 1), b = to_quantity(L, 2);
  aligned(L, "compare", a, b);
  lua_pushboolean(L, relation == 0 ? a->value == b->value : relation < 0 ? a->value < b->value : a->value <= b->value);
  return 1;
}

int text(lua_State* L) {
  push(L, quantity_text(*to_quantity(L, 1)));
  return 1;
}

}  // namespace

const std::vector<Unit>& units() {
  constexpr Dimension mass{0, 1, 0, 0}, energy{2, 1, -2, 0}, power{2, 1, -3, 0};
  static const std::vector<Unit> all = {
      {"mm", 1e-3, dimension::length, "millimetre"},
      {"cm", 1e-2, dimension::length, "centimetre"},
      {"m", 1, dimension::length, "metre"},
      {"km", 1e3, dimension::length, "kilometre"},
      {"kg", 1, mass, "kilogram"},
      {"t", 1e3, mass, "tonne, 1000 kg"},
      {"s", 1, dimension::time, "second"},
      {"minute", 60, dimension::time, "60 s"},
      {"minutes", 60, dimension::time, "60 s"},
      {"hour", 3600, dimension::time, "3600 s"},
      {"hours", 3600, dimension::time, "3600 s"},
      {"day", 86400, dimension::time, "86400 s"},
      {"days", 86400, dimension::time, "86400 s"},
      {"year", 365.25 * 86400, dimension::time, "365.25 days"},
      {"years", 365.25 * 86400, dimension::time, "365.25 days"},
      {"N", 1, dimension::force, "newton"},
      {"kN", 1e3, dimension::force, "1000 N"},
      {"MN", 1e6, dimension::force, "1e6 N"},
      {"GN", 1e9, dimension::force, "1e9 N"},
      {"Pa", 1, dimension::pressure, "pascal"},
      {"kPa", 1e3, dimension::pressure, "1000 Pa"},
      {"MPa", 1e6, dimension::pressure, "1e6 Pa"},
      {"GPa", 1e9, dimension::pressure, "1e9 Pa"},
      {"J", 1, energy, "joule"},
      {"kJ", 1e3, energy, "1000 J"},
      {"W", 1, power, "watt"},
      {"kW", 1e3, power, "1000 W"},
      {"K", 1, dimension::temperature, "kelvin, in units such as W/(m*K)"},
      {"degC", 1, dimension::temperature, "degree Celsius: every temperature of a deck"},
      {"rad", 1, dimension::none, "radian"},
      {"deg", std::numbers::pi / 180, dimension::none, "degree of angle"},
      {"percent", 0.01, dimension::none, "one hundredth"},
  };
  return all;
}

std::string unit_symbol(const Dimension& dimension, bool temperature) {
  if (dimension == Dimension{}) return "";
  if (temperature && dimension == dimension::temperature) return "degC";
  for (const auto& n : named)
    if (n.dimension == dimension) return n.symbol;
  std::string symbol;
  const std::pair<const char*, int> parts[] = {
      {"kg", dimension.kg}, {"m", dimension.m}, {"s", dimension.s}, {"K", dimension.K}};
  for (auto [name, exponent] : parts) {
    if (exponent == 0) continue;
    symbol += (symbol.empty() ? "" : "*") + std::string(name);
    if (exponent != 1) symbol += "^" + std::to_string(exponent);
  }
  return symbol;
}

std::string dimension_advice(const Dimension& dimension) {
  for (const auto& n : named)
    if (n.dimension == dimension) return n.advice;
  return dimension == Dimension{} ? "a plain number" : "a value in " + unit_symbol(dimension);
}

std::string decimal_text(double value) {
  if (std::isnan(value)) return "nan";
  char buffer[40];
  for (int digits = 6; digits <= 17; ++digits) {
    std::snprintf(buffer, sizeof buffer, "%.*g", digits, value);
    if (std::abs(std::strtod(buffer, nullptr) - value) <= 1e-12 * std::abs(value)) break;
  }
  return buffer;
}

std::string quantity_text(const Quantity& q) {
  if (!q.dimension || *q.dimension == Dimension{}) return decimal_text(q.value);
  Unit best{unit_symbol(*q.dimension, q.celsius), 1, {}, ""};
  if (*q.dimension == dimension::pressure || *q.dimension == dimension::force)
    for (const auto& unit : units())
      if (unit.dimension == *q.dimension && unit.scale > best.scale && std::abs(q.value) >= unit.scale) best = unit;
  return decimal_text(q.value / best.scale) + " " + best.name;
}

std::optional<Quantity> to_quantity(lua_State* L, int index) {
  if (lua_type(L, index) == LUA_TNUMBER) return Quantity{lua_tonumber(L, index), {}, false};
  if (void* held = luaL_testudata(L, index, type_name)) return *static_cast<Quantity*>(held);
  return std::nullopt;
}

void push_quantity(lua_State* L, const Quantity& quantity) {
  if (!quantity.dimension || *quantity.dimension == Dimension{}) return lua_pushnumber(L, quantity.value);
  static_assert(std::is_trivially_destructible_v<Quantity>);
  new (lua_newuserdatauv(L, sizeof(Quantity), 0)) Quantity(quantity);
  luaL_setmetatable(L, type_name);
}

void open_units(lua_State* L) {
  luaL_newmetatable(L, type_name);
  const std::pair<const char*, lua_CFunction> methods[] = {{"__add", guarded<arithmetic<Operation::add>>},
                                                           {"__sub", guarded<arithmetic<Operation::subtract>>},
                                                           {"__mul", guarded<arithmetic<Operation::multiply>>},
                                                           {"__div", guarded<arithmetic<Operation::divide>>},
                                                           {"__pow", guarded<arithmetic<Operation::power>>},
                                                           {"__unm", guarded<negate>},
                                                           {"__eq", guarded<compare<0>>},
                                                           {"__lt", guarded<compare<-1>>},
                                                           {"__le", guarded<compare<1>>},
                                                           {"__tostring", guarded<text>}};
  for (auto [name, function] : methods) {
    lua_pushcfunction(L, function);
    lua_setfield(L, -2, name);
  }
  lua_pushliteral(L, "quantity");
  lua_setfield(L, -2, "__metatable");
  lua_pop(L, 1);
  for (const auto& unit : units()) {
    push_quantity(L, {unit.scale, unit.dimension, unit.name == "degC"});
    lua_setfield(L, -2, unit.name.c_str());
  }
}

}  // namespace ashlar
