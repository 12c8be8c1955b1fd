#pragma once
#include <omp.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "backend/machine_memory.hpp"
#include "backend/pack.hpp"
#include "backend/phases.hpp"
#include "kernels/sum.hpp"

namespace ashlar {

/// The Gauss points of the elements in one pack; unused lanes repeat the last element.
template <class V, class Real>
struct PackedPoints {
  const BodyView<Real>& body;
  const BatchView& batch;
  int first, used;
  int element(int lane) const { return first + std::min(lane, used - 1); }
  V warming(int g) const {
    V w;
    for (int l = 0; l < lane_count<V>; ++l) w.lanes[l] = body.warming[batch.gauss(element(l), g)];
    return w;
  }
  Sym3<V> averaged_stress(int g) const {
    Sym3<V> s;
    V mean;
    for (int l = 0; l < lane_count<V>; ++l) {
      const int at = batch.gauss(element(l), g);
      for (int c = 0; c < 6; ++c) s[c].lanes[l] = body.stress[6 * at + c];
      mean.lanes[l] = body.averaged[at];
    }
    return with_mean(s, mean);
  }
  Real length(int lane, const Vec3<Real>& normal) const { return length_across(body, batch, element(lane), normal); }
  bool remembers() const { return marks() & 1; }
  bool quiet() const { return marks() == 0; }
  void expect_more() const { body.remembers[batch.history(first, 0)] |= 2; }
  template <class History>
  void read_history(int g, History& h) const {
    for (int c = 0; c < h.size; ++c)
      for (int l = 0; l < lane_count<V>; ++l)
        h[c].lanes[l] = body.history[c * body.history_stride + batch.history(element(l), g)];
  }

 private:
  int marks() const {
    int all = 0;
    for (int l = 0; l < used; ++l) all |= body.remembers[batch.history(first + l, 0)];
    return all;
  }
};

/// Memory and loops of the CPU.
class CpuExec {
 public:
  template <class T>
  class Array {
   public:
    Array() = default;
    Array(Array&& other) noexcept : size_(std::exchange(other.size_, 0)), values_(std::move(other.values_)) {}
    ~Array() { book(0); }
    void resize(std::size_t n) {
      if (book(n)) values_.assign(n, T());
    }
    void assign(const std::vector<T>& values) {
      if (book(values.size())) values_ = values;
    }
    void upload(const std::vector<T>& values) {
      if (!values_.empty()) std::copy(values.begin(), values.end(), values_.begin());
    }
    void download(std::vector<T>& values) const { values = values_; }
    void copy(const Array& other) {
      if (other.size_ != size_) throw std::logic_error("copy of another size");
      values_ = other.values_;
    }
    std::size_t size() const { return size_; }
    T* data() { return values_.data(); }

   private:
    bool book(std::size_t n) { return MachineMemory::book(std::exchange(size_, n) * sizeof(T), n * sizeof(T)); }
    std::size_t size_ = 0;
    std::vector<T> values_;
  };

  static constexpr bool marches = false;

  explicit CpuExec(int threads) : threads_(threads > 0 ? threads : omp_get_num_procs()) {}
  std::string name() const { return "cpu, " + std::to_string(threads_) + (threads_ == 1 ? " thread" : " threads"); }

  template <class Real>
  void set_patches(const Discretisation&) {}
  void finish() const {}

  /// @param worth fewer than so many are left to one thread
  template <class Kernel>
  void for_each(int n, const Kernel& kernel, int worth = 1024) const {
#pragma omp parallel for schedule(static) num_threads(threads_) if (n >= worth)
    for (int i = 0; i < n; ++i) kernel(i);
  }

  /// Combines what `terms(item, values)` says of n items, in the order of kernels/sum.hpp.
  template <int count, class How = Sum, class Terms>
  std::array<double, count> combine(int n, const Terms& terms) const {
    std::vector<double> left = combine_chunks<count, How>(n, terms);
    while (left.size() > count)
      left = combine_chunks<count, How>(static_cast<int>(left.size()) / count, ChunkTerms<count>{left.data()});
    std::array<double, count> total;
    total.fill(How::start);
    std::copy(left.begin(), left.end(), total.begin());
    return total;
  }

  /// Patch by patch: coordinates and displacements staged in cache, elements in vector packs, sums element by element.
  template <template <class> class Element, bool Warm, class Point, class Real>
  void block_forces(const BodyView<Real>& body, const BatchView& batch, const Point& law, const Discretisation& d,
                    int b) const {
    const Batch& source = d.batches[b];
#pragma omp parallel for schedule(static) num_threads(threads_) if (source.patch_count > 1)
    for (int p = source.first_patch; p < source.first_patch + source.patch_count; ++p)
      patch_force<Element, Warm>(body, batch, law, p, d.patch_first_element[p] - source.first_element,
                                 d.patch_first_element[p + 1] - source.first_element);
  }

  /// Heat flow of one batch, into the nodes inside its patches and the partial sums of the others.
  template <template <class> class Element, class Real>
  void heat_flows(ElementTag<Element>, const HeatView<Real>& heat, const BatchView& batch, Real conductivity,
                  const Summed<Real>& field, const Discretisation& d, int b, const StoreSum<Real>& store) const {
    for_each(batch.element_count, HeatFlow<Element, Real>{heat, batch, conductivity, field});
    const Batch& source = d.batches[b];
    const GatherPatch<Real, 1> gather{heat.nodes, heat.corner, heat.partial, store.sum};
    const int first = d.heat.patch_first_entry[source.first_patch];
    for_each(d.heat.patch_first_entry[source.first_patch + source.patch_count] - first,
             [&](int i) { gather(first + i); });
  }

 private:
  template <int count, class How, class Terms>
  std::vector<double> combine_chunks(int n, const Terms& terms) const {
    std::vector<double> of_chunk(chunk_count(n) * std::size_t{count});
    const auto combine_chunk = [&](int chunk) {
      double value[count][chunk_items];
      const int first = chunk * chunk_items, used = std::min(chunk_items, n - first);
      for (int i = 0; i < chunk_items; ++i) {
        double term[count];
        for (int k = 0; k < count; ++k) term[k] = How::start;
        if (i < used) terms(first + i, term);
        for (int k = 0; k < count; ++k) value[k][i] = term[k];
      }
      for (int k = 0; k < count; ++k) {
        for (int half = chunk_items / 2; half > 0; half /= 2)
          for (int i = 0; i < half; ++i) value[k][i] = How::of(value[k][i], value[k][i + half]);
        of_chunk[chunk * count + k] = value[k][0];
      }
    };
    for_each(chunk_count(n), combine_chunk, 8);
    return of_chunk;
  }
  template <class Real>
  static SummedValue<Real> moved_at(const Real* at, int c) {
    if constexpr (Summed<Real>::paired)
      return {at[4 + c], at[8 + c]};
    else
      return {at[4 + c]};
  }
  template <template <class> class Element, bool Warm, class Point, class Real>
  static void patch_force(const BodyView<Real>& body, const BatchView& batch, const Point& law, int patch, int first,
                          int last) {
    constexpr int width = pack_width<Real>;
    using V = Pack<Real, width>;
    constexpr int corners = Element<V>::corners;
    const NodeSetView& nodes = body.nodes;
    const int first_entry = nodes.patch_first_entry[patch];
    const int entries = nodes.patch_first_entry[patch + 1] - first_entry;

    static thread_local std::vector<Real> scratch;
    constexpr int stride = Summed<Real>::paired ? 12 : 8;  // a node: x y z - ux uy uz -, and what u has beyond
    scratch.resize((stride + 4) * std::size_t(entries));
    Real* const place = scratch.data();
    Real* const sum = scratch.data() + stride * entries;  // 4 a node: fx fy fz -
    for (int l = 0; l < entries; ++l) {
      const int n = 3 * nodes.entry_node[first_entry + l];
      for (int c = 0; c < 3; ++c) {
        place[stride * l + c] = body.x[3 * (first_entry + l) + c];
        const SummedValue<Real> moved = body.u[n + c];
        place[stride * l + 4 + c] = moved.high;
        if constexpr (Summed<Real>::paired) place[stride * l + 8 + c] = moved.low;
        sum[4 * l + c] = Real(0);
      }
    }

    for (int i = first; i < last; i += width) {
      const int used = std::min(width, last - i);
      const auto read = [&](V(&x)[3][corners], V(&u)[3][corners]) {
        for (int k = 0; k < corners; ++k)
          for (int lane = 0; lane < width; ++lane) {
            const int element = i + std::min(lane, used - 1);
            const Real* at = place + stride * nodes.corner_entry[batch.slot(element, corners, k)];
            const Real* base = place + stride * nodes.corner_entry[batch.slot(element, corners, 0)];
            for (int c = 0; c < 3; ++c) {
              x[c][k].lanes[lane] = at[c];
              u[c][k].lanes[lane] = relative(moved_at<Real>(at, c), moved_at<Real>(base, c));
            }
          }
      };
      V f[3][corners];
      read_element_force<Element, Warm, V>(law, read, PackedPoints<V, Real>{body, batch, i, used}, f);
      for (int lane = 0; lane < used; ++lane)
        for (int k = 0; k < corners; ++k) {
          Real* at = sum + 4 * nodes.corner_entry[batch.slot(i + lane, corners, k)];
          for (int c = 0; c < 3; ++c) at[c] += f[c][k].lanes[lane];
        }
    }

    for (int l = 0; l < entries; ++l) {
      const int node = nodes.entry_node[first_entry + l];
      Real* out = l < nodes.patch_interior[patch] ? body.force + 3 * node : body.partial + 3 * (first_entry + l);
      for (int c = 0; c < 3; ++c) out[c] = sum[4 * l + c];
    }
  }

  int threads_;
};

}  // namespace ashlar
