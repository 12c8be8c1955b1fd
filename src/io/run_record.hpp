#pragma once
#include <string>
#include <utility>
#include <vector>

#include "io/run_writer.hpp"
#include "solve/checkpoint.hpp"

namespace ashlar {

/// What an earlier run left in its folder for going on with it.
struct RunRecord {
  std::string status;             ///< "running" (until it was killed), "interrupted", "failed", "finished", "not converged"
  std::string deck;               ///< as given
  std::string working_directory;  ///< where it was started
  std::vector<std::pair<std::string, std::string>> settings;  ///< arguments of the deck given on the command line
  std::string precision;
  Restart restart;     ///< from the checkpoints; empty where none was written
  RunKept kept;
};

/// Throws DeckError: no run in this folder; ResourceError: a file that cannot be read.
RunRecord read_run(const std::string& folder);

/// Throws DeckError where the run was of another deck, other data, another version: what differs.
void check_same_run(const RunRecord& record, const RunDescription& description);

}  // namespace ashlar
