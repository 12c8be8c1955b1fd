#include "cli/check_report.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "cli/estimate.hpp"
#include "cli/left_out.hpp"
#include "cli/page.hpp"
#include "cli/wording.hpp"
#include "model/blocks.hpp"
#include "model/check_mesh.hpp"
#include "model/conditions.hpp"
#include "physics/laws/laws.hpp"
#include "solve/plan.hpp"

namespace ashlar {
namespace {

const Material* material_of(const Model& model, const std::string& region) {
  for (const Material& material : model.materials)
    if (std::find(material.regions.begin(), material.regions.end(), region) != material.regions.end()) return &material;
  return nullptr;
}

void describe_mesh(Page& page, const Model& model, const MeshQuality& quality) {
  const Mesh& mesh = model.mesh;
  std::map<Shape, long> by_shape;
  for (Shape shape : mesh.shapes) ++by_shape[shape];
  std::string shapes;
  for (const auto& [shape, count] : by_shape)
    shapes += (shapes.empty() ? "" : ", ") + count_text(count) + " " + shape_name(shape);
  page.line("mesh", counted(mesh.element_count(), "element") + " (" + shapes + "), " +
                        counted(mesh.node_count(), "node") + text(", %.6g m^3", quality.volume));
  Vec3<double> low = mesh.points[0], high = low;
  for (const auto& p : mesh.points)
    for (int i = 0; i < 3; ++i) low[i] = std::min(low[i], p[i]), high[i] = std::max(high[i], p[i]);
  page.line("mesh", "from " + place_in_metres(low) + " to " + place_in_metres(high));
  const auto worst = [&](const WorstElement& w, const char* format) {
    return text(format, w.value) + text(": element %ld of ", mesh.source_ids[w.element]) +
           mesh.region_names[mesh.regions[w.element]] + " at " + place_in_metres(w.place);
  };
  page.line("quality", worst(quality.smallest_edge, "smallest edge %.4g m"));
  page.line("quality", worst(quality.worst_aspect, "largest aspect ratio %.3g"));
  page.line("quality", worst(quality.worst_scaled_jacobian, "smallest scaled Jacobian %.3f (1 is best)"));
}

void describe_regions(Page& page, const Model& model, const MeshQuality& quality) {
  const Mesh& mesh = model.mesh;
  for (std::size_t r = 0; r < mesh.region_names.size(); ++r) {
    const long count = std::count(mesh.regions.begin(), mesh.regions.end(), static_cast<int>(r));
    const Material* material = material_of(model, mesh.region_names[r]);
    page.line("region", text("%s: %s, %.6g m^3", mesh.region_names[r].c_str(), counted(count, "element").c_str(),
                             quality.region_volume[r]) +
                            (material ? ", " + mass_text(material->density * quality.region_volume[r]) + ", " +
                                            material->name + " (" + material->law + ")"
                                      : ", no material"));
  }
}

/// Whether the deck or its mesh files name the surface; sections and boxes bring sides that nobody may have asked for.
bool is_deck_surface(const Model& model, const std::string& name) {
  for (const SurfaceChoice& choice : model.surfaces)
    if (choice.name == name) return true;
  for (const ImportedMesh& imported : model.imports)
    if (imported.mesh.find_surface(name)) return true;
  return false;
}

void describe_surfaces(Page& page, const Model& model) {
  std::map<std::string, std::string> users;
  for (const Condition& condition : model.conditions)
    for (const std::string& name : condition.surfaces) {
      std::string& list = users[name];
      if (list.find(condition.noun) == std::string::npos) list += (list.empty() ? "" : ", ") + condition.noun;
    }
  for (const Surface& surface : model.mesh.surfaces) {
    double area = 0;
    for (const Facet& facet : surface.facets) area += norm(model.mesh.facet_area(facet));
    const std::string& use = users[surface.name];
    if (use.empty() && !is_deck_surface(model, surface.name)) continue;
    page.line("surface", text("%s: %s, %.6g m^2", surface.name.c_str(),
                              counted(static_cast<long>(surface.facets.size()), "facet").c_str(), area) +
                             (use.empty() ? "" : ", " + use));
  }
}

struct ContactSum {
  long faces = 0, points = 0;
  double area = 0, lowest = 0, highest = 0;
  double spring_compliance = 0,
         body_compliance = 0;  ///< area times compliance per area, of springs and of the elements beside them
};

/// Compliance of a spring per area, 1 / k_n, against that of the element halves beside it, h / E_oed (numerics 5).
std::vector<ContactSum> sum_contacts(const Model& model, const Blocks& blocks, const ContactPoints& contacts) {
  std::vector<ContactSum> sums(model.interfaces.size());
  for (const InterfaceFace& face : blocks.faces) ++sums[face.interface].faces;
  for (int i = 0; i < contacts.count(); ++i) {
    ContactSum& sum = sums[contacts.interface[i]];
    const InterfaceFace& face = blocks.faces[contacts.face[i]];
    const double spring = contacts.normal_stiffness[i];
    sum.lowest = sum.points ? std::min(sum.lowest, spring) : spring;
    sum.highest = std::max(sum.highest, spring);
    ++sum.points;
    sum.area += contacts.area[i];
    sum.spring_compliance += contacts.area[i] / spring;
    const double face_area = norm(model.mesh.facet_area(face.a));
    for (const Facet& side : {face.a, face.b}) {
      const Material* material = material_of(model, model.mesh.region_names[model.mesh.regions[side.element]]);
      const double half_height = element_volume(model.mesh, side.element) / face_area / 2;
      const double stiffness = make_law<Elastic>(material->values).oedometric();
      if (material->law != DiscreteSpring::name) sum.body_compliance += contacts.area[i] * half_height / stiffness;
    }
  }
  return sums;
}

/// Faces meshed apart: what a joint made of them.
void describe_match(Page& page, const JointMatch& match) {
  page.line("contacts", text("  meshed apart: %s of faces, gaps up to %.2g m, overlaps up to %.2g m",
                             counted(match.joined, "pair").c_str(), match.largest_gap, match.largest_overlap));
  double free = 0;
  for (const UnmatchedFace& face : match.unmatched)
    if (face.gap == 0) free += face.free;
  if (match.partly_covered)
    page.line(
        "contacts",
        "  " + counted(match.partly_covered, "face") +
            text(" covered in part, %.4g m^2 of them free; surfaces take a face whole, by its larger part: %.2g m^2 "
                 "free count as joined, %.2g m^2 joined as free",
                 free, match.inner_free, match.outer_joined));
  if (match.too_far)
    page.line("contacts",
              "  " + counted(match.too_far, "face") +
                  text(" left free beyond the tolerance, the nearest %s %.3g m",
                       match.too_far_by > 0 ? "across a gap of" : "overlapping by", std::abs(match.too_far_by)));
}

void describe_contacts(Page& page, const Model& model, const Blocks& blocks, const std::vector<ContactSum>& sums) {
  if (model.interfaces.empty()) return;
  page.line("blocks", counted(blocks.block_count, "block") + ", " + counted(blocks.node_count(), "block node"));
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const Interface& interface = model.interfaces[i];
    const ContactSum& sum = sums[i];
    const std::string noun = interface.crackable ? "crackable" : "joint";
    page.line("contacts",
              text("%s %s (%s): %s, %.6g m^2, %s", noun.c_str(), interface.name.c_str(), interface.law.c_str(),
                   counted(sum.faces, "face").c_str(), sum.area, counted(sum.points, "contact point").c_str()));
    if (const JointMatch& match = blocks.matches[i]; match.joined) describe_match(page, match);
    if (sum.points)
      page.line("contacts",
                text("  normal stiffness %.3g to %.3g Pa/m", sum.lowest, sum.highest) +
                    (sum.body_compliance > 0 ? text(": across its faces the elements are about %.2g %% too soft",
                                                    100 * sum.spring_compliance / sum.body_compliance)
                                             : ", of a discrete_spring material: they are its elasticity"));
  }
}

std::string solve_words(const Stage& stage) {
  if (const auto* s = std::get_if<StaticSolve>(&stage.solve))
    return text("static, to a ratio of %g", s->relaxation.tolerance);
  if (const auto* t = std::get_if<ThermalSolve>(&stage.solve))
    return t->steady ? std::string("thermal, steady") : text("thermal, %.6g days", t->duration / 86400);
  if (const auto* c = std::get_if<CoupledSolve>(&stage.solve))
    return text("coupled, %.6g days, balanced every %.6g days to a ratio of %g", c->duration / 86400, c->every / 86400,
                c->relaxation.tolerance);
  if (const auto* d = std::get_if<DynamicSolve>(&stage.solve)) return text(d->large_displacement ? "dynamic, %.6g s, large displacement" : "dynamic, %.6g s", d->duration);
  if (const auto* r = std::get_if<StrengthReduction>(&stage.solve))
    return text("strength reduction, a factor between %g and %g to within %g", r->low, r->high, r->width);
  const auto& f = std::get<FractureSolve>(stage.solve);
  return text("fracture, from %s to %s in %d increments, to a ratio of %g",
              f.from.empty() ? "the reference temperature" : f.from.c_str(), f.to.c_str(), f.increments,
              f.relaxation.tolerance);
}

/// Whether a condition has a say in such a stage: heat in thermal ones, forces and supports in the others.
bool matters(const Condition& condition, const Stage& stage) {
  if (std::holds_alternative<TemperatureField>(condition.kind)) return true;
  const bool heat = gives_heat(condition) || std::holds_alternative<InitialTemperature>(condition.kind);
  return heat ? is_thermal(stage) : is_mechanical(stage);
}

void describe_plan(Page& page, const Model& model) {
  for (std::size_t i = 0; i < model.stages.size(); ++i) {
    page.line("stage", text("%zu %s: %s", i + 1, model.stages[i].name.c_str(), solve_words(model.stages[i]).c_str()));
    std::string names;
    for (const ActingCondition& acting : acting_conditions(model, static_cast<int>(i))) {
      const Condition& c = *acting.condition;
      if (!matters(c, model.stages[i])) continue;
      std::string name = c.noun + (c.name.empty() ? "" : " " + c.name);
      for (const Surface* surface : acting.surfaces)
        if (c.name.empty()) name += (surface == acting.surfaces.front() ? " on " : " and ") + surface->name;
      names += (names.empty() ? "" : ", ") + name;
    }
    page.line("stage", "  acting: " + (names.empty() ? "nothing" : names));
  }
}

}  // namespace

std::string check_report(Problem& problem) {
  const Model& model = problem.model;
  const MeshQuality quality = measure_quality(model.mesh);
  const std::vector<StagePlan> plan = plan_stages(problem);
  const StepSeconds seconds = measure_steps(problem);
  const Blocks& blocks = problem.blocks;
  const ContactPoints& contacts = problem.contacts;
  Page page;
  page.line("model", model.name);
  describe_mesh(page, model, quality);
  describe_regions(page, model, quality);
  describe_surfaces(page, model);
  const std::vector<ContactSum> sums = sum_contacts(model, blocks, contacts);
  describe_contacts(page, model, blocks, sums);
  describe_plan(page, model);
  for (const std::string& line : estimate_effort(problem, plan, seconds)) page.line("estimate", line);
  for (const std::string& line : model.notes) page.line("note", line);
  for (const std::string& line : left_out(model)) page.line("left out", line);
  return page.lines();
}

}  // namespace ashlar
