#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "cli/commands.hpp"
#include "cli/page.hpp"
#include "io/mesh_writer.hpp"
#include "io/text_file.hpp"
#include "script/deck.hpp"
#include "solve/stage_conditions.hpp"

namespace ashlar {
namespace {

/// What a static stage asks of the mesh nodes; copies of a node that contacts tie are one again.
NodalStep nodal_step(const Problem& problem, int stage) {
  const MechanicalConditions conditions = mechanical_conditions(problem, stage);
  const auto nodes = problem.model.mesh.points.size();
  NodalStep step{problem.model.stages[stage].name, std::vector<double>(3 * nodes), std::vector<unsigned>(nodes),
                 std::vector<double>(3 * nodes)};
  const auto& mesh_node = problem.blocks.mesh_node;
  for (std::size_t n = 0; n < mesh_node.size(); ++n) {
    for (int a = 0; a < 3; ++a) step.force[3 * mesh_node[n] + a] += conditions.load[3 * n + a];
    step.held[mesh_node[n]] |= static_cast<unsigned>(conditions.fixed[n]);
  }
  for (std::size_t i = 0; i < conditions.prescribed.size(); ++i)
    step.displacement[3 * mesh_node[conditions.prescribed[i] / 3] + conditions.prescribed[i] % 3] =
        conditions.displacement[i];
  return step;
}

/// What an Abaqus file does not hold of the model.
std::vector<std::string> missing(const Model& model) {
  std::vector<std::string> lines;
  for (const Interface& i : model.interfaces)
    lines.push_back(std::string(i.crackable ? "crackable '" : "joint '") + i.name + "': bodies are whole here");
  for (const Material& m : model.materials)
    if (m.law != "elastic") lines.push_back("material '" + m.name + "': elastic here, law " + m.law + " in the deck");
  bool warm = false;
  for (const Condition& c : model.conditions) warm = warm || std::holds_alternative<TemperatureField>(c.kind);
  for (const Stage& stage : model.stages) {
    warm = warm || is_thermal(stage);
    if (!std::holds_alternative<StaticSolve>(stage.solve))
      lines.push_back("stage '" + stage.name + "': only static stages become steps");
  }
  if (warm) lines.push_back("temperatures: steps have no thermal strains");
  return lines;
}

std::string abaqus_text_of(const Model& model, const std::vector<std::string>& remarks) {
  std::vector<NodalStep> steps;
  if (!model.stages.empty()) {
    check_model(model);
    const Problem problem(model, {});
    for (std::size_t s = 0; s < model.stages.size(); ++s)
      if (std::holds_alternative<StaticSolve>(model.stages[s].solve))
        steps.push_back(nodal_step(problem, static_cast<int>(s)));
  }
  return abaqus_text(model, steps, remarks);
}

}  // namespace

int export_command(const Arguments& arguments) {
  const std::string extension = std::filesystem::path(arguments.to).extension();
  if (extension != ".msh" && extension != ".vtu" && extension != ".inp")
    throw UsageError("--to names the file to write, whose extension is its kind: .msh (Gmsh 4.1), .vtu (ParaView), " +
                     std::string(".inp (CalculiX, Abaqus)") +
                     (arguments.to.empty() ? "" : "; not '" + arguments.to + "'"));
  if (std::filesystem::exists(arguments.to) && !arguments.force)
    throw UsageError("'" + arguments.to + "' exists already; give another name, or --force to replace it");
  Deck deck = read_deck(arguments.operands[0], {arguments.settings.begin(), arguments.settings.end()});
  build_mesh(deck.model);
  const Mesh& mesh = deck.model.mesh;
  const auto remarks = extension == ".inp" ? missing(deck.model) : std::vector<std::string>{};
  replace_file(arguments.to, extension == ".msh"   ? gmsh_text(mesh)
                             : extension == ".vtu" ? vtu_text(mesh)
                                                   : abaqus_text_of(deck.model, remarks));
  Page page;
  page.line("export", arguments.to + ": " + counted(mesh.element_count(), "element") + ", " +
                          counted(mesh.node_count(), "node") + ", " +
                          counted(static_cast<long>(mesh.region_names.size()), "region") + ", " +
                          counted(static_cast<long>(mesh.surfaces.size()), "surface"));
  for (const std::string& line : remarks) page.line("left out", line);
  std::fputs(page.lines().c_str(), stdout);
  return 0;
}

}  // namespace ashlar
