#include <gtest/gtest.h>

#include <cstring>
#include <numbers>
#include <set>

#include "model/mesh_tools.hpp"
#include "model/mesher/lattice.hpp"
#include "model/mesher/merge_points.hpp"
#include "model/mesher/spacing.hpp"

namespace ashlar {
namespace {

using namespace testing_meshes;

Box box(const std::string& name, std::array<double, 3> from, std::array<double, 3> to, std::array<int, 3> cells,
        Shape shape) {
  return {name, {"dam.lua", 1}, from, to, cells, shape};
}

class MesherShapes : public testing::TestWithParam<Shape> {};
INSTANTIATE_TEST_SUITE_P(mesher, MesherShapes, testing::Values(Shape::hex8, Shape::wedge6, Shape::tet4),
                         [](const auto& info) { return shape_name(info.param); });

TEST_P(MesherShapes, a_box_has_its_volume_and_its_skin_has_its_area) {
  Model model;
  model.boxes = {box("bar", {1, 2, 3}, {3, 5, 7}, {2, 3, 4}, GetParam())};
  build_mesh(model);
  EXPECT_NEAR(all_volume(model.mesh), 24, 1e-12);
  EXPECT_NEAR(area(model.mesh, find_faces(model.mesh).outer), 2 * (6 + 8 + 12), 1e-12);
  EXPECT_NEAR(area(model.mesh, "bar.left"), 12, 1e-12);
  EXPECT_NEAR(area(model.mesh, "bar.back"), 8, 1e-12);
  EXPECT_NEAR(area(model.mesh, "bar.top"), 6, 1e-12);
  const int per_cell = GetParam() == Shape::hex8 ? 1 : GetParam() == Shape::wedge6 ? 2 : 6;
  EXPECT_EQ(model.mesh.element_count(), 24 * per_cell);
}

TEST_P(MesherShapes, touching_boxes_share_their_nodes_and_one_body_comes_out) {
  Model model;
  model.boxes = {box("a", {0, 0, 0}, {0.3, 1, 1}, {3, 2, 2}, GetParam()),
                 box("b", {0.3, 0, 0}, {1, 1, 1}, {2, 2, 2}, GetParam())};
  build_mesh(model);
  EXPECT_NEAR(area(model.mesh, find_faces(model.mesh).outer), 6, 1e-12);
  EXPECT_EQ(model.mesh.node_count(), 6 * 9);
  EXPECT_EQ(model.mesh.find_surface("a.right"), nullptr);
}

TEST(mesher, six_tetrahedra_of_a_box_cell_share_the_diagonal_from_first_to_last_corner) {
  Model model;
  model.boxes = {box("cell", {0, 0, 0}, {1, 1, 1}, {1, 1, 1}, Shape::tet4)};
  build_mesh(model);
  for (int e = 0; e < 6; ++e) {
    std::set<std::array<double, 3>> corners;
    for (const int n : model.mesh.element(e))
      corners.insert({model.mesh.points[n].x, model.mesh.points[n].y, model.mesh.points[n].z});
    EXPECT_TRUE(corners.count({0, 0, 0}) && corners.count({1, 1, 1}));
  }
}

TEST_P(MesherShapes, dam_on_rock_conforms_and_has_the_weights_and_skin_of_the_closed_form) {
  auto model = dam_on_rock(GetParam());
  build_mesh(model);
  // Reference cases, section 6: weights 4.18141e8 N and 3.14454e9 N at 2400 and 2650 kg/m^3, 9.81 m/s^2.
  const double section = 8 * 60 + 0.5 * 40 * 50;
  EXPECT_NEAR(region_volume(model.mesh, "dam") * 2400 * 9.81, section * 12 * 2400 * 9.81, 1e-3);
  EXPECT_NEAR(region_volume(model.mesh, "dam") * 2400 * 9.81, 4.18141e8, 1e3);
  EXPECT_NEAR(region_volume(model.mesh, "rock") * 2650 * 9.81, 3.14454e9, 1e4);
  const double perimeter = 60 + 8 + 10 + std::hypot(40, 50) + 60 + 60 + 60 + 168 + 60 + 60 - 60;
  EXPECT_NEAR(area(model.mesh, find_faces(model.mesh).outer), perimeter * 12 + 2 * (section + 168 * 60), 1e-8);
}

TEST(mesher, sizes_give_the_divisions_of_the_reference_dam) {
  auto model = dam_on_rock();
  build_mesh(model);
  // Base 48 m in 8 m, both grounds 60 m in 10 m, depth 60 m in 10 m, slope 64 m in 8 m, neck 10 m in 8 m.
  EXPECT_EQ(model.mesh.element_count(), 2 * (18 * 6 + 6 * (8 + 2)));
}

TEST(mesher, rows_are_level_and_columns_upright) {
  auto model = dam_on_rock();
  build_mesh(model);
  std::set<double> dam_levels, rock_columns;
  for (int e = 0; e < model.mesh.element_count(); ++e)
    for (const int n : model.mesh.element(e)) {
      const auto& p = model.mesh.points[n];
      if (model.mesh.regions[e] == 0) dam_levels.insert(std::round(p.z * 1e9));
      if (model.mesh.regions[e] == 1) rock_columns.insert(std::round(p.x * 1e9));
    }
  EXPECT_EQ(dam_levels.size(), 8 + 2 + 1);
  EXPECT_TRUE(dam_levels.count(50e9));
  EXPECT_EQ(rock_columns.size(), 18 + 1);
}

TEST(mesher, finer_neighbour_decides_the_divisions_of_a_shared_edge) {
  auto model = dam_on_rock();
  model.extrudes[0].size = 4;
  build_mesh(model);
  std::set<double> base;
  for (const auto& p : model.mesh.points)
    if (p.z == 0 && p.x >= 0 && p.x <= 48) base.insert(p.x);
  EXPECT_EQ(base.size(), 12 + 1);
}

TEST(mesher, rows_grow_from_the_neighbours_size_to_the_own_one) {
  auto model = dam_on_rock();
  model.extrudes[0].size = 2;
  model.extrudes[1].size = 15;
  model.extrudes[1].grow = 1.25;
  build_mesh(model);
  std::vector<double> ground;
  for (const auto& p : model.mesh.points)
    if (p.z == 0 && p.y == 0 && p.x <= 0) ground.push_back(p.x);
  std::sort(ground.rbegin(), ground.rend());
  for (std::size_t i = 0; i + 2 < ground.size(); ++i) {
    const double here = ground[i] - ground[i + 1], next = ground[i + 1] - ground[i + 2];
    EXPECT_LT(next / here, 1.29);  // 1.25, and a little more where the element across the end of the growth is even
    EXPECT_GT(next / here, 0.99);
  }
  EXPECT_NEAR(ground[0] - ground[1], 2, 0.25);
  EXPECT_LT(ground.size(), 14u);  // uniform in 2 m: 31
  EXPECT_NEAR(region_volume(model.mesh, "rock"), 168 * 60 * 12, 1e-7);
}

TEST(mesher, a_geometric_progression_is_met_exactly) {
  // 1 + 1.5 + 2.25 + 3.375: four elements.
  const Spacing spacing{8.125, 100, 1, 100, 1.5};
  EXPECT_NEAR(spacing.natural_count(), 4, 1e-12);
  const auto places = spacing.places(4);
  EXPECT_NEAR(places[1] * 8.125, 1, 1e-12);
  EXPECT_NEAR(places[2] * 8.125, 2.5, 1e-12);
  EXPECT_NEAR(places[3] * 8.125, 4.75, 1e-12);
  const auto mirrored = spacing.reversed().places(4);
  for (int k = 0; k <= 4; ++k) EXPECT_NEAR(mirrored[k], 1 - places[4 - k], 1e-12);
}

TEST(mesher, divisions_asked_are_met_also_over_a_side_of_several_pieces) {
  auto model = dam_on_rock();
  model.extrudes[0].divisions = {{1, 6}, {4, 8}};  // base, upstream face (two pieces: 50 m and 10 m)
  model.extrudes[1].divisions = {{3, 18}, {2, 5}};
  build_mesh(model);
  EXPECT_EQ(model.mesh.element_count(), 2 * (18 * 5 + 6 * 8));
}

TEST(mesher, divisions_that_contradict_each_other_are_an_error) {
  auto model = dam_on_rock();
  model.extrudes[0].divisions = {{1, 6}};
  model.extrudes[1].divisions = {{3, 7}};
  EXPECT_SAYS(complaint([&] { build_mesh(model); }),
              "dam.lua:4: extrude 'rock': divisions = 7 on side 3 cannot be met: the side has 3 pieces");
  model.extrudes[1].divisions = {{1, 10}, {3, 12}};
  EXPECT_SAYS(complaint([&] { build_mesh(model); }), "cannot be met");
}

TEST(mesher, orientation_of_the_outline_does_not_matter) {
  auto model = dam_on_rock();
  build_mesh(model);
  auto turned = dam_on_rock();
  for (auto& e : turned.extrudes) std::reverse(e.section.begin(), e.section.end());
  build_mesh(turned);
  ASSERT_EQ(turned.mesh.node_count(), model.mesh.node_count());
  for (int n = 0; n < model.mesh.node_count(); ++n)
    EXPECT_NEAR(norm(turned.mesh.points[n] - model.mesh.points[n]), 0, 1e-12);
}

TEST(mesher, two_runs_give_the_same_bytes) {
  auto first = dam_on_rock(Shape::tet4), second = dam_on_rock(Shape::tet4);
  build_mesh(first);
  build_mesh(second);
  EXPECT_EQ(first.mesh.corners, second.mesh.corners);
  EXPECT_EQ(std::memcmp(first.mesh.points.data(), second.mesh.points.data(), first.mesh.points.size() * 24), 0);
}

TEST(mesher, breaks_run_on_through_deeper_sections) {
  auto model = dam_on_rock();
  model.extrudes.push_back(extrude("deep rock", {{-60, -100}, {108, -100}, {108, -60}, {-60, -60}}, 12, 20, 5));
  build_mesh(model);
  // The columns under the dam reach the bottom of the model.
  std::set<double> columns;  // nm
  for (const auto& p : model.mesh.points)
    if (p.z == -100) columns.insert(std::round(p.x * 1e9));
  EXPECT_TRUE(columns.count(0) && columns.count(48e9));
  EXPECT_EQ(columns.size(), 18u + 1);
}

TEST(mesher, layers_agree_where_sections_stand_side_by_side) {
  Model model;
  model.extrudes = {extrude("rock", {{-10, -5}, {10, -5}, {10, 0}, {-10, 0}}, 60, 10),
                    extrude("left", {{-5, 0}, {5, 0}, {5, 5}, {-5, 5}}, 20, 4)};
  model.extrudes[1].y0 = 20;
  build_mesh(model);
  std::set<double> planes;
  for (const auto& p : model.mesh.points) planes.insert(p.y);
  EXPECT_EQ(planes, (std::set<double>{0, 10, 20, 24, 28, 32, 36, 40, 50, 60}));
  EXPECT_NEAR(all_volume(model.mesh), 20 * 5 * 60 + 10 * 5 * 20, 1e-9);
  EXPECT_NEAR(area(model.mesh, find_faces(model.mesh).outer), 2 * (20 * 60 + 5 * 60 + 20 * 5) + 2 * (5 * 20 + 10 * 5),
              1e-9);
}

TEST_P(MesherShapes, monoliths_behind_each_other_conform) {
  auto model = dam_on_rock(GetParam());
  auto behind = model.extrudes;
  for (auto& e : behind) {
    e.name += " 2";
    e.y0 = 12;
    std::rotate(e.section.begin(), e.section.begin() + 2, e.section.end());
    model.extrudes.push_back(e);
  }
  build_mesh(model);
  EXPECT_EQ(model.mesh.find_surface("dam.back"), nullptr);
  EXPECT_NEAR(area(model.mesh, "dam.front"), 8 * 60 + 0.5 * 40 * 50, 1e-9);
  EXPECT_NEAR(area(model.mesh, "dam 2.back"), 8 * 60 + 0.5 * 40 * 50, 1e-9);
}

TEST(mesher, a_sector_is_filled_between_polyline_sides) {
  Model model;
  std::vector<std::array<double, 2>> section;
  const int n = 8;
  for (int i = 0; i <= n; ++i) {
    const double a = std::numbers::pi / 2 * i / n;
    section.push_back({2 * std::cos(a), 2 * std::sin(a)});
  }
  for (int i = n; i >= 0; --i) {
    const double a = std::numbers::pi / 2 * i / n;
    section.push_back({std::cos(a), std::sin(a)});
  }
  model.extrudes = {extrude("arch", section, 1, 0.25)};
  build_mesh(model);
  // Polygon of n chords: 1/2 R^2 sin(d) each.
  EXPECT_NEAR(all_volume(model.mesh), n * 0.5 * (4 - 1) * std::sin(std::numbers::pi / 2 / n), 1e-12);
  EXPECT_GT(measure_quality(model.mesh).worst_scaled_jacobian.value, 0.9);
}

TEST(mesher, element_shapes_that_do_not_fit_together_are_an_error) {
  auto model = dam_on_rock();
  model.extrudes[1].shape = Shape::tet4;
  EXPECT_SAYS(complaint([&] { build_mesh(model); }), "give both regions the same elements");
}

TEST(mesher, bodies_that_touch_without_sharing_nodes_are_an_error) {
  Model model;
  model.boxes = {box("a", {0, 0, 0}, {1, 1, 1}, {2, 2, 2}, Shape::hex8),
                 box("b", {1, 0, 0}, {2, 1, 1}, {2, 3, 2}, Shape::hex8)};
  EXPECT_SAYS(complaint([&] { build_mesh(model); }),
              "dam.lua:1: hex8 element 2 of region 'a' at (0.75, 0.25, 0.25): touches hex8 element 1 of region 'b'");
  model.boxes[1].from[0] = 1.01;
  build_mesh(model);
  EXPECT_NEAR(all_volume(model.mesh), 1.99, 1e-12);
}

TEST(mesher, wedges_beside_hexahedra_fit_along_the_sides_of_a_section) {
  auto model = dam_on_rock();
  model.extrudes[1].shape = Shape::wedge6;
  build_mesh(model);
  EXPECT_NEAR(region_volume(model.mesh, "rock"), 168 * 60 * 12, 1e-7);
}

TEST(mesher, points_merge_across_sources_only) {
  const auto merged = merge_points({{0, 0, 0}, {1, 0, 0}, {1, 1e-12, 0}, {1, 0, 0}, {NAN, 0, 0}}, {0, 0, 1, 1, 1});
  EXPECT_EQ(merged.node, (std::vector{0, 1, 1, 1, 2}));
  EXPECT_EQ(merged.repeated, (std::vector<std::pair<int, int>>{{2, 3}}));
}

// ---------------------------------------------------------------- wrong input

std::string section_error(std::vector<std::array<double, 2>> section, std::vector<int> corners = {}) {
  Model model;
  model.extrudes = {extrude("body", std::move(section), 1, 1, 7)};
  model.extrudes[0].corners = std::move(corners);
  return complaint([&] { build_mesh(model); });
}

TEST(mesher, corners_that_make_no_logical_quad_are_refused_with_what_to_do) {
  const auto folded = section_error({{0, 0}, {9, 0}, {9, 9}, {7, 9}, {7, 2}, {0, 2}}, {1, 2, 3, 4});
  EXPECT_SAYS(folded, "folds at");
  EXPECT_SAYS(folded, "structured = false");
  EXPECT_SAYS(section_error({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {1, 2, 3}), "'corners' must name four different points");
  EXPECT_SAYS(section_error({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {1, 3, 2, 4}),
              "'corners' must name four different points");
}

TEST(mesher, an_angle_in_the_outline_is_meshed_once_its_corners_are_named) {
  Model model;
  model.extrudes = {extrude("body", {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 1, 0.5)};
  model.extrudes[0].corners = {2, 3, 5, 6};
  build_mesh(model);
  EXPECT_NEAR(all_volume(model.mesh), 3, 1e-12);
}

TEST(mesher, outlines_that_cross_themselves_or_have_repeated_points_are_refused) {
  EXPECT_SAYS(section_error({{0, 0}, {1, 1}, {1, 0}, {0, 1}}),
              "the outline of the section crosses or touches itself: edge 1 (0, 0) - 2 (1, 1)");
  EXPECT_SAYS(section_error({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}),
              "points 1 (0, 0) and 5 (0, 0) of the section are the same");
  EXPECT_SAYS(section_error({{0, 0}, {4, 0}, {1, 0}, {0, 1}}), "crosses or touches itself");
  EXPECT_SAYS(section_error({{0, 0}, {1, 0}, {1, NAN}, {0, 1}}), "point 3 of the section is not finite");
}

TEST(mesher, sections_that_overlap_or_nearly_touch_are_refused) {
  auto model = dam_on_rock();
  for (auto& p : model.extrudes[0].section) p[1] -= 5;
  EXPECT_SAYS(complaint([&] { build_mesh(model); }), "dam.lua:4: extrude 'rock': its section overlaps that of 'dam'");
  model = dam_on_rock();
  model.extrudes[0].section = model.extrudes[1].section;
  EXPECT_SAYS(complaint([&] { build_mesh(model); }), "overlaps");
  model = dam_on_rock();
  model.extrudes[0].section = {{0, -30}, {10, -30}, {10, -20}, {0, -20}};
  EXPECT_SAYS(complaint([&] { build_mesh(model); }), "overlaps");
  model = dam_on_rock();
  for (auto& p : model.extrudes[0].section) p[1] += 0.004;
  EXPECT_SAYS(complaint([&] { build_mesh(model); }),
              "dam.lua:3: extrude 'dam': its point (0, 0.004) lies 0.004 m beside the outline of 'rock'");
}

TEST(mesher, numbers_out_of_range_are_refused_all_at_once) {
  auto model = dam_on_rock();
  model.extrudes[0].length = -1;
  model.extrudes[0].size = 0;
  model.extrudes[0].grow = 0.5;
  model.extrudes[0].divisions = {{5, 3}};
  const auto text = complaint([&] { build_mesh(model); });
  EXPECT_SAYS(text, "'length' must be greater than 0 m");
  EXPECT_SAYS(text, "'size' must be greater than 0 m");
  EXPECT_SAYS(text, "'grow'");
  EXPECT_SAYS(text, "'divisions' of side 5");
  model = dam_on_rock();
  model.extrudes[0].size = 1e-6;
  EXPECT_SAYS(complaint([&] { build_mesh(model); }), "would have");
}

TEST(mesher, boxes_without_extent_and_models_without_geometry_are_refused) {
  Model model;
  EXPECT_SAYS(complaint([&] { build_mesh(model); }), "the model has no geometry");
  model.boxes = {box("bar", {0, 0, 0}, {1, 0, 1}, {1, 1, 0}, Shape::hex8)};
  const auto text = complaint([&] { build_mesh(model); });
  EXPECT_SAYS(text, "'to' must lie beyond 'from' along y");
  EXPECT_SAYS(text, "at least one cell along z");
  model.boxes = {box("bar", {0, 0, 0}, {1, 1, 1}, {1, 1, 1}, Shape::hex8),
                 box("bar", {1, 0, 0}, {2, 1, 1}, {1, 1, 1}, Shape::hex8)};
  EXPECT_SAYS(complaint([&] { build_mesh(model); }), "region 'bar' exists already, from line 1");
  model.boxes = {box("bar", {0, 0, 0}, {1, 1, 1}, {1000000, 1000, 1000}, Shape::hex8)};
  EXPECT_SAYS(complaint([&] { build_mesh(model); }), "more than 40 million");
}

}  // namespace
}  // namespace ashlar
