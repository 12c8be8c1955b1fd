#pragma once
#include <string>
#include <vector>

#include "script/deck.hpp"
#include "solve/result.hpp"

namespace ashlar {

/// What a run leaves besides its RunResult.
struct RunFacts {
  double wall_seconds = 0;
  bool resumed = false;  ///< wall_seconds is the time since then
  std::vector<ExpectOutcome> expects;
  std::string folder;
  std::vector<std::string> files;  ///< names inside the folder
};

/// Name of the file in a run's folder that keeps its summary.
inline constexpr const char* summary_file = "summary.txt";

/// The end of a run, one fact a line: stages, cracks, time per phase, expects, what the model leaves out, files.
std::string summary(const Model& model, const RunResult& result, const RunFacts& facts);

/// 0; 3 if a stage did not converge; 4 if an expect failed; 130 if the run was interrupted.
int exit_code(const RunResult& result, const std::vector<ExpectOutcome>& expects);

}  // namespace ashlar
