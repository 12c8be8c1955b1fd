#include "solve/block_state.hpp"

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

/// One Gauss point that remembers.
struct Remembered {
  int element, gauss;  ///< mesh element
  Measure measure;
  bool has_plane;
  const double* values;
  std::size_t stride;
  double operator[](int number) const { return values[number * stride]; }
};

template <class Work>
void each_remembered(const Problem& p, Work work) {
  const std::vector<double> history = p.backend->read(Field::history);
  const std::vector<int> first = p.setup().first_history();
  for (std::size_t b = 0; b < p.discretisation.batches.size(); ++b) {
    const Batch& batch = p.discretisation.batches[b];
    if (first[b] == first[b + 1]) continue;
    const std::string& law = p.model.materials[batch.material].law;
    Remembered point{0, 0, measure(law), has_crack_plane(law), nullptr, static_cast<std::size_t>(first.back())};
    for (point.gauss = 0; point.gauss < gauss_count(batch.shape); ++point.gauss)
      for (int i = 0; i < batch.element_count; ++i) {
        point.element = p.discretisation.source_element[batch.first_element + i];
        point.values = history.data() + first[b] + point.gauss * batch.element_count + i;
        work(point);
      }
  }
}

}  // namespace

std::vector<double> element_measure(const Problem& p, Measure wanted) {
  std::vector<double> mean(p.model.mesh.element_count());
  each_remembered(p, [&](const Remembered& point) {
    if (point.measure == wanted)
      mean[point.element] += point[measure_number] / gauss_count(p.model.mesh.shapes[point.element]);
  });
  return mean;
}

std::vector<double> element_crack_normal(const Problem& p) {
  std::vector<double> normal(3 * static_cast<std::size_t>(p.model.mesh.element_count())),
      most(p.model.mesh.element_count());
  each_remembered(p, [&](const Remembered& point) {
    if (!point.has_plane || !(point[measure_number] > most[point.element])) return;
    most[point.element] = point[measure_number];
    for (int c = 0; c < 3; ++c) normal[3 * static_cast<std::size_t>(point.element) + c] = point[normal_number + c];
  });
  return normal;
}

BlockWork block_work(const Problem& p) {
  BlockWork work;
  std::vector<std::vector<double>> volumes(p.model.mesh.element_count());
  each_remembered(p, [&](const Remembered& point) {
    const int e = point.element;
    if (volumes[e].empty())
      volumes[e] = with_element(p.model.mesh.shapes[e], false, [&]<template <class> class E>(ElementTag<E>) {
        return gauss_volumes<E<double>>(p.model.mesh, e);
      });
    (point.measure == Measure::damage ? work.fracture : work.plastic) +=
        point[dissipation_number] * volumes[e][point.gauss];
  });
  return work;
}

}  // namespace ashlar
