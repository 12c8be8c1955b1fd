#include <gtest/gtest.h>

#include <cstring>
#include <numbers>
#include <random>
#include <set>

#include "model/mesh_tools.hpp"
#include "model/mesher/extrude.hpp"
#include "model/mesher/triangulate.hpp"

/// Sections that are no logical quads: holes, re-entrant corners, several sides.
namespace ashlar {
namespace {

using namespace testing_meshes;
using Outline = std::vector<std::array<double, 2>>;

double loop_area(const Outline& loop) { return 0.5 * std::abs(twice_area(loop)); }
double perimeter(const Outline& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) sum += distance(loop[i], loop[(i + 1) % loop.size()]);
  return sum;
}

/// A drainage gallery: 2 m wide, 3 m high, with a round vault.
Outline gallery(double x, double z) {
  Outline points{{x, z}, {x + 2, z}};
  for (int i = 0; i <= 8; ++i) {
    const double angle = std::numbers::pi * i / 8;
    points.push_back({x + 1 + std::cos(angle), z + 2 + std::sin(angle)});
  }
  return points;
}

/// The reference dam with a gallery near its heel.
Model dam_with_gallery(Shape shape) {
  auto model = dam_on_rock(shape);
  model.extrudes[0].holes = {gallery(4, 4)};
  model.extrudes[0].hole_size = 0.8;
  return model;
}

/// Every face has two owners inside and one on the skin, whose area is that of the body; no element is near folding.
void expect_sound(const Mesh& mesh, double skin) {
  EXPECT_NEAR(area(mesh, find_faces(mesh).outer), skin, 1e-9 * skin);
  // Tetrahedra cut from prisms that are longer than wide are as slender.
  EXPECT_GT(measure_quality(mesh).worst_scaled_jacobian.value, mesh.shapes[0] == Shape::tet4 ? 0 : 0.2);
}

/// Smallest angle of the front faces' corners, degrees.
double smallest_angle(const Mesh& mesh, const std::string& region) {
  double smallest = 180;
  const int wanted = mesh.find_region(region);
  for (const auto& facet : find_faces(mesh).outer) {
    if (mesh.regions[facet.element] != wanted || mesh.facet_area(facet).y >= -1e-12) continue;
    const auto nodes = mesh.facet_nodes(facet);
    const int n = static_cast<int>(nodes.size());
    for (int i = 0; i < n; ++i) {
      const auto a = mesh.points[nodes[(i + n - 1) % n]] - mesh.points[nodes[i]];
      const auto b = mesh.points[nodes[(i + 1) % n]] - mesh.points[nodes[i]];
      smallest = std::min(smallest, std::acos(dot(a, b) / norm(a) / norm(b)) * 180 / std::numbers::pi);
    }
  }
  return smallest;
}

class FreeShapes : public testing::TestWithParam<Shape> {};
INSTANTIATE_TEST_SUITE_P(mesher_free, FreeShapes, testing::Values(Shape::hex8, Shape::wedge6, Shape::tet4),
                         [](const auto& info) { return shape_name(info.param); });

TEST_P(FreeShapes, a_gallery_is_left_out_of_the_dam_and_its_wall_is_a_free_surface) {
  auto model = dam_with_gallery(GetParam());
  build_mesh(model);
  const auto hole = gallery(4, 4);
  const double section = 8 * 60 + 0.5 * 40 * 50 - loop_area(hole);
  EXPECT_NEAR(region_volume(model.mesh, "dam"), section * 12, 1e-8);
  EXPECT_NEAR(region_volume(model.mesh, "rock"), 168 * 60 * 12, 1e-7);
  const double outline = 60 + 8 + 10 + std::hypot(40, 50) + 60 + 60 + 60 + 168 + 60 + 60 - 60;
  expect_sound(model.mesh, (outline + perimeter(hole)) * 12 + 2 * (section + 168 * 60));
  double wall = 0;
  for (const auto& facet : find_faces(model.mesh).outer) {
    const auto p = model.mesh.facet_centroid(facet);
    if (p.y > 0 && p.y < 12 && p.x > 3.9 && p.x < 6.1 && p.z > 3.9 && p.z < 7.1)
      wall += norm(model.mesh.facet_area(facet));
  }
  EXPECT_NEAR(wall, perimeter(hole) * 12, 1e-9);
}

TEST_P(FreeShapes, sections_with_re_entrant_corners_and_with_many_sides_have_their_volume) {
  for (const auto& section : {Outline{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, Outline{{0, 0}, {2, 0}, {0, 2}},
                              Outline{{0, 0}, {3, 0}, {4, 2}, {2, 4}, {-1, 2}}, Outline{{0, 0}, {4, 0}, {1, 1}, {0, 4}},
                              Outline{{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {1, 1}, {1, 3}, {0, 3}}}) {
    Model model;
    model.extrudes = {extrude("body", section, 1.5, 0.4)};
    model.extrudes[0].shape = GetParam();
    build_mesh(model);
    EXPECT_NEAR(all_volume(model.mesh), loop_area(section) * 1.5, 1e-11);
    expect_sound(model.mesh, 2 * loop_area(section) + perimeter(section) * 1.5);
  }
}

TEST_P(FreeShapes, a_free_section_and_one_in_rows_share_their_nodes) {
  Model model;
  model.extrudes = {extrude("free", {{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 2}, {0, 2}}, 2, 0.7),
                    extrude("below", {{-2, -3}, {6, -3}, {6, 0}, {-2, 0}}, 2, 1),
                    extrude("notch", {{0, 2}, {2, 2}, {2, 4}, {0, 4}}, 2, 0.3)};
  for (auto& e : model.extrudes) e.shape = GetParam();
  build_mesh(model);
  expect_sound(model.mesh, 2 * (8 * 3 + 16) + 2 * (8 + 2 * 3 + 2 * 4 + 8));
  EXPECT_NEAR(all_volume(model.mesh), 2 * (8 * 3 + 16), 1e-10);
}

TEST_P(FreeShapes, a_lining_fills_its_hole_and_leaves_the_one_inside_it) {
  Model model;
  const Outline outside{{3, 3}, {7, 3}, {7, 7}, {3, 7}}, inside{{4, 4}, {6, 4}, {6, 6}, {4, 6}};
  model.extrudes = {extrude("rock", {{0, 0}, {10, 0}, {10, 10}, {0, 10}}, 2, 2), extrude("lining", outside, 2, 0.5)};
  model.extrudes[0].holes = {outside};
  model.extrudes[1].holes = {inside};
  for (auto& e : model.extrudes) e.shape = GetParam();
  build_mesh(model);
  EXPECT_NEAR(region_volume(model.mesh, "rock"), 2 * (100 - 16), 1e-10);
  EXPECT_NEAR(region_volume(model.mesh, "lining"), 2 * (16 - 4), 1e-10);
  expect_sound(model.mesh, 2 * (100 - 4) + 2 * (40 + 8));
}

TEST_P(FreeShapes, sections_behind_each_other_conform_whatever_point_they_start_from) {
  auto model = dam_with_gallery(GetParam());
  for (int i = 0; i < 2; ++i) {
    auto behind = model.extrudes[i];
    behind.name += " 2";
    behind.y0 = 12;
    std::rotate(behind.section.begin(), behind.section.begin() + 2, behind.section.end());
    if (i == 0) std::reverse(behind.holes[0].begin(), behind.holes[0].end());
    model.extrudes.push_back(behind);
  }
  build_mesh(model);
  EXPECT_EQ(model.mesh.find_surface("dam.back"), nullptr);
  EXPECT_NEAR(area(model.mesh, "dam 2.back"), 8 * 60 + 0.5 * 40 * 50 - loop_area(gallery(4, 4)), 1e-9);
}

TEST_P(FreeShapes, a_quad_is_meshed_free_on_request) {
  Model model;
  model.extrudes = {extrude("body", {{0, 0}, {4, 0}, {4, 3}, {0, 3}}, 1, 1)};
  model.extrudes[0].structured = false;
  model.extrudes[0].shape = GetParam();
  build_mesh(model);
  EXPECT_NEAR(all_volume(model.mesh), 12, 1e-11);
  EXPECT_NE(model.mesh.element_count(), 12 * (GetParam() == Shape::hex8 ? 1 : GetParam() == Shape::wedge6 ? 2 : 6));
  expect_sound(model.mesh, 2 * 12 + 14);
}

TEST(mesher_free, no_angle_is_below_twenty_degrees_where_the_outline_has_none) {
  Model model;
  model.extrudes = {extrude("plate", {{0, 0}, {10, 0}, {10, 6}, {6, 6}, {6, 10}, {0, 10}}, 1, 1)};
  model.extrudes[0].holes = {{{2, 2}, {4, 2}, {4, 4}, {2, 4}}};
  model.extrudes[0].hole_size = 0.25;
  model.extrudes[0].shape = Shape::wedge6;
  build_mesh(model);
  EXPECT_GT(smallest_angle(model.mesh, "plate"), 20.7);
}

TEST(mesher_free, edges_are_as_long_as_size_near_and_far_and_grow_between) {
  Model model;
  model.extrudes = {extrude("plate", {{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}, 1, 4)};
  auto& e = model.extrudes[0];
  e.holes = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  e.hole_size = 0.2;
  e.grow = 1.2;
  e.layers = 1;
  e.shape = Shape::wedge6;
  build_mesh(model);
  std::set<std::pair<int, int>> edges;
  for (const auto& facet : find_faces(model.mesh).outer) {
    const auto nodes = model.mesh.facet_nodes(facet);
    if (nodes.size() == 3 && model.mesh.facet_area(facet).y < 0)
      for (int i = 0; i < 3; ++i) edges.insert(edge_of(nodes[i], nodes[(i + 1) % 3]));
  }
  double sum = 0;
  for (const auto& [a, b] : edges) {
    const auto p = model.mesh.points[a], q = model.mesh.points[b], middle = 0.5 * (p + q);
    const double away = std::hypot(std::max(0.0, std::abs(middle.x) - 1), std::max(0.0, std::abs(middle.z) - 1));
    const double wanted = std::min(4.0, 0.2 + 0.2 * away), ratio = norm(p - q) / wanted;
    EXPECT_LT(ratio, 1.7) << middle.x << " " << middle.z;
    EXPECT_GT(ratio, 0.4) << middle.x << " " << middle.z;
    sum += ratio;
  }
  EXPECT_NEAR(sum / static_cast<double>(edges.size()), 1, 0.12);
}

TEST(mesher_free, without_growth_the_finest_size_is_everywhere) {
  Model model;
  model.extrudes = {extrude("plate", {{0, 0}, {10, 0}, {10, 10}, {0, 10}}, 1, 4)};
  model.extrudes[0].holes = {{{4, 4}, {6, 4}, {6, 6}, {4, 6}}};
  model.extrudes[0].hole_size = 0.5;
  model.extrudes[0].grow = 1;
  model.extrudes[0].shape = Shape::wedge6;
  build_mesh(model);
  std::set<double> side;
  for (const auto& p : model.mesh.points)
    if (p.x == 0 && p.y == 0) side.insert(p.z);
  EXPECT_EQ(side.size(), 20u + 1);
}

TEST(mesher_free, thin_parts_get_finer_elements) {
  Model model;
  model.extrudes = {extrude("plate", {{0, 0}, {10, 0}, {10, 10}, {0, 10}}, 1, 2)};
  model.extrudes[0].holes = {{{3, 0.5}, {7, 0.5}, {7, 4}, {3, 4}}};
  model.extrudes[0].shape = Shape::wedge6;
  build_mesh(model);
  EXPECT_NEAR(all_volume(model.mesh), 100 - 14, 1e-10);
  EXPECT_GT(smallest_angle(model.mesh, "plate"), 20);
}

TEST(mesher_free, two_runs_give_the_same_bytes_wherever_memory_lies) {
  auto first = dam_with_gallery(Shape::hex8), second = dam_with_gallery(Shape::hex8);
  build_mesh(first);
  std::vector<std::vector<char>> litter;  // other addresses for the second run
  for (int i = 1; i < 4000; ++i) litter.emplace_back(static_cast<std::size_t>(i * 37 % 5000 + 1));
  for (std::size_t i = 0; i < litter.size(); i += 2) litter[i] = {};
  build_mesh(second);
  EXPECT_EQ(first.mesh.corners, second.mesh.corners);
  ASSERT_EQ(first.mesh.points.size(), second.mesh.points.size());
  EXPECT_EQ(std::memcmp(first.mesh.points.data(), second.mesh.points.data(), first.mesh.points.size() * 24), 0);
}

TEST(mesher_free, boundary_edges_stay_whole_however_fine_the_inside) {
  Outline square;
  for (int side = 0; side < 4; ++side)
    for (int i = 0; i < 5; ++i)
      square.push_back(side == 0   ? std::array{0.2 * i, 0.0}
                       : side == 1 ? std::array{1.0, 0.2 * i}
                       : side == 2 ? std::array{1 - 0.2 * i, 1.0}
                                   : std::array{0.0, 1 - 0.2 * i});
  const auto mesh = triangulate({square}, [](const auto&) { return 0.02; });
  ASSERT_GT(mesh.points.size(), square.size() + 100);
  for (std::size_t i = 0; i < square.size(); ++i) EXPECT_EQ(mesh.points[i], square[i]);
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    EXPECT_GT(turn(mesh.points[a], mesh.points[b], mesh.points[c]), 0);
    sum += 0.5 * turn(mesh.points[a], mesh.points[b], mesh.points[c]);
  }
  EXPECT_NEAR(sum, 1, 1e-13);
  for (std::size_t i = square.size(); i < mesh.points.size(); ++i)
    for (int a = 0; a < 2; ++a) EXPECT_TRUE(mesh.points[i][a] > 0 && mesh.points[i][a] < 1);
}

/// A ragged star around a centre, by chance of the seed.
Outline star(std::mt19937& random, double x, double z, double radius, int points) {
  const auto chance = [&](double low, double high) { return low + (high - low) * (random() / 4294967296.0); };
  Outline outline;
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * std::numbers::pi * (i + chance(-0.3, 0.3)) / points, r = radius * chance(0.4, 1);
    outline.push_back({x + r * std::cos(angle), z + r * std::sin(angle)});
  }
  return outline;
}

TEST_P(FreeShapes, any_outline_with_holes_inside_a_frame_on_rows_is_meshed_exactly) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    Model model;
    model.extrudes = {
        extrude("body", star(random, 0, 0, 10, 5 + static_cast<int>(seed)), 1, 1.5),
        extrude("frame", {{-12, -12}, {12, -12}, {12, 12}, {-12, 12}}, 1, 3),
        extrude("rows", {{-20, -15}, {20, -15}, {20, -12}, {-20, -12}}, 1, 2),
    };
    model.extrudes[0].structured = false;
    model.extrudes[0].holes = {star(random, -1.2, 0, 1, 6), star(random, 1.2, 0, 1, 4)};
    model.extrudes[0].hole_size = 0.5;
    model.extrudes[1].holes = {model.extrudes[0].section};
    double section = 24 * 24 + 40 * 3, skin = 3 * 24 + (40 - 24) + 40 + 2 * 3;
    for (const auto& hole : model.extrudes[0].holes) {
      section -= loop_area(hole);
      skin += perimeter(hole);
    }
    for (auto& e : model.extrudes) {
      e.shape = GetParam();
      e.layers = 1;
    }
    build_mesh(model);
    EXPECT_NEAR(all_volume(model.mesh), section, 1e-9);
    EXPECT_NEAR(area(model.mesh, find_faces(model.mesh).outer), 2 * section + skin, 1e-8);
  }
}

// ---------------------------------------------------------------- wrong input

std::string hole_error(std::vector<Outline> holes, double size = 1) {
  Model model;
  model.extrudes = {extrude("body", {{0, 0}, {10, 0}, {10, 10}, {0, 10}}, 1, size, 7)};
  model.extrudes[0].holes = std::move(holes);
  return complaint([&] { build_mesh(model); });
}

TEST(mesher_free, holes_that_do_not_lie_inside_are_refused) {
  const Outline square{{2, 2}, {4, 2}, {4, 4}, {2, 4}};
  EXPECT_SAYS(hole_error({{{12, 2}, {14, 2}, {13, 4}}}), "dam.lua:7: extrude 'body': hole 1 at (12, 2) lies outside");
  EXPECT_SAYS(hole_error({{{-5, -5}, {15, -5}, {15, 15}, {-5, 15}}}), "lies outside the section");
  EXPECT_SAYS(hole_error({square, {{8, 2}, {12, 2}, {9, 4}}}), "hole 2 crosses or touches the outline of the section");
  EXPECT_SAYS(hole_error({{{2, 0}, {4, 2}, {2, 4}}}), "hole 1 crosses or touches the outline of the section: edge 1");
  EXPECT_SAYS(hole_error({{{2, 2}, {4, 4}, {4, 2}, {2, 4}}}), "the outline of hole 1 crosses or touches itself");
  EXPECT_SAYS(hole_error({square, {{3, 3}, {5, 3}, {5, 5}}}), "hole 2 and hole 1 cross or touch");
  EXPECT_SAYS(hole_error({square, {{2.5, 2.5}, {3, 2.5}, {3, 3}}}), "hole 2 and hole 1 lie one in the other");
  EXPECT_SAYS(hole_error({{{2, 2}, {4, 2}}}), "hole 1 needs at least 3 points");
  EXPECT_SAYS(hole_error({{{2, 2}, {4, NAN}, {2, 4}}}), "point 2 of hole 1 is not finite");
}

TEST(mesher_free, sections_too_thin_for_their_size_are_refused) {
  const auto text = hole_error({{{3, 0.01}, {7, 0.01}, {7, 4}, {3, 4}}});
  EXPECT_SAYS(text, "dam.lua:7: extrude 'body': between (");
  EXPECT_SAYS(text, "the section is only 0.01 m thick, less than a fiftieth of its element size 1 m");
  EXPECT_SAYS(hole_error({{{2, 2}, {4, 2}, {3, 4}}}, 1e-6), "is 'size' in metres?");
  EXPECT_SAYS(hole_error({{{2, 2}, {4, 2}, {3, 4}}}, 1e-3), "more than 40 million");
}

TEST(mesher_free, keys_of_rows_are_refused_in_free_sections) {
  Model model;
  model.extrudes = {extrude("body", {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 1, 1, 7)};
  model.extrudes[0].divisions = {{1, 3}};
  EXPECT_SAYS(complaint([&] { build_mesh(model); }),
              "dam.lua:7: extrude 'body': 'divisions' has a meaning only in a section that is meshed in rows between "
              "four corners; this one is not: four corners cannot be told from its angles, 90, 90, 90, 270, 90, 90");
  model.extrudes[0].structured = false;
  EXPECT_SAYS(complaint([&] { build_mesh(model); }), "this one is not: structured = false");
  model.extrudes[0].structured = true;
  model.extrudes[0].corners = {2, 3, 5, 6};
  model.extrudes[0].holes = {{{0.2, 0.2}, {0.4, 0.2}, {0.3, 0.4}}};
  EXPECT_SAYS(complaint([&] { build_mesh(model); }), "this one is not: it has holes");
}

TEST(mesher_free, odd_divisions_beside_split_triangles_are_refused) {
  auto model = dam_with_gallery(Shape::hex8);
  model.extrudes[1].divisions = {{3, 17}};
  EXPECT_SAYS(complaint([&] { build_mesh(model); }), "give an even number");
}

TEST(mesher_free, hole_sizes_beyond_the_size_are_refused) {
  auto model = dam_with_gallery(Shape::hex8);
  model.extrudes[0].hole_size = 20;
  EXPECT_SAYS(complaint([&] { build_mesh(model); }), "'hole_size' is the element size around holes, at most 'size'");
}

}  // namespace
}  // namespace ashlar
