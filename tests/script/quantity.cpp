#include "script/quantity.hpp"

#include "script/deck_text.hpp"

namespace ashlar {
namespace {

using test::complaint;

/// Runs assertions of a deck.
void holds(const std::string& statement) { EXPECT_EQ(complaint("assert(" + statement + ")"), "") << statement; }

TEST(Quantity, UnitsCarryDimensionThroughArithmetic) {
  holds("3*MPa + 2*kPa == 3.002*MPa");
  holds("2*m * 3*m == 6*m^2");
  holds("10*kN / (2*m^2) == 5*kPa");
  holds("2400*kg/m^3 * 9.81*m/s^2 * 10*m == 235440*Pa");
  holds("(4*m^2)^0.5 == 2*m");
  holds("-(2*m) < 1*mm and 1*m <= 100*cm");
  holds("W*s == J and N*m == J and 1*t == 1000*kg");
  holds("math.abs(100*days - 8640000*s) < 1e-6*s");
}

TEST(Quantity, WhatHasNoDimensionIsAPlainNumber) {
  holds("type(6*m / (2*m)) == 'number' and 6*m / (2*m) == 3");
  holds("math.abs(math.sin(30*deg) - 0.5) < 1e-15");
  holds("30*percent == 0.3");
}

TEST(Quantity, BareNumbersAreSI) {
  holds("2*m + 1 == 3*m");
  holds("math.max(2*m, 5) == 5");
}

TEST(Quantity, DifferentDimensionsDoNotAddOrCompare) {
  EXPECT_EQ(complaint("local a = 3*MPa\nlocal b = a + 2*m"),
            "deck.lua:2: cannot add 3 MPa and 2 m: their dimensions differ");
  EXPECT_EQ(complaint("local a = 3*s < 2*m"), "deck.lua:1: cannot compare 3 s and 2 m: their dimensions differ");
  EXPECT_EQ(complaint("local a = m^0.5"), "deck.lua:1: a power of 1 m that leaves a fraction of a unit");
  EXPECT_EQ(complaint("local a = 3*m + 'x'"), "deck.lua:1: cannot add 3 m and a string");
}

TEST(Quantity, MessagesShowSuitableUnits) {
  EXPECT_EQ(quantity_text({30e9, dimension::pressure}), "30 GPa");
  EXPECT_EQ(quantity_text({250, dimension::pressure}), "250 Pa");
  EXPECT_EQ(quantity_text({12.5, dimension::temperature, true}), "12.5 degC");
  EXPECT_EQ(quantity_text({1, Dimension{1, 2, -3, 0}}), "1 kg^2*m*s^-3");
  EXPECT_EQ(decimal_text(0.1 * 3), "0.3");
}

}  // namespace
}  // namespace ashlar
