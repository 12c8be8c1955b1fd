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

}  // namespace

std::string vtu_text(const Mesh& mesh) {
  std::string points, connectivity, offsets, types, regions;
  for (const auto& p : mesh.points) points += shortest(p.x) + ' ' + shortest(p.y) + ' ' + shortest(p.z) + '\n';
  long corners = 0, cells = 0;
  const auto add = [&](std::span<const int> nodes, int type, std::size_t region) {
    for (const int n : nodes) connectivity += std::to_string(n) + ' ';
    connectivity += '\n';
    offsets += std::to_string(corners += static_cast<long>(nodes.size())) + '\n';
    types += std::to_string(type) + '\n';
    regions += std::to_string(region) + '\n';
    ++cells;
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
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
         "<UnstructuredGrid>\n<FieldData>\n" +
         names("region_names", mesh.region_names) + names("surface_names", surface_names) +
         "</FieldData>\n<Piece NumberOfPoints=\"" + std::to_string(mesh.points.size()) + "\" NumberOfCells=\"" +
         std::to_string(cells) + "\">\n<Points>\n" +
         array("type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"", points) + "</Points>\n<Cells>\n" +
         array("type=\"Int64\" Name=\"connectivity\"", connectivity) +
         array("type=\"Int64\" Name=\"offsets\"", offsets) + array("type=\"UInt8\" Name=\"types\"", types) +
         "</Cells>\n<CellData>\n" + array("type=\"Int32\" Name=\"region\"", regions) +
         "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace ashlar
