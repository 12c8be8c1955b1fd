#include <gtest/gtest.h>

#include "cli/left_out.hpp"
#include "cli/summary.hpp"
#include "cli/wording.hpp"

namespace ashlar {
namespace {

SurfaceChoice side(const std::string& name, const std::string& where) {
  SurfaceChoice choice;
  choice.name = name;
  choice.of = {"rock"};
  choice.side = {where};
  return choice;
}

/// A cube of rock with its upper and its upstream face as surfaces.
Model cube() {
  Model model;
  model.boxes.push_back({.name = "rock", .where = {}, .from = {0, 0, 0}, .to = {1, 1, 1}, .cells = {1, 1, 1}});
  model.surfaces = {side("face", "left"), side("floor", "top")};
  build_mesh(model);
  return model;
}

Condition water_on(std::vector<std::string> surfaces) {
  return {.noun = "water_pressure",
          .name = "",
          .where = {},
          .surfaces = std::move(surfaces),
          .kind = WaterPressure{.level = 5}};
}

bool mentions(const std::vector<std::string>& lines, const std::string& words) {
  for (const auto& line : lines)
    if (line.find(words) != std::string::npos) return true;
  return false;
}

TEST(LeftOut, WaterOnADamFaceAloneLeavesOutUpliftAndTheReservoirFloor) {
  Model model = cube();
  EXPECT_TRUE(left_out(model).empty());
  model.conditions.push_back(water_on({"face"}));
  EXPECT_TRUE(mentions(left_out(model), "uplift"));
  EXPECT_TRUE(mentions(left_out(model), "reservoir floor load"));
  model.conditions.push_back(water_on({"floor"}));
  EXPECT_FALSE(mentions(left_out(model), "reservoir floor load"));
  EXPECT_TRUE(mentions(left_out(model), "uplift"));
}

RunResult one_stage(bool converged) {
  StageResult stage;
  stage.name = "gravity";
  stage.kind = "static";
  stage.converged = converged;
  stage.stop_reason = converged ? "converged" : "step limit";
  stage.steps = 12345;
  stage.ratio = 3.2e-7;
  RunResult result;
  result.stages.push_back(stage);
  return result;
}

ExpectOutcome outcome(const std::string& name, bool passed, const std::string& message) {
  ExpectOutcome made;
  made.name = name;
  made.passed = passed;
  made.message = message;
  return made;
}

TEST(Summary, AMotionThatDoesNotKeepItsEnergySaysSo) {
  RunResult result = one_stage(true);
  result.stages[0].kind = "dynamic";
  result.stages[0].energy.drift = 1e-3;
  EXPECT_EQ(summary(cube(), result, {}).find("time_factor"), std::string::npos);
  result.stages[0].energy.drift = 0.2;
  EXPECT_NE(summary(cube(), result, {}).find("time_factor"), std::string::npos);
}

TEST(Summary, SaysWhichEndsOfStagesAreNoEquilibrium) {
  const auto says = [](const char* kind, const char* reason, double factor) {
    RunResult result = one_stage(false);
    result.stages[0].kind = kind;
    result.stages[0].stop_reason = reason;
    result.stages[0].safety_factor = factor;
    return summary(cube(), result, {}).find("NOT in balance") != std::string::npos;
  };
  EXPECT_TRUE(says("static", "step limit", 0));
  EXPECT_TRUE(says("fracture", "interrupted", 0));
  EXPECT_TRUE(says("dynamic", "runaway energy", 0));
  EXPECT_TRUE(says("strength reduction", "falls at the lowest factor", 0));
  EXPECT_FALSE(says("dynamic", "interrupted", 0));            // a motion needs no balance
  EXPECT_FALSE(says("thermal transient", "interrupted", 0));  // nor does heat on its way
  EXPECT_FALSE(says("strength reduction", "stands at the highest factor", 3));
  EXPECT_FALSE(says("static", "precision limit", 0));  // as near as the numbers go
}

TEST(ExitCode, InterruptionBeatsConvergenceBeatsExpects) {
  const std::vector<ExpectOutcome> failed{outcome("a", false, "")}, passed{outcome("a", true, "")};
  EXPECT_EQ(exit_code(one_stage(true), passed), 0);
  EXPECT_EQ(exit_code(one_stage(true), failed), 4);
  EXPECT_EQ(exit_code(one_stage(false), failed), 3);
  RunResult interrupted = one_stage(false);
  interrupted.interrupted = true;
  EXPECT_EQ(exit_code(interrupted, failed), 130);
}

TEST(Summary, NamesStopReasonCracksExpectsAndFiles) {
  const Model model = cube();
  RunResult result = one_stage(true);
  StageResult& stage = result.stages[0];
  stage.phases = {{"block_force", 3.0}, {"move_nodes", 1.0}};
  stage.events = {
      {.load_factor = 0.25, .place = {1, 2, 3}, .contact_points = 2, .interface = "base", .mode = "shear"},
      {.load_factor = 0.5, .place = {4, 5, -6}, .contact_points = 4, .interface = "body", .mode = "tension"}};
  stage.cracked_area = 12.5;
  stage.cracked_area_by_direction = {{"horizontal", 2.5}, {"vertical", 10}};
  const std::string words = summary(model, result,
                                    {.wall_seconds = 75,
                                     .expects = {outcome("stands", false, "it fell")},
                                     .folder = "dam.run",
                                     .files = {"results.xdmf"}});
  for (const char* line :
       {"1 gravity (static): converged, 12 345 steps, ratio 3.2e-07", "gravity: 2 events, 6 contact points",
        "first: load factor 0.2500, base, in shear, at (1, 2, 3) m",
        "last:  load factor 0.5000, body, in tension, at (4, 5, -6) m", "area 12.5 m^2 (horizontal 2.5, vertical 10)",
        "01:15 in all", "block_force 3.0 s (75 %)", "FAILED  stands: it fell", "dam.run/results.xdmf"})
    EXPECT_NE(words.find(line), std::string::npos) << line << "\n" << words;
}

TEST(Wording, NumbersReadAsPeopleWriteThem) {
  EXPECT_EQ(count_text(7), "7");
  EXPECT_EQ(count_text(1000), "1 000");
  EXPECT_EQ(count_text(-1234567), "-1 234 567");
  EXPECT_EQ(counted(1, "step"), "1 step");
  EXPECT_EQ(duration_text(0.25), "250 ms");
  EXPECT_EQ(duration_text(59.94), "59.9 s");
  EXPECT_EQ(duration_text(3599), "59:59");
  EXPECT_EQ(duration_text(8100), "2:15:00");
  EXPECT_EQ(place_in_metres({-1e-9, 2.5, 48}), "(0, 2.5, 48) m");
}

}  // namespace
}  // namespace ashlar
