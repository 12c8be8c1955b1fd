#include "model/mesher/spacing.hpp"

#include <algorithm>
#include <cmath>

namespace ashlar {

namespace {

/// Geometric growth from both ends with a uniform part between. In a geometric progression of ratio g that starts with
/// h, the element at distance x has the size h + (g - 1) x, and x holds log(1 + (g - 1) x / h) / log(g) elements.
class Growth {
 public:
  explicit Growth(const Spacing& s) : slope_(s.grade - 1), log_(std::log(s.grade)), size_(s.size), length_(s.length) {
    first_ = std::min(s.first, s.size);
    last_ = std::min(s.last, s.size);
    growing_ = (size_ - first_) / slope_;
    shrinking_ = (size_ - last_) / slope_;
    if (growing_ + shrinking_ > length_) {
      growing_ = std::clamp((last_ - first_ + slope_ * length_) / (2 * slope_), 0.0, length_);
      shrinking_ = length_ - growing_;
    }
    count_growing_ = std::log1p(slope_ * growing_ / first_) / log_;
    count_even_ = (length_ - growing_ - shrinking_) / size_;
    count_shrinking_ = std::log1p(slope_ * shrinking_ / last_) / log_;
  }
  double total() const { return count_growing_ + count_even_ + count_shrinking_; }
  double distance_after(double count) const {
    if (count <= count_growing_) return first_ * std::expm1(count * log_) / slope_;
    if (count <= count_growing_ + count_even_) return growing_ + (count - count_growing_) * size_;
    return length_ - last_ * std::expm1((total() - count) * log_) / slope_;
  }

 private:
  double slope_, log_, size_, length_, first_, last_;
  double growing_, shrinking_;  ///< lengths of the two graded parts, m
  double count_growing_, count_even_, count_shrinking_;
};

}  // namespace

double Spacing::natural_count() const { return grade > 1 ? Growth(*this).total() : length / size; }

int Spacing::count() const { return static_cast<int>(std::clamp(std::ceil(natural_count() - 0.05), 1.0, 1e9)); }

std::vector<double> Spacing::places(int n) const {
  std::vector<double> places(n + 1);
  for (int k = 0; k <= n; ++k) places[k] = static_cast<double>(k) / n;
  if (grade > 1) {
    const Growth growth(*this);
    for (int k = 1; k < n; ++k) places[k] = growth.distance_after(places[k] * growth.total()) / length;
  }
  return places;
}

}  // namespace ashlar
