#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "io/hdf5.hpp"

namespace ashlar {

/// Points and cells as VTK has them.
struct Grid {
  std::vector<double> points;  ///< [3 * points] m
  std::vector<std::int64_t> connectivity;
  std::vector<std::int64_t> offsets{0};  ///< [cells + 1]
  std::vector<std::uint8_t> types;       ///< [cells] VTK cell types: 5 triangle, 9 quad, 10 tet, 12 hex, 13 wedge
  std::size_t point_count() const { return points.size() / 3; }
  std::size_t cell_count() const { return types.size(); }
};

/// One array of a grid.
struct GridArray {
  enum class Type { real, integer, byte };
  std::string name;
  bool on_points = true;  ///< else one value per cell
  int components = 1;
  Type type = Type::real;
  std::string unit;                      ///< "" where it has none
  std::vector<std::string> labels = {};  ///< names of the components, or of the values of an integer array
};

/// When arrays are written.
struct GridStep {
  double time = 0;  ///< grows from step to step
  std::string stage;
  int stage_number = 0;
  double load_factor = 0;
  bool stage_end = true;
  bool balanced = true;  ///< false: the last state of a stage that failed
};

/// Where output `step` (0-based) lies in a file, and when it was made.
std::string step_group(std::size_t step);
GridStep read_step(hdf5::File& file, std::size_t step);

/// A grid with arrays over time: NAME.vtkhdf (HDF5 in VTKHDF layout 2.0, temporal unstructured grid) and NAME.xdmf
/// beside it, which shows the same bytes to readers that know no VTKHDF, through virtual datasets /Steps/00001/ARRAY.
/// Both are complete after every append. Every group /Steps/00001 carries the attributes of its GridStep. Throws
/// ResourceError if the disk does not take the data.
class GridFile {
 public:
  /// `fixed` holds whole-run integer arrays (regions), `varying` those that every append brings. `keep`: goes on with
  /// the file of the same grid that is there, behind its first `keep` steps; the others are dropped. 0: a new file.
  GridFile(const std::string& folder, const std::string& name, const Grid& grid,
           const std::vector<std::pair<std::string, std::string>>& attributes,
           const std::vector<std::pair<GridArray, std::vector<int>>>& fixed, const std::vector<GridArray>& varying,
           std::size_t keep = 0);

  /// `data` is parallel to `varying`: each points at components * points (or cells) values of the array's type.
  void append(const GridStep& step, const std::vector<const void*>& data);

  const std::vector<GridStep>& steps() const { return steps_; }
  std::vector<std::string> file_names() const { return {name_ + ".vtkhdf", name_ + ".xdmf"}; }

 private:
  void create(const Grid& grid, const std::vector<std::pair<std::string, std::string>>& attributes,
              const std::vector<std::pair<GridArray, std::vector<int>>>& fixed);
  void go_on_behind(std::size_t steps);
  std::string path() const;
  void write_xdmf() const;
  std::string xdmf_item(const std::string& dataset, const GridArray& array) const;
  std::size_t rows(const GridArray& array) const { return array.on_points ? point_count_ : cell_count_; }

  std::string folder_, name_;
  hdf5::File file_;
  std::size_t point_count_, cell_count_, topology_size_ = 0;
  std::vector<GridArray> fixed_, varying_;
  std::vector<GridStep> steps_;
};

}  // namespace ashlar
