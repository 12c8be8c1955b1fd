#include "cli/estimate.hpp"

#include "cli/wording.hpp"
#include "model/check_mesh.hpp"

namespace ashlar {

std::vector<std::string> estimate_effort(const Model& model, const Blocks& blocks, const ContactPoints& contacts, int) {
  // Arrays of the backend and of the discretisation, bytes each; about 30 MB are the program and its libraries.
  constexpr double per_node = 400, per_corner = 120, per_gauss_point = 60, per_contact_point = 400, program = 30e6;
  double gauss = 0;
  for (Shape shape : model.mesh.shapes) gauss += gauss_count(shape);
  const double bytes = program + per_node * blocks.node_count() +
                       per_corner * static_cast<double>(blocks.corners.size()) + per_gauss_point * gauss +
                       per_contact_point * contacts.count();
  return {text("memory about %.0f MB", bytes / 1e6)};
}

}  // namespace ashlar
