#include "io/run_writer.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "io/checkpoint_file.hpp"
#include "io/history_file.hpp"
#include "io/result_file.hpp"
#include "io/sha256.hpp"

namespace ashlar {

namespace {

using Json = nlohmann::ordered_json;

/// Text that is not UTF-8 (deck strings may be anything) is written with replacement marks.
std::string dumped(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string bytes_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  if (!stream) throw ResourceError("cannot read '" + path + "' again to copy it into the results");
  return bytes;
}

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

Json described(const std::map<std::string, double>& values) {
  Json json = Json::object();
  for (const auto& [key, value] : values) json[key] = value;
  return json;
}

Json described(const Model& model, const Blocks& blocks, const ContactPoints& contacts) {
  const Mesh& mesh = model.mesh;
  std::vector<int> elements(mesh.region_names.size(), 0);
  for (const int region : mesh.regions) ++elements[region];
  Json json{{"name", model.name},
            {"reference_temperature", model.reference_temperature},
            {"nodes", mesh.node_count()},
            {"elements", mesh.element_count()},
            {"blocks", blocks.block_count},
            {"block_nodes", blocks.node_count()},
            {"interface_faces", blocks.faces.size()},
            {"contact_points", contacts.count()}};
  for (std::size_t r = 0; r < elements.size(); ++r)
    json["regions"].push_back({{"name", mesh.region_names[r]}, {"elements", elements[r]}});
  for (const auto& material : model.materials) {
    Json entry{
        {"name", material.name}, {"regions", material.regions}, {"law", material.law}, {"density", material.density}};
    if (material.conductivity) entry["conductivity"] = *material.conductivity;
    if (material.heat_capacity) entry["heat_capacity"] = *material.heat_capacity;
    entry["values"] = described(material.values);
    json["materials"].push_back(entry);
  }
  for (const auto& interface : model.interfaces)
    json["interfaces"].push_back({{"name", interface.name},
                                  {"noun", interface.crackable ? "crackable" : "joint"},
                                  {"regions", interface.regions},
                                  {"law", interface.law},
                                  {"values", described(interface.values)}});
  for (const auto& stage : model.stages) json["stages"].push_back(stage.name);
  for (const auto& condition : model.conditions)
    for (const auto& number : condition.in_time)
      json["in_time"].push_back({{"noun", condition.noun},
                                 {"name", condition.name},
                                 {"key", number.key},
                                 {"of_place", static_cast<bool>(number.field)},
                                 {"time", number.table.time},
                                 {"value", number.table.value}});
  return json;
}

Json described(const CrackEvent& event) {
  Json json{{"load_factor", event.load_factor},
            {"place", {event.place.x, event.place.y, event.place.z}},
            {"contact_points", event.contact_points},
            {"interface", event.interface},
            {"mode", event.mode}};
  if (event.seconds > 0) json["seconds"] = event.seconds;
  return json;
}

Json described(const StageResult& stage) {
  Json json{{"name", stage.name},
            {"kind", stage.kind},
            {"converged", stage.converged},
            {"balanced", stage.balanced()},
            {"stop_reason", stage.stop_reason},
            {"steps", stage.steps},
            {"ratio", stage.ratio},
            {"load_factor", stage.load_factor},
            {"crack_events", stage.events.size()},
            {"cracked_area", stage.cracked_area}};
  json["cracked_area_by_direction"] = described(stage.cracked_area_by_direction);
  json["free_blocks"] = stage.free_blocks;
  json["loose"] = Json::array();
  for (const LooseBlocks& body : stage.loose)
    json["loose"].push_back({{"blocks", body.blocks},
                             {"region", body.region},
                             {"volume", body.volume},
                             {"centre", {body.centre.x, body.centre.y, body.centre.z}}});
  json["dissipated_energy"] = stage.dissipated_energy;
  json["dissipated_by_contacts"] = {{"opening", stage.dissipated_by_contacts.opening},
                                    {"shear", stage.dissipated_by_contacts.shear},
                                    {"friction", stage.dissipated_by_contacts.friction}};
  json["plastic_work"] = stage.plastic_work;
  json["fracture_work"] = stage.fracture_work;
  if (stage.safety_factor > 0) json["safety_factor"] = stage.safety_factor;
  if (stage.falling_factor > 0) json["falling_factor"] = stage.falling_factor;
  if (stage.time_step > 0) {
    json["time_step"] = stage.time_step;
    json["stable_step"] = stage.stable_step;
    json["energy"] = {{"kinetic", stage.energy.kinetic},
                      {"strain", stage.energy.strain},
                      {"dissipated", stage.energy.dissipated},
                      {"external_work", stage.energy.external_work},
                      {"drift", stage.energy.drift}};
  }
  if (stage.lanes)
    json["lanes"] = {{"stress", {{"device", stage.lanes->stress_device}, {"seconds", stage.lanes->stress}}},
                     {"heat",
                      {{"device", stage.lanes->heat_device},
                       {"seconds", stage.lanes->heat},
                       {"steps", stage.lanes->heat_steps}}},
                     {"beside", stage.lanes->beside},
                     {"seconds_of_both", stage.lanes->both}};
  if (stage.initial) json["initial_stress_out_of_balance"] = stage.initial->share;
  json["wall_seconds"] = stage.wall_seconds;
  json["activity_seconds"] = Json::object();
  for (const auto& activity : stage.activities) json["activity_seconds"][activity.phase] = activity.seconds;
  json["phase_seconds"] = Json::object();
  for (const auto& phase : stage.phases) json["phase_seconds"][phase.phase] = phase.seconds;
  return json;
}

}  // namespace

std::vector<std::string> identity(const RunDescription& description) {
  std::vector<std::string> lines{"ashlar " + description.version + ", checkpoints of kind 2",
                                 description.precision + " precision"};
  for (const auto& [name, value] : description.settings) lines.push_back("argument " + name + "=" + value);
  std::vector<std::string> files = description.files;
  if (std::find(files.begin(), files.end(), description.deck) == files.end()) files.push_back(description.deck);
  for (const std::string& file : files) lines.push_back(file + " with sha256 " + sha256(bytes_of(file)));
  return lines;
}

struct RunWriter::Files {
  RunFolder folder;
  GrowingFile log;
  Json manifest;
  std::string deck_copy;
  ResultFile results;
  std::map<std::string, std::pair<std::string, HistoryFile>> histories;  ///< by name: file name and file
  std::vector<std::string> history_files;
  std::vector<std::string> identity_lines;
  std::chrono::duration<double> between_checkpoints;
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now(), last_progress = start,
                                        last_checkpoint = start;

  Files(const RunFolder& folder, const RunDescription& description, const Model& model, const Blocks& blocks,
        const ContactPoints& contacts, const RunKept& kept)
      : folder(folder),
        log(own_log(folder, !kept.identity.empty())),
        manifest(first_manifest(description, model, blocks, contacts)),
        deck_copy(copy_deck(description)),
        results(folder.path(), "ashlar " + description.version, model, blocks, contacts, kept.outputs),
        identity_lines(identity(description)),
        between_checkpoints(60 * description.checkpoint_minutes) {
    if (kept.stages == 0) return;
    const auto earlier = Json::parse(bytes_of(folder.file("manifest.json")), nullptr, false);
    for (int s = 0; s < kept.stages; ++s) manifest["stages"].push_back(earlier.at("stages").at(s));
  }

  static GrowingFile own_log(const RunFolder& folder, bool go_on) {
    GrowingFile log(folder.file("log.jsonl"), go_on);
    if (!log.claim()) throw ResourceError("another program is at work in '" + folder.path() + "'");
    return log;
  }

  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); }

  static Json first_manifest(const RunDescription& description, const Model& model, const Blocks& blocks,
                             const ContactPoints& contacts) {
    Json inputs = Json::array();
    for (const auto& path : description.files) inputs.push_back({{"file", path}, {"sha256", sha256(bytes_of(path))}});
    Json arguments = Json::array();
    for (const auto& a : description.arguments)
      arguments.push_back({{"name", a.name}, {"value", a.value}, {"unit", a.unit}, {"set", a.set}});
    Json settings = Json::array();
    for (const auto& [name, value] : description.settings) settings.push_back({name, value});
    Json pictures = Json::array();
    for (const auto& p : model.pictures)
      pictures.push_back(
          {{"name", p.name}, {"of", p.of}, {"stage", p.stage}, {"deform", p.deform}, {"section", p.section}});
    return {{"program", "ashlar"},
            {"version", description.version},
            {"compiler", description.compiler},
            {"started", utc_now()},
            {"status", "running"},
            {"deck", {{"file", description.deck}, {"sha256", sha256(bytes_of(description.deck))}}},
            {"inputs", inputs},
            {"arguments", arguments},
            {"settings", settings},
            {"working_directory", std::filesystem::current_path().string()},
            {"device", description.device},
            {"precision", description.precision},
            {"threads", description.threads},
            {"model", described(model, blocks, contacts)},
            {"recorded", recorded_names(model)},
            {"pictures", pictures},
            {"histories", Json::array()},
            {"stages", Json::array()},
            {"files", Json::array()}};
  }

  std::string copy_deck(const RunDescription& description) const {
    const std::string name = std::filesystem::path(description.deck).filename().string();
    replace_file(folder.file(name), bytes_of(description.deck));
    return name;
  }

  std::vector<std::string> names() const {
    std::vector<std::string> names{"manifest.json", "log.jsonl", deck_copy};
    for (const auto& name : results.file_names())
      if (std::filesystem::exists(folder.file(name))) names.push_back(name);
    names.insert(names.end(), history_files.begin(), history_files.end());
    return names;
  }

  void write_manifest() {
    manifest["wall_seconds"] = seconds();
    manifest["files"] = names();
    replace_file(folder.file("manifest.json"), dumped(manifest, 2));
  }

  void write_log(const char* event, const Json& more) {
    Json line{{"seconds", seconds()}, {"event", event}};
    line.update(more);
    log.add(dumped(line, -1));
  }

  HistoryFile& history(const HistoryTable& table) {
    if (const auto found = histories.find(table.name); found != histories.end()) return found->second.second;
    // Two names may differ only in letters that a file name cannot hold.
    const std::string stem = "history_" + file_name_of(table.name);
    std::string name = stem + ".csv";
    for (int number = 2; std::count(history_files.begin(), history_files.end(), name); ++number)
      name = stem + "_" + std::to_string(number) + ".csv";
    HistoryFile file(folder.file(name), table);
    history_files.push_back(name);
    manifest["histories"].push_back({{"name", table.name}, {"file", name}});
    return histories.try_emplace(table.name, name, std::move(file)).first->second.second;
  }
};

RunWriter::RunWriter(const RunFolder& folder, const RunDescription& description, const Model& model,
                     const Blocks& blocks, const ContactPoints& contacts, const RunKept& kept)
    : files_(std::make_unique<Files>(folder, description, model, blocks, contacts, kept)) {
  files_->write_log(kept.identity.empty() ? "run_begins" : "run_goes_on",
                    {{"deck", description.deck}, {"device", description.device}, {"threads", description.threads}});
  files_->write_manifest();
}

RunWriter::~RunWriter() = default;

void RunWriter::stage_begins(int number, const std::string& name, const std::string& kind) {
  files_->write_log("stage_begins", {{"number", number}, {"stage", name}, {"kind", kind}});
}

void RunWriter::progress(const Progress& progress) {
  // Ten lines a second would bury the events of a long run.
  const auto now = std::chrono::steady_clock::now();
  if (now - files_->last_progress < std::chrono::seconds(5)) return;
  files_->last_progress = now;
  files_->write_log("progress", {{"stage", progress.stage},
                                 {"step", progress.step},
                                 {"ratio", progress.ratio},
                                 {"target", progress.target},
                                 {"increment", progress.increment},
                                 {"fraction", progress.fraction},
                                 {"cracked_fraction", progress.cracked_fraction}});
}

void RunWriter::crack(const std::string& stage, const CrackEvent& event) {
  Json json{{"stage", stage}};
  json.update(described(event));
  files_->write_log("crack", json);
}

void RunWriter::output(const Snapshot& snapshot) {
  files_->results.append(snapshot);
  files_->write_log("output",
                    {{"stage", snapshot.stage}, {"time", snapshot.time}, {"load_factor", snapshot.load_factor}});
}

void RunWriter::history_row(const HistoryTable& table) { files_->history(table).update(table); }

void RunWriter::stage_ends(const StageResult& stage) {
  files_->manifest["stages"].push_back(described(stage));
  files_->write_log("stage_ends", described(stage));
  files_->write_manifest();
}

bool RunWriter::wants_checkpoint() {
  return std::chrono::steady_clock::now() - files_->last_checkpoint >= files_->between_checkpoints;
}

void RunWriter::checkpoint(const Checkpoint& checkpoint) {
  for (const std::string& name : files_->names()) sync_to_disk(files_->folder.file(name));
  write_checkpoint(files_->folder.file(checkpoint.within ? within_checkpoint : stage_checkpoint),
                   {checkpoint, files_->results.count(), files_->identity_lines});
  if (!checkpoint.within) std::filesystem::remove(files_->folder.file(within_checkpoint));
  files_->write_log("checkpoint", {{"stage_number", checkpoint.stage + 1}, {"within", checkpoint.within}});
  files_->last_checkpoint = std::chrono::steady_clock::now();
}

void RunWriter::finish(const RunResult& result, const std::vector<ExpectRecord>& expects) {
  for (const auto& table : result.histories) files_->history(table).update(table);
  Json stages = Json::array(), checked = Json::array();
  for (const auto& stage : result.stages) stages.push_back(described(stage));
  for (const auto& expect : expects) {
    Json entry{{"name", expect.name}, {"passed", expect.passed}, {"message", expect.message}};
    if (std::isfinite(expect.found)) entry["found"] = expect.found;
    if (expect.between) entry["between"] = *expect.between;
    checked.push_back(entry);
  }
  auto& manifest = files_->manifest;
  manifest["status"] = result.interrupted ? "interrupted" : result.all_converged() ? "finished" : "not converged";
  if (!result.device.empty()) manifest["device"] = result.device;
  manifest["stages"] = stages;
  manifest["expects"] = checked;
  files_->write_log("run_ends", {{"status", manifest["status"]}});
  files_->write_manifest();
  if (result.interrupted) return;
  for (const char* name : {stage_checkpoint, within_checkpoint}) std::filesystem::remove(files_->folder.file(name));
}

void RunWriter::fail(const std::string& message) {
  files_->manifest["status"] = "failed";
  files_->manifest["error"] = message;
  files_->write_log("run_fails", {{"error", message}});
  files_->write_manifest();
}

std::vector<std::string> RunWriter::file_names() const { return files_->names(); }

}  // namespace ashlar
