#include "io/run_record.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "io/checkpoint_file.hpp"

namespace ashlar {

RunRecord read_run(const std::string& folder) {
  const auto file = [&](const char* name) { return (std::filesystem::path(folder) / name).string(); };
  std::ifstream stream(file("manifest.json"));
  if (!stream) throw DeckError({}, "'" + folder + "' holds no run: there is no " + file("manifest.json"));
  const auto manifest = nlohmann::ordered_json::parse(stream, nullptr, false);
  RunRecord record;
  try {
    record.status = manifest.at("status");
    record.deck = manifest.at("deck").at("file");
    record.working_directory = manifest.at("working_directory");
    record.precision = manifest.at("precision");
    for (const auto& setting : manifest.at("settings")) record.settings.emplace_back(setting.at(0), setting.at(1));
  } catch (const nlohmann::json::exception& error) {
    throw DeckError({}, file("manifest.json") + " is not of a run that this program can go on with: " + error.what());
  }
  auto start = read_checkpoint(file(stage_checkpoint));
  auto within = read_checkpoint(file(within_checkpoint));
  if (start) {
    record.kept = {start->outputs, start->checkpoint.stage, start->identity};
    record.restart.stage_start = std::move(start->checkpoint);
  }
  // One that is left of an earlier stage was about to be removed.
  const int stage = record.restart.stage_start ? record.restart.stage_start->stage : 0;
  if (within && within->checkpoint.stage == stage) {
    record.kept = {within->outputs, stage, within->identity};
    record.restart.within = std::move(within->checkpoint);
  }
  return record;
}

void check_same_run(const RunRecord& record, const RunDescription& description) {
  const std::vector<std::string> now = identity(description);
  std::vector<std::string> complaints;
  for (const std::string& line : record.kept.identity)
    if (std::find(now.begin(), now.end(), line) == now.end()) complaints.push_back("the run was of " + line);
  for (const std::string& line : now)
    if (std::find(record.kept.identity.begin(), record.kept.identity.end(), line) == record.kept.identity.end())
      complaints.push_back("now there is " + line);
  if (complaints.empty() || record.kept.identity.empty()) return;
  complaints.push_back("a run goes on with what it was begun with; start it anew with 'ashlar run' and --force");
  throw DeckError(complaints);
}

}  // namespace ashlar
