#include "cli/commands.hpp"

#include <omp.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "backend/device.hpp"
#include "cli/check_report.hpp"
#include "cli/page.hpp"
#include "cli/plot.hpp"
#include "cli/summary.hpp"
#include "cli/wording.hpp"
#include "io/mesh_writer.hpp"
#include "io/text_file.hpp"
#include "script/deck.hpp"
#include "script/schema.hpp"

namespace ashlar {

int check_command(const Arguments& arguments) {
  if (!arguments.to.empty() && std::filesystem::path(arguments.to).extension() != ".vtu")
    throw UsageError("--to of check names the file for the interfaces, with the extension .vtu; not '" + arguments.to +
                     "'");
  if (!arguments.to.empty() && std::filesystem::exists(arguments.to) && !arguments.force)
    throw UsageError("'" + arguments.to + "' exists already; give another name, or --force to replace it");
  Deck deck = read_deck(arguments.operands[0], {arguments.settings.begin(), arguments.settings.end()});
  build_mesh(deck.model);
  check_model(deck.model);
  Problem problem(deck.model, {});
  std::fputs(check_report(problem).c_str(), stdout);
  if (arguments.to.empty()) return 0;
  replace_file(arguments.to, interfaces_vtu_text(deck.model, problem.blocks));
  Page page;
  page.line("interfaces", arguments.to + ": to be seen in ParaView");
  std::fputs(page.lines().c_str(), stdout);
  return 0;
}

int info_command(const Arguments& arguments) {
  if (arguments.operands.empty()) {
    Page page;
    page.line("ashlar", ASHLAR_VERSION ", built by " ASHLAR_COMPILER);
    page.line("machine", counted(omp_get_num_procs(), "core"));
    const CudaSupport cuda = cuda_support();
    for (std::size_t i = 0; i < cuda.devices.size(); ++i) {
      const CudaDevice& d = cuda.devices[i];
      page.line("machine", text("cuda:%zu: %s, compute capability %d.%d, %.1f of %.1f GB free", i, d.name.c_str(),
                                d.major, d.minor, double(d.free_bytes) / 1e9, double(d.memory_bytes) / 1e9));
    }
    if (!cuda.missing.empty()) page.line("machine", cuda.missing);
    page.line("runs use", cuda.devices.empty() ? "the CPU" : "cuda:0, unless --device says otherwise");
    page.line("lanes", "of coupled stages: in turns there, or beside each other, as --devices stress=" +
                           std::string(cuda.devices.empty()       ? "cpu,thermal=cpu"
                                       : cuda.devices.size() == 1 ? "cuda:0,thermal=cuda:0"
                                                                  : "cuda:0,thermal=cuda:1"));
    std::fputs(page.lines().c_str(), stdout);
    return 0;
  }
  const std::filesystem::path folder = arguments.operands[0];
  std::ifstream file(folder / summary_file);
  if (!file)
    throw UsageError("'" + folder.string() + "' holds no finished run: there is no " +
                     (folder / summary_file).string());
  std::stringstream words;
  words << file.rdbuf();
  std::fputs(words.str().c_str(), stdout);
  return 0;
}

int help_command(const Arguments& arguments) {
  std::string page = usage_page() + "\n" + help_index();
  if (!arguments.operands.empty()) {
    const std::string& about = arguments.operands[0];  // may be a command and a noun
    page = usage_of(about);
    if (page.empty() || find_noun(about)) page = help(about) + (page.empty() ? "" : "\nThe command\n\n" + page);
  }
  std::fputs(page.c_str(), stdout);
  return 0;
}

int version_command(const Arguments&) {
  std::puts("ashlar " ASHLAR_VERSION);
  return 0;
}

int plot_command(const Arguments& arguments) { return plot(arguments.passed); }

}  // namespace ashlar
