#include "model/mesher/merge_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace ashlar {

namespace {

bool finite(const Vec3<double>& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// Points sorted by the cube that holds them, cubes much larger than the tolerance.
class Cubes {
 public:
  Cubes(const std::vector<Vec3<double>>& points) : points_(points) {
    constexpr double far = std::numeric_limits<double>::infinity();
    low_ = {far, far, far};
    Vec3<double> high{-far, -far, -far};
    for (const auto& p : points)
      if (finite(p))
        for (int a = 0; a < 3; ++a) {
          low_[a] = std::min(low_[a], p[a]);
          high[a] = std::max(high[a], p[a]);
        }
    const double extent = norm(high - low_);
    tolerance_ = 1e-9 * extent;
    edge_ = extent > 0 ? 1e-6 * extent : 1;
    for (int i = 0; i < static_cast<int>(points.size()); ++i)
      if (finite(points[i])) sorted_.push_back({key(cell(points[i], 0)), i});
    std::sort(sorted_.begin(), sorted_.end());
  }

  /// Points before `i` at the same place, ascending.
  std::vector<int> earlier_at(int i) const {
    std::vector<int> found;
    const auto low = cell(points_[i], -tolerance_), high = cell(points_[i], tolerance_);
    for (auto x = low[0]; x <= high[0]; ++x)
      for (auto y = low[1]; y <= high[1]; ++y)
        for (auto z = low[2]; z <= high[2]; ++z) {
          const std::uint64_t wanted = key({x, y, z});
          for (auto at = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair{wanted, 0});
               at != sorted_.end() && at->first == wanted && at->second < i; ++at)
            if (norm(points_[at->second] - points_[i]) <= tolerance_) found.push_back(at->second);
        }
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  using Cell = std::array<std::uint64_t, 3>;
  Cell cell(const Vec3<double>& p, double shift) const {
    Cell c;
    for (int a = 0; a < 3; ++a) c[a] = static_cast<std::uint64_t>(std::max(0.0, (p[a] + shift - low_[a]) / edge_));
    return c;
  }
  static std::uint64_t key(const Cell& c) { return c[0] << 42 | c[1] << 21 | c[2]; }

  const std::vector<Vec3<double>>& points_;
  Vec3<double> low_;
  double tolerance_ = 0, edge_ = 1;
  std::vector<std::pair<std::uint64_t, int>> sorted_;
};

}  // namespace

MergedPoints merge_points(const std::vector<Vec3<double>>& points, const std::vector<int>& source) {
  const Cubes cubes(points);
  MergedPoints merged;
  merged.node.assign(points.size(), -1);
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    if (finite(points[i]))
      for (const int other : cubes.earlier_at(i)) {
        if (source[other] == source[i])
          merged.repeated.push_back({other, i});
        else if (merged.node[i] < 0)
          merged.node[i] = merged.node[other];
      }
    if (merged.node[i] < 0) {
      merged.node[i] = static_cast<int>(merged.points.size());
      merged.points.push_back(points[i]);
    }
  }
  return merged;
}

}  // namespace ashlar
