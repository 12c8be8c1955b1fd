#pragma once
#include <string>
#include <vector>

#include "io/grid_file.hpp"

namespace ashlar {

/// A field that was written at every output.
struct ResultField {
  std::string name, unit;
  bool on_points = true;
  int components = 1;
  std::vector<std::string> labels;  ///< of the components, where there are several
};

/// Reads a result file back (results.vtkhdf, interfaces.vtkhdf), also one whose run goes on or was killed.
class ResultReader {
 public:
  /// Throws DeckError: no such file, or no result file; ResourceError: it cannot be read.
  explicit ResultReader(const std::string& path);

  const std::string& path() const { return file_.path(); }
  const Grid& grid() const { return grid_; }
  const std::vector<GridStep>& steps() const { return steps_; }
  const std::vector<ResultField>& fields() const { return fields_; }
  /// [points or cells, times components] of output `step` (0-based).
  std::vector<double> values(std::size_t step, const ResultField& field);

 private:
  hdf5::File file_;
  Grid grid_;
  std::vector<GridStep> steps_;
  std::vector<ResultField> fields_;
};

}  // namespace ashlar
