#include "solve/contact_start.hpp"

#include <cstddef>

#include "kernels/moving_contact.hpp"
#include "solve/contact_states.hpp"

namespace ashlar {

void begin_with_shear_of_springs(const Problem& problem) {
  const ContactSurface& surface = problem.surface;
  const ContactPoints& contacts = problem.contacts;
  if (surface.empty() || contacts.count() == 0) return;
  Backend& backend = *problem.backend;
  std::vector<double> memory = backend.read(Field::probe_memory);
  if (memory[0] != ProbeMemory<double>{}.target) return;

  std::vector<std::vector<int>> probes(problem.blocks.node_count());
  std::vector<Vec3<double>> outward(surface.probe_count());
  for (int p = 0; p < surface.probe_count(); ++p) {
    probes[surface.probe_node[p]].push_back(p);
    const int* const corner = &surface.corner[3 * surface.facet[surface.first_facet[p]]];
    const std::vector<Vec3<double>>& at = problem.discretisation.block_points;
    const Vec3<double> area = cross(at[corner[1]] - at[corner[0]], at[corner[2]] - at[corner[0]]);
    outward[p] = (1 / norm(area)) * area;
  }
  std::vector<Vec3<double>> stretch(surface.probe_count());
  std::vector<double> area(surface.probe_count());
  const std::vector<ContactPoint> points = ContactReader(problem).read();
  for (int c = 0; c < contacts.count(); ++c)
    contacts.each_end(c, [&](int node, double weight) {
      for (const int p : probes[problem.discretisation.blocks.new_node[node]]) {
        const double side = weight < 0 ? 1 : -1;  // the normal leaves side a
        if (side * dot(outward[p], contacts.normal[c]) < 0.9) continue;
        const double share = std::abs(weight) * contacts.area[c];
        area[p] += share;
        stretch[p] = stretch[p] - (side * share / contacts.shear_stiffness[c]) * points[c].traction.shear;
      }
    });
  constexpr std::size_t shear = offsetof(ProbeMemory<double>, shear) / sizeof(double);
  for (int p = 0; p < surface.probe_count(); ++p)
    for (int i = 0; i < 3 && area[p] > 0; ++i) memory[probe_numbers * p + shear + i] = stretch[p][i] / area[p];
  backend.write(Field::probe_memory, memory);
}

}  // namespace ashlar
