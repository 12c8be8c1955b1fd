#include "model/mesh.hpp"

#include <gtest/gtest.h>

#include <map>

#include "base/error.hpp"

namespace ashlar {
namespace {

/// One element with the corners of its reference shape, slightly distorted where `warp` is not zero.
Mesh one_element(Shape shape, double warp) {
  Mesh mesh;
  if (shape == Shape::hex8)
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  if (shape == Shape::wedge6) mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
  if (shape == Shape::tet4) mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::vector<int> nodes;
  for (int n = 0; n < corner_count(shape); ++n) {
    nodes.push_back(n);
    mesh.points[n] = mesh.points[n] + warp * Vec3<double>{0.1 * n, 0.07 * n * n, -0.03 * n};
  }
  mesh.region_names = {"body"};
  mesh.add_element(shape, nodes, 0, 1);
  return mesh;
}

class EveryShape : public testing::TestWithParam<Shape> {};
INSTANTIATE_TEST_SUITE_P(Shapes, EveryShape, testing::Values(Shape::hex8, Shape::wedge6, Shape::tet4),
                         [](const auto& info) { return shape_name(info.param); });

TEST_P(EveryShape, face_normals_point_out_of_the_element) {
  const auto mesh = one_element(GetParam(), 0);
  const auto middle = mesh.centroid(0);
  for (int f = 0; f < face_count(GetParam()); ++f)
    EXPECT_GT(dot(mesh.facet_area({0, f}), mesh.facet_centroid({0, f}) - middle), 0) << "face " << f;
}

TEST_P(EveryShape, area_vectors_of_a_closed_body_sum_to_zero_even_with_warped_faces) {
  const auto mesh = one_element(GetParam(), 0.3);
  Vec3<double> sum;
  for (int f = 0; f < face_count(GetParam()); ++f) sum = sum + mesh.facet_area({0, f});
  EXPECT_NEAR(norm(sum), 0, 1e-15);
}

TEST_P(EveryShape, every_edge_belongs_to_two_faces_that_run_along_it_in_opposite_directions) {
  std::map<std::pair<int, int>, int> runs;
  for (int f = 0; f < face_count(GetParam()); ++f) {
    const auto corners = face_corners(GetParam(), f);
    for (std::size_t i = 0; i < corners.size(); ++i) ++runs[{corners[i], corners[(i + 1) % corners.size()]}];
  }
  for (const auto& [edge, count] : runs) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(runs.count({edge.second, edge.first}), 1u);
  }
  const int edges = GetParam() == Shape::hex8 ? 12 : GetParam() == Shape::wedge6 ? 9 : 6;
  EXPECT_EQ(runs.size(), 2u * edges);
}

TEST(mesh, divergence_theorem_gives_the_volume_of_a_unit_cube_from_its_faces) {
  const auto mesh = one_element(Shape::hex8, 0);
  double volume = 0;
  for (int f = 0; f < 6; ++f) volume += dot(mesh.facet_area({0, f}), mesh.facet_centroid({0, f})) / 3;
  EXPECT_NEAR(volume, 1, 1e-15);
}

/// Two unit cubes side by side in x.
Mesh two_cubes() {
  Mesh mesh;
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 3; ++i) mesh.points.push_back({double(i), double(j), double(k)});
  mesh.region_names = {"left", "right"};
  mesh.add_element(Shape::hex8, std::vector{0, 1, 4, 3, 6, 7, 10, 9}, 0, 11);
  mesh.add_element(Shape::hex8, std::vector{1, 2, 5, 4, 7, 8, 11, 10}, 1, 12);
  return mesh;
}

TEST(mesh, two_cubes_share_one_face_and_ten_are_outer) {
  const auto mesh = two_cubes();
  const auto faces = find_faces(mesh);
  ASSERT_EQ(faces.inner.size(), 1u);
  EXPECT_EQ(faces.outer.size(), 10u);
  const auto [a, b] = faces.inner[0];
  EXPECT_EQ(a.element, 0);
  EXPECT_EQ(b.element, 1);
  EXPECT_NEAR(norm(mesh.facet_area(a) + mesh.facet_area(b)), 0, 1e-15);
  EXPECT_EQ(mesh.facet_area(a).x, 1);
}

TEST(mesh, a_face_of_three_elements_is_an_error_that_names_them) {
  auto mesh = two_cubes();
  mesh.add_element(Shape::hex8, std::vector{1, 2, 5, 4, 7, 8, 11, 10}, 1, 13);
  try {
    find_faces(mesh);
    FAIL();
  } catch (const DeckError& error) {
    EXPECT_NE(std::string(error.what()).find("11, 12, 13"), std::string::npos) << error.what();
  }
}

TEST(mesh, regions_and_surfaces_are_found_by_name) {
  auto mesh = two_cubes();
  mesh.surfaces.push_back({"end", {{1, 3}}});
  EXPECT_EQ(mesh.find_region("right"), 1);
  EXPECT_EQ(mesh.find_region("middle"), -1);
  ASSERT_NE(mesh.find_surface("end"), nullptr);
  EXPECT_EQ(mesh.facet_centroid(mesh.find_surface("end")->facets[0]).x, 2);
  EXPECT_EQ(mesh.find_surface("front"), nullptr);
}

}  // namespace
}  // namespace ashlar
