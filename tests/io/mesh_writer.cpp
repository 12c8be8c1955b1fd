#include "io/mesh_writer.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "io/mesh_file.hpp"
#include "io/sample_model.hpp"

namespace ashlar {
namespace {

Box box(const std::string& name, std::array<double, 3> from, std::array<double, 3> to, Shape shape) {
  return {name, {}, from, to, {2, 3, 2}, shape};
}

/// Every shape, regions that touch, a surface over two regions that shares facets with their sides.
Model all_shapes() {
  Model model;
  model.name = "bodies";
  model.boxes = {box("rock", {0, 0, -1.0 / 3}, {1, 1, 0}, Shape::hex8), box("dam", {0, 0, 0}, {1, 1, 0.7}, Shape::hex8),
                 box("far side", {5, 0, 0}, {6, 1, 1}, Shape::tet4), box("pier", {8, 0, 0}, {9, 1, 1}, Shape::wedge6)};
  SurfaceChoice wet;
  wet.name = "wet";
  wet.of = {"rock", "dam"};
  wet.side = {"left"};
  model.surfaces = {wet};
  build_mesh(model);
  return model;
}

Mesh read_back(const std::string& text, const std::string& name) {
  const TemporaryFolder folder;
  std::ofstream(folder.file(name)) << text;
  return read_mesh(folder.file(name), {});
}

void expect_same(const Mesh& a, const Mesh& b) {
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t n = 0; n < a.points.size(); ++n)
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(a.points[n][axis], b.points[n][axis]);
  EXPECT_EQ(a.shapes, b.shapes);
  EXPECT_EQ(a.corners, b.corners);
  EXPECT_EQ(a.regions, b.regions);
  EXPECT_EQ(a.region_names, b.region_names);
  ASSERT_EQ(a.surfaces.size(), b.surfaces.size());
  for (std::size_t s = 0; s < a.surfaces.size(); ++s) {
    EXPECT_EQ(a.surfaces[s].name, b.surfaces[s].name);
    auto facets = a.surfaces[s].facets;
    std::sort(facets.begin(), facets.end(), [](const Facet& f, const Facet& g) {
      return std::pair(f.element, f.face) < std::pair(g.element, g.face);
    });
    EXPECT_EQ(facets, b.surfaces[s].facets) << a.surfaces[s].name;
  }
}

TEST(MeshWriter, WhatIsWrittenReadsBackTheSame) {
  const auto mesh = all_shapes().mesh;
  ASSERT_EQ(mesh.surfaces.size(), 23u);
  expect_same(mesh, read_back(gmsh_text(mesh), "mesh.msh"));
  expect_same(mesh, read_back(vtu_text(mesh), "mesh.vtu"));
}

TEST(MeshWriter, AnAbaqusFileReadsBackTheSameButForNamesItCannotHold) {
  auto model = all_shapes();
  auto wanted = model.mesh;
  wanted.region_names[2] = "far_side";
  for (auto& surface : wanted.surfaces)
    if (surface.name.starts_with("far side")) surface.name[3] = '_';
  expect_same(wanted, read_back(abaqus_text(model, {}, {}), "mesh.inp"));

  for (const auto& region : model.mesh.region_names) {
    Material material;
    material.name = "of " + region;
    material.regions = {region};
    material.density = 2400;
    material.values = {{"young", 30e9}, {"poisson", 0.2}};
    model.materials.push_back(material);
  }
  const auto nodes = model.mesh.points.size();
  NodalStep step{"weight", std::vector<double>(3 * nodes, -1.5), std::vector<unsigned>(nodes, 0),
                 std::vector<double>(3 * nodes, 0)};
  step.held[4] = 5;
  const auto text = abaqus_text(model, {step}, {"a remark"});
  for (const char* line :
       {"** a remark", "*ELASTIC\n3e+10, 0.2", "*SOLID SECTION, ELSET=far_side, MATERIAL=of_far_side",
        "*BOUNDARY, OP=NEW\n5, 1, 1, 0\n5, 3, 3, 0\n*CLOAD", "\n5, 2, -1.5\n6, 1, -1.5\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line;
  expect_same(wanted, read_back(text, "mesh.inp"));
}

TEST(MeshWriter, NamesThatBecomeOneAreRefused) {
  auto model = all_shapes();
  model.mesh.surfaces[0].name = "WET";
  EXPECT_THROW(abaqus_text(model, {}, {}), DeckError);
}

}  // namespace
}  // namespace ashlar
