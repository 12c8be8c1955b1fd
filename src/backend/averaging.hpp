#pragma once
#include <map>

#include "kernels/averaging.hpp"
#include "model/discretisation.hpp"

namespace ashlar {

/// Corners of averaged elements in a machine's memory.
template <class Exec, class Real>
class Averaging {
 public:
  /// @param batches those whose elements are averaged
  void assign(const Discretisation& d, const std::vector<int>& batches) {
    std::vector<int> first{0}, around, corner_of;
    std::vector<Real> share;
    for (const int b : batches) {
      const Batch& batch = d.batches[b];
      std::map<int, std::vector<int>> elements;  // of a node
      for (int i = 0; i < batch.element_count; ++i)
        for (int k = 0; k < 4; ++k) elements[node_of(d, batch, i, k)].push_back(i);
      std::map<int, int> number;
      for (const auto& [node, these] : elements) {
        number[node] = static_cast<int>(first.size()) - 1;
        double volume = 0;
        for (const int i : these) volume += volume_of(d, batch, i);
        for (const int i : these) {
          around.push_back(batch.gauss(i, 0));
          share.push_back(Real(volume_of(d, batch, i) / volume));
        }
        first.push_back(static_cast<int>(around.size()));
      }
      first_corner_[b] = static_cast<int>(corner_of.size());
      for (int i = 0; i < batch.element_count; ++i)
        for (int k = 0; k < 4; ++k) corner_of.push_back(number[node_of(d, batch, i, k)]);
    }
    first_.assign(first);
    around_.assign(around);
    share_.assign(share);
    corner_.assign(corner_of);
    value_.resize(first.size() - 1);
    mean_.resize(d.gauss_count);
  }
  bool any() const { return !first_corner_.empty(); }
  Real* mean() { return mean_.data(); }

  /// mean() of elements, to their corners and back.
  template <class BatchViewOf>
  void spread(Exec& exec, const BatchViewOf& batch_view) {
    const AveragingView<Real> corners{.corner_count = static_cast<int>(value_.size()),
                                      .first = first_.data(),
                                      .around = around_.data(),
                                      .share = share_.data(),
                                      .value = value_.data()};
    exec.for_each(corners.corner_count, CornerMean<Real>{corners, mean()});
    for (const auto& [b, first] : first_corner_) {
      const BatchView batch = batch_view(b);
      exec.for_each(batch.element_count, ElementMean<Real>{corners, batch, corner_.data() + first, mean()});
    }
  }

 private:
  template <class T>
  using Array = typename Exec::template Array<T>;

  static int node_of(const Discretisation& d, const Batch& batch, int i, int k) {
    return d.blocks.corner_node[batch.first_slot + 4 * i + k];
  }
  static double volume_of(const Discretisation& d, const Batch& batch, int i) {
    const auto edge = [&](int k) {
      return d.block_points[node_of(d, batch, i, k)] - d.block_points[node_of(d, batch, i, 0)];
    };
    return Tet4<double>::weight * jacobian(edge(1), edge(2), edge(3)).det;
  }

  std::map<int, int> first_corner_;  ///< of averaged batches, into corner_
  Array<int> first_, around_, corner_;
  Array<Real> share_, value_, mean_;
};

}  // namespace ashlar
