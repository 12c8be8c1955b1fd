#include "model/hilbert.hpp"

#include <algorithm>
#include <numeric>

namespace ashlar {

std::uint64_t hilbert_key(std::uint32_t x, std::uint32_t y, std::uint32_t z, int bits) {
  std::uint32_t axis[3] = {x, y, z};
  const std::uint32_t top = 1u << (bits - 1);
  for (std::uint32_t q = top; q > 1; q >>= 1) {
    const std::uint32_t low = q - 1;
    for (auto& a : axis) {
      if (a & q) {
        axis[0] ^= low;
      } else {
        const std::uint32_t swap = (axis[0] ^ a) & low;
        axis[0] ^= swap;
        a ^= swap;
      }
    }
  }
  axis[1] ^= axis[0];
  axis[2] ^= axis[1];
  std::uint32_t flip = 0;
  for (std::uint32_t q = top; q > 1; q >>= 1)
    if (axis[2] & q) flip ^= q - 1;
  std::uint64_t key = 0;
  for (auto& a : axis) a ^= flip;
  for (int bit = bits - 1; bit >= 0; --bit)
    for (const auto a : axis) key = (key << 1) | ((a >> bit) & 1u);
  return key;
}

std::vector<int> hilbert_order(const std::vector<Vec3<double>>& points) {
  constexpr int bits = 20;
  Vec3<double> low = points.empty() ? Vec3<double>{} : points[0], high = low;
  for (const auto& p : points)
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  const double extent = std::max({high.x - low.x, high.y - low.y, high.z - low.z, 1e-300});
  const double cells = (1u << bits) - 1;
  std::vector<std::uint64_t> keys(points.size());
  for (std::size_t n = 0; n < points.size(); ++n) {
    std::uint32_t cell[3];
    for (int i = 0; i < 3; ++i) cell[i] = static_cast<std::uint32_t>((points[n][i] - low[i]) / extent * cells);
    keys[n] = hilbert_key(cell[0], cell[1], cell[2], bits);
  }
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return keys[a] < keys[b]; });
  return order;
}

}  // namespace ashlar
