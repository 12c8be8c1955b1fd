#include "solve/support.hpp"

#include <gtest/gtest.h>

#include "solve/static_case.hpp"
#include "support/brick.hpp"

namespace ashlar {
namespace {

using test::StaticCase;

/// A row of `cells` cubes along x; those from x = 1 on are frictional blocks, each by itself.
Model row(int cells) {
  Model model;
  model.mesh = brick({cells, 1, 1}, [=](const Vec3<double>& p) { return Vec3<double>{cells * p.x, p.y, p.z}; });
  Material stone;
  stone.regions = {"body"};
  stone.values = {{"young", 1e9}, {"poisson", 0.2}};
  model.materials = {stone};
  model.interfaces = {{"gaps", {}, true, {"body"}, "frictional", {{"friction", 0.5}}}};
  return model;
}

/// Moves every block along x by `step` times its number.
void spread(StaticCase& blocks, double step) {
  const Problem& p = blocks.problem();
  std::vector<double> u(3 * p.blocks.node_count());
  for (int e = 0; e < p.model.mesh.element_count(); ++e)
    for (int c = p.model.mesh.first_corner[e]; c < p.model.mesh.first_corner[e + 1]; ++c)
      u[3 * p.blocks.corners[c]] = step * e;
  p.backend->write(Field::displacement, p.to_machine(u, 3));
}

std::vector<FreeBody> free_of(StaticCase& blocks) {
  blocks.problem().backend->loosened_springs();
  return free_bodies(blocks.problem());
}

TEST(free_bodies, blocks_in_touch_with_a_held_one_are_held) {
  const auto model = row(3);
  StaticCase blocks(model, {});
  blocks.fix("left", 7);
  EXPECT_TRUE(free_of(blocks).empty());
}

TEST(free_bodies, blocks_apart_float_one_by_one) {
  const auto model = row(3);
  StaticCase blocks(model, {});
  blocks.fix("left", 7);
  spread(blocks, 1e-6);
  const auto free = free_of(blocks);
  ASSERT_EQ(free.size(), 2u);
  EXPECT_EQ(free[0].blocks, std::vector<int>{1});
  EXPECT_EQ(free[1].blocks, std::vector<int>{2});
  EXPECT_EQ(free[0].nodes.size(), 8u);
}

TEST(free_bodies, rollers_that_leave_a_movement_free_do_not_hold) {
  const auto model = row(2);
  StaticCase blocks(model, {});
  for (const auto& [surface, component] : {std::pair{"front", 2}, std::pair{"back", 2}}) blocks.fix(surface, component);
  ASSERT_EQ(free_of(blocks).size(), 1u);
  EXPECT_EQ(free_of(blocks)[0].blocks, (std::vector<int>{0, 1}));
  blocks.fix("bottom", 4);
  EXPECT_EQ(free_of(blocks).size(), 1u);  // still slides along x
  blocks.fix("left", 1);
  EXPECT_TRUE(free_of(blocks).empty());
}

TEST(free_bodies, their_supports_stop_all_six_movements_and_no_more) {
  const auto model = row(2);
  StaticCase blocks(model, {});
  blocks.fix("left", 7);
  spread(blocks, 1e-6);
  auto free = free_of(blocks);
  ASSERT_EQ(free.size(), 1u);
  EXPECT_EQ(free[0].supports.size(), 6u);
  auto fixed = blocks.problem().backend->read(Field::fixed);
  for (const int component : free[0].supports)
    fixed[component / 3] = static_cast<int>(fixed[component / 3]) | 1 << component % 3;
  blocks.problem().backend->write(Field::fixed, fixed);
  EXPECT_TRUE(free_of(blocks).empty());
}

}  // namespace
}  // namespace ashlar
