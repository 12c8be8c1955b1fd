#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "base/nearest_name.hpp"
#include "cli/commands.hpp"
#include "cli/page.hpp"
#include "io/text_file.hpp"
#include "script/deck.hpp"
#include "solve/material_test.hpp"

namespace ashlar {
namespace {

const Material& material_named(const Model& model, const std::string& name) {
  std::vector<std::string> names;
  for (const Material& material : model.materials) {
    if (material.name == name) return material;
    names.push_back(material.name);
  }
  throw UsageError("the deck has no material '" + name + "'" + suggest_name(name, names));
}

/// What the law counts, in words.
struct Counted {
  const char *column, *name, *begins;
};
Counted counted_by(const std::string& law) {
  if (measure(law) == Measure::damage) return {"damage %", "damage", "cracks"};
  return {"plastic %", "plastic_strain", "flows"};
}

std::string row(const MaterialState& s) {
  return text("%14.5g%14.5g%14.5g%14.5g%14.5g", 100 * s.strain, s.stress / 1e6, s.lateral_stress / 1e6, 100 * s.volume,
              100 * s.plastic_strain);
}

void describe(Page& page, const MaterialCurve& curve, const Counted& counted) {
  constexpr int rows = 8;
  const auto flows = [&](const MaterialState& s) { return s.plastic_strain > curve.states[0].plastic_strain; };
  const auto first = std::find_if(curve.states.begin(), curve.states.end(), flows);
  const auto peak = std::max_element(curve.states.begin(), curve.states.end(), [](const auto& a, const auto& b) {
    return std::abs(a.stress) < std::abs(b.stress) * (1 - 1e-9);
  });
  const auto at = [](const MaterialState& s) { return text("%.5g MPa at %.4g %%", s.stress / 1e6, 100 * s.strain); };
  page.line("test", curve.test + (first == curve.states.end() ? ": elastic, up to " : ": " + std::string(counted.begins) + " from ") +
                        at(first == curve.states.end() ? *peak : *first) +
                        (first == curve.states.end() ? "" : ", peak " + at(*peak)));
  page.line("", text("    strain %%    stress MPa   lateral MPa      volume %%%14s", counted.column));
  const std::size_t last = curve.states.size() - 1;
  for (int i = 0; i <= rows; ++i) page.line("", row(curve.states[last * i / rows]));
}

void write_curves(const std::string& path, bool force, const std::vector<MaterialCurve>& curves,
                  const Counted& counted) {
  if (std::filesystem::exists(path) && !force)
    throw UsageError("'" + path + "' exists already; give another name, or --force to replace it");
  std::string all = "test,strain,stress [Pa],lateral_stress [Pa],volumetric_strain," + std::string(counted.name) + "\n";
  for (const MaterialCurve& curve : curves)
    for (const MaterialState& s : curve.states)
      all += curve.test +
             text(",%.9g,%.9g,%.9g,%.9g,%.9g\n", s.strain, s.stress, s.lateral_stress, s.volume, s.plastic_strain);
  replace_file(path, all);
}

}  // namespace

int material_command(const Arguments& arguments) {
  const Deck deck = read_deck(arguments.operands[0], {arguments.settings.begin(), arguments.settings.end()});
  const Material& material = material_named(deck.model, arguments.operands[1]);
  std::vector<double> confining;
  for (const double pressure : arguments.confining) confining.push_back(1e6 * pressure);
  const BlockLaw law = make_block_law(material.law, material.values);
  if (const double most = largest_length(law); arguments.size > most)
    throw UsageError(text("a block of %.4g m would snap back as it cracks; give --size of at most %.4g", arguments.size,
                          most));
  const auto curves = test_material(law, confining, arguments.strain, arguments.size);
  Page page;
  page.line("material", material.name + ", law " + material.law + "; one point, tension positive");
  for (const MaterialCurve& curve : curves) describe(page, curve, counted_by(material.law));
  if (!arguments.to.empty()) {
    write_curves(arguments.to, arguments.force, curves, counted_by(material.law));
    page.line("files", arguments.to + "  (`ashlar plot " + arguments.to + "` draws it)");
  }
  std::fputs(page.lines().c_str(), stdout);
  return 0;
}

}  // namespace ashlar
