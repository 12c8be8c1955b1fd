#pragma once
#include "patch_kernels.hpp"
#include "resident_lists.hpp"

/// Many steps of a small model in one launch: every patch stays in the shared memory of its thread group, and groups
/// send each other their sums at shared nodes without a barrier over the device (speed.md 2, step 4). Which patches a
/// node's sum comes from, and in which order, is as in every other step.
namespace ashlar {

/// Sums of a patch at nodes that others share, with the step that they belong to. A message of 16 bytes arrives as a
/// whole; two rooms take turns, since a group can be ahead of its neighbours by one step.
template <class Real>
struct Messages {
  static constexpr int words = sizeof(Real) == 8 ? 3 : 1;  ///< 16 bytes hold one double or three floats
  struct Word {
    unsigned long long low, high;
  };
  Word* room;   ///< [2][entries][words]
  int entries;  ///< of all patches

  __device__ Word* at(unsigned step, int entry) const {
    return room + (std::size_t(step & 1) * entries + entry) * words;
  }
  __device__ void post(unsigned step, int entry, const Real (&sum)[3]) const {
    Word* const to = at(step, entry);
    if constexpr (words == 3) {
      ASHLAR_UNROLL
      for (int c = 0; c < 3; ++c) send(to + c, {static_cast<unsigned long long>(__double_as_longlong(sum[c])), step});
    } else {
      send(to, {joined(__float_as_uint(sum[0]), __float_as_uint(sum[1])), joined(__float_as_uint(sum[2]), step)});
    }
  }

  /// What another patch posted at an entry.
  struct Mail {
    Word word[words];
    __device__ void look(const Word* from) {
      ASHLAR_UNROLL
      for (int w = 0; w < words; ++w) word[w] = receive(from + w);
    }
    __device__ bool is_of(unsigned step) const {
      bool all = true;
      ASHLAR_UNROLL
      for (int w = 0; w < words; ++w)
        all = all && (words == 3 ? word[w].high == step : static_cast<unsigned>(word[w].high >> 32) == step);
      return all;
    }
    __device__ Real operator[](int c) const {
      if constexpr (words == 3)
        return __longlong_as_double(static_cast<long long>(word[c].low));
      else
        return __uint_as_float(static_cast<unsigned>((c == 2 ? word[0].high : word[0].low) >> (c == 1 ? 32 : 0)));
    }
  };

 private:
  __device__ static unsigned long long joined(unsigned low, unsigned high) {
    return static_cast<unsigned long long>(high) << 32 | low;
  }
  __device__ static void send(Word* to, const Word& w) {
    asm volatile("{ .reg .b128 word; mov.b128 word, {%1, %2}; st.relaxed.gpu.global.b128 [%0], word; }" ::"l"(to),
                 "l"(w.low), "l"(w.high)
                 : "memory");
  }
  __device__ static Word receive(const Word* from) {
    Word w;
    asm volatile("{ .reg .b128 word; ld.relaxed.gpu.global.b128 word, [%2]; mov.b128 {%0, %1}, word; }"
                 : "=l"(w.low), "=l"(w.high)
                 : "l"(from)
                 : "memory");
    return w;
  }
};

/// Shared memory that a resident patch needs: that of a step, its velocities and its inbox.
template <class Real>
constexpr std::size_t resident_bytes(int entries, int inbox) {
  return patch_bytes<Real, 3>(entries) + sizeof(Real) * 3 * (std::size_t(entries) + inbox);
}

/// Puts what other patches have posted for this step into the inbox, several at a time so that they travel together.
template <int threads, class Real>
__device__ void fetch_letters(const Messages<Real>& messages, unsigned step, const InboxHead& head,
                              const Letter* letters, Real* inbox) {
  constexpr int together = 3;
  for (int i = threadIdx.x; i < head.letters; i += together * threads) {
    Letter letter[together];
    typename Messages<Real>::Mail mail[together];
    ASHLAR_UNROLL
    for (int k = 0; k < together; ++k)
      if (i + k * threads < head.letters) {
        letter[k] = letters[head.first_letter + i + k * threads];
        mail[k].look(messages.at(step, letter[k].entry));
      }
    ASHLAR_UNROLL
    for (int k = 0; k < together; ++k)
      if (i + k * threads < head.letters) {
        while (!mail[k].is_of(step)) mail[k].look(messages.at(step, letter[k].entry));
        ASHLAR_UNROLL
        for (int c = 0; c < 3; ++c) inbox[3 * letter[k].place + c] = mail[k][c];
      }
  }
}

/// `steps` steps of relaxation, the first of them number `first_step`. All thread groups have to run at once.
/// @param works [batches] the same but for the batch and the constants of its law
template <class Work>
__global__ void __launch_bounds__(Work::group.threads, Work::group.per_processor)
    march_patches(const Work* const works, const int batches, const PatchListsView lists,
                  const ResidentListsView exchange, const Messages<typename Work::Real> messages, const int capacity,
                  const MoveNode<typename Work::Real> step, const unsigned first_step, const int steps) {
  using Real = typename Work::Real;
  constexpr int threads = Work::group.threads;
  extern __shared__ __align__(16) unsigned char shared[];
  const PatchHead head = lists.heads[blockIdx.x];
  const InboxHead inbox_head = exchange.heads[blockIdx.x];
  int batch = 0;
  while (batch + 1 < batches && static_cast<int>(blockIdx.x) >= works[batch + 1].batch.first_patch) ++batch;
  const Work work = works[batch];
  const BodyView<Real>& body = work.body;
  const NodeSetView& nodes = body.nodes;
  const PatchMemory<Work> patch(shared, head, capacity, Summed<Real>::paired);
  Real* const velocity = reinterpret_cast<Real*>(shared + patch_bytes<Real, 3>(capacity));  // [3 * entries]
  Real* const inbox = velocity + 3 * capacity;
  const auto node_of = [&](int l) {
    return l < head.interior ? head.first_node + l : __ldg(nodes.entry_node + head.first_entry + l);
  };
  patch.load(work, head);
  for (int l = threadIdx.x; l < head.entries; l += threads)
    for (int c = 0; c < 3; ++c) velocity[3 * l + c] = body.v[3 * node_of(l) + c];
  CornerEntries<Work::corners> first_entries;
  if (threadIdx.x < head.elements) first_entries = patch.entries_of(work, head, threadIdx.x);
  const auto controls = step.controls();
  // Shared nodes come first: their sums are on the way while the patch's own nodes move.
  const int shared_nodes = head.entries - head.interior;
  const auto nth = [&](int i) { return i < shared_nodes ? head.interior + i : i - shared_nodes; };
  struct Load {
    Real along[3], inverse_mass;
    std::uint8_t fixed;
  };
  const auto load_of = [&](int l) -> Load {
    const int node = node_of(l);
    return {{body.load[3 * node], body.load[3 * node + 1], body.load[3 * node + 2]},
            body.inverse_mass[node],
            body.fixed[node]};
  };
  const auto move = [&](int l, const Load& load, const Real(&force)[3]) {
    typename MoveNode<Real>::Before before;
    ASHLAR_UNROLL
    for (int c = 0; c < 3; ++c) before.along[c] = {velocity[3 * l + c], load.along[c]};
    before.inverse_mass = load.inverse_mass;
    before.fixed = load.fixed;
    ASHLAR_UNROLL
    for (int c = 0; c < 3; ++c) {
      SummedValue<Real> u = patch.value[3 * l + c];
      velocity[3 * l + c] = step(controls, before, c, force[c], u);
      patch.value.write(3 * l + c, u);
    }
  };
  wait_for_copies();
  __syncthreads();

  for (unsigned now = first_step; now != first_step + steps; ++now) {
    patch.run_elements(work, head, first_entries);
    uint4 row{};
    if (threadIdx.x < head.entries) row = first_row(head, lists.rows, nth(threadIdx.x));
    __syncthreads();
#pragma unroll 1
    for (int i = threadIdx.x; i < head.entries; i += threads) {
      const int l = nth(i);
      const uint4 first = row;
      if (i + threads < head.entries) row = first_row(head, lists.rows, nth(i + threads));
      Real sum[3];
      if (l >= head.interior) {
        const int own = 3 * exchange.places[head.first_entry + l].own;
        sum_corners<3>(head, lists.rows, l, first, patch.corner, sum);
        messages.post(now, head.first_entry + l, sum);
        for (int c = 0; c < 3; ++c) inbox[own + c] = sum[c];
      } else {
        const Load load = load_of(l);
        sum_corners<3>(head, lists.rows, l, first, patch.corner, sum);
        move(l, load, sum);
      }
    }
    Load load{};
    InboxPlaces places{};
    const auto ask = [&](int l) {
      if (l >= head.entries) return;
      load = load_of(l);
      places = exchange.places[head.first_entry + l];
    };
    ask(head.interior + threadIdx.x);
    fetch_letters<threads>(messages, now, inbox_head, exchange.letters, inbox);
    __syncthreads();
#pragma unroll 1
    for (int l = head.interior + threadIdx.x; l < head.entries; l += threads) {
      const Load mine = load;
      const InboxPlaces here = places;
      ask(l + threads);
      Real force[3] = {};
      for (int j = here.first; j < here.end; ++j)
        for (int c = 0; c < 3; ++c) force[c] += inbox[3 * j + c];
      move(l, mine, force);
    }
    __syncthreads();
  }

  for (int l = threadIdx.x; l < head.entries; l += threads) {
    const bool first_of_all =
        l < head.interior || exchange.places[head.first_entry + l].own == exchange.places[head.first_entry + l].first;
    if (!first_of_all) continue;
    const int node = node_of(l);
    for (int c = 0; c < 3; ++c) {
      body.u.write(3 * node + c, patch.value[3 * l + c]);
      body.v[3 * node + c] = velocity[3 * l + c];
    }
  }
}

}  // namespace ashlar
