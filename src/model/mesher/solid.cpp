#include "model/mesher/solid.hpp"

#include <cmath>

#include "model/place_text.hpp"

namespace ashlar {

namespace {

double volume_of(const Tetrahedra& mesh) {
  double sum = 0;
  for (const auto& [a, b, c, d] : mesh.cells) {
    const auto& origin = mesh.points[a];
    sum += dot(cross(mesh.points[b] - origin, mesh.points[c] - origin), mesh.points[d] - origin);
  }
  return sum / 6;
}

}  // namespace

Tetrahedra mesh_solid(const Solid& solid, std::vector<std::string>& notes) {
  const std::string title = "solid '" + solid.name + "'";
  auto surface = solid.surface;
  if (check_closed(surface, solid.where, title + ": " + solid.file))
    notes.push_back(title + ": the facets of " + solid.file + " look inwards; they are taken the other way round");

  const double volume = enclosed_volume(surface);
  constexpr double most = 2e8, share_of_cube = 0.118;  // volume of a regular tetrahedron over its edge cubed
  const double expected = volume / (share_of_cube * std::pow(solid.size, 3));
  if (expected > most && solid.grow <= 1)
    throw DeckError(solid.where, title + " would have about " + number_text(expected) +
                                     " elements, more than 200 million; make 'size' larger");

  constexpr double deviation = 0.05;  // of the mesh from the surface between its sharp edges, over the size
  auto mesh = tetrahedralise(surface, solid.size, solid.grow, solid.feature_angle, deviation * solid.size);
  const double filled = volume_of(mesh), off = std::abs(filled - volume) / volume;
  const std::string share = number_text(filled) + " of " + number_text(volume) + " m^3";
  constexpr double refused = 0.1, noted = 0.01;
  if (mesh.cells.empty() || off > refused)
    throw DeckError(solid.where, title + ": elements of " + number_text(solid.size) +
                                     " m are too large for its shape: they fill " + share + "; make 'size' smaller");
  if (off > noted)
    notes.push_back(title + ": elements fill " + share + "; a smaller 'size' follows the surface better");
  return mesh;
}

void add_cells(Mesh& mesh, const Tetrahedra& tetrahedra, const std::vector<int>& node, int region) {
  long source_id = 0;
  for (auto cell : tetrahedra.cells) {
    for (int& corner : cell) corner = node[corner];
    mesh.add_element(Shape::tet4, cell, region, ++source_id);
  }
}

}  // namespace ashlar
