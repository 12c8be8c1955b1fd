#pragma once
#include <cstdint>
#include <vector>

#include "base/tensor.hpp"

namespace ashlar {

/// Position of an integer cell along the 3-D Hilbert curve of `bits` bits an axis (Skilling, AIP Conf. Proc. 707,
/// 2004).
std::uint64_t hilbert_key(std::uint32_t x, std::uint32_t y, std::uint32_t z, int bits);

/// Indices of the points in Hilbert order; equal keys keep their input order.
std::vector<int> hilbert_order(const std::vector<Vec3<double>>& points);

}  // namespace ashlar
