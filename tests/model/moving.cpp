#include "model/contact/moving.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "model/grid.hpp"
#include "physics/edge_crossing.hpp"

namespace ashlar {
namespace {

/// Two unit cubes beside each other along x, of one element each.
struct Cubes {
  Model model;
  Blocks blocks;
  Discretisation discretisation;
  ContactSurface surface;
  std::vector<int> right;  ///< nodes of the second one, the machine's numbers

  Cubes() {
    model.mesh = test::grid(2, 1, 1);
    model.interfaces = {test::interface_of(true, {"body"})};
    model.interfaces[0].law = "frictional";
    model.interfaces[0].values = {{"friction", 0.5}, {"normal_stiffness", 2e9}, {"shear_stiffness", 1e9}};
    blocks = split_blocks(model, find_faces(model.mesh));
    discretisation = discretise(model.mesh, blocks, {0}, 1024);
    surface = contact_surface(model, blocks, discretisation);
    for (int k = 8; k < 16; ++k) right.push_back(discretisation.blocks.new_node[blocks.corners[k]]);
  }
  /// Candidates after the second cube has moved.
  ContactCandidates moved(const Vec3<double>& by) const {
    std::vector<Vec3<double>> places = discretisation.block_points;
    for (const int n : right) places[n] = places[n] + by;
    return find_candidates(surface, places);
  }
};

TEST(moving_contacts, probes_of_a_cube_share_the_area_of_its_faces) {
  const Cubes cubes;
  const ContactSurface& s = cubes.surface;
  EXPECT_EQ(s.probe_count(), 2 * 8 * 3);  // three faces meet at every corner
  EXPECT_EQ(s.triangle_count(), 2 * 6 * 2);
  EXPECT_NEAR(std::accumulate(s.area.begin(), s.area.end(), 0.0), 12, 1e-12);
}

TEST(moving_contacts, faces_that_touch_find_each_other_both_ways) {
  const Cubes cubes;
  const ContactSurface& s = cubes.surface;
  const ContactCandidates found = cubes.moved({});
  int near = 0;
  double area = 0;
  for (int p = 0; p < s.probe_count(); ++p) {
    if (found.first[p] == found.first[p + 1]) continue;
    ++near;
    area += found.area[found.first[p]];
    for (int j = found.first[p]; j < found.first[p + 1]; ++j)
      EXPECT_NE(s.block[found.target[j]], s.probe_block[p]) << "a block does not touch itself";
  }
  EXPECT_EQ(near, 8);
  EXPECT_NEAR(area, 1, 1e-12) << "of faces of one size each side bears half";
}

TEST(moving_contacts, a_cube_has_twelve_sharp_edges_and_they_press_with_half_of_what_corners_do) {
  const Cubes cubes;
  const ContactSurface& s = cubes.surface;
  EXPECT_EQ(s.edge_count(), 2 * 12);
  EXPECT_NEAR(std::accumulate(s.edge_area.begin(), s.edge_area.end(), 0.0), 2 * 12 * 2 * 0.5 / 4, 1e-12);
  EXPECT_EQ(std::count(s.edge_ends.begin(), s.edge_ends.end(), 1), 2 * 12 * 2) << "all edges end at corners";
}

TEST(moving_contacts, edges_of_a_bar_are_one_long_edge_each_however_it_is_meshed) {
  Model model;
  model.mesh = test::grid(4, 1, 1, {"bar", "bar", "bar", "other"});
  model.interfaces = {test::interface_of(false, {"bar", "other"})};
  model.interfaces[0].law = "frictional";
  model.interfaces[0].values = {{"friction", 0.5}, {"normal_stiffness", 2e9}, {"shear_stiffness", 1e9}};
  const Blocks blocks = split_blocks(model, find_faces(model.mesh));
  const ContactSurface s = contact_surface(model, blocks, discretise(model.mesh, blocks, {0, 0}, 1024));
  EXPECT_EQ(s.edge_count(), (4 * 3 + 8) + 12);
  EXPECT_EQ(std::set<int>(s.long_edge.begin(), s.long_edge.end()).size(), 12u + 12u);
  EXPECT_EQ(std::count(s.edge_ends.begin(), s.edge_ends.end(), 0), 4 * 2 * 2);
}

TEST(moving_contacts, the_smaller_faces_bear_all_and_nodes_inside_large_ones_nothing) {
  Model model;  // a cube on the middle of a plate of 2 x 2 faces, whose middle node lies under the cube
  model.mesh = test::grid(2, 2, 1, {"plate", "plate", "plate", "plate"});
  const Mesh cube = test::grid(1, 1, 1, {"cube"});
  const int first = static_cast<int>(model.mesh.points.size());
  model.mesh.region_names.push_back("cube");
  for (const Vec3<double>& p : cube.points)
    model.mesh.points.push_back({0.9 + 0.2 * p.x, 0.9 + 0.2 * p.y, 1 + 0.2 * p.z});
  std::vector<int> nodes;
  for (const int k : cube.corners) nodes.push_back(first + k);
  model.mesh.add_element(cube.shapes[0], nodes, 1, 5);
  model.interfaces = {test::interface_of(false, {"plate", "cube"})};
  model.interfaces[0].law = "frictional";
  model.interfaces[0].values = {{"friction", 0.5}, {"normal_stiffness", 2e9}, {"shear_stiffness", 1e9}};
  const Blocks blocks = split_blocks(model, find_faces(model.mesh));
  const Discretisation discretisation = discretise(model.mesh, blocks, {0, 0}, 1024);
  const ContactSurface s = contact_surface(model, blocks, discretisation);
  const ContactCandidates found = find_candidates(s, discretisation.block_points);
  double area = 0;
  for (int p = 0; p < s.probe_count(); ++p)
    if (found.first[p] < found.first[p + 1]) area += found.area[found.first[p]];
  EXPECT_NEAR(area, 0.2 * 0.2, 1e-12);
}

TEST(moving_contacts, what_is_further_than_the_skin_is_not_found) {
  const Cubes cubes;
  EXPECT_GT(cubes.moved({0.5 * cubes.surface.skin, 0, 0}).target.size(), 0u);
  EXPECT_EQ(cubes.moved({3 * cubes.surface.skin, 0, 0}).target.size(), 0u);
}

}  // namespace
}  // namespace ashlar
