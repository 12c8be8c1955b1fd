#include "io/mesh_writer.hpp"
#include "io/text_file.hpp"

namespace ashlar {

namespace {

std::string array(const std::string& attributes, const std::string& words) {
  return "<DataArray " + attributes + " format=\"ascii\">\n" + words + "\n</DataArray>\n";
}

/// VTK keeps strings as the numbers of their characters, each string ended by a zero.
template <class Names>
std::string names(const std::string& name, const Names& all) {
  std::string codes;
  for (const std::string& text : all) {
    for (const char c : text) codes += std::to_string(static_cast<unsigned char>(c)) + ' ';
    codes += "0\n";
  }
  return array("type=\"String\" Name=\"" + name + "\" NumberOfTuples=\"" + std::to_string(all.size()) + '"', codes);
}

/// The cells of a file, and what belongs to them.
class Cells {
 public:
  void add(const std::vector<int>& nodes, int type) {
    for (const int n : nodes) connectivity_ += std::to_string(n) + ' ';
    connectivity_ += '\n';
    offsets_ += std::to_string(corners_ += static_cast<long>(nodes.size())) + '\n';
    types_ += std::to_string(type) + '\n';
    ++count_;
  }
  std::string file(const std::string& fields, const std::string& points, long point_count,
                   const std::string& cell_data) const {
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
           "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n<FieldData>\n" +
           fields + "</FieldData>\n<Piece NumberOfPoints=\"" + std::to_string(point_count) + "\" NumberOfCells=\"" +
           std::to_string(count_) + "\">\n<Points>\n" +
           array("type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"", points) + "</Points>\n<Cells>\n" +
           array("type=\"Int64\" Name=\"connectivity\"", connectivity_) +
           array("type=\"Int64\" Name=\"offsets\"", offsets_) + array("type=\"UInt8\" Name=\"types\"", types_) +
           "</Cells>\n<CellData>\n" + cell_data + "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  }

 private:
  std::string connectivity_, offsets_, types_;
  long corners_ = 0, count_ = 0;
};

std::string place(const Vec3<double>& p) { return shortest(p.x) + ' ' + shortest(p.y) + ' ' + shortest(p.z) + '\n'; }

}  // namespace

std::string vtu_text(const Mesh& mesh) {
  std::string points, regions;
  for (const auto& p : mesh.points) points += place(p);
  Cells cells;
  const auto add = [&](std::span<const int> nodes, int type, std::size_t region) {
    cells.add({nodes.begin(), nodes.end()}, type);
    regions += std::to_string(region) + '\n';
  };
  for (int e = 0; e < mesh.element_count(); ++e)
    add(mesh.element(e), vtk_cell_type(mesh.shapes[e]), static_cast<std::size_t>(mesh.regions[e]) + 1);
  std::vector<std::string> surface_names;
  for (const Surface& surface : mesh.surfaces) {
    surface_names.push_back(surface.name);
    for (const Facet& facet : surface.facets) {
      const auto nodes = mesh.facet_nodes(facet);
      add(nodes, nodes.size() == 3 ? 5 : 9, mesh.region_names.size() + surface_names.size());
    }
  }
  return cells.file(names("region_names", mesh.region_names) + names("surface_names", surface_names), points,
                    mesh.node_count(), array("type=\"Int32\" Name=\"region\"", regions));
}

std::string interfaces_vtu_text(const Model& model, const Blocks& blocks) {
  constexpr int polygon_type = 7;
  const Mesh& mesh = model.mesh;
  std::string points, interfaces, matches, areas, gaps, sides_a, sides_b;
  Cells cells;
  int point_count = 0;
  const auto add = [&](const std::vector<Vec3<double>>& polygon, int interface, int match, double area, double gap,
                       int a, int b) {
    std::vector<int> nodes;
    for (const auto& p : polygon) {
      points += place(p);
      nodes.push_back(point_count++);
    }
    cells.add(nodes, polygon_type);
    interfaces += std::to_string(interface) + '\n';
    matches += std::to_string(match) + '\n';
    areas += shortest(area) + '\n';
    gaps += shortest(gap) + '\n';
    sides_a += std::to_string(a) + '\n';
    sides_b += std::to_string(b) + '\n';
  };
  const auto corners = [&](const Facet& facet) {
    std::vector<Vec3<double>> polygon;
    for (const int n : mesh.facet_nodes(facet)) polygon.push_back(mesh.points[n]);
    return polygon;
  };
  for (int f = 0; f < static_cast<int>(blocks.faces.size()); ++f) {
    const InterfaceFace& face = blocks.faces[f];
    const int a = blocks.block_of_element[face.a.element], b = blocks.block_of_element[face.b.element];
    const Vec3<double> area = mesh.facet_area(face.a);
    if (f < blocks.coincident_count()) {
      const double gap = dot(mesh.facet_centroid(face.b) - mesh.facet_centroid(face.a), area) / norm(area);
      add(corners(face.a), face.interface, 0, norm(area), gap, a, b);
    } else {
      const Overlap& overlap = blocks.overlaps[f - blocks.coincident_count()];
      add(overlap.polygon, face.interface, 1, overlap.area, overlap.gap, a, b);
    }
  }
  for (int i = 0; i < static_cast<int>(blocks.matches.size()); ++i)
    for (const UnmatchedFace& face : blocks.matches[i].unmatched)
      add(corners(face.facet), i, face.gap != 0 ? 3 : 2, face.free, face.gap,
          blocks.block_of_element[face.facet.element], -1);
  std::vector<std::string> interface_names;
  for (const Interface& i : model.interfaces) interface_names.push_back(i.name);
  return cells.file(
      names("interface_names", interface_names), points, point_count,
      array("type=\"Int32\" Name=\"interface\"", interfaces) + array("type=\"Int32\" Name=\"match\"", matches) +
          array("type=\"Float64\" Name=\"area\"", areas) + array("type=\"Float64\" Name=\"gap\"", gaps) +
          array("type=\"Int32\" Name=\"block_a\"", sides_a) + array("type=\"Int32\" Name=\"block_b\"", sides_b));
}

}  // namespace ashlar
