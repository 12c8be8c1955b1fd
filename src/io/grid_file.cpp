#include "io/grid_file.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "base/error.hpp"
#include "io/text_file.hpp"

namespace ashlar {

namespace {

hid_t hdf5_type(GridArray::Type type) {
  switch (type) {
    case GridArray::Type::real: return H5T_NATIVE_DOUBLE;
    case GridArray::Type::integer: return H5T_NATIVE_INT32;
    case GridArray::Type::byte: break;
  }
  return H5T_NATIVE_UINT8;
}

std::string path_of(const GridArray& array) {
  return std::string("/VTKHDF/") + (array.on_points ? "PointData/" : "CellData/") + array.name;
}
std::string offsets_of(const GridArray& array) {
  return std::string("/VTKHDF/Steps/") + (array.on_points ? "PointDataOffsets/" : "CellDataOffsets/") + array.name;
}

constexpr hsize_t chunk_bytes = 1 << 20;  // at most: many are packed side by side, and readers keep a few in memory

/// XDMF's code of a VTK cell type.
int xdmf_code(int vtk_type) {
  switch (vtk_type) {
    case 5: return 4;
    case 9: return 5;
    case 10: return 6;
    case 13: return 8;
    case 12: return 9;
  }
  throw std::logic_error("no XDMF code for VTK cell type " + std::to_string(vtk_type));
}

/// XDMF wants the type code before the corners of every cell.
std::vector<int> xdmf_topology(const Grid& grid) {
  std::vector<int> topology;
  topology.reserve(grid.connectivity.size() + grid.cell_count());
  for (std::size_t c = 0; c < grid.cell_count(); ++c) {
    topology.push_back(xdmf_code(grid.types[c]));
    for (auto i = grid.offsets[c]; i < grid.offsets[c + 1]; ++i)
      topology.push_back(static_cast<int>(grid.connectivity[i]));
  }
  return topology;
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

}  // namespace

std::string step_group(std::size_t step) {
  char name[32];
  std::snprintf(name, sizeof name, "/Steps/%05zu", step + 1);
  return name;
}

GridStep read_step(hdf5::File& file, std::size_t step) {
  const std::string group = step_group(step);
  return {file.number(group, "time"), file.text(group, "stage"), static_cast<int>(file.number(group, "stage_number")),
          file.number(group, "load_factor"), file.number(group, "stage_end") != 0,
          file.number(group, "balanced") != 0};
}

GridFile::GridFile(const std::string& folder, const std::string& name, const Grid& grid,
                   const std::vector<std::pair<std::string, std::string>>& attributes,
                   const std::vector<std::pair<GridArray, std::vector<int>>>& fixed,
                   const std::vector<GridArray>& varying, std::size_t keep)
    : folder_(folder),
      name_(name),
      file_(path(), keep > 0 ? hdf5::Mode::change : hdf5::Mode::create),
      point_count_(grid.point_count()),
      cell_count_(grid.cell_count()),
      topology_size_(grid.connectivity.size() + grid.cell_count()),
      varying_(varying) {
  for (const auto& entry : fixed) fixed_.push_back(entry.first);
  if (keep > 0)
    go_on_behind(keep);
  else
    create(grid, attributes, fixed);
}

std::string GridFile::path() const { return (std::filesystem::path(folder_) / (name_ + ".vtkhdf")).string(); }

void GridFile::create(const Grid& grid, const std::vector<std::pair<std::string, std::string>>& attributes,
                      const std::vector<std::pair<GridArray, std::vector<int>>>& fixed) {
  for (const char* group : {"/VTKHDF", "/VTKHDF/PointData", "/VTKHDF/CellData", "/VTKHDF/Steps",
                            "/VTKHDF/Steps/PointDataOffsets", "/VTKHDF/Steps/CellDataOffsets", "/Xdmf", "/Steps"})
    file_.group(group);
  file_.attribute("/VTKHDF", "Version", std::vector<std::int64_t>{2, 0});
  file_.attribute("/VTKHDF", "Type", std::string("UnstructuredGrid"));
  for (const auto& [key, value] : attributes) file_.attribute("/", key, value);

  const auto count = [&](const char* dataset, std::size_t value) {
    const auto number = static_cast<std::int64_t>(value);
    file_.write(dataset, std::span<const std::int64_t>(&number, 1), {1});
  };
  count("/VTKHDF/NumberOfPoints", point_count_);
  count("/VTKHDF/NumberOfCells", cell_count_);
  count("/VTKHDF/NumberOfConnectivityIds", grid.connectivity.size());
  file_.write("/VTKHDF/Points", std::span(grid.points), {point_count_, 3});
  file_.write("/VTKHDF/Connectivity", std::span(grid.connectivity), {grid.connectivity.size()});
  file_.write("/VTKHDF/Offsets", std::span(grid.offsets), {cell_count_ + 1});
  file_.write("/VTKHDF/Types", std::span(grid.types), {cell_count_});
  const auto topology = xdmf_topology(grid);
  file_.write("/Xdmf/topology", std::span(topology), {topology_size_});
  file_.attribute("/VTKHDF/Points", "unit", std::string("m"));

  const auto integer = [&](const std::string& dataset, const std::vector<hsize_t>& row) {
    file_.create_rows(dataset, H5T_NATIVE_INT64, 64, row, false);
  };
  file_.attribute("/VTKHDF/Steps", "NSteps", std::int64_t{0});
  file_.create_rows("/VTKHDF/Steps/Values", H5T_NATIVE_DOUBLE, 64, {}, false);
  for (const char* offsets : {"PartOffsets", "NumberOfParts", "PointOffsets"})
    integer(std::string("/VTKHDF/Steps/") + offsets, {});
  for (const char* offsets : {"CellOffsets", "ConnectivityIdOffsets"})
    integer(std::string("/VTKHDF/Steps/") + offsets, {1});

  const auto describe = [&](const GridArray& array, const char* labels) {
    integer(offsets_of(array), {});
    if (!array.unit.empty()) file_.attribute(path_of(array), "unit", array.unit);
    if (!array.labels.empty()) file_.attribute(path_of(array), labels, array.labels);
  };
  for (const auto& [array, values] : fixed) {
    file_.write(path_of(array), std::span(values), {values.size()});
    describe(array, "names");
  }
  for (const auto& array : varying_) {
    std::vector<hsize_t> row;
    if (array.components > 1) row.push_back(array.components);
    const auto type = hdf5_type(array.type);
    const hsize_t row_bytes = H5Tget_size(type) * static_cast<hsize_t>(array.components);
    file_.create_rows(path_of(array), type, std::min<hsize_t>(rows(array), chunk_bytes / row_bytes), row, true);
    describe(array, array.components > 1 ? "components" : "names");
  }
  file_.flush();
}

void GridFile::go_on_behind(std::size_t steps) {
  for (std::size_t s = 0; s < steps; ++s) {
    if (!file_.has(step_group(s))) throw ResourceError(path() + " has lost output " + std::to_string(s + 1));
    steps_.push_back(read_step(file_, s));
  }
  for (std::size_t s = steps; file_.has(step_group(s)); ++s) file_.remove(step_group(s));
  for (const auto& array : fixed_) file_.cut(offsets_of(array), steps);
  for (const auto& array : varying_) {
    file_.cut(path_of(array), steps * rows(array));
    file_.cut(offsets_of(array), steps);
  }
  for (const char* dataset : {"Values", "PartOffsets", "NumberOfParts", "PointOffsets", "CellOffsets",
                              "ConnectivityIdOffsets"})
    file_.cut(std::string("/VTKHDF/Steps/") + dataset, steps);
  file_.attribute("/VTKHDF/Steps", "NSteps", static_cast<std::int64_t>(steps));
  file_.flush();
  write_xdmf();
}

void GridFile::append(const GridStep& step, const std::vector<const void*>& data) {
  if (data.size() != varying_.size()) throw std::logic_error("GridFile::append: one array of data for every array");
  const std::string group = step_group(steps_.size());
  file_.group(group);
  file_.attribute(group, "stage", step.stage);
  file_.attribute(group, "stage_number", std::int64_t{step.stage_number});
  file_.attribute(group, "time", step.time);
  file_.attribute(group, "load_factor", step.load_factor);
  file_.attribute(group, "stage_end", std::int64_t{step.stage_end});
  file_.attribute(group, "balanced", std::int64_t{step.balanced});

  const auto append_integer = [&](const std::string& dataset, std::int64_t value) {
    file_.append(dataset, H5T_NATIVE_INT64, &value, 1);
  };
  for (const auto& array : fixed_) append_integer(offsets_of(array), 0);
  for (std::size_t a = 0; a < varying_.size(); ++a) {
    const auto& array = varying_[a];
    const auto type = hdf5_type(array.type);
    const hsize_t first = file_.append(path_of(array), type, data[a], rows(array));
    file_.link_rows(group + "/" + array.name, path_of(array), type, first, rows(array));
    append_integer(offsets_of(array), static_cast<std::int64_t>(first));
  }
  for (const char* offsets : {"PartOffsets", "PointOffsets", "CellOffsets", "ConnectivityIdOffsets"})
    append_integer(std::string("/VTKHDF/Steps/") + offsets, 0);
  append_integer("/VTKHDF/Steps/NumberOfParts", 1);
  file_.append("/VTKHDF/Steps/Values", H5T_NATIVE_DOUBLE, &step.time, 1);
  steps_.push_back(step);
  file_.attribute("/VTKHDF/Steps", "NSteps", static_cast<std::int64_t>(steps_.size()));
  file_.flush();
  write_xdmf();
}

std::string GridFile::xdmf_item(const std::string& dataset, const GridArray& array) const {
  const char* numbers[] = {"NumberType=\"Float\" Precision=\"8\"", "NumberType=\"Int\" Precision=\"4\"",
                           "NumberType=\"UChar\" Precision=\"1\""};
  // Six components: a Tensor6 would be reordered to XDMF's own order of a symmetric tensor.
  const char* kind = array.components == 1 ? "Scalar" : array.components == 3 ? "Vector" : "Matrix";
  std::string dimensions = std::to_string(rows(array));
  if (array.components > 1) dimensions += " " + std::to_string(array.components);
  return "        <Attribute Name=\"" + array.name + "\" AttributeType=\"" + kind + "\" Center=\"" +
         (array.on_points ? "Node" : "Cell") + "\">\n          <DataItem Dimensions=\"" + dimensions + "\" " +
         numbers[static_cast<int>(array.type)] + " Format=\"HDF\">" + escaped(name_) + ".vtkhdf:" + dataset +
         "</DataItem>\n        </Attribute>\n";
}

void GridFile::write_xdmf() const {
  const std::string file = escaped(name_) + ".vtkhdf:";
  const std::string mesh = "        <Topology TopologyType=\"Mixed\" NumberOfElements=\"" +
                           std::to_string(cell_count_) + "\">\n          <DataItem Dimensions=\"" +
                           std::to_string(topology_size_) + "\" NumberType=\"Int\" Precision=\"4\" Format=\"HDF\">" +
                           file +
                           "/Xdmf/topology</DataItem>\n        </Topology>\n        <Geometry GeometryType=\"XYZ\">\n"
                           "          <DataItem Dimensions=\"" +
                           std::to_string(point_count_) + " 3\" NumberType=\"Float\" Precision=\"8\" Format=\"HDF\">" +
                           file + "/VTKHDF/Points</DataItem>\n        </Geometry>\n";
  std::string text =
      "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n  <Domain>\n"
      "    <Grid Name=\"" +
      escaped(name_) + "\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (std::size_t s = 0; s < steps_.size(); ++s) {
    text += "      <Grid Name=\"" + escaped(steps_[s].stage) + "\" GridType=\"Uniform\">\n        <Time Value=\"" +
            shortest(steps_[s].time) + "\"/>\n" + mesh;
    for (const auto& array : fixed_) text += xdmf_item(path_of(array), array);
    for (const auto& array : varying_) text += xdmf_item(step_group(s) + "/" + array.name, array);
    text += "      </Grid>\n";
  }
  text += "    </Grid>\n  </Domain>\n</Xdmf>\n";
  replace_file((std::filesystem::path(folder_) / (name_ + ".xdmf")).string(), text);
}

}  // namespace ashlar
