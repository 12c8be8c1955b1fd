#include <cstdio>
#include <filesystem>

#include "cli/commands.hpp"
#include "cli/page.hpp"
#include "io/compare_results.hpp"

namespace ashlar {
namespace {

namespace fs = std::filesystem;

/// The result file that an operand means: itself, the one beside an .xdmf, or NAME.vtkhdf of a run's folder.
std::string file_of(const std::string& operand, const std::string& name) {
  if (fs::is_directory(operand)) return (fs::path(operand) / (name + ".vtkhdf")).string();
  if (fs::path(operand).extension() == ".xdmf") return fs::path(operand).replace_extension(".vtkhdf").string();
  return operand;
}

void describe(Page& page, const Comparison& comparison, const char* point, const char* cell) {
  for (const StageDifference& stage : comparison.stages)
    for (const FieldDifference& d : stage.fields)
      page.line(stage.stage, d.largest == 0 ? text("%-18s same bits", d.field.c_str())
                                            : text("%-18s max %.2e, mean %.2e, %.3g %s at ", d.field.c_str(),
                                                   d.largest_relative, d.mean_relative, d.largest, d.unit.c_str()) +
                                                  text("%s %zu, ", d.on_points ? point : cell, d.index) +
                                                  place_in_metres(d.place));
  for (const std::string& line : comparison.missing) page.line("missing", line);
}

void describe(const LineComparison& table) {
  std::printf("\n%s [%s]\n%10s  %-34s %14s %14s %10s\n", table.name.c_str(), table.unit.c_str(), "along [m]",
              "place [m]", "A", "B", "error [%]");
  for (const LineSample& s : table.samples) {
    const std::string place = text("(%.6g, %.6g, %.6g)", s.place.x, s.place.y, s.place.z);
    if (s.inside)
      std::printf("%10.5g  %-34s %14.6e %14.6e %10.3g\n", s.along, place.c_str(), s.a, s.b, 100 * s.relative);
    else
      std::printf("%10.5g  %-34s outside the body\n", s.along, place.c_str());
  }
}

}  // namespace

int compare_command(const Arguments& arguments) {
  const std::string &a = arguments.operands[0], &b = arguments.operands[1];
  Page page;
  double largest = 0;
  std::size_t missing = 0;
  const auto compare = [&](const std::string& name, const char* point, const char* cell) {
    ResultReader one(file_of(a, name)), other(file_of(b, name));
    const Comparison comparison = compare_results(one, other);
    describe(page, comparison, point, cell);
    largest = std::max(largest, comparison.largest_relative());
    missing += comparison.missing.size();
  };
  page.line("compare", "A: " + a);
  page.line("compare", "B: " + b);
  page.line("measure", "|A - B| over the largest |B| of the field in all stages, |..| the root of the sum of squares of "
                       "components");
  compare("results", "node", "element");
  const auto interfaces = [](const std::string& run) { return fs::exists(fs::path(run) / "interfaces.vtkhdf"); };
  if (interfaces(a) && interfaces(b)) compare("interfaces", "contact point", "face");
  const bool within = largest <= arguments.tolerance && missing == 0;
  page.line("result", (largest == 0 ? std::string("same bits") : text("largest difference %.2e", largest)) +
                          (missing > 0 ? ", " + counted(long(missing), "output") + " or fields missing" : "") +
                          (arguments.tolerance < 0 ? "" : text(", %s the tolerance %g", within ? "within" : "beyond",
                                                               arguments.tolerance)));
  std::vector<LineComparison> tables;
  std::string stage = arguments.stage;
  if (!arguments.line.empty()) {
    ResultReader one(file_of(a, "results")), other(file_of(b, "results"));
    if (other.steps().empty()) throw UsageError("'" + b + "' holds no output yet");
    const auto& l = arguments.line;
    if (stage.empty()) stage = other.steps().back().stage;
    tables = compare_along(one, other, stage, {l[0], l[1], l[2]}, {l[3], l[4], l[5]},
                           arguments.of.empty() ? "displacement" : arguments.of);
  }
  std::fputs(page.lines().c_str(), stdout);
  if (!tables.empty())
    std::printf("\nAlong the line, end of stage %s; error: |A - B| over the largest |B| of the line\n", stage.c_str());
  for (const LineComparison& table : tables) describe(table);
  return within || arguments.tolerance < 0 ? 0 : 4;
}

}  // namespace ashlar
