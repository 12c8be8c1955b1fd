#include "solve/plastic_output.hpp"

#include "kernels/element_types.hpp"

namespace ashlar {

namespace {

/// Volumes of the Gauss points of one element, m^3.
template <class Element>
std::vector<double> gauss_volumes(const Mesh& mesh, int element) {
  double x[3][Element::corners];
  for (int k = 0; k < Element::corners; ++k)
    for (int c = 0; c < 3; ++c) x[c][k] = mesh.points[mesh.element(element)[k]][c];
  const ElementGeometry<Element, double> geometry(x);
  std::vector<double> volumes;
  for (int g = 0; g < Element::gauss_points; ++g)
    volumes.push_back(GaussTable<Element>::factor * geometry.jacobian_at(g).det);
  return volumes;
}

/// work(mesh element, Gauss point, value) for one number of the history.
template <class Work>
void each_remembered(const Problem& p, int number, Work work) {
  const std::vector<double> history = p.backend->read(Field::history);
  const std::vector<int> first = p.setup().first_history();
  const double* values = history.data() + static_cast<std::size_t>(number) * first.back();
  for (std::size_t b = 0; b < p.discretisation.batches.size(); ++b) {
    const Batch& batch = p.discretisation.batches[b];
    if (first[b] == first[b + 1]) continue;
    for (int g = 0; g < gauss_count(batch.shape); ++g)
      for (int i = 0; i < batch.element_count; ++i)
        work(p.discretisation.source_element[batch.first_element + i], g,
             values[first[b] + g * batch.element_count + i]);
  }
}

constexpr int equivalent = 6, dissipation = 7;  // of PlasticHistory

}  // namespace

std::vector<double> element_plastic_strain(const Problem& p) {
  std::vector<double> strain(p.model.mesh.element_count());
  if (p.backend->size(Field::history) == 0) return strain;
  each_remembered(p, equivalent,
                  [&](int e, int, double value) { strain[e] += value / gauss_count(p.model.mesh.shapes[e]); });
  return strain;
}

double plastic_work(const Problem& p) {
  double work = 0;
  if (p.backend->size(Field::history) == 0) return work;
  std::vector<std::vector<double>> volumes(p.model.mesh.element_count());
  each_remembered(p, dissipation, [&](int e, int g, double value) {
    if (volumes[e].empty())
      volumes[e] = with_element(p.model.mesh.shapes[e], false, [&]<template <class> class E>(ElementTag<E>) {
        return gauss_volumes<E<double>>(p.model.mesh, e);
      });
    work += value * volumes[e][g];
  });
  return work;
}

}  // namespace ashlar
