#include "script/lines.hpp"

#include <gtest/gtest.h>

namespace ashlar {
namespace {

TEST(DeckLines, EveryKeyOfALiteralTableHasItsOwnLine) {
  const DeckLines lines(R"(-- a comment { with = braces }
material "rock" {
  region = "rock", density = 2600,   --[[ long
  comment, young = 1 ]]
  young =
    30,
  section = { {0, 0},
              {1, 0} },
  f = function(x)
    local a, young = x == 1, { poisson = 2 }
    return a
  end, poisson = 0.2,
  ["expansion"] = [==[ text { } ]==],
}
)");
  EXPECT_EQ(lines.line(2, "material", "rock", "density"), 3);
  EXPECT_EQ(lines.line(2, "material", "rock", "young"), 5);
  EXPECT_EQ(lines.line(2, "material", "rock", "section.2"), 8);
  EXPECT_EQ(lines.line(2, "material", "rock", "section.2.1"), 8);
  EXPECT_EQ(lines.line(2, "material", "rock", "poisson"), 12);
  EXPECT_EQ(lines.line(2, "material", "rock", "expansion"), 13);
  EXPECT_EQ(lines.line(2, "material", "rock", "unheard_of"), 2);
}

TEST(DeckLines, CallsInsideCallsAreToldApart) {
  const DeckLines lines(R"(stage "summer" {
  apply = {
    convection { surface = "air",
      film = 15 },
    flux({ value = 3,
      surface = "top" }),
  },
  solve = static { tolerance = 1 } }
for i = 1, 2 do
  box("box " .. i) {
    from = 1 }
end
)");
  EXPECT_EQ(lines.line(3, "convection", "", "film"), 4);
  EXPECT_EQ(lines.line(5, "flux", "", "surface"), 6);
  EXPECT_EQ(lines.line(1, "stage", "summer", "solve"), 8);
  EXPECT_EQ(lines.line(10, "box", "box 1", "from"), 11);
}

TEST(DeckLines, LocalNamesThatHideUnitsAreFoundWhereTheyAreDeclared) {
  const DeckLines lines(R"(local a, m = 1, 2  -- local W = 3
local c <const>, N = 4, 5
local function box(K) return 3 * K end
for i, t in ipairs { 1 } do local J = t end
local x = { s = 3*kg, J = "local kN" }
model "deck" { reference_temperature = function(t) return 2*s/t end }
if x then local deg = 1 end
return 2*deg
)");
  std::string found;
  for (const LocalName& local : lines.locals())
    found += local.name + std::to_string(local.line) + (local.of_block ? "b" : "") + (local.is_factor ? "f" : "") + " ";
  EXPECT_EQ(found, "a1 m1 c2 N2 box3 K3bf i4b t4b J4b x5 t6b deg7b ");
}

TEST(DeckLines, TwoCallsOnOneLineAreToldApartByName) {
  const DeckLines lines("fix \"a\" { x = 0 } fix \"b\" {\n  x = 0 }\n");
  EXPECT_EQ(lines.line(1, "fix", "a", "x"), 1);
  EXPECT_EQ(lines.line(1, "fix", "b", "x"), 2);
}

}  // namespace
}  // namespace ashlar
