#include <omp.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>

#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress.hpp"
#include "cli/summary.hpp"
#include "io/run_record.hpp"
#include "io/run_writer.hpp"
#include "io/text_file.hpp"
#include "script/deck.hpp"
#include "solve/plan.hpp"
#include "solve/solver.hpp"

namespace ashlar {
namespace {

/// Passes everything to the person and to the files.
class Both : public Observer {
 public:
  Both(Observer& person, Observer& files) : person_(person), files_(files) {}
  void stage_begins(int number, const std::string& name, const std::string& kind) override {
    person_.stage_begins(number, name, kind);
    files_.stage_begins(number, name, kind);
  }
  void progress(const Progress& progress) override {
    person_.progress(progress);
    files_.progress(progress);
  }
  void crack(const std::string& stage, const CrackEvent& event) override {
    person_.crack(stage, event);
    files_.crack(stage, event);
  }
  void output(const Snapshot& snapshot) override { files_.output(snapshot); }
  void history_row(const HistoryTable& table) override { files_.history_row(table); }
  void stage_ends(const StageResult& stage) override {
    person_.stage_ends(stage);
    files_.stage_ends(stage);
  }
  bool wants_checkpoint() override { return files_.wants_checkpoint() || interrupted(); }
  void checkpoint(const Checkpoint& checkpoint) override { files_.checkpoint(checkpoint); }
  bool interrupted() override { return person_.interrupted(); }

 private:
  Observer& person_;
  Observer& files_;
};

RunDescription describe(const Deck& deck, const Arguments& arguments, const std::string& device) {
  RunDescription description{.version = ASHLAR_VERSION,
                             .compiler = ASHLAR_COMPILER,
                             .deck = deck.path,
                             .files = deck.files,
                             .arguments = {},
                             .settings = arguments.settings,
                             .device = device,
                             .precision = arguments.precision == Precision::double_precision ? "double" : "single",
                             .threads = arguments.threads,
                             .checkpoint_minutes = arguments.checkpoint_every};
  for (const Argument& a : deck.arguments) description.arguments.push_back({a.name, a.value, a.unit, a.set});
  return description;
}

/// Runs the deck, or goes on with the run that `record` tells of.
int run_deck(const Arguments& arguments, const RunRecord* record) {
  const auto start = std::chrono::steady_clock::now();
  Deck deck = read_deck(arguments.operands[0], {arguments.settings.begin(), arguments.settings.end()});
  build_mesh(deck.model);
  check_model(deck.model);
  if (arguments.threads > 0) omp_set_num_threads(arguments.threads);  // of what is written, too
  Problem problem(deck.model, {arguments.precision, arguments.threads, arguments.device, arguments.heat_device,
                               static_cast<std::size_t>(1e9 * arguments.memory)});
  plan_stages(problem);  // refuses what a later stage could not start with
  for (const std::string& note : deck.model.notes) std::printf("note: %s\n", note.c_str());
  std::fflush(stdout);

  const RunDescription description = describe(deck, arguments, problem.backend->name());
  if (record) check_same_run(*record, description);
  const RunFolder folder =
      record ? RunFolder::existing(arguments.out)
             : RunFolder(arguments.out.empty() ? run_folder_name(deck.path) : arguments.out, arguments.force);
  RunWriter writer(folder, description, deck.model, problem.blocks, problem.contacts, record ? record->kept : RunKept{});
  ProgressLines progress(stdout, isatty(STDOUT_FILENO));
  Both both(progress, writer);
  catch_interrupts();
  try {
    const RunResult result = solve(problem, both, record ? record->restart : Restart{});
    RunFacts facts;
    facts.resumed = record != nullptr;
    facts.expects = evaluate(deck, result);
    facts.folder = folder.path();
    std::vector<ExpectRecord> records;
    for (const ExpectOutcome& e : facts.expects) records.push_back({e.name, e.passed, e.message, e.found, e.between});
    writer.finish(result, records);
    facts.files = writer.file_names();
    facts.files.push_back(summary_file);
    facts.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const std::string words = summary(deck.model, result, facts);
    replace_file(folder.file(summary_file), words);
    std::printf("\n%s", words.c_str());
    if (result.interrupted) std::printf("to go on: ashlar resume %s\n", folder.path().c_str());
    return exit_code(result, facts.expects);
  } catch (const std::exception& error) {
    writer.fail(error.what());
    if (std::filesystem::exists(folder.file(stage_checkpoint)) || std::filesystem::exists(folder.file(within_checkpoint)))
      std::printf("to go on from the last checkpoint: ashlar resume %s\n", folder.path().c_str());
    throw;
  }
}

}  // namespace

int run_command(const Arguments& arguments) { return run_deck(arguments, nullptr); }

int resume_command(const Arguments& given) {
  namespace fs = std::filesystem;
  Arguments arguments = given;
  const std::string folder = given.operands[0];
  const RunRecord record = read_run(folder);
  if (record.status == "finished" || record.status == "not converged")
    throw UsageError("'" + folder + "' is a run that came to its end (" + record.status + "): nothing is left to do");
  arguments.out = folder;
  std::error_code error;
  if (!fs::equivalent(record.working_directory, fs::current_path(), error)) {
    arguments.out = fs::absolute(folder).string();
    fs::current_path(record.working_directory, error);
    if (error)
      throw UsageError("the run was started in '" + record.working_directory + "', which is not there: " +
                       error.message());
  }
  arguments.operands = {record.deck};
  arguments.settings = record.settings;
  arguments.precision = record.precision == "single" ? Precision::single_precision : Precision::double_precision;
  if (record.kept.identity.empty()) {
    std::printf("no checkpoint had been written: the run starts anew\n");
    arguments.force = true;
    return run_deck(arguments, nullptr);
  }
  std::printf("goes on %s stage %d\n", record.restart.within ? "within" : "with", record.kept.stages + 1);
  return run_deck(arguments, &record);
}

}  // namespace ashlar
