#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "model/blocks.hpp"
#include "model/grid.hpp"
#include "model/loads.hpp"

namespace ashlar {
namespace {

/// Two layers of unit size that meet at z = 1, n x n hex8 below and m x m hex8 or twice as many wedge6 above, meshed
/// apart. `bend` moves the nodes inside, so that faces are no parallelograms.
Model layers(int n, int m, double bend, bool wedges = false) {
  Model model;
  Mesh& mesh = model.mesh;
  mesh.region_names = {"a", "b"};
  const auto add = [&](int cells, double bottom, int region, double by) {
    const int base = mesh.node_count();
    for (int k = 0; k < 2; ++k)
      for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i) {
          const double x = double(i) / cells, y = double(j) / cells;
          const double bump = by * std::sin(std::numbers::pi * x) * std::sin(std::numbers::pi * y);
          mesh.points.push_back({x + bump, y + 0.7 * bump, bottom + k});
        }
    const auto node = [&](int i, int j, int k) { return base + (k * (cells + 1) + j) * (cells + 1) + i; };
    for (int j = 0; j < cells; ++j)
      for (int i = 0; i < cells; ++i) {
        const std::array h{node(i, j, 0), node(i + 1, j, 0), node(i + 1, j + 1, 0), node(i, j + 1, 0),
                           node(i, j, 1), node(i + 1, j, 1), node(i + 1, j + 1, 1), node(i, j + 1, 1)};
        const long id = mesh.element_count() + 1;
        if (!wedges || region == 0) {
          mesh.add_element(Shape::hex8, h, region, id);
        } else {
          mesh.add_element(Shape::wedge6, std::array{h[0], h[1], h[2], h[4], h[5], h[6]}, region, id);
          mesh.add_element(Shape::wedge6, std::array{h[0], h[2], h[3], h[4], h[6], h[7]}, region, id + 1);
        }
      }
  };
  add(n, 0, 0, bend);
  add(m, 1, 1, -bend);
  model.materials = {test::elastic({"a", "b"}, 30e9, 0.2)};
  model.interfaces = {test::interface_of(false, {"a", "b"})};
  return model;
}

struct Transfer {
  int pairs = 0, overlap_points = 0;
  double area = 0, unbalanced = 0;
  double worst = 0;  ///< of the nodal parts of a unit traction, against those of the elements' own faces
};
Transfer transfer(const Model& model) {
  const Mesh& mesh = model.mesh;
  const Blocks blocks = split_blocks(model, find_faces(mesh));
  const ContactPoints contacts = place_contacts(model, blocks);
  std::map<int, double> wanted, found;
  for (int e = 0; e < mesh.element_count(); ++e)
    for (int f = 0; f < face_count(mesh.shapes[e]); ++f) {
      const Facet facet{e, f};
      if (std::abs(mesh.facet_centroid(facet).z - 1) > 1e-9 || std::abs(mesh.facet_area(facet).z) < 1e-12) continue;
      const auto nodes = mesh.facet_nodes(facet);
      const auto of_element = mesh.element(e);
      for (const auto& point : facet_points(facet_corners(mesh, facet)))
        for (int i = 0; i < 4; ++i) {
          const int node = nodes[std::min<int>(i, static_cast<int>(nodes.size()) - 1)];
          const auto at = std::find(of_element.begin(), of_element.end(), node) - of_element.begin();
          wanted[blocks.corners[mesh.first_corner[e] + at]] += point.shape[i] * point.area.z;
        }
    }
  Transfer t{contacts.pair_count(), contacts.count() - contacts.pair_count()};
  for (int c = 0; c < contacts.count(); ++c) {
    t.area += contacts.area[c];
    contacts.each_end(c, [&](int node, double weight) {
      found[node] -= weight * contacts.area[c];
      t.unbalanced += weight * contacts.area[c];
    });
  }
  for (const auto& [node, part] : wanted) t.worst = std::max(t.worst, std::abs(found[node] / part - 1));
  return t;
}

void expect_exact(const Transfer& t, double tolerance) {
  EXPECT_NEAR(t.area, 1, 1e-12);
  EXPECT_NEAR(t.unbalanced, 0, 1e-12);
  EXPECT_LT(t.worst, tolerance);
}

TEST(overlaps, pass_a_uniform_traction_between_meshes_that_do_not_match) {
  for (const bool wedges : {false, true}) {
    const Transfer t = transfer(layers(3, 4, 0, wedges));
    EXPECT_EQ(t.pairs, 0);
    expect_exact(t, 1e-12);
  }
}

TEST(overlaps, pass_it_to_a_thousandth_between_general_quads) { expect_exact(transfer(layers(3, 4, 0.05)), 1e-3); }

TEST(overlaps, identical_faces_meshed_apart_get_the_node_pairs_of_faces_that_share_nodes) {
  const Transfer t = transfer(layers(3, 3, 0));
  EXPECT_EQ(t.pairs, 4 * 9);
  EXPECT_EQ(t.overlap_points, 0);
  expect_exact(t, 1e-12);
}

TEST(overlaps, a_joint_that_resists_heat_parts_the_nodes_of_its_sides_where_nothing_else_joins_them) {
  Model model;
  model.boxes = {{"under", {}, {0, 0, 0}, {1, 1, 1}, {2, 1, 1}},
                 {"over", {}, {0, 0, 1}, {1, 1, 2}, {2, 1, 1}},
                 {"beside", {}, {1, 0, 0}, {2, 1, 2}, {1, 1, 2}}};
  model.materials = {test::elastic({"under", "over", "beside"}, 30e9, 0.2)};
  model.interfaces = {test::interface_of(false, {"under", "over"})};
  build_mesh(model);
  EXPECT_EQ(model.mesh.node_count(), 24);
  model.interfaces[0].conductance = 5;
  build_mesh(model);
  EXPECT_EQ(model.mesh.node_count(), 28);  // those of its edge belong to the third body too
  const Blocks blocks = split_blocks(model, find_faces(model.mesh));
  EXPECT_EQ(blocks.faces.size(), 2u);
  const ContactPoints contacts = place_contacts(model, blocks);
  const std::vector<HeatLink> links = heat_links(model, blocks, contacts, {});
  EXPECT_EQ(contacts.pair_count(), 8);
  ASSERT_EQ(links.size(), 6u);
  for (const HeatLink& link : links) EXPECT_NEAR(link.conductance, 5 * 0.125, 1e-12);
  for (const HeatLink& link : heat_links(model, blocks, contacts, std::vector<double>(8, 0.8)))
    EXPECT_NEAR(link.conductance, 0.2 * 5 * 0.125, 1e-12);
}

}  // namespace
}  // namespace ashlar
