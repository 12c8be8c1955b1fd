#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "model/mesh_tools.hpp"
#include "model/mesher/solid.hpp"

/// Bodies inside closed surfaces.
namespace ashlar {
namespace {

using namespace testing_meshes;

/// A polygon in x-z, convex, extruded along y: as facets.
FacetSurface prism(const std::vector<std::array<double, 2>>& section, double length) {
  FacetSurface s;
  const int n = static_cast<int>(section.size());
  for (const double y : {0.0, length})
    for (const auto& [x, z] : section) s.points.push_back({x, y, z});
  for (int i = 1; i + 1 < n; ++i) {
    s.triangles.push_back({0, i, i + 1});
    s.triangles.push_back({n, n + i + 1, n + i});
  }
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    s.triangles.push_back({i, i + n, j + n});
    s.triangles.push_back({i, j + n, j});
  }
  for (int t = 0; t < static_cast<int>(s.triangles.size()); ++t) s.facets.push_back(t + 1);
  return s;
}

FacetSurface dam() { return prism({{0, 0}, {48, 0}, {8, 50}, {8, 60}, {0, 60}}, 12); }

/// A cylinder of radius r along y.
FacetSurface cylinder(double r, double length) {
  std::vector<std::array<double, 2>> section;
  for (int i = 0; i < 90; ++i) {
    const double angle = 2 * std::numbers::pi * i / 90;
    section.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return prism(section, length);
}

Solid solid(const FacetSurface& surface, double size) {
  Solid s;
  s.name = "body";
  s.where = {"dam.lua", 3};
  s.file = "body.stl";
  s.surface = surface;
  s.size = size;
  return s;
}

Model model_of(const Solid& s) {
  Model model;
  model.solids = {s};
  build_mesh(model);
  return model;
}

TEST(Solid, APolyhedronKeepsItsVolumeAndItsSides) {
  const auto model = model_of(solid(dam(), 5));
  const double section = 48 * 60 - (40 * 50 / 2 + 40 * 10);
  EXPECT_NEAR(all_volume(model.mesh), section * 12, 1e-9 * section * 12);
  EXPECT_NEAR(area(model.mesh, "body.left"), 60 * 12, 1e-6);
  EXPECT_NEAR(area(model.mesh, "body.bottom"), 48 * 12, 1e-6);
  EXPECT_NEAR(area(model.mesh, "body.front"), section, 1e-6);
  EXPECT_GT(measure_quality(model.mesh).worst_scaled_jacobian.value, 0.05);
}

TEST(Solid, ARoundBodyKeepsItsVolumeWithinWhatTheSizeAllows) {
  for (const double size : {2.0, 1.0}) {
    const auto surface = cylinder(4, 10);
    const auto model = model_of(solid(surface, size));
    // Chords of the length of the size lie at most size^2 / 8 r inside the circle.
    const double allowed = size * size / (8 * 4) * total_area(surface);
    EXPECT_NEAR(all_volume(model.mesh), enclosed_volume(surface), allowed) << size;
  }
}

TEST(Solid, TheSameSurfaceGivesTheSameBytes) {
  std::vector<std::string> notes;
  const auto first = mesh_solid(solid(dam(), 5), notes), second = mesh_solid(solid(dam(), 5), notes);
  ASSERT_EQ(first.points.size(), second.points.size());
  for (std::size_t i = 0; i < first.points.size(); ++i)
    for (int a = 0; a < 3; ++a) EXPECT_EQ(first.points[i][a], second.points[i][a]);
  EXPECT_EQ(first.cells, second.cells);
}

TEST(Solid, SizeIsTheMeanEdgeAndGrowSavesElementsInside) {
  const auto even = model_of(solid(dam(), 3));
  double sum = 0;
  long count = 0;
  for (int e = 0; e < even.mesh.element_count(); ++e)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < i; ++j, ++count)
        sum += norm(even.mesh.points[even.mesh.element(e)[i]] - even.mesh.points[even.mesh.element(e)[j]]);
  EXPECT_NEAR(sum / static_cast<double>(count), 3, 0.3);
  auto graded = solid(dam(), 3);
  graded.grow = 1.5;
  EXPECT_LT(model_of(graded).mesh.element_count(), 0.8 * even.mesh.element_count());
}

TEST(Solid, AShellThatLooksInwardsIsTurnedWithANote) {
  auto surface = dam();
  for (auto& triangle : surface.triangles) std::swap(triangle[1], triangle[2]);
  const auto model = model_of(solid(surface, 8));
  ASSERT_EQ(model.notes.size(), 1u);
  EXPECT_SAYS(model.notes[0], "look inwards");
  EXPECT_NEAR(all_volume(model.mesh), enclosed_volume(dam()), 1e-9 * enclosed_volume(dam()));
  EXPECT_TRUE(model_of(solid(dam(), 8)).notes.empty());
}

TEST(Solid, ElementsTooLargeForTheShapeAreRefused) {
  // A rod whose round ends no element of such a size can follow.
  const auto text = complaint([] { model_of(solid(cylinder(0.5, 40), 30)); });
  EXPECT_SAYS(text, "dam.lua:3: solid 'body': elements of 30 m are too large for its shape");
}

TEST(Solid, TextAndBinaryFilesGiveTheSameFacets) {
  const std::string folder = ::testing::TempDir();
  const auto surface = prism({{0, 0}, {3, 0}, {0, 4}}, 2);  // coordinates that floats hold
  std::ofstream text(folder + "body.stl");
  std::ofstream binary(folder + "body_binary.stl", std::ios::binary);
  text << "solid body\n";
  binary << std::string(80, ' ');
  const auto raw = [&](auto value) { binary.write(reinterpret_cast<const char*>(&value), sizeof value); };
  raw(static_cast<std::uint32_t>(surface.triangles.size()));
  for (const auto& triangle : surface.triangles) {
    text << "facet normal 0 0 0\nouter loop\n";
    for (int i = 0; i < 3; ++i) raw(0.0f);
    for (const int corner : triangle) {
      const auto& p = surface.points[corner];
      text << "vertex " << p.x << " " << p.y << " " << p.z << "\n";
      for (int a = 0; a < 3; ++a) raw(static_cast<float>(p[a]));
    }
    text << "endloop\nendfacet\n";
    raw(std::uint16_t{0});
  }
  text << "endsolid body\n";
  text.close();
  binary.close();
  const auto a = read_facets(folder + "body.stl", {}), b = read_facets(folder + "body_binary.stl", {});
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.facets, surface.facets);
  EXPECT_EQ(a.points.size(), surface.points.size());
  EXPECT_NEAR(enclosed_volume(b), 12, 1e-12);
}

TEST(Solid, FacetsOfManyCornersAreCut) {
  const std::string path = ::testing::TempDir() + "cube.off";
  std::ofstream(path) << "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
                         "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";
  auto surface = read_facets(path, {});
  EXPECT_EQ(surface.triangles.size(), 12u);
  EXPECT_EQ(surface.facets.back(), 6);
  EXPECT_FALSE(check_closed(surface, {}, "solid"));
  EXPECT_NEAR(enclosed_volume(surface), 1, 1e-15);
}

TEST(Solid, FilesThatAnnounceMoreThanTheyHoldAreRefused) {
  const auto read = [](const std::string& extension, const std::string& text) {
    const std::string path = ::testing::TempDir() + "facets" + extension;
    std::ofstream(path) << text;
    return read_facets(path, {"dam.lua", 3});
  };
  const auto said = [&](const std::string& extension, const std::string& text) {
    return complaint([&] { read(extension, text); });
  };
  const std::string three = "0 0 0\n1 0 0\n0 1 0\n", fine = "OFF\n# a facet\n3 1 0\n" + three + "3 0 1 2 255 0 0\n";
  EXPECT_EQ(read(".off", fine).triangles.size(), 1u);
  EXPECT_SAYS(said(".off", "OFF\n3 1 0\n" + three + "-2147483648 0 1 2\n"),
              "facets.off:6: expected the number of corners");
  EXPECT_SAYS(said(".off", "OFF\n3 1 0\n" + three + "2000000000 0 1 2\n"),
              "facets.off:6: the number of corners of facet 1");
  EXPECT_SAYS(said(".off", "OFF\n4000000000 1 0\n" + three), "facets.off:2: the number of points is 4000000000");
  EXPECT_SAYS(said(".off", "OFF\n3 1 0\n" + three + "3 0 1 3\n"), "facet 1 has a corner that the file does not give");
  EXPECT_SAYS(said(".off", "OFF\n3 2 0\n" + three + "3 0 1 2\n"), "expected facet 2 of 2, but the file ends here");
  EXPECT_SAYS(said(".off", "COFF\n3 1 0\n" + three + "3 0 1 2\n"), "only the text kind");
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string end = " vertex_indices\nend_header\n" + three + "3 0 1 2\n";
  EXPECT_EQ(read(".ply", head + "element face 1\nproperty list uchar int" + end).triangles.size(), 1u);
  EXPECT_SAYS(said(".ply", head + "element face 4000000000\nproperty list uchar int" + end), "facets.ply:7");
  EXPECT_SAYS(said(".ply", head + "element face 1\nproperty list int int" + end), "by one byte");
}

TEST(Solid, ASurfaceThatTouchesItselfAtAPointIsRefused) {
  // A cube whose dented top reaches down to the middle of its floor.
  FacetSurface s;
  s.points = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}, {1, 1, 0}};
  s.triangles = {{8, 1, 0}, {8, 2, 1}, {8, 3, 2}, {8, 0, 3}, {8, 4, 5}, {8, 5, 6}, {8, 6, 7}, {8, 7, 4},
                 {0, 1, 5}, {0, 5, 4}, {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
  for (int t = 0; t < 16; ++t) s.facets.push_back(t + 1);
  const auto text = complaint([&] { check_closed(s, {"dam.lua", 3}, "solid 'body'"); });
  EXPECT_SAYS(text, "touches itself at the point (1, 1, 0)");
}

}  // namespace
}  // namespace ashlar
