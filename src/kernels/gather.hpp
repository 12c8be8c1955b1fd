#pragma once
#include "model/view.hpp"

/// Phase gather_force: corner values to nodal sums in the model's own order, without atomics: first the corners of a
/// node inside one patch, element by element, then the patches of a node that several share (numerics 8).
namespace ashlar {

/// One entry of a patch -> the node itself if it is interior to the patch, else the patch's partial sum.
template <class Real, int width>
struct GatherPatch {
  NodeSetView nodes;
  const Real* corner;  ///< [width * slots]
  Real* partial;       ///< [width * entries]
  Real* sum;           ///< [width * nodes]

  ASHLAR_HD void operator()(int entry) const {
    Real s[width];
    for (int c = 0; c < width; ++c) s[c] = Real(0);
    for (int j = nodes.entry_first_slot[entry]; j < nodes.entry_first_slot[entry + 1]; ++j)
      for (int c = 0; c < width; ++c) s[c] += corner[width * nodes.entry_slot[j] + c];
    const int node = nodes.entry_node[entry];
    Real* out = node < nodes.interior_count ? sum + width * node : partial + width * entry;
    for (int c = 0; c < width; ++c) out[c] = s[c];
  }
};

/// Sum of the partial sums of boundary node b (counted among boundary nodes), patch by patch.
template <class Real, int width>
ASHLAR_HD void sum_patches(const NodeSetView& nodes, const Real* partial, int b, Real (&sum)[width]) {
  for (int c = 0; c < width; ++c) sum[c] = Real(0);
  for (int j = nodes.boundary_first[b]; j < nodes.boundary_first[b + 1]; ++j)
    for (int c = 0; c < width; ++c) sum[c] += partial[width * nodes.boundary_entry[j] + c];
}

/// One boundary node -> the sum of its patches' partial sums.
template <class Real, int width>
struct GatherBoundary {
  NodeSetView nodes;
  const Real* partial;
  Real* sum;

  ASHLAR_HD void operator()(int b) const {
    Real s[width];
    sum_patches<Real, width>(nodes, partial, b, s);
    for (int c = 0; c < width; ++c) sum[width * (nodes.interior_count + b) + c] = s[c];
  }
};

/// Node step (see MoveNode) that keeps the sums.
template <class Real>
struct StoreSum {
  static constexpr bool moves = false;
  Real* sum;  ///< [width * nodes]
  struct Before {};
  ASHLAR_HD Before read(int) const { return {}; }
  ASHLAR_HD Before controls() const { return {}; }
  ASHLAR_HD Real* result() const { return sum; }
};

/// One node -> the largest of its three components.
template <class Real>
struct LargestComponent {
  const Real* vector;  ///< [3 * nodes]
  Real* largest;       ///< [nodes]
  ASHLAR_HD void operator()(int node) const {
    const Real* v = vector + 3 * node;
    const Real m = v[0] < v[1] ? v[1] : v[0];
    largest[node] = m < v[2] ? v[2] : m;
  }
};

}  // namespace ashlar
