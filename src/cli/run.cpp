#include <unistd.h>

#include <chrono>
#include <cstdio>

#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress.hpp"
#include "cli/summary.hpp"
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
                             .device = device,
                             .precision = arguments.precision == Precision::double_precision ? "double" : "single",
                             .threads = arguments.threads};
  for (const Argument& a : deck.arguments) description.arguments.push_back({a.name, a.value, a.unit, a.set});
  return description;
}

}  // namespace

int run_command(const Arguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  Deck deck = read_deck(arguments.operands[0], {arguments.settings.begin(), arguments.settings.end()});
  build_mesh(deck.model);
  check_model(deck.model);
  Problem problem(deck.model, {arguments.precision, arguments.threads, arguments.device, arguments.heat_device});
  plan_stages(problem);  // refuses what a later stage could not start with

  const RunFolder folder(arguments.out.empty() ? run_folder_name(deck.path) : arguments.out, arguments.force);
  RunWriter writer(folder, describe(deck, arguments, problem.backend->name()), deck.model, problem.blocks,
                   problem.contacts);
  ProgressLines progress(stdout, isatty(STDOUT_FILENO));
  Both both(progress, writer);
  catch_interrupts();
  try {
    const RunResult result = solve(problem, both);
    RunFacts facts;
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
    return exit_code(result, facts.expects);
  } catch (const std::exception& error) {
    writer.fail(error.what());
    throw;
  }
}

}  // namespace ashlar
