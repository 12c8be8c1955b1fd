#include "io/run_writer.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/history_file.hpp"
#include "io/sample_model.hpp"
#include "io/sha256.hpp"

namespace ashlar {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::vector<std::string> lines_of(const std::string& path) {
  std::istringstream text(text_of(path));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

/// Message of the DeckError that `action` throws.
template <class Action>
std::string deck_error(Action action) {
  try {
    action();
  } catch (const DeckError& error) {
    return error.what();
  }
  return "no complaint";
}

// FIPS 180-4 test vectors.
TEST(Sha256, gives_the_published_digests) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(RunFolder, is_never_overwritten_unless_asked) {
  const TemporaryFolder place;
  const std::string path = place.file("deep/dam.run");
  { const RunFolder folder(path, false); }
  EXPECT_TRUE(std::filesystem::is_directory(path));
  const RunFolder again(path, false);  // an empty folder is as good as none
  std::ofstream(again.file("manifest.json")) << "{}";
  std::ofstream(again.file("old.png")) << "old";
  EXPECT_EQ(deck_error([&] { RunFolder(path, false); }),
            "folder '" + path + "' holds an earlier run; replace it with --force or choose another folder with --out");
  EXPECT_TRUE(std::filesystem::exists(path + "/old.png"));
  const RunFolder replaced(path, true);
  EXPECT_TRUE(std::filesystem::is_empty(path));
}

TEST(RunFolder, a_folder_that_is_no_run_is_left_alone_even_if_asked) {
  const TemporaryFolder place;
  std::ofstream(place.file("thesis.tex")) << "years of work";
  EXPECT_EQ(deck_error([&] { RunFolder(place.path(), true); }),
            "folder '" + place.path() + "' is not empty and holds no run; choose another one with --out");
  EXPECT_EQ(text_of(place.file("thesis.tex")), "years of work");
  EXPECT_EQ(deck_error([&] { RunFolder(place.file("thesis.tex"), true); }),
            "'" + place.file("thesis.tex") + "' is a file; choose another folder for the results with --out");
}

TEST(RunFolder, a_place_that_refuses_it_is_a_resource_error) {
  try {
    const RunFolder folder("/proc/dam.run", false);
    FAIL();
  } catch (const ResourceError& error) {
    EXPECT_EQ(std::string(error.what()).find("cannot create folder '/proc/dam.run': "), 0u);
  }
}

TEST(RunFolder, is_named_after_the_deck) { EXPECT_EQ(run_folder_name("decks/dam/seasons.lua"), "seasons.run"); }

HistoryTable crest() {
  HistoryTable table;
  table.name = "crest";
  table.columns = {"displacement.x", "temperature"};
  table.units = {"m", "degC"};
  table.rows = {{"gravity", 1, 1, {1.0 / 3, 10}}, {"a,\"b\"", 86400, 0.1, {-2.5e-300, -0.0}, false}};
  return table;
}

TEST(HistoryFile, numbers_read_back_as_the_same_bits) {
  const TemporaryFolder place;
  HistoryFile file(place.file("h.csv"), crest());
  file.update(crest());
  const auto lines = lines_of(place.file("h.csv"));
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], "stage,time,load_factor,balanced,displacement.x [m],temperature [degC]");
  double x = 0, t = 0;
  ASSERT_EQ(std::sscanf(lines[1].c_str(), "gravity,1,1,1,%lf,%lf", &x, &t), 2);
  EXPECT_EQ(x, 1.0 / 3);
  EXPECT_EQ(lines[2], "\"a,\"\"b\"\"\",86400,0.1,0,-2.5e-300,-0");
}

/// A run of the sample model; what it wrote lies in `folder`.
struct SampleRun {
  TemporaryFolder place;
  SampleModel sample;
  std::string deck = place.file("dam.lua");
  RunFolder folder{place.file("dam.run"), false};

  RunDescription description() {
    std::ofstream(deck) << "model \"sample\" {}\n";
    return {"0.1.0", "g++", deck, {deck}, {{"water", "150 m", "m", true}}, {}, "cpu", "double", 2};
  }

  void run(const std::string& history_name = "crest") {
    sample.model.pictures.resize(1);
    sample.model.pictures[0].name = "cracks";
    sample.model.pictures[0].of = "broken";
    RunWriter writer(folder, description(), sample.model, sample.blocks, sample.contacts);
    RunResult result;
    result.device = "cpu, 2 threads";
    result.histories = {crest()};
    result.histories[0].name = history_name;
    for (int number = 1; number <= 2; ++number) {
      StageResult stage;
      stage.name = number == 1 ? "gravity" : "winter";
      stage.kind = number == 1 ? "static" : "thermal transient";
      stage.converged = true;
      stage.stop_reason = "converged";
      stage.phases = {{"block_force", 0.25}};
      stage.events = {{0.5, {1, 2, 3}, 4, "dam_base", "tension"}};
      writer.stage_begins(number, stage.name, stage.kind);
      writer.crack(stage.name, stage.events[0]);
      auto partial = result.histories[0];
      partial.rows.resize(number);
      writer.history_row(partial);
      writer.output(sample.snapshot(stage.name, number, number, number == 2));
      writer.stage_ends(stage);
      result.stages.push_back(stage);
    }
    writer.finish(result, {{"crest settles", true, "-12 mm", -0.012, std::array{-0.02, -0.01}}});
  }
  nlohmann::json manifest() const { return nlohmann::json::parse(text_of(folder.file("manifest.json"))); }
};

TEST(RunWriter, manifest_says_what_ran_on_what_and_which_files_it_left) {
  SampleRun run;
  run.run();
  const auto manifest = run.manifest();
  EXPECT_EQ(manifest["status"], "finished");
  EXPECT_EQ(manifest["device"], "cpu, 2 threads");
  EXPECT_EQ(manifest["model"]["name"], "sample");
  EXPECT_EQ(manifest["model"]["elements"], 4);
  EXPECT_EQ(manifest["deck"]["sha256"], sha256("model \"sample\" {}\n"));
  EXPECT_EQ(manifest["arguments"][0]["value"], "150 m");
  EXPECT_EQ(manifest["stages"][1]["phase_seconds"]["block_force"], 0.25);
  EXPECT_EQ(manifest["pictures"][0]["of"], "broken");
  EXPECT_EQ(manifest["expects"][0]["passed"], true);
  EXPECT_EQ(manifest["expects"][0]["found"], -0.012);
  EXPECT_EQ(manifest["expects"][0]["between"], (std::vector<double>{-0.02, -0.01}));
  const std::vector<std::string> files = manifest["files"];
  EXPECT_EQ(files, (std::vector<std::string>{"manifest.json", "log.jsonl", "dam.lua", "results.vtkhdf", "results.xdmf",
                                             "interfaces.vtkhdf", "interfaces.xdmf", "history_crest.csv"}));
  for (const auto& file : files) EXPECT_TRUE(std::filesystem::exists(run.folder.file(file))) << file;
  for (const auto& entry : std::filesystem::directory_iterator(run.folder.path()))
    EXPECT_NE(std::find(files.begin(), files.end(), entry.path().filename()), files.end()) << entry.path();
  EXPECT_EQ(text_of(run.folder.file("dam.lua")), text_of(run.deck));
}

TEST(RunWriter, log_has_one_object_a_line_in_order) {
  SampleRun run;
  run.run();
  std::vector<std::string> events;
  double seconds = 0;
  for (const auto& line : lines_of(run.folder.file("log.jsonl"))) {
    const auto json = nlohmann::json::parse(line);
    events.push_back(json["event"]);
    EXPECT_GE(json["seconds"], seconds);
    seconds = json["seconds"];
  }
  EXPECT_EQ(events, (std::vector<std::string>{"run_begins", "stage_begins", "crack", "output", "stage_ends",
                                              "stage_begins", "crack", "output", "stage_ends", "run_ends"}));
}

TEST(RunWriter, every_history_row_is_written_once) {
  SampleRun run;
  run.run("crest/left");
  EXPECT_EQ(lines_of(run.folder.file("history_crest_left.csv")).size(), 3u);
  EXPECT_EQ(run.manifest()["histories"][0]["file"], "history_crest_left.csv");
}

TEST(RunWriter, a_run_that_stops_half_way_leaves_a_manifest_and_its_rows) {
  SampleRun run;
  {
    RunWriter writer(run.folder, run.description(), run.sample.model, run.sample.blocks, run.sample.contacts);
    EXPECT_EQ(run.manifest()["status"], "running");
    auto table = crest();
    table.rows.resize(1);
    writer.history_row(table);
    EXPECT_EQ(lines_of(run.folder.file("history_crest.csv")).size(), 2u);
    writer.fail("the disk is full");
  }
  EXPECT_EQ(run.manifest()["status"], "failed");
  EXPECT_EQ(run.manifest()["error"], "the disk is full");
}

TEST(RunWriter, results_do_not_depend_on_when_the_run_was) {
  SampleRun a, b;
  a.run();
  b.run();
  for (const char* name : {"history_crest.csv", "results.vtkhdf", "results.xdmf", "interfaces.vtkhdf"})
    EXPECT_TRUE(text_of(a.folder.file(name)) == text_of(b.folder.file(name))) << name;
}

TEST(RunWriter, a_folder_that_vanished_is_a_resource_error_that_names_it) {
  SampleRun run;
  const auto description = run.description();
  std::filesystem::remove_all(run.folder.path());
  try {
    RunWriter writer(run.folder, description, run.sample.model, run.sample.blocks, run.sample.contacts);
    FAIL();
  } catch (const ResourceError& error) {
    EXPECT_EQ(std::string(error.what()),
              "cannot write '" + run.folder.file("log.jsonl") + "': No such file or directory");
  }
}

TEST(RunWriter, a_full_disk_is_a_resource_error) {
  GrowingFile full("/dev/full");
  EXPECT_THROW(full.add("text\n"), ResourceError);
}

}  // namespace
}  // namespace ashlar
