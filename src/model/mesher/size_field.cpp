#include "model/mesher/size_field.hpp"

#include <algorithm>
#include <tuple>

namespace ashlar {

SizeField::SizeField(std::vector<SizeAt> places, double slope, double largest)
    : places_(std::move(places)), slope_(slope), largest_(largest) {
  std::erase_if(places_, [&](const SizeAt& p) { return p.size >= largest; });
  bounds_.resize(places_.size());
  if (!places_.empty()) build(0, places_.size(), 0);
}

double SizeField::at(const PlanePoint& p) const {
  double best = largest_;
  search(0, places_.size(), p, best);
  return best;
}

SizeField::Bounds SizeField::build(std::size_t from, std::size_t to, int axis) {
  const std::size_t middle = from + (to - from) / 2;
  const auto key = [axis](const SizeAt& s) { return std::tuple(s.place[axis], s.place[1 - axis], s.size); };
  std::nth_element(places_.begin() + static_cast<long>(from), places_.begin() + static_cast<long>(middle),
                   places_.begin() + static_cast<long>(to),
                   [&](const SizeAt& a, const SizeAt& b) { return key(a) < key(b); });
  const auto& here = places_[middle];
  Bounds bounds{here.place, here.place, here.size};
  const auto include = [&](const Bounds& part) {
    for (int a = 0; a < 2; ++a) {
      bounds.low[a] = std::min(bounds.low[a], part.low[a]);
      bounds.high[a] = std::max(bounds.high[a], part.high[a]);
    }
    bounds.smallest = std::min(bounds.smallest, part.smallest);
  };
  if (from < middle) include(build(from, middle, 1 - axis));
  if (middle + 1 < to) include(build(middle + 1, to, 1 - axis));
  return bounds_[middle] = bounds;
}

void SizeField::search(std::size_t from, std::size_t to, const PlanePoint& p, double& best) const {
  if (from >= to) return;
  const std::size_t middle = from + (to - from) / 2;
  const auto& bounds = bounds_[middle];
  const PlanePoint nearest{std::clamp(p[0], bounds.low[0], bounds.high[0]),
                           std::clamp(p[1], bounds.low[1], bounds.high[1])};
  if (bounds.smallest + slope_ * distance(nearest, p) >= best) return;
  best = std::min(best, places_[middle].size + slope_ * distance(places_[middle].place, p));
  search(from, middle, p, best);
  search(middle + 1, to, p, best);
}

}  // namespace ashlar
