#include "cli/summary.hpp"

#include <sys/resource.h>

#include <algorithm>

#include "cli/left_out.hpp"
#include "cli/page.hpp"
#include "cli/wording.hpp"

namespace ashlar {
namespace {

void describe_initial(Page& page, const InitialBalance& initial) {
  if (initial.share < InitialBalance::far)
    return page.line("stage", text("  initial stress: out of balance by %.1e of its forces", initial.share));
  page.line("stage", text("  WARNING initial stress and loads are out of balance by %.2g %% of their forces, most at ",
                          100 * initial.share) +
                         place_in_metres(initial.place) + text(", %.3g N:", initial.largest));
  page.line("stage", "    as it should be where the model leaves out ground that has been dug away, as in a tunnel; else:");
  page.line("stage", "    is gravity given, are level, unit weight and k0 those of the ground, are its sides held?");
}

void describe_end(Page& page, const StageResult& stage) {
  if (stage.balanced()) return;
  page.line("stage", "  its end is NOT in balance: the last row of histories has balanced = 0, pictures say so");
}

void describe_stage(Page& page, int number, const StageResult& stage) {
  if (stage.kind == "dynamic") {
    page.line("stage", text("%d %s (%s): %s, %s of %.3g s, %s", number, stage.name.c_str(), stage.kind.c_str(),
                            stage.stop_reason.c_str(), counted(stage.steps, "step").c_str(), stage.time_step,
                            duration_text(stage.wall_seconds).c_str()));
    const EnergyBalance& e = stage.energy;
    page.line("stage", text("  energy: kinetic %.4g + strain %.4g + dissipated %.4g - work %.4g = %.4g J, kept to %.1e",
                            e.kinetic, e.strain, e.dissipated, e.external_work,
                            e.kinetic + e.strain + e.dissipated - e.external_work, e.drift));
    if (e.drift > 0.01)
      page.line("stage",
                "    not well: faces that chatter want a smaller 'time_factor' or damping; the work of crack_water "
                "is not counted");
    if (stage.initial) describe_initial(page, *stage.initial);
    return;
  }
  page.line("stage", text("%d %s (%s): %s, %s, ratio %.1e, %s", number, stage.name.c_str(), stage.kind.c_str(),
                          stage.stop_reason.c_str(), counted(stage.steps, "step").c_str(), stage.ratio,
                          duration_text(stage.wall_seconds).c_str()));
  if (stage.initial) describe_initial(page, *stage.initial);
  if (stage.safety_factor > 0)
    page.line("stage", text("  safety factor %.4g: stands at %.4g", stage.safety_factor, stage.safety_factor) +
                           (stage.falling_factor > 0 ? text(", falls at %.4g", stage.falling_factor) : ""));
  if (stage.lanes) {
    const LaneTimes& lanes = *stage.lanes;
    page.line("lanes", text("stress on %s: at work for %s", lanes.stress_device.c_str(),
                            duration_text(lanes.stress).c_str()));
    page.line("lanes", text("heat on %s: %s, at work for %s, ", lanes.heat_device.c_str(),
                            counted(lanes.heat_steps, "step").c_str(), duration_text(lanes.heat).c_str()) +
                           (lanes.beside ? text("%s of them beside the stress (%.0f %%)",
                                                duration_text(lanes.both).c_str(), 100 * lanes.both / lanes.heat)
                                         : "in turns with the stress"));
    if (stage.load_factor < 1) page.line("stage", "  stopped after " + time_text(stage.seconds));
    return;
  }
  if (stage.load_factor < 1) page.line("stage", text("  stopped at load factor %.4f", stage.load_factor));
}

std::string event_text(const CrackEvent& event) {
  const std::string when =
      event.seconds > 0 ? "after " + time_text(event.seconds) : text("load factor %.4f", event.load_factor);
  return text("%s, %s, in %s, at %s", when.c_str(), event.interface.c_str(), event.mode.c_str(),
              place_in_metres(event.place).c_str());
}

void describe_cracks(Page& page, const StageResult& stage) {
  if (stage.events.empty() && stage.cracked_area == 0 && stage.loose.empty()) return;
  long points = 0;
  for (const CrackEvent& event : stage.events) points += event.contact_points;
  page.line("cracks",
            text("%s: %s, %s", stage.name.c_str(), counted(static_cast<long>(stage.events.size()), "event").c_str(),
                 counted(points, "contact point").c_str()));
  if (!stage.events.empty()) {
    page.line("cracks", "  first: " + event_text(stage.events.front()));
    page.line("cracks", "  last:  " + event_text(stage.events.back()));
  }
  std::string directions;
  for (const auto& [direction, area] : stage.cracked_area_by_direction)
    directions += (directions.empty() ? " (" : ", ") + direction + text(" %.4g", area);
  page.line("cracks", text("  area %.4g m^2", stage.cracked_area) + directions + (directions.empty() ? "" : ")"));
  if (const auto& lost = stage.dissipated_by_contacts; lost.sum() > 0)
    page.line("cracks", text("  dissipated by opening %.4g J, by shear %.4g J, by friction %.4g J", lost.opening,
                             lost.shear, lost.friction));
  constexpr std::size_t most_named = 10;
  for (std::size_t i = 0; i < stage.loose.size() && i < most_named; ++i) {
    const LooseBlocks& loose = stage.loose[i];
    page.line("cracks", "  loose: " + counted(static_cast<long>(loose.blocks.size()), "block") +
                            text(" of %s, %.4g m^3 about ", loose.region.c_str(), loose.volume) +
                            place_in_metres(loose.centre));
  }
  if (stage.loose.size() > most_named)
    page.line("cracks", text("  and %zu more loose bodies, in manifest.json", stage.loose.size() - most_named));
}

/// Seconds per activity or per phase over all stages, the longest first, one line each.
void describe_times(Page& page, const RunResult& result, std::vector<PhaseTime> StageResult::*times, const char* indent) {
  std::vector<PhaseTime> total;
  double sum = 0;
  for (const StageResult& stage : result.stages)
    for (const PhaseTime& time : stage.*times) {
      auto same = std::find_if(total.begin(), total.end(), [&](const PhaseTime& t) { return t.phase == time.phase; });
      if (same == total.end()) same = total.insert(total.end(), {time.phase, 0});
      same->seconds += time.seconds;
      sum += time.seconds;
    }
  std::stable_sort(total.begin(), total.end(),
                   [](const PhaseTime& a, const PhaseTime& b) { return a.seconds > b.seconds; });
  for (const PhaseTime& time : total)
    if (time.seconds > 0.01 * sum)
      page.line("time", text("%s%s %s (%.0f %%)", indent, time.phase.c_str(), duration_text(time.seconds).c_str(),
                             100 * time.seconds / sum));
}

double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

}  // namespace

std::string summary(const Model& model, const RunResult& result, const RunFacts& facts) {
  Page page;
  page.line("model",
            model.name + text(": %s, ", counted(model.mesh.element_count(), "element").c_str()) + result.device);
  for (std::size_t i = 0; i < result.stages.size(); ++i) {
    describe_stage(page, static_cast<int>(i) + 1, result.stages[i]);
    describe_end(page, result.stages[i]);
  }
  for (const StageResult& stage : result.stages) describe_cracks(page, stage);
  for (const StageResult& stage : result.stages)
    if (stage.plastic_work > 0)
      page.line("flow", text("%s: plastic flow dissipated %.4g J", stage.name.c_str(), stage.plastic_work));
  for (const StageResult& stage : result.stages)
    if (stage.fracture_work > 0)
      page.line("cracks", text("%s: cracking blocks released %.4g J", stage.name.c_str(), stage.fracture_work));
  page.line("time", duration_text(facts.wall_seconds) + (facts.resumed ? " since it was resumed" : " in all"));
  describe_times(page, result, &StageResult::activities, "  ");
  const bool phases = std::any_of(result.stages.begin(), result.stages.end(), [](auto& s) { return !s.phases.empty(); });
  if (phases) page.line("time", "  by phases of steps, set-up and output:");
  describe_times(page, result, &StageResult::phases, "    ");
  page.line("memory", text("%.0f MB at most", peak_memory() / 1e6));
  for (const ExpectOutcome& outcome : facts.expects)
    page.line("expect", (outcome.passed ? "ok      " : "FAILED  ") + outcome.name + ": " + outcome.message);
  for (const std::string& line : model.notes) page.line("note", line);
  for (const std::string& line : left_out(model)) page.line("left out", line);
  for (const std::string& file : facts.files) page.line("files", facts.folder + "/" + file);
  return page.lines();
}

int exit_code(const RunResult& result, const std::vector<ExpectOutcome>& expects) {
  if (result.interrupted) return 130;
  if (!result.all_converged()) return 3;
  for (const ExpectOutcome& outcome : expects)
    if (!outcome.passed) return 4;
  return 0;
}

}  // namespace ashlar
