#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "model/blocks.hpp"
#include "model/grid.hpp"

namespace ashlar {
namespace {

using test::elastic;
using test::grid;
using test::interface_of;

struct Placed {
  Blocks blocks;
  ContactPoints contacts;
};
Placed place(const Model& model) {
  Placed placed{split_blocks(model, find_faces(model.mesh)), {}};
  placed.contacts = place_contacts(model, placed.blocks);
  return placed;
}

Model jointed_pair() {
  Model model;
  model.mesh = grid(2, 1, 1, {"a", "b"});
  model.materials = {elastic({"a"}, 30e9, 0.2), elastic({"b"}, 20e9, 0.2)};
  model.interfaces = {interface_of(false, {"a", "b"})};
  return model;
}

TEST(place_contacts, joins_coincident_corners_of_the_two_sides) {
  const auto model = jointed_pair();
  const auto [blocks, contacts] = place(model);
  ASSERT_EQ(contacts.count(), 4);
  for (int c = 0; c < 4; ++c) {
    EXPECT_NE(contacts.node_a[c], contacts.node_b[c]);
    EXPECT_EQ(blocks.mesh_node[contacts.node_a[c]], blocks.mesh_node[contacts.node_b[c]]);
    EXPECT_EQ(contacts.normal[c].x, 1);
    EXPECT_DOUBLE_EQ(contacts.area[c], 0.25);
  }
}

TEST(place_contacts, normals_point_from_a_to_b_everywhere) {
  Model model;
  model.mesh = grid(3, 2, 2);
  model.materials = {elastic({"body"}, 20e9, 0.2)};
  model.interfaces = {interface_of(true, {"body"})};
  const auto [blocks, contacts] = place(model);
  for (int c = 0; c < contacts.count(); ++c) {
    const auto& face = blocks.faces[contacts.face[c]];
    const auto ab = model.mesh.centroid(face.b.element) - model.mesh.centroid(face.a.element);
    EXPECT_NEAR(dot(contacts.normal[c], ab), 1, 1e-14);
  }
}

TEST(place_contacts, areas_sum_to_the_area_of_a_distorted_face_and_weigh_its_centroid) {
  auto model = jointed_pair();
  for (int n = 0; n < model.mesh.node_count(); ++n)  // planar, but not a parallelogram
    if (model.mesh.points[n].x == 1) model.mesh.points[n].y *= model.mesh.points[n].z == 1 ? 3 : 1;
  const auto [blocks, contacts] = place(model);
  double area = 0, moment = 0;
  for (int c = 0; c < 4; ++c) {
    area += contacts.area[c];
    moment += contacts.area[c] * model.mesh.points[blocks.mesh_node[contacts.node_a[c]]].z;
  }
  EXPECT_NEAR(area, 2, 1e-14);          // trapezium: (1 + 3) / 2
  EXPECT_NEAR(moment, 7.0 / 6, 1e-14);  // integral of z (1 + 2 z) over 0..1
}

TEST(place_contacts, triangles_share_their_area_in_exact_thirds) {
  Model model;
  model.mesh.points = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 1}, {0, 0, -1}};
  model.mesh.region_names = {"a", "b"};
  model.mesh.add_element(Shape::tet4, std::vector{0, 1, 2, 3}, 0, 1);
  model.mesh.add_element(Shape::tet4, std::vector{0, 2, 1, 4}, 1, 2);
  model.materials = {elastic({"a", "b"}, 1e9, 0)};
  model.interfaces = {interface_of(false, {"a", "b"})};
  const auto [blocks, contacts] = place(model);
  ASSERT_EQ(contacts.count(), 3);
  for (int c = 0; c < 3; ++c) EXPECT_DOUBLE_EQ(contacts.area[c], 1);
  EXPECT_DOUBLE_EQ(contacts.normal_stiffness[0], 100 * 1e9 / (1.0 / 3));  // volume 1, area 3 on both sides
}

TEST(place_contacts, default_stiffness_is_a_hundred_times_that_of_the_weaker_element) {
  auto model = jointed_pair();
  for (auto& p : model.mesh.points) p.x *= 0.5;
  const auto contacts = place(model).contacts;
  const double shear = 20e9 / 2.4, oedometric = 20e9 * 0.8 / (1.2 * 0.6);
  for (int c = 0; c < 4; ++c) {
    EXPECT_NEAR(contacts.normal_stiffness[c], 100 * oedometric / 0.5, 1e-12 * contacts.normal_stiffness[c]);
    EXPECT_NEAR(contacts.shear_stiffness[c], 100 * shear / 0.5, 1e-12 * contacts.shear_stiffness[c]);
  }
}

TEST(place_contacts, given_stiffness_wins) {
  auto model = jointed_pair();
  model.interfaces[0].values = {{"normal_stiffness", 3e11}, {"shear_stiffness", 1e11}};
  const auto contacts = place(model).contacts;
  EXPECT_EQ(contacts.normal_stiffness[0], 3e11);
  EXPECT_EQ(contacts.shear_stiffness[0], 1e11);
}

TEST(place_contacts, a_region_without_material_is_named) {
  auto model = jointed_pair();
  model.materials.pop_back();
  try {
    place(model);
    FAIL();
  } catch (const DeckError& error) {
    EXPECT_STREQ(
        error.what(),
        "joint 'seam': no stiffness, because region 'b' has no material: give it one, or give normal_stiffness and "
        "shear_stiffness");
  }
}

}  // namespace
}  // namespace ashlar
