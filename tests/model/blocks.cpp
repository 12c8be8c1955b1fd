#include "model/blocks.hpp"

#include <gtest/gtest.h>

#include <set>

#include "model/grid.hpp"

namespace ashlar {
namespace {

using test::grid;
using test::interface_of;

Blocks split(const Model& model) { return split_blocks(model, find_faces(model.mesh)); }

TEST(split_blocks, without_interfaces_block_nodes_are_the_mesh_nodes) {
  Model model;
  model.mesh = grid(3, 2, 2);
  const auto blocks = split(model);
  EXPECT_EQ(blocks.corners, model.mesh.corners);
  EXPECT_EQ(blocks.block_count, 1);
  EXPECT_TRUE(blocks.faces.empty());
}

TEST(split_blocks, a_crackable_region_gives_every_element_its_own_nodes) {
  Model model;
  model.mesh = grid(3, 2, 2);
  model.interfaces = {interface_of(true, {"body"})};
  const auto blocks = split(model);
  EXPECT_EQ(blocks.node_count(), 8 * 12);
  EXPECT_EQ(std::set<int>(blocks.corners.begin(), blocks.corners.end()).size(), 8u * 12);
  EXPECT_EQ(blocks.block_count, 12);
  EXPECT_EQ(blocks.faces.size(), find_faces(model.mesh).inner.size());
}

TEST(split_blocks, copies_keep_their_mesh_node_and_are_numbered_in_mesh_node_order) {
  Model model;
  model.mesh = grid(2, 2, 2);
  model.interfaces = {interface_of(true, {"body"})};
  const auto blocks = split(model);
  for (std::size_t c = 0; c < blocks.corners.size(); ++c)
    EXPECT_EQ(blocks.mesh_node[blocks.corners[c]], model.mesh.corners[c]);
  EXPECT_TRUE(std::is_sorted(blocks.mesh_node.begin(), blocks.mesh_node.end()));
  for (int n = 0; n < model.mesh.node_count(); ++n)
    for (int copy = blocks.first_copy[n]; copy < blocks.first_copy[n + 1]; ++copy) EXPECT_EQ(blocks.mesh_node[copy], n);
  EXPECT_EQ(blocks.first_copy.back(), blocks.node_count());
}

TEST(split_blocks, a_joint_splits_only_the_nodes_of_its_faces) {
  Model model;
  model.mesh = grid(4, 1, 1, {"left", "left", "right", "right"});
  model.interfaces = {interface_of(false, {"left", "right"})};
  const auto blocks = split(model);
  EXPECT_EQ(blocks.node_count(), model.mesh.node_count() + 4);
  EXPECT_EQ(blocks.block_of_element, (std::vector<int>{0, 0, 1, 1}));
  ASSERT_EQ(blocks.faces.size(), 1u);
  EXPECT_EQ(blocks.faces[0].a.element, 1);
  EXPECT_EQ(blocks.faces[0].b.element, 2);
}

TEST(split_blocks, a_joint_that_ends_inside_the_body_leaves_its_tip_whole) {
  // Seen from above: regions a | b side by side on top of c, which continues under both.
  Model model;
  model.mesh = grid(2, 1, 2, {"c", "c", "a", "b"});
  model.interfaces = {interface_of(false, {"a", "b"})};
  const auto blocks = split(model);
  EXPECT_EQ(blocks.block_count, 1);
  EXPECT_EQ(blocks.node_count(),
            model.mesh.node_count() + 2);  // the two top nodes of the face; its bottom edge is the tip
}

TEST(split_blocks, a_joint_takes_precedence_over_crackable_regions_beside_it) {
  Model model;
  model.mesh = grid(3, 1, 1, {"rock", "dam", "dam"});
  model.interfaces = {interface_of(true, {"dam"}), interface_of(false, {"rock", "dam"})};
  const auto blocks = split(model);
  ASSERT_EQ(blocks.faces.size(), 2u);
  EXPECT_EQ(blocks.faces[0].interface, 1);
  EXPECT_EQ(blocks.faces[1].interface, 0);
}

TEST(split_blocks, the_one_crackable_beside_a_plain_region_holds_on_their_common_face) {
  Model model;
  model.mesh = grid(3, 1, 1, {"rock", "dam", "dam"});
  model.interfaces = {interface_of(true, {"dam"})};
  const auto blocks = split(model);
  ASSERT_EQ(blocks.faces.size(), 2u);
  EXPECT_EQ(blocks.block_count, 3);
}

TEST(split_blocks, crackables_that_meet_without_a_joint_are_both_named) {
  Model model;
  model.mesh = grid(2, 1, 1, {"rock", "dam"});
  model.interfaces = {interface_of(true, {"dam"}), interface_of(true, {"rock"})};
  model.interfaces[0].name = "body", model.interfaces[1].name = "ground";
  model.interfaces[1].where = {"dam.lua", 12};
  try {
    split(model);
    FAIL();
  } catch (const DeckError& error) {
    EXPECT_STREQ(error.what(),
                 "dam.lua:12: crackable 'ground' meets crackable 'body' and nothing says which law holds between them: "
                 "add joint { between = { 'rock', 'dam' }, ... }");
  }
}

TEST(split_blocks, a_joint_without_common_faces_is_refused) {
  Model model;
  model.mesh = grid(3, 1, 1, {"a", "b", "c"});
  model.interfaces = {interface_of(false, {"a", "c"})};
  model.interfaces[0].where = {"dam.lua", 5};
  try {
    split(model);
    FAIL();
  } catch (const DeckError& error) {
    EXPECT_STREQ(error.what(),
                 "dam.lua:5: joint 'seam': regions 'a' and 'c' share no face: a gap of 1 m along x lies between them; "
                 "let them touch");
  }
}

TEST(split_blocks, unknown_regions_and_double_claims_are_all_reported) {
  Model model;
  model.mesh = grid(2, 1, 1, {"a", "b"});
  model.interfaces = {interface_of(false, {"a", "b"}), interface_of(false, {"b", "a"}), interface_of(true, {"q"})};
  model.interfaces[1].name = "second";
  try {
    split(model);
    FAIL();
  } catch (const DeckError& error) {
    ASSERT_EQ(error.lines().size(), 2u);
    EXPECT_EQ(error.lines()[0], "joint 'second': joint 'seam' already takes the faces between 'a' and 'b'");
    EXPECT_EQ(error.lines()[1], "crackable 'body': no region 'q'; there are: a, b");
  }
}

}  // namespace
}  // namespace ashlar
