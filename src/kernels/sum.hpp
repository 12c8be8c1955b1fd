#pragma once
#include "base/hd.hpp"

/// Sums over many items that come out the same on every machine and for every number of threads (numerics 8): items in
/// chunks of a fixed size, a chunk by halves, then the chunks' sums in the same manner until one is left.
namespace ashlar {

inline constexpr int chunk_items = 256;

/// Chunks of `items`.
ASHLAR_HD int chunk_count(int items) { return (items + chunk_items - 1) / chunk_items; }

/// Sums of one chunk as the terms of the next round.
template <int count>
struct ChunkTerms {
  const double* chunk_sums;  ///< [chunks * count]
  ASHLAR_HD void operator()(int chunk, double (&s)[count]) const {
    for (int k = 0; k < count; ++k) s[k] = chunk_sums[chunk * count + k];
  }
};

}  // namespace ashlar
