#pragma once
#include "base/number.hpp"

/// A vector pack: the same element in several lanes on the CPU, one lane an element. Lanes round exactly as scalars do,
/// so packed and scalar runs give the same bits.
namespace ashlar {

template <class T, int width>
struct VectorOf {
  typedef T type __attribute__((vector_size(width * sizeof(T))));
};

template <class T, int width>
struct Pack {
  using Lanes = typename VectorOf<T, width>::type;
  Lanes lanes;

  Pack() = default;
  explicit Pack(T value) : lanes(value - Lanes{}) {}
  explicit Pack(const Lanes& l) : lanes(l) {}

  friend ASHLAR_HD Pack operator+(Pack a, Pack b) { return Pack(a.lanes + b.lanes); }
  friend ASHLAR_HD Pack operator-(Pack a, Pack b) { return Pack(a.lanes - b.lanes); }
  friend ASHLAR_HD Pack operator*(Pack a, Pack b) { return Pack(a.lanes * b.lanes); }
  friend ASHLAR_HD Pack operator/(Pack a, Pack b) { return Pack(a.lanes / b.lanes); }
  friend ASHLAR_HD Pack operator-(Pack a) { return Pack(-a.lanes); }
  friend ASHLAR_HD Pack fma(Pack a, Pack b, Pack c) {
    Pack r;
    for (int i = 0; i < width; ++i) r.lanes[i] = fma(a.lanes[i], b.lanes[i], c.lanes[i]);
    return r;
  }
  friend ASHLAR_HD Pack reciprocal(Pack a) { return Pack(T(1)) / a; }
  friend ASHLAR_HD Pack root(Pack a) {
    Pack r;
    for (int i = 0; i < width; ++i) r.lanes[i] = root(a.lanes[i]);
    return r;
  }
  friend ASHLAR_HD Pack normal_root(Pack a) { return root(a); }
  friend ASHLAR_HD Pack if_less(Pack a, Pack b, Pack x, Pack y) { return Pack(a.lanes < b.lanes ? x.lanes : y.lanes); }
  friend ASHLAR_HD T lane(Pack a, int i) { return a.lanes[i]; }
  friend ASHLAR_HD void set_lane(Pack& a, int i, T value) { a.lanes[i] = value; }
};

template <class T, int width>
inline constexpr int lane_count<Pack<T, width>> = width;

template <class T, int width>
struct ScalarOf<Pack<T, width>> {
  using type = T;
};

/// Widest pack of the instruction set that the build targets.
#if defined(__AVX512F__)
inline constexpr int pack_bytes = 64;
#else
inline constexpr int pack_bytes = 32;
#endif
template <class T>
inline constexpr int pack_width = pack_bytes / sizeof(T);

}  // namespace ashlar
