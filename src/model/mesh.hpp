#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/tensor.hpp"

namespace ashlar {

/// Element shapes, corners in VTK order. VTK's wedge has its first triangle (0,1,2) with the normal pointing OUT of the
/// element in VTK's own documentation, but VTK and Gmsh files in practice use the right-handed order that Abaqus uses:
/// corner 3 above 0, triangle (0,1,2) counter-clockwise seen from above. Ashlar uses that order: positive Jacobian.
enum class Shape : std::uint8_t { hex8, wedge6, tet4 };

inline constexpr int shape_count = 3;
constexpr int corner_count(Shape s) { return s == Shape::hex8 ? 8 : s == Shape::wedge6 ? 6 : 4; }
constexpr int gauss_count(Shape s) { return s == Shape::hex8 ? 8 : s == Shape::wedge6 ? 6 : 1; }
constexpr int face_count(Shape s) { return s == Shape::hex8 ? 6 : s == Shape::wedge6 ? 5 : 4; }
constexpr int vtk_cell_type(Shape s) { return s == Shape::hex8 ? 12 : s == Shape::wedge6 ? 13 : 10; }
constexpr const char* shape_name(Shape s) { return s == Shape::hex8 ? "hex8" : s == Shape::wedge6 ? "wedge6" : "tet4"; }

/// Local corners of one face, ordered so that the right-hand normal points out of the element. Three or four entries.
std::span<const int> face_corners(Shape shape, int face);

/// One face of one element.
struct Facet {
  int element = -1;
  int face = -1;
  bool operator==(const Facet&) const = default;
};

/// Order of faces: by element, then face.
bool before(const Facet& a, const Facet& b);

/// A named set of faces. Outer faces have one owner; a facet inside the mesh names the element that it was selected from.
struct Surface {
  std::string name;
  std::vector<Facet> facets;
};

/// Nodes, elements, regions and surfaces as geometry: before blocks are split and before anything is renumbered.
/// Points and elements keep the order of their source (file or mesher).
struct Mesh {
  std::vector<Vec3<double>> points;      ///< [nodes], m
  std::vector<Shape> shapes;             ///< [elements]
  std::vector<int> first_corner{0};      ///< [elements + 1], offsets into corners
  std::vector<int> corners;              ///< node numbers, element after element
  std::vector<int> regions;              ///< [elements], index into region_names
  std::vector<std::string> region_names;
  std::vector<Surface> surfaces;         ///< groups of the mesh file, sides made by the mesher
  std::vector<long> source_ids;          ///< [elements], the id that the source file gave (1, 2, ... for meshers): for messages

  int node_count() const { return static_cast<int>(points.size()); }
  int element_count() const { return static_cast<int>(shapes.size()); }
  std::span<const int> element(int e) const {
    return {corners.data() + first_corner[e], static_cast<std::size_t>(first_corner[e + 1] - first_corner[e])};
  }
  void add_element(Shape shape, std::span<const int> nodes, int region, long source_id);
  Vec3<double> centroid(int e) const;
  /// Node numbers of a facet, outward right-hand order.
  std::vector<int> facet_nodes(const Facet& f) const;
  Vec3<double> facet_centroid(const Facet& f) const;
  /// Area vector (outward normal times area), m^2.
  Vec3<double> facet_area(const Facet& f) const;
  /// Diagonal of the bounding box, m.
  double extent() const;
  const Surface* find_surface(const std::string& name) const;
  int find_region(const std::string& name) const;  ///< -1 if there is none
};

/// Two faces of different elements on the same corner nodes.
struct FacePair {
  Facet a, b;  ///< a.element < b.element
};

/// Which faces belong to two elements and which to one. Sorted by element, so the answer does not depend on hashing.
struct FaceGraph {
  std::vector<FacePair> inner;
  std::vector<Facet> outer;
};
FaceGraph find_faces(const Mesh& mesh);

}  // namespace ashlar
