#include "model/mesher/solid.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

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

/// Elements follow sharp edges into the corners of a surface: where two meet in a facet's corner at less than a degree,
/// they would shrink without end.
void check_corners(const FacetSurface& surface, double feature_angle, const Where& where, const std::string& title) {
  const int count = static_cast<int>(surface.triangles.size());
  const auto edge = [&](int t, int side) {
    const int a = surface.triangles[t][side], b = surface.triangles[t][(side + 1) % 3];
    return std::pair<int, int>(std::min(a, b), std::max(a, b));
  };
  std::map<std::pair<int, int>, std::vector<int>> sides;
  for (int t = 0; t < count; ++t)
    for (int side = 0; side < 3; ++side) sides[edge(t, side)].push_back(t);
  const auto sharp = [&](const std::pair<int, int>& e) {
    const Vec3<double> n = twice_area(surface, sides[e][0]), other = twice_area(surface, sides[e][1]);
    return std::atan2(norm(cross(n, other)), dot(n, other)) > feature_angle;
  };
  constexpr double degree = std::numbers::pi / 180;
  std::set<int> told;
  Complaints complaints;
  for (int t = 0; t < count; ++t)
    for (int i = 0; i < 3; ++i) {
      const auto& corner = surface.points[surface.triangles[t][i]];
      const Vec3<double> a = surface.points[surface.triangles[t][(i + 1) % 3]] - corner,
                         b = surface.points[surface.triangles[t][(i + 2) % 3]] - corner;
      const double angle = std::atan2(norm(cross(a, b)), dot(a, b));
      if (angle >= degree || !sharp(edge(t, i)) || !sharp(edge(t, (i + 2) % 3)) ||
          !told.insert(surface.triangles[t][i]).second)
        continue;
      complaints.add(where, title + ": facet " + std::to_string(surface.facets[t]) + " ends in a needle at " +
                                place_text(corner) + ", where two sharp edges meet at " + number_text(angle / degree) +
                                " degrees; elements would shrink without end there. Cut the point off, or raise " +
                                "'feature_angle'");
    }
  complaints.raise();
}

/// Elements follow the edges of facets, however short: those that nobody meant would make elements as small.
void check_sizes(const FacetSurface& surface, double size, const Where& where, const std::string& title) {
  constexpr double least = 1e-4;  // of an element's edge
  constexpr int most = 10;
  int tiny = 0;
  Complaints complaints;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    const auto &p = surface.points[a], &q = surface.points[b], &r = surface.points[c];
    const double longest = std::max({norm(q - p), norm(r - q), norm(p - r)});
    if (longest < least * size && ++tiny <= most)
      complaints.add(where, title + ": facet " + std::to_string(surface.facets[t]) + " at " +
                                place_text((1.0 / 3) * (p + q + r)) + " is tiny: no edge is longer than " +
                                number_text(longest) +
                                " m, a ten-thousandth of 'size' or less, and elements would be " + "as small there");
  }
  if (tiny > most) complaints.add(where, title + ": ... and " + std::to_string(tiny - most) + " more");
  if (tiny > 0)
    complaints.add(where, title + ": remove tiny facets where the surface was made, or make 'size' smaller");
  complaints.raise();
}

}  // namespace

Tetrahedra mesh_solid(const Solid& solid, std::vector<std::string>& notes) {
  const std::string title = "solid '" + solid.name + "'";
  auto surface = solid.surface;
  if (check_closed(surface, solid.where, title + ": " + solid.file))
    notes.push_back(title + ": the facets of " + solid.file + " look inwards; they are taken the other way round");
  check_sizes(surface, solid.size, solid.where, title + ": " + solid.file);
  check_corners(surface, solid.feature_angle, solid.where, title + ": " + solid.file);

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
