#pragma once
#include <cmath>
#include <vector>

#include "backend/backend.hpp"
#include "kernels/balance.hpp"

namespace ashlar {

/// Vectors of the elastic search in a machine's memory; empty until aggregates are written.
template <class Exec, class Real>
class BalanceLane {
 public:
  /// @param points [nodes] m
  void write_aggregates(const NodeAggregates& a, const std::vector<Vec3<double>>& points) {
    const std::size_t vector = 3 * a.aggregate.size();
    for (auto* array : {&residual_, &preconditioned_, &direction_, &product_}) array->resize(vector);
    aggregate_.assign(a.aggregate);
    first_.assign(a.first);
    node_.assign(a.member);
    std::vector<Real> arm(vector);
    for (std::size_t i = 0; i < vector; ++i) arm[i] = Real(points[i / 3][i % 3] - a.centre[3 * a.aggregate[i / 3] + i % 3]);
    arm_.assign(arm);
    coarse_.resize(rigid_modes * (a.first.size() - 1));
  }
  BalanceView<Real> view(const BodyView<Real>& body, const GroupView<Real>& groups) {
    return {.body = body,
            .groups = groups,
            .residual = residual_.data(),
            .preconditioned = preconditioned_.data(),
            .direction = direction_.data(),
            .product = product_.data(),
            .aggregate_count = static_cast<int>(coarse_.size() / rigid_modes),
            .aggregate = aggregate_.data(),
            .aggregate_first = first_.data(),
            .aggregate_node = node_.data(),
            .arm = arm_.data()};
  }
  BalanceMeasure sums(Exec& exec, const BalanceView<Real>& view) {
    const auto s = exec.template combine<balance_sum_count>(view.body.nodes.node_count, BalanceSums<Real>{view});
    return {std::sqrt(s[balance_residual]), s[balance_preconditioned], s[balance_along]};
  }
  std::vector<double> resultants(Exec& exec, const BalanceView<Real>& view) {
    exec.for_each(view.aggregate_count, BalanceRestrict<Real>{view, coarse_.data()});
    std::vector<double> resultant(coarse_.size());
    coarse_.download(resultant);
    return resultant;
  }
  void prolong(Exec& exec, const BalanceView<Real>& view, const std::vector<double>& movement) {
    coarse_.upload(movement);
    exec.for_each(view.body.nodes.node_count, BalanceProlong<Real>{view, coarse_.data()});
  }

 private:
  template <class T>
  using Array = typename Exec::template Array<T>;
  Array<Real> residual_, preconditioned_, direction_, product_, arm_;
  Array<int> aggregate_, first_, node_;
  Array<double> coarse_;
};

}  // namespace ashlar
