#include <gtest/gtest.h>

#include "model/loose_bodies.hpp"
#include "support/brick.hpp"

namespace ashlar {
namespace {

/// A column of 1 x 1 x 4 m with one static stage; conditions as given.
Model column(std::vector<Condition> conditions) {
  Model model;
  model.mesh = brick({1, 1, 4}, Vec3<double>{1, 1, 4});
  model.materials = {
      {"concrete", {}, {"body"}, "elastic", 2400, {}, {}, {{"young", 30e9}, {"poisson", 0.2}, {"expansion", 0}}}};
  model.conditions = std::move(conditions);
  model.stages = {{"rest", {}, {}, {}, StaticSolve{}, false}};
  return model;
}

Condition fix(const std::string& surface, Fix held) { return {"fix", surface, {}, {surface}, held, {}, true}; }

std::vector<LooseBody> loose(const Model& model, int stage = 0) {
  return loose_bodies(model, split_blocks(model, find_faces(model.mesh)), stage);
}

TEST(LooseBodies, AFixedFootHoldsTheWhole) {
  EXPECT_TRUE(loose(column({fix("bottom", {true, true, true, false})})).empty());
}

TEST(LooseBodies, ThreePerpendicularRollersHold) {
  const Fix roller{false, false, false, true};
  EXPECT_TRUE(loose(column({fix("bottom", roller), fix("left", roller), fix("front", roller)})).empty());
  const auto free = loose(column({fix("bottom", roller), fix("left", roller), fix("right", roller)}));
  ASSERT_EQ(free.size(), 1u);
  EXPECT_EQ(free[0].movement, "along y");
}

TEST(LooseBodies, WithoutSupportsEverythingIsFree) {
  const auto free = loose(column({}));
  ASSERT_EQ(free.size(), 1u);
  EXPECT_EQ(free[0].movement, "in any direction");
  EXPECT_EQ(free[0].regions, std::vector<std::string>{"body"});
}

TEST(LooseBodies, GivenDisplacementsHoldToo) {
  Condition moved{"displacement", "lift", {}, {"bottom"}, Displacement{{}, {}, Value{}}, {}, true};
  const auto free = loose(column({moved, fix("left", {false, true, false, false})}));
  ASSERT_EQ(free.size(), 1u);
  EXPECT_EQ(free[0].movement, "along x");
}

TEST(LooseBodies, ASupportThatAStageRemovesHoldsNoLonger) {
  Model model = column({fix("bottom", {true, true, true, false})});
  model.stages.push_back({"lifted", {}, {}, {"bottom"}, StaticSolve{}, false});
  EXPECT_TRUE(loose(model, 0).empty());
  EXPECT_EQ(loose(model, 1).size(), 1u);
}

TEST(LooseBodies, BlocksHoldEachOtherThroughTheirInterfaces) {
  Model model = column({fix("bottom", {true, true, true, false})});
  model.interfaces = {{"cracks", {}, true, {"body"}, "brittle", {}}};
  EXPECT_EQ(split_blocks(model, find_faces(model.mesh)).block_count, 4);
  EXPECT_TRUE(loose(model).empty());
}

TEST(LooseBodies, SizeAndPlaceDoNotMatter) {
  for (const double size : {1e-3, 1e3})
    for (const double shift : {0.0, 1e4}) {
      Model model = column({fix("bottom", {true, true, true, false})});
      for (auto& p : model.mesh.points) p = {size * p.x + shift, size * p.y, size * p.z - shift};
      EXPECT_TRUE(loose(model).empty()) << size << " m, " << shift << " m away";
      model.conditions = {fix("bottom", {false, false, true, false})};
      EXPECT_EQ(loose(model).size(), 1u) << size << " m, " << shift << " m away";
    }
}

std::string complaint(const Model& model) {
  try {
    check_model(model);
    return "";
  } catch (const DeckError& error) {
    return error.what();
  }
}

TEST(CheckModel, ASoundModelPasses) { EXPECT_EQ(complaint(column({fix("bottom", {true, true, true, false})})), ""); }

TEST(CheckModel, ARegionHasExactlyOneMaterial) {
  Model model = column({fix("bottom", {true, true, true, false})});
  model.materials.push_back(model.materials[0]);
  model.materials[1].name = "rock";
  EXPECT_EQ(complaint(model), "material 'rock': region 'body' is made of material 'concrete' already");
  model.materials.clear();
  EXPECT_EQ(complaint(model), "region 'body' has no material; write material \"...\" { region = \"body\", ... }");
}

TEST(CheckModel, FractureTakesTemperaturesFromEarlierThermalStages) {
  Model model = column({fix("bottom", {true, true, true, false})});
  model.materials[0].conductivity = 2.6;
  model.conditions.push_back({"fixed_temperature", "air", {}, {"top"}, FixedTemperature{}, {}, true});
  model.stages = {{"winter", {}, {}, {}, ThermalSolve{true}, false},
                  {"cracks", {}, {}, {}, FractureSolve{"", "winter"}, false}};
  EXPECT_EQ(complaint(model), "");
  std::swap(model.stages[0], model.stages[1]);
  EXPECT_EQ(complaint(model), "stage 'cracks': stage 'winter' must come before it");
}

TEST(CheckModel, SteadyHeatNeedsATemperature) {
  Model model = column({{"flux", "sun", {}, {"top"}, Flux{Value{20}}, {}, true}});
  model.materials[0].conductivity = 2.6;
  model.stages = {{"summer", {}, {}, {}, ThermalSolve{true}, false}};
  EXPECT_EQ(complaint(model), "stage 'summer': a steady state needs a fixed_temperature or a convection");
}

TEST(CheckModel, AHistoryPointLiesInTheBody) {
  Model model = column({fix("bottom", {true, true, true, false})});
  model.histories = {{"tip", {}, Vec3<double>{0.5, 0.5, 4.5}, "", {"displacement"}}};
  EXPECT_EQ(complaint(model).substr(0, 54), "history 'tip': (0.5, 0.5, 4.5) is outside the body; th");
}

}  // namespace
}  // namespace ashlar
