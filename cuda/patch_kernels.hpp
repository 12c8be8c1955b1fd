#pragma once
#include <cstdint>

#include "kernels/block_force.hpp"
#include "kernels/gather.hpp"
#include "kernels/heat_flow.hpp"
#include "kernels/heat_step.hpp"
#include "kernels/move_nodes.hpp"
#include "patch_lists.hpp"
#include "staging.hpp"

/// One patch a thread group (speed.md 2): nodes staged in shared memory, one thread an element, then one thread a node
/// that sums its corners in the model's order and makes its step. The element routines and the node steps are those of
/// src/kernels.
namespace ashlar {

/// Threads of the group that has a patch, and groups that a processor is to run at once: what registers allow.
struct PatchGroup {
  int threads, per_processor;
};
template <class Real>
constexpr PatchGroup stress_group(int corners) {
  if (sizeof(Real) == 4) return {128, 4};
  return {corners == 8 ? 128 : corners == 6 ? 192 : 256, 2};
}
template <class Real>
inline constexpr PatchGroup heat_group{128, sizeof(Real) == 4 ? 6 : 4};

/// Element forces: what a patch does with displacements.
template <template <class> class Element, bool Warm, class Point, class Real_>
struct StressPatch {
  using Real = Real_;
  static constexpr int corners = Element<Real>::corners, width = 3;
  static constexpr PatchGroup group = stress_group<Real>(corners);
  BodyView<Real> body;
  BatchView batch;
  Point law;

  __device__ const NodeSetView& nodes() const { return body.nodes; }
  __device__ const Real* places() const { return body.x; }
  __device__ const Summed<Real>& values() const { return body.u; }
  __device__ Real* partial() const { return body.partial; }
  template <class Read>
  __device__ void operator()(int element, const Read& read, Real (&f)[width][corners]) const {
    read_element_force<Element, Warm, Real>(law, read, StoredPoints<Real>{body, batch, element}, f);
  }
};

/// Heat flow: what a patch does with temperatures.
template <template <class> class Element, class Real_>
struct HeatPatch {
  using Real = Real_;
  static constexpr int corners = Element<Real>::corners, width = 1;
  static constexpr PatchGroup group = heat_group<Real>;
  HeatView<Real> heat;
  BatchView batch;
  Real conductivity;
  Summed<Real> field;  ///< [nodes] temperature, or the search direction of conjugate gradients

  __device__ const NodeSetView& nodes() const { return heat.nodes; }
  __device__ const Real* places() const { return heat.x; }
  __device__ const Summed<Real>& values() const { return field; }
  __device__ Real* partial() const { return heat.partial; }
  template <class Read>
  __device__ void operator()(int, const Read& read, Real (&flow)[width][corners]) const {
    Real x[3][corners], temperature[width][corners];
    read(x, temperature);
    heat_flow<Element<Real>>(x, temperature[0], conductivity, flow[0]);
  }
};

/// Corner values of one component in shared memory, and the zero that unused gather places point to. The padding moves
/// components to other banks.
template <class Real>
inline constexpr int component_stride = most_patch_slots<Real> + 8;

/// Numbers of shared memory for `width` of them an entry, wherever the first lies behind a 16-byte border.
template <class Real>
__host__ __device__ constexpr int staged_numbers(int width, int entries) {
  constexpr int per = reals_in_16_bytes<Real>;
  return (width * entries + per - 1) / per * per + 2 * per;
}

/// Bytes of shared memory that a patch needs: corner values; places, later results; values.
template <class Real, int width>
constexpr std::size_t patch_bytes(int entries) {
  return sizeof(Real) * (std::size_t(width) * component_stride<Real> + staged_numbers<Real>(3, entries) +
                         (Summed<Real>::paired ? 2 : 1) * staged_numbers<Real>(width, entries));
}

/// Patch entries of the corners of one element, two in a word; batches begin at 16-byte borders.
template <int corners>
struct CornerEntries {
  unsigned words[corners / 2];

  __device__ __forceinline__ void read(const std::uint16_t* corner_entry, int first_slot) {
    static_assert(corners == 8 || corners == 6 || corners == 4);
    const std::uint16_t* at = corner_entry + first_slot;
    if constexpr (corners == 8) {
      const uint4 q = __ldg(reinterpret_cast<const uint4*>(at));
      words[0] = q.x, words[1] = q.y, words[2] = q.z, words[3] = q.w;
    } else if constexpr (corners == 6) {
      ASHLAR_UNROLL
      for (int k = 0; k < 3; ++k) words[k] = __ldg(reinterpret_cast<const unsigned*>(at) + k);
    } else {
      const uint2 q = __ldg(reinterpret_cast<const uint2*>(at));
      words[0] = q.x, words[1] = q.y;
    }
  }
  __device__ __forceinline__ int operator[](int k) const { return (words[k / 2] >> (16 * (k & 1))) & 0xffff; }
};

__device__ __forceinline__ int row_count(const PatchHead& head) {
  return (head.entries + 31) / 32 * 32 * head.rows_per_lane;
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
                                            const Real* corner, Real (&sum)[width]) {
  ASHLAR_UNROLL
  for (int c = 0; c < width; ++c) sum[c] = Real(0);
  for (int r = 1;; ++r) {
    const unsigned words[4] = {q.x, q.y, q.z, q.w};
    if (r < head.rows_per_lane) q = __ldg(reinterpret_cast<const uint4*>(row_of(head, rows, l) + 32 * r));
    ASHLAR_UNROLL
    for (int j = 0; j < 8; ++j) {
      const int place = (words[j / 2] >> (16 * (j & 1))) & 0xffff;
      ASHLAR_UNROLL
      for (int c = 0; c < width; ++c) sum[c] += corner[c * component_stride<Real> + place];
    }
    if (r >= head.rows_per_lane) break;
  }
}

/// The nodal values that a patch works on, in shared memory.
template <class Real>
struct StagedValues {
  Real* high;
  Real* low;  ///< null: zero throughout
  __device__ SummedValue<Real> operator[](int i) const {
    if constexpr (Summed<Real>::paired)
      return {high[i], low ? low[i] : Real(0)};
    else
      return {high[i]};
  }
  __device__ void write(int i, const SummedValue<Real>& value) const {
    high[i] = value.high;
    if constexpr (Summed<Real>::paired) low[i] = value.low;
  }
};

/// Reads the corners of one element of a patch.
template <class Real, int corners, int width>
struct StagedCorners {
  const Real* place;
  StagedValues<Real> value;
  CornerEntries<corners> entry;
  __device__ __forceinline__ void operator()(Real (&x)[3][corners], Real (&u)[width][corners]) const {
    ASHLAR_UNROLL
    for (int k = 0; k < corners; ++k) {
      ASHLAR_UNROLL
      for (int c = 0; c < 3; ++c) x[c][k] = place[3 * entry[k] + c];
      ASHLAR_UNROLL
      for (int c = 0; c < width; ++c) u[c][k] = relative(value[width * entry[k] + c], value[width * entry[0] + c]);
    }
  }
};

/// Asks for what the steps of nodes first .. first + count will read.
template <class Real>
__device__ void prefetch_step(const StoreSum<Real>&, int, int) {}
template <class Real>
__device__ void prefetch_step(const MoveNode<Real>& step, int first, int count) {
  prefetch_span(step.body.v, 3 * first, 3 * count);
  prefetch_span(step.body.load, 3 * first, 3 * count);
  prefetch_span(step.body.inverse_mass, first, count);
}
template <class Real>
__device__ void prefetch_step(const StepHeat<Real>& step, int first, int count) {
  prefetch_span(step.heat.heat, first, count);
  prefetch_span(step.heat.inverse_capacity, first, count);
}

/// Asks for what another patch will read: the next that gets this one's place.
template <class Work, class NodeStep>
__device__ void prefetch_patch(const Work& work, const PatchListsView& lists, const PatchHead& head,
                               const NodeStep& step) {
  constexpr int width = Work::width;
  const Summed<typename Work::Real> values = work.values();
  prefetch_span(work.nodes().entry_node, head.first_entry + head.interior, head.entries - head.interior);
  prefetch_span(work.places(), 3 * head.first_entry, 3 * head.entries);
  prefetch_span(values.high, width * head.first_node, width * head.interior);
  if (values.low) prefetch_span(values.low, width * head.first_node, width * head.interior);
  prefetch_span(work.nodes().corner_entry, work.batch.slot(head.first_element, Work::corners, 0),
                head.elements * Work::corners);
  prefetch_span(lists.rows, head.first_row, row_count(head));
  prefetch_step(step, head.first_node, head.interior);
}

/// A patch in the shared memory of its thread group: corner values, places, nodal values.
template <class Work>
struct PatchMemory {
  using Real = typename Work::Real;
  static constexpr int corners = Work::corners, width = Work::width, stride = component_stride<Real>;
  static constexpr int elements = most_patch_slots<Real> / corners, threads = Work::group.threads;
  Real* corner;
  Real* places;  ///< at a 16-byte border
  Real* place;
  StagedValues<Real> value;

  /// @param capacity entries of a patch at most
  __device__ PatchMemory(unsigned char* shared, const PatchHead& head, int capacity, bool paired)
      : corner(reinterpret_cast<Real*>(shared)),
        places(corner + width * stride),
        place(places + behind_border<Real>(3 * head.first_entry)) {
    value.high = places + staged_numbers<Real>(3, capacity) + behind_border<Real>(width * head.first_node);
    value.low = paired ? value.high + staged_numbers<Real>(width, capacity) : nullptr;
  }

  /// Starts the copies into it.
  __device__ void load(const Work& work, const PatchHead& head) const {
    const Summed<Real> values = work.values();
    const int first_value = width * head.first_node, inside = width * head.interior;
    load_span<threads>(place, work.places(), 3 * head.first_entry, 3 * head.entries);
    load_span<threads>(value.high, values.high, first_value, inside);
    if (value.low) load_span<threads>(value.low, values.low, first_value, inside);
    for (int l = head.interior + threadIdx.x; l < head.entries; l += threads) {
      const int n = width * __ldg(work.nodes().entry_node + head.first_entry + l);
      ASHLAR_UNROLL
      for (int c = 0; c < width; ++c) {
        copy_async(value.high + width * l + c, values.high + n + c);
        if (value.low) copy_async(value.low + width * l + c, values.low + n + c);
      }
    }
    if (threadIdx.x < width) corner[threadIdx.x * stride + most_patch_slots<Real>] = Real(0);
  }

  /// Entries of the corners of element i of the patch.
  __device__ CornerEntries<corners> entries_of(const Work& work, const PatchHead& head, int i) const {
    CornerEntries<corners> entries;
    entries.read(work.nodes().corner_entry, work.batch.slot(head.first_element + i, corners, 0));
    return entries;
  }

  /// Corner values of every element; `next`: entries of the first that this thread has.
  __device__ void run_elements(const Work& work, const PatchHead& head, CornerEntries<corners> next) const {
    for (int i = threadIdx.x; i < head.elements; i += threads) {
      const CornerEntries<corners> entry = next;
      if (i + threads < head.elements) next = entries_of(work, head, i + threads);
      Real f[width][corners];
      work(head.first_element + i, StagedCorners<Real, corners, width>{place, value, entry}, f);
      ASHLAR_UNROLL
      for (int k = 0; k < corners; ++k) {
        ASHLAR_UNROLL
        for (int c = 0; c < width; ++c) corner[c * stride + k * elements + i] = f[c][k];
      }
    }
  }
};

/// One patch. `step` (kernels/move_nodes.hpp, step_heat.hpp, StoreSum) takes the sums of nodes inside; nodes that other
/// patches share leave a partial sum. `ahead`: thread groups that run at once; a patch so far behind is asked for
/// early.
template <class Work, class NodeStep>
__global__ void __launch_bounds__(Work::group.threads, Work::group.per_processor)
    run_patch(const __grid_constant__ Work work, const PatchListsView lists, const int first_patch, const int ahead,
              const int capacity, const NodeStep step) {
  using Real = typename Work::Real;
  constexpr int width = Work::width, threads = Work::group.threads;
  extern __shared__ __align__(16) unsigned char shared[];
  const PatchHead head = lists.heads[first_patch + blockIdx.x];
  const Summed<Real> values = work.values();
  const int first_value = width * head.first_node, inside = width * head.interior;
  const PatchMemory<Work> patch(shared, head, capacity, Summed<Real>::paired && values.low);
  const StagedValues<Real>& value = patch.value;
  patch.load(work, head);
  CornerEntries<Work::corners> first_entries;
  if (threadIdx.x < head.elements) first_entries = patch.entries_of(work, head, threadIdx.x);
  if (threadIdx.x == threads - 1) {
    prefetch_step(step, head.first_node, head.interior);
    prefetch_span(lists.rows, head.first_row, row_count(head));
    if (blockIdx.x + ahead < gridDim.x)
      prefetch_patch(work, lists, lists.heads[first_patch + blockIdx.x + ahead], step);
  }
  wait_for_copies();
  __syncthreads();

  patch.run_elements(work, head, first_entries);

  // What the next round of sums needs is always on its way.
  uint4 row{};
  typename NodeStep::Before before{};
  const auto ask = [&](int l) {
    if (l < head.entries) row = first_row(head, lists.rows, l);
    if (l < head.interior) before = step.read(head.first_node + l);
  };
  ask(threadIdx.x);
  __syncthreads();

  // Results lie where the places were: of nodes inside as far behind a border as their values, then partial sums.
  Real* const result = patch.places + behind_border<Real>(first_value);
  Real* const partial = patch.places + reals_in_16_bytes<Real> + behind_border<Real>(width * head.first_entry);
  const auto controls = step.controls();
#pragma unroll 1
  for (int l = threadIdx.x; l < head.entries; l += threads) {
    const uint4 first = row;
    const typename NodeStep::Before earlier = before;
    ask(l + threads);
    Real sum[width];
    sum_corners<width>(head, lists.rows, l, first, patch.corner, sum);
    ASHLAR_UNROLL
    for (int c = 0; c < width; ++c) {
      const int i = width * l + c;
      if (l >= head.interior) {
        partial[i] = sum[c];
      } else if constexpr (NodeStep::moves) {
        SummedValue<Real> moved = value[i];
        result[i] = step(controls, earlier, c, sum[c], moved);
        value.write(i, moved);
      } else {
        result[i] = sum[c];
      }
    }
  }
  __syncthreads();

  store_span<threads>(step.result(), first_value, inside, result);
  store_span<threads>(work.partial(), width * (head.first_entry + head.interior),
                      width * (head.entries - head.interior), partial + inside);
  if constexpr (NodeStep::moves) {
    store_span<threads>(values.high, first_value, inside, value.high);
    if (value.low) store_span<threads>(values.low, first_value, inside, value.low);
  }
}

/// Sums of a boundary node's patches, then its step.
template <class Real, int width, class NodeStep>
struct StepBoundary {
  NodeSetView nodes;
  const Real* partial;
  Summed<Real> values;
  NodeStep step;
  ASHLAR_HD void operator()(int b) const {
    const int node = nodes.interior_count + b;
    const auto before = step.read(node);
    Real sum[width];
    sum_patches<Real, width>(nodes, partial, b, sum);
    const auto controls = step.controls();
    for (int c = 0; c < width; ++c) {
      const int i = width * node + c;
      SummedValue<Real> moved = values[i];
      step.result()[i] = step(controls, before, c, sum[c], moved);
      values.write(i, moved);
    }
  }
};

}  // namespace ashlar
