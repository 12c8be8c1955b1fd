#include <gtest/gtest.h>

#include <regex>

#include "backend/machine_memory.hpp"
#include "solve/solver.hpp"
#include "support/brick.hpp"

namespace ashlar {
namespace {

/// A brick that hangs from its top; every cell its own block if `exploded`; then it swings.
Model hanging(int cells, bool exploded) {
  Model model;
  model.mesh = brick({cells, cells, cells}, [](const Vec3<double>& p) { return p; });
  Material rock;
  rock.name = "rock";
  rock.regions = {"body"};
  rock.density = 2500;
  rock.values = {{"young", 20e9}, {"poisson", 0.2}};
  model.materials = {rock};
  if (exploded)
    model.interfaces = {{"faces", {}, true, {"body"}, "brittle",
                         {{"normal_stiffness", 1e12}, {"shear_stiffness", 1e12}, {"tensile_strength", 1e9}, {"cohesion", 1e9}}}};
  Condition held, weight;
  held.noun = "fix";
  held.surfaces = {"top"};
  held.kind = Fix{true, true, true};
  weight.noun = "gravity";
  weight.kind = Gravity{{0, 0, -9.81}};
  model.conditions = {held, weight};
  Stage still, swing;
  still.name = "still";
  still.solve = StaticSolve{.increments = 2};
  swing.name = "swing";
  swing.solve = DynamicSolve{.duration = 1e-4, .stiffness_damping = 1e-7};
  model.stages = {still, swing};
  return model;
}

std::string refusal(const Model& model, const RunOptions& options) {
  try {
    const Problem problem(model, options);
  } catch (const ResourceError& error) {
    return error.what();
  }
  return "";
}

class Memory : public testing::TestWithParam<std::tuple<Precision, bool>> {};

TEST_P(Memory, a_run_takes_what_was_counted_before_it_began) {
  const auto [precision, exploded] = GetParam();
  const Model model = hanging(8, exploded);
  const std::size_t before = MachineMemory::bytes;
  {
    Problem problem(model, {.precision = precision, .threads = 1});
    const std::size_t counted = problem.backend->memory_bytes();
    Observer nobody;
    ASSERT_TRUE(solve(problem, nobody).all_converged());
    const std::size_t taken = MachineMemory::bytes - before;
    EXPECT_LE(taken, counted);
    // Bonded nodes have been counted as if each were a group of its own, and the way to a crack as if there were one.
    EXPECT_GT(static_cast<double>(taken), (exploded ? 0.9 : 1 - 1e-9) * static_cast<double>(counted));
  }
  EXPECT_EQ(MachineMemory::bytes, before);
}

TEST_P(Memory, a_model_that_does_not_fit_is_refused_without_taking_more_than_there_is) {
  const auto [precision, exploded] = GetParam();
  const Model model = hanging(8, exploded);
  const std::size_t before = MachineMemory::bytes;
  RunOptions options{.precision = precision, .threads = 1};
  const std::size_t needed = Problem(model, options).backend->memory_bytes();
  options.memory = needed;
  EXPECT_EQ(refusal(model, options), "");
  for (const std::size_t memory : {needed - 1, needed / 8, std::size_t{1}}) {
    options.memory = memory;
    const std::string words = refusal(model, options);
    std::smatch found;
    ASSERT_TRUE(std::regex_search(words, found,
                                  std::regex("needs .* \\((\\d+) bytes\\), .* \\((\\d+) bytes\\) are free; about (\\d+) of "
                                             "its 512 elements would fit: make them (\\S+) times as long")))
        << words;
    EXPECT_EQ(std::stoull(found[1]), needed);
    EXPECT_EQ(std::stoull(found[2]), memory);
    const double fitting = std::stod(found[3]), longer = std::stod(found[4]);
    EXPECT_LE(fitting, 512.0 * static_cast<double>(memory) / static_cast<double>(needed));
    EXPECT_LE(512 / (longer * longer * longer), fitting + 1);
    EXPECT_EQ(MachineMemory::bytes, before);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Memory,
                         testing::Combine(testing::Values(Precision::double_precision, Precision::single_precision),
                                          testing::Bool()));

}  // namespace
}  // namespace ashlar
