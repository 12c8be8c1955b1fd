#pragma once
#include <string>

#include "io/text_file.hpp"
#include "solve/result.hpp"

namespace ashlar {

/// One history as a table: stage, time, load_factor, balanced (0: the last state of a stage that failed), then the
/// recorded columns with their units: "displacement.x [m]".
/// Numbers are the shortest text that reads back as the same number.
class HistoryFile {
 public:
  HistoryFile(const std::string& path, const HistoryTable& table);
  /// Adds the rows of `table` that the file does not have yet.
  void update(const HistoryTable& table);

 private:
  GrowingFile file_;
  std::size_t rows_ = 0;
};

}  // namespace ashlar
