#pragma once
#include <span>
#include <stdexcept>
#include <vector>

#include "model/summed.hpp"

namespace ashlar {

/// Values of a Summed in a machine's memory.
template <class Exec, class Real>
class SummedArray {
 public:
  void resize(std::size_t n) {
    high_.resize(n);
    if (Summed<Real>::paired) low_.resize(n);
  }
  std::size_t size() const { return high_.size(); }
  Summed<Real> view() { return {high_.data(), Summed<Real>::paired ? low_.data() : nullptr}; }
  void upload(std::span<const double> values) {
    if (values.size() != size()) throw std::logic_error("field of the wrong size");
    std::vector<Real> part(values.begin(), values.end());
    high_.upload(part);
    if (!Summed<Real>::paired) return;
    for (std::size_t i = 0; i < part.size(); ++i) part[i] = Real(values[i] - double(part[i]));
    low_.upload(part);
  }
  void download(std::span<double> values) const {
    std::vector<Real> part(size());
    high_.download(part);
    for (std::size_t i = 0; i < part.size(); ++i) values[i] = double(part[i]);
    if (!Summed<Real>::paired) return;
    low_.download(part);
    for (std::size_t i = 0; i < part.size(); ++i) values[i] += double(part[i]);
  }

 private:
  template <class T>
  using Array = typename Exec::template Array<T>;
  Array<Real> high_, low_;
};

/// Points at the entries of a node set, from the first entry of each patch: small numbers, whatever the model's place.
template <class Real>
std::vector<Real> places_in_patches(const Topology& t, const std::vector<Vec3<double>>& points) {
  std::vector<Real> places(3 * t.entry_node.size());
  for (std::size_t p = 0; p + 1 < t.patch_first_entry.size(); ++p)
    for (int e = t.patch_first_entry[p]; e < t.patch_first_entry[p + 1]; ++e)
      for (int c = 0; c < 3; ++c)
        places[3 * std::size_t(e) + c] =
            Real(points[t.entry_node[e]][c] - points[t.entry_node[t.patch_first_entry[p]]][c]);
  return places;
}

}  // namespace ashlar
