#pragma once
#include <optional>
#include <string>
#include <vector>

#include "solve/checkpoint.hpp"

namespace ashlar {

/// A checkpoint with what ties it to its run.
struct StoredCheckpoint {
  Checkpoint checkpoint;
  std::size_t outputs = 0;            ///< of the result files, when it was made
  std::vector<std::string> identity;  ///< a line for each thing that has to be the same when the run goes on
};

/// Writes a whole file beside, waits for the disk and puts it in place of the one before: a reader, and a run that is
/// killed or loses its power, finds either the old one or the new one. Throws ResourceError naming the path.
void write_checkpoint(const std::string& path, const StoredCheckpoint& stored);

/// Nothing: there is no such file. Throws ResourceError: it cannot be read.
std::optional<StoredCheckpoint> read_checkpoint(const std::string& path);

}  // namespace ashlar
