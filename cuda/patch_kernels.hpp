#pragma once
#include <cstdint>

#include "kernels/block_force.hpp"
#include "patch_lists.hpp"

/// Kernels for one patch a thread group (speed.md 2): nodes staged in shared memory, one thread an element, then one
/// thread a node that sums its corners in the model's order. The element routine and the node routine are those of
/// src/kernels.
namespace ashlar {

inline constexpr int patch_threads = 128;
template <class Real>
inline constexpr int patch_groups_per_processor = sizeof(Real) == 4 ? 4 : 2;

template <class Real>
inline constexpr int patch_capacity = sizeof(Real) == 4 ? patch_size_single : patch_size_double;

/// Corner values of one component in shared memory, and the zero that unused gather places point to. The padding moves
/// components to other banks.
template <class Real, int corners>
inline constexpr int component_stride = corners * patch_capacity<Real> + 8;

/// Starts a copy of one number from global to shared memory that needs no register.
template <class Real>
__device__ __forceinline__ void copy_async(Real* shared, const Real* global) {
  const unsigned to = static_cast<unsigned>(__cvta_generic_to_shared(shared));
  asm volatile("cp.async.ca.shared.global [%0], [%1], %2;\n" ::"r"(to), "l"(global), "n"(sizeof(Real)));
}
__device__ __forceinline__ void wait_for_copies() { asm volatile("cp.async.wait_all;\n" ::: "memory"); }

/// Patch entries of the corners of one element: 2 bytes each, read together.
template <int corners>
__device__ __forceinline__ void read_entries(const std::uint16_t* corner_entry, int first_slot, int (&entry)[corners]) {
  static_assert(corners == 8 || corners == 6 || corners == 4);
  const std::uint16_t* at = corner_entry + first_slot;
  if constexpr (corners == 8) {
    const uint4 q = __ldg(reinterpret_cast<const uint4*>(at));
    const unsigned words[4] = {q.x, q.y, q.z, q.w};
    ASHLAR_UNROLL
    for (int k = 0; k < 8; ++k) entry[k] = (words[k / 2] >> (16 * (k & 1))) & 0xffff;
  } else {
    ASHLAR_UNROLL
    for (int k = 0; k < corners; ++k) entry[k] = __ldg(at + k);
  }
}

/// Where the gather list of entry l begins.
__device__ __forceinline__ const GatherRow* row_of(const PatchHead& head, const GatherRow* rows, int l) {
  return rows + head.first_row + l / 32 * head.rows_per_lane * 32 + l % 32;
}
__device__ __forceinline__ uint4 first_row(const PatchHead& head, const GatherRow* rows, int l) {
  return __ldg(reinterpret_cast<const uint4*>(row_of(head, rows, l)));
}

/// Sum over the corners of entry l of `width` components in shared memory; `q` is its first row.
template <int width, class Real>
__device__ __forceinline__ void sum_corners(const PatchHead& head, const GatherRow* rows, int l, uint4 q,
                                            const Real* corner, int stride, Real (&sum)[width]) {
  ASHLAR_UNROLL
  for (int c = 0; c < width; ++c) sum[c] = Real(0);
  for (int r = 0;;) {
    const unsigned words[4] = {q.x, q.y, q.z, q.w};
    ASHLAR_UNROLL
    for (int j = 0; j < 8; ++j) {
      const int place = (words[j / 2] >> (16 * (j & 1))) & 0xffff;
      ASHLAR_UNROLL
      for (int c = 0; c < width; ++c) sum[c] += corner[c * stride + place];
    }
    if (++r == head.rows_per_lane) break;
    q = __ldg(reinterpret_cast<const uint4*>(row_of(head, rows, l) + 32 * r));
  }
}

/// Bytes of shared memory that a patch of a batch needs.
template <class Real, int corners, int width, int staged>
constexpr std::size_t patch_bytes(int entries) {
  return sizeof(Real) * (std::size_t(width) * component_stride<Real, corners> + std::size_t(staged) * entries);
}

/// Component c of an entry's displacement as staged.
template <class Real>
__device__ __forceinline__ SummedValue<Real> moved_at(const Real* moved, int capacity, int c, int entry,
                                                      const Real* has_low) {
  if constexpr (Summed<Real>::paired)
    return {moved[c * capacity + entry], has_low ? moved[(3 + c) * capacity + entry] : Real(0)};
  else
    return {moved[c * capacity + entry]};
}

/// Forces of one patch; `node(n, force)` takes what is whole, nodes shared with other patches leave a partial sum.
template <template <class> class Element, bool Warm, class Point, class Real, class NodeStep>
__global__ void __launch_bounds__(patch_threads, patch_groups_per_processor<Real>)
    patch_force(const BodyView<Real> body, const BatchView batch, const Point law, const PatchListsView lists,
                const int first_patch, const int capacity, const NodeStep node_step) {
  constexpr int corners = Element<Real>::corners;
  constexpr int stride = component_stride<Real, corners>;
  extern __shared__ __align__(16) unsigned char shared[];
  Real* const force = reinterpret_cast<Real*>(shared);
  Real* const place = force + 3 * stride;       // [3 * capacity]
  Real* const moved = place + 3 * capacity;     // [3 * capacity], twice where paired
  const PatchHead head = lists.heads[first_patch + blockIdx.x];

  for (int l = threadIdx.x; l < head.entries; l += patch_threads) {
    const int n = 3 * (l < head.interior ? head.first_node + l : __ldg(body.nodes.entry_node + head.first_entry + l));
    ASHLAR_UNROLL
    for (int c = 0; c < 3; ++c) {
      copy_async(place + c * capacity + l, body.x + 3 * (head.first_entry + l) + c);
      copy_async(moved + c * capacity + l, body.u.high + n + c);
      if constexpr (Summed<Real>::paired)
        if (body.u.low) copy_async(moved + (3 + c) * capacity + l, body.u.low + n + c);
    }
  }
  if (threadIdx.x < 3) force[threadIdx.x * stride + corners * patch_capacity<Real>] = Real(0);
  wait_for_copies();
  __syncthreads();

  for (int i = threadIdx.x; i < head.elements; i += patch_threads) {
    const int element = head.first_element + i;
    int entry[corners];
    read_entries<corners>(body.nodes.corner_entry, batch.slot(element, corners, 0), entry);
    Real x[3][corners], u[3][corners], f[3][corners];
    ASHLAR_UNROLL
    for (int k = 0; k < corners; ++k)
      ASHLAR_UNROLL
      for (int c = 0; c < 3; ++c) {
        x[c][k] = place[c * capacity + entry[k]];
        u[c][k] = relative(moved_at(moved, capacity, c, entry[k], body.u.low),
                           moved_at(moved, capacity, c, entry[0], body.u.low));
      }
    element_force<Element, Warm>(law, x, u, StoredPoints<Real>{body, batch, element}, f);
    ASHLAR_UNROLL
    for (int k = 0; k < corners; ++k)
      ASHLAR_UNROLL
      for (int c = 0; c < 3; ++c) force[c * stride + k * patch_capacity<Real> + i] = f[c][k];
  }
  __syncthreads();

  // What the first rounds of sums need is on its way while slower threads are still at their elements.
  constexpr int rounds = 3;
  uint4 row[rounds];
  typename NodeStep::Before before[rounds];
  ASHLAR_UNROLL
  for (int r = 0; r < rounds; ++r) {
    const int l = threadIdx.x + r * patch_threads;
    if (l < head.entries) row[r] = first_row(head, lists.rows, l);
    if (l < head.interior) before[r] = node_step.read(head.first_node + l);
  }
  __syncthreads();

  const auto finish = [&](int l, const uint4& first, const typename NodeStep::Before& b) {
    Real sum[3];
    sum_corners<3>(head, lists.rows, l, first, force, stride, sum);
    if (l < head.interior) {
      node_step(head.first_node + l, b, sum);
    } else {
      ASHLAR_UNROLL
      for (int c = 0; c < 3; ++c) body.partial[3 * (head.first_entry + l) + c] = sum[c];
    }
  };
  ASHLAR_UNROLL
  for (int r = 0; r < rounds; ++r) {
    const int l = threadIdx.x + r * patch_threads;
    if (l < head.entries) finish(l, row[r], before[r]);
  }
  for (int l = threadIdx.x + rounds * patch_threads; l < head.entries; l += patch_threads) {
    const typename NodeStep::Before b = l < head.interior ? node_step.read(head.first_node + l) : typename NodeStep::Before{};
    finish(l, first_row(head, lists.rows, l), b);
  }
}

}  // namespace ashlar
