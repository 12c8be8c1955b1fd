#include "model/check_mesh.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "model/mesh_tools.hpp"

namespace ashlar {
namespace {

using namespace testing_meshes;

/// Unit cubes in a row along x, as a file would give them.
Model row_of_cubes(int count) {
  Model model;
  auto& import = model.imports.emplace_back();
  import.where = {"dam.lua", 5};
  import.file = "row.msh";
  for (int i = 0; i <= count; ++i)
    for (int k = 0; k < 2; ++k)
      for (int j = 0; j < 2; ++j) import.mesh.points.push_back({double(i), double(j), double(k)});
  import.mesh.region_names = {"dam", "rock"};
  for (int i = 0; i < count; ++i) {
    const int a = 4 * i, b = a + 4;
    import.mesh.add_element(Shape::hex8, std::array{a, b, b + 1, a + 1, a + 2, b + 2, b + 3, a + 3}, i % 2, 101 + i);
  }
  return model;
}

std::string refusal(Model model) {
  return complaint([&] { build_mesh(model); });
}

TEST(check_mesh, sound_cubes_pass_with_the_quality_of_a_cube) {
  auto model = row_of_cubes(2);
  build_mesh(model);
  const auto quality = measure_quality(model.mesh);
  EXPECT_DOUBLE_EQ(quality.smallest_edge.value, 1);
  EXPECT_DOUBLE_EQ(quality.worst_aspect.value, 1);
  EXPECT_DOUBLE_EQ(quality.worst_scaled_jacobian.value, 1);
  EXPECT_NEAR(quality.volume, 2, 1e-14);
  EXPECT_NEAR(quality.region_volume[1], 1, 1e-14);
}

TEST(check_mesh, quality_is_one_in_ideal_elements_and_points_to_the_worst) {
  Mesh mesh;
  mesh.region_names = {"body"};
  mesh.points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  mesh.add_element(Shape::tet4, std::array{0, 2, 1, 3}, 0, 1);
  EXPECT_NEAR(measure_quality(mesh).worst_scaled_jacobian.value, 1, 1e-14);
  EXPECT_NEAR(measure_quality(mesh).volume, 8.0 / 3, 1e-14);
  const double h = std::sqrt(0.75);
  for (const Vec3<double>& p : {Vec3<double>{9, 0, 0}, {10, 0, 0}, {9.5, h, 0}, {9, 0, 3}, {10, 0, 3}, {9.5, h, 3}})
    mesh.points.push_back(p);
  mesh.add_element(Shape::wedge6, std::array{4, 5, 6, 7, 8, 9}, 0, 2);
  const auto quality = measure_quality(mesh);
  EXPECT_NEAR(quality.worst_scaled_jacobian.value, 1, 1e-14);
  EXPECT_NEAR(quality.worst_aspect.value, 3, 1e-14);
  EXPECT_EQ(quality.worst_aspect.element, 1);
  EXPECT_NEAR(quality.worst_aspect.place.z, 1.5, 1e-14);
  EXPECT_NEAR(quality.volume, 8.0 / 3 + 3 * h / 2, 1e-14);
}

TEST(check_mesh, an_element_inside_out_is_named_with_id_region_and_place) {
  auto model = row_of_cubes(2);
  auto& corners = model.imports[0].mesh.corners;
  std::swap_ranges(corners.begin() + 8, corners.begin() + 12, corners.begin() + 12);
  EXPECT_SAYS(refusal(model),
              "dam.lua:5: hex8 element 102 of region 'rock' at (1.5, 0.5, 0.5): is inside out (volume -1 m^3)");
}

TEST(check_mesh, a_folded_corner_is_found_where_the_volume_is_still_positive) {
  auto model = row_of_cubes(1);
  model.imports[0].mesh.points[7] = {0.62, 0.62, 0.62};
  EXPECT_SAYS(refusal(model), "is folded (Jacobian not positive at a corner)");
}

TEST(check_mesh, a_flat_element_has_no_volume) {
  auto model = row_of_cubes(1);
  for (auto& p : model.imports[0].mesh.points) p.z = 0.1 * p.x + (p.z > 0 ? 1e-16 : 0);
  for (int i = 0; i < 8; ++i) model.imports[0].mesh.points[i].y += 2 * (i % 4 / 2);  // no two nodes coincide
  EXPECT_SAYS(refusal(model), "has no volume");
}

TEST(check_mesh, repeated_nodes_in_an_element) {
  auto model = row_of_cubes(1);
  model.imports[0].mesh.corners[7] = model.imports[0].mesh.corners[4];
  EXPECT_SAYS(refusal(model), "element 101 of region 'dam'");
  EXPECT_SAYS(refusal(model), "node 3 is two of its corners");
}

TEST(check_mesh, an_element_in_two_regions) {
  auto model = row_of_cubes(2);
  auto& mesh = model.imports[0].mesh;
  const std::vector<int> again(mesh.element(0).begin(), mesh.element(0).end());
  mesh.add_element(Shape::hex8, again, 1, 103);
  EXPECT_SAYS(refusal(model),
              "element 103 of region 'rock' at (0.5, 0.5, 0.5): has the same corners as element 101 of region 'dam'");
}

TEST(check_mesh, elements_on_the_same_side_of_a_face_overlap) {
  auto model = row_of_cubes(1);
  auto& mesh = model.imports[0].mesh;
  // A longer hex that starts from the same face.
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 2; ++j) mesh.points.push_back({2, double(j), double(k)});
  mesh.add_element(Shape::hex8, std::array{0, 8, 9, 1, 2, 10, 11, 3}, 1, 102);
  EXPECT_SAYS(refusal(model), "elements overlap");
}

TEST(check_mesh, a_node_without_element_and_a_coordinate_that_is_no_number) {
  auto model = row_of_cubes(1);
  model.imports[0].mesh.points.push_back({5, 6, 7});
  EXPECT_SAYS(refusal(model), "node 9 at (5, 6, 7) belongs to no element");
  model.imports[0].mesh.points[2].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_SAYS(refusal(model), "node 3: coordinates (0, nan, 1) are not finite");
}

TEST(check_mesh, nodes_of_one_file_at_the_same_place) {
  auto model = row_of_cubes(2);
  auto& mesh = model.imports[0].mesh;
  for (int n = 4; n < 8; ++n) {
    mesh.points.push_back(mesh.points[n]);
    std::replace(mesh.corners.begin() + 8, mesh.corners.end(), n, n + 8);
  }
  EXPECT_SAYS(refusal(model), "dam.lua:5: row.msh: nodes 5 and 13 (counted from 1) lie at the same place, (1, 0, 0)");
}

TEST(check_mesh, ten_complaints_of_a_kind_are_written_out_and_the_rest_counted) {
  auto model = row_of_cubes(25);
  auto& corners = model.imports[0].mesh.corners;
  for (int e = 0; e < 25; ++e)
    std::swap_ranges(corners.begin() + 8 * e, corners.begin() + 8 * e + 4, corners.begin() + 8 * e + 4);
  try {
    build_mesh(model);
    FAIL();
  } catch (const DeckError& error) {
    EXPECT_EQ(error.lines().size(), 11u);
    EXPECT_EQ(error.lines().back(), "dam.lua:5: ... and 15 more of the same kind");
  }
}

}  // namespace
}  // namespace ashlar
