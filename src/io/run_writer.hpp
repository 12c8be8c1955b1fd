#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/run_folder.hpp"
#include "model/blocks.hpp"
#include "solve/observer.hpp"

namespace ashlar {

/// What a run is, beside its model: goes into manifest.json.
struct RunDescription {
  std::string version;             ///< of the program: "0.1.0"
  std::string compiler;            ///< "g++ 12.2.0"
  std::string deck;                ///< path as given; copied into the folder
  std::vector<std::string> files;  ///< every file that was read, with or without the deck: modules, tables, meshes
  struct Argument {
    std::string name, value, unit;
    bool set = false;  ///< given on the command line
  };
  std::vector<Argument> arguments;
  std::vector<std::pair<std::string, std::string>> settings;  ///< arguments given on the command line, as typed
  std::string device;     ///< "cpu"
  std::string precision;  ///< "double"
  int threads = 0;
  double checkpoint_minutes = 10;  ///< between two checkpoints within a stage
};

/// What has to be the same when a run goes on later, a line for each: version, precision, arguments, files.
std::vector<std::string> identity(const RunDescription& description);

/// Checkpoints in a run's folder: at the end of the last stage, and within the present one.
inline constexpr const char* stage_checkpoint = "checkpoint.h5";
inline constexpr const char* within_checkpoint = "checkpoint_within_stage.h5";

/// What stays of a run that goes on.
struct RunKept {
  std::size_t outputs = 0;
  int stages = 0;                     ///< ended
  std::vector<std::string> identity;  ///< empty: no checkpoint was written
};

/// An `expect` of the deck after the run.
struct ExpectRecord {
  std::string name;
  bool passed = false;
  std::string message;
  double found = 0;                              ///< SI; NaN where a function decided or nothing was found
  std::optional<std::array<double, 2>> between;  ///< lowest and highest value allowed, SI
};

/// Writes a run's folder while the run goes on:
///   manifest.json            what ran on what, sizes, stages with times, files; complete after every stage
///   log.jsonl                one JSON object per event
///   history_NAME.csv         one row per record; columns with units, "displacement.x [m]"
///   results.*, interfaces.*  the fields (result_file.hpp)
///   a copy of the deck
///   checkpoint*.h5           where the run can go on from; on disk, with all results before them, when they are there
/// Everything but manifest.json, log.jsonl and the checkpoints has the same bytes in every run of the same deck.
/// Throws ResourceError naming the path if the disk does not take the data.
class RunWriter : public Observer {
 public:
  /// Model, blocks and contacts outlive the writer. `kept`: goes on in the folder of an earlier run.
  RunWriter(const RunFolder& folder, const RunDescription& description, const Model& model, const Blocks& blocks,
            const ContactPoints& contacts, const RunKept& kept = {});
  ~RunWriter() override;

  void stage_begins(int number, const std::string& name, const std::string& kind) override;
  void progress(const Progress& progress) override;
  void crack(const std::string& stage, const CrackEvent& event) override;
  void output(const Snapshot& snapshot) override;
  void history_row(const HistoryTable& table) override;
  void stage_ends(const StageResult& stage) override;
  bool wants_checkpoint() override;
  void checkpoint(const Checkpoint& checkpoint) override;

  /// The end of a run that came to its end or was interrupted: missing history rows, last manifest.
  void finish(const RunResult& result, const std::vector<ExpectRecord>& expects);
  /// The end of a run that an error stopped.
  void fail(const std::string& message);

  /// Names inside the folder, as far as they exist.
  std::vector<std::string> file_names() const;

 private:
  struct Files;
  std::unique_ptr<Files> files_;
};

}  // namespace ashlar
