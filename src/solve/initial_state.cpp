#include "solve/initial_state.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/element_types.hpp"
#include "model/initial_stress.hpp"
#include "solve/problem.hpp"
#include "solve/relaxation.hpp"

namespace ashlar {

namespace {

/// One element's initial stress at its Gauss points and the corner forces that balance it.
struct ElementState {
  std::vector<Sym3<double>> stress;
  std::vector<Vec3<double>> force;  ///< [corners] N
};

template <class Element>
ElementState element_state(const Mesh& mesh, int element, const InitialStressField& field) {
  const std::span<const int> nodes = mesh.element(element);
  ElementState state;
  for (int g = 0; g < Element::gauss_points; ++g) {
    Vec3<double> p;
    for (int k = 0; k < Element::corners; ++k) p = p + double(Element::shape(g, k)) * mesh.points[nodes[k]];
    state.stress.push_back(field.at(mesh.regions[element], p));
  }
  double x[3][Element::corners], u[3][Element::corners] = {}, f[3][Element::corners];
  for (int k = 0; k < Element::corners; ++k)
    for (int c = 0; c < 3; ++c) x[c][k] = mesh.points[nodes[k]][c];
  const auto stress = [&](int g, const Sym3<double>&) { return state.stress[g]; };
  Element::force(x, u, f, stress);
  for (int k = 0; k < Element::corners; ++k) state.force.push_back({f[0][k], f[1][k], f[2][k]});
  return state;
}

/// Elastic strain of a stress, engineering shear.
Sym3<double> elastic_strain(const Elastic& law, const Sym3<double>& s) {
  const double trace = s.xx + s.yy + s.zz, shear = law.shear();
  Sym3<double> strain;
  for (int c = 0; c < 3; ++c) strain[c] = ((1 + law.poisson) * s[c] - law.poisson * trace) / law.young;
  for (int c = 3; c < 6; ++c) strain[c] = s[c] / shear;
  return strain;
}

}  // namespace

InitialState initial_state(const Model& model, const Blocks& blocks, const Setup& setup) {
  InitialState state;
  const InitialStressField field(model);
  if (!field.any()) return state;
  const Mesh& mesh = model.mesh;
  const Discretisation& d = setup.discretisation;
  state.stress.assign(6 * static_cast<std::size_t>(d.gauss_count), 0);
  state.force.assign(3 * static_cast<std::size_t>(blocks.node_count()), 0);
  const std::vector<int> first = setup.first_history();
  int remembered = 0;
  for (const BlockLaw& law : setup.laws) remembered = std::max(remembered, history_size(law));
  state.history.assign(static_cast<std::size_t>(remembered) * first.back(), 0);
  for (std::size_t b = 0; b < d.batches.size(); ++b) {
    const Batch& batch = d.batches[b];
    const bool remembers = first[b + 1] > first[b];
    const Elastic elastic = make_law<Elastic>(model.materials[batch.material].values);
    for (int i = 0; i < batch.element_count; ++i) {
      const int e = d.source_element[batch.first_element + i];
      const ElementState element = with_element(
          batch.shape, setup.bbar[batch.material],
          [&]<template <class> class E>(ElementTag<E>) { return element_state<E<double>>(mesh, e, field); });
      for (int g = 0; g < static_cast<int>(element.stress.size()); ++g) {
        const Sym3<double> strain = elastic_strain(elastic, element.stress[g]);
        for (int c = 0; c < 6; ++c)
          if (remembers)
            state.history[static_cast<std::size_t>(c) * first.back() + first[b] + g * batch.element_count + i] =
                -strain[c];
          else
            state.stress[6 * static_cast<std::size_t>(batch.gauss(i, g)) + c] = element.stress[g][c];
      }
      if (remembers) continue;
      for (std::size_t k = 0; k < element.force.size(); ++k)
        for (int c = 0; c < 3; ++c)
          state.force[3 * blocks.corners[mesh.first_corner[e] + k] + c] += element.force[k][c];
    }
  }
  return state;
}

InitialBalance initial_balance(const Problem& p) {
  evaluate_force(*p.backend);
  const std::vector<double> load = p.to_blocks(p.backend->read(Field::load), 3),
                            force = p.to_blocks(p.backend->read(Field::force), 3),
                            fixed = p.to_blocks(p.backend->read(Field::fixed), 1);
  InitialBalance balance;
  double unbalanced = 0, outside = 0, inside = 0;
  for (std::size_t n = 0; n < fixed.size(); ++n) {
    Vec3<double> out;
    for (int c = 0; c < 3; ++c) {
      if ((static_cast<unsigned>(fixed[n]) >> c) & 1u) continue;
      const std::size_t i = 3 * n + c;
      const double constant = p.initial.force.empty() ? 0 : p.initial.force[i];
      out[c] = load[i] - force[i];
      outside += (load[i] + constant) * (load[i] + constant);
      inside += (force[i] + constant) * (force[i] + constant);
    }
    unbalanced += dot(out, out);
    if (norm(out) <= balance.largest) continue;
    balance.largest = norm(out);
    balance.place = p.model.mesh.points[p.blocks.mesh_node[n]];
  }
  for (int i = 0; i < 3; ++i) balance.place[i] += 0.0;  // meshes write -0
  const double scale = std::sqrt(std::max(outside, inside));
  balance.share = scale > 0 ? std::sqrt(unbalanced) / scale : 0;
  return balance;
}

}  // namespace ashlar
