#pragma once
#include "base/hd.hpp"

/// Sums and maxima over many items that come out the same on every machine and for every number of threads (numerics 8):
/// items in chunks of a fixed size, a chunk by halves, then the chunks' numbers in the same manner until one is left.
namespace ashlar {

inline constexpr int chunk_items = 256;

/// Chunks of `items`.
ASHLAR_HD int chunk_count(int items) { return (items + chunk_items - 1) / chunk_items; }

struct Sum {
  static constexpr double start = 0;
  static ASHLAR_HD double of(double a, double b) { return a + b; }
};
struct Largest {
  static constexpr double start = -1e300;  ///< where no item says anything
  static ASHLAR_HD double of(double a, double b) { return a < b ? b : a; }
};

/// Numbers of one chunk as the terms of the next round.
template <int count>
struct ChunkTerms {
  const double* of_chunk;  ///< [chunks * count]
  ASHLAR_HD void operator()(int chunk, double (&s)[count]) const {
    for (int k = 0; k < count; ++k) s[k] = of_chunk[chunk * count + k];
  }
};

}  // namespace ashlar
