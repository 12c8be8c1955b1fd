#include "cli/estimate.hpp"

#include <algorithm>
#include <cmath>

#include "cli/wording.hpp"
#include "model/check_mesh.hpp"

namespace ashlar {
namespace {

// Steps per element across and decade of the ratio, fitted to runs of dams, whole and split into blocks: right within a
// factor of two or three for such bodies. Static stages search like an elastic body; crack events relax.
constexpr double search_steps = 1.0, relaxation_steps = 5;
constexpr double element_steps_per_second = 1.5e6;  // a machine of two cores, contact springs included

/// Bytes of the arrays of backend and discretisation.
double bytes_needed(const Mesh& mesh, const Blocks& blocks, const ContactPoints& contacts) {
  constexpr double per_node = 400, per_corner = 120, per_gauss_point = 60, per_contact_point = 400, program = 20e6;
  double gauss = 0;
  for (Shape shape : mesh.shapes) gauss += gauss_count(shape);
  return program + per_node * blocks.node_count() + per_corner * static_cast<double>(blocks.corners.size()) +
         per_gauss_point * gauss + per_contact_point * contacts.count();
}

/// Elements that a wave passes on its way through the model.
double elements_across(const Mesh& mesh) {
  Vec3<double> low = mesh.points[0], high = low;
  for (const auto& p : mesh.points)
    for (int i = 0; i < 3; ++i) low[i] = std::min(low[i], p[i]), high[i] = std::max(high[i], p[i]);
  double volume = 0;
  for (int e = 0; e < mesh.element_count(); ++e) volume += element_volume(mesh, e);
  return std::max({high.x - low.x, high.y - low.y, high.z - low.z}) / std::cbrt(volume / mesh.element_count());
}

const Relaxation* relaxation_of(const Stage& stage) {
  if (const auto* s = std::get_if<StaticSolve>(&stage.solve)) return &s->relaxation;
  if (const auto* f = std::get_if<FractureSolve>(&stage.solve)) return &f->relaxation;
  return nullptr;
}

/// One digit and zeros: 20 000.
std::string rounded(double steps) {
  const double power = std::pow(10, std::floor(std::log10(steps)));
  return count_text(std::lround(std::round(steps / power) * power));
}

}  // namespace

std::vector<std::string> estimate_effort(const Model& model, const Blocks& blocks, const ContactPoints& contacts) {
  std::vector<std::string> lines{text("memory about %.0f MB", bytes_needed(model.mesh, blocks, contacts) / 1e6)};
  const double across = elements_across(model.mesh);
  for (const Stage& stage : model.stages) {
    const Relaxation* relaxation = relaxation_of(stage);
    if (!relaxation) continue;
    const auto* fracture = std::get_if<FractureSolve>(&stage.solve);
    const double decades = 1 - std::log10(relaxation->tolerance);
    const double steps = (fracture ? relaxation_steps : search_steps) * across * decades;
    const double seconds = steps * model.mesh.element_count() / element_steps_per_second;
    std::string line = text("stage %s: about %s steps, %s", stage.name.c_str(), rounded(steps).c_str(),
                            duration_text(seconds).c_str());
    if (fracture) line += text(", for each of %d increments and of the crack events", fracture->increments);
    lines.push_back(line);
  }
  return lines;
}

}  // namespace ashlar
