#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "backend/backend.hpp"
#include "kernels/balance.hpp"

namespace ashlar {

/// Vectors of the elastic search in a machine's memory; empty until its coarse part is written.
template <class Exec, class Real>
class BalanceLane {
 public:
  /// @param points [nodes] m
  void write(const CoarseBalance& coarse, const std::vector<Vec3<double>>& points) {
    const std::size_t vector = 3 * coarse.aggregate.size();
    for (auto* array : {&residual_, &preconditioned_, &direction_, &product_}) array->resize(vector);
    aggregate_.assign(coarse.aggregate);
    first_.assign(coarse.first);
    node_.assign(coarse.member);
    std::vector<int> first_block{0}, of_block;
    for (int a = 0; a < coarse.count(); ++a) {
      const int nodes = std::max(1, coarse.first[a + 1] - coarse.first[a]);  // one without nodes has a block, too
      of_block.insert(of_block.end(), (nodes + nodes_per_block - 1) / nodes_per_block, a);
      first_block.push_back(static_cast<int>(of_block.size()));
    }
    first_block_.assign(first_block);
    of_block_.assign(of_block);
    std::vector<Real> arm(vector);
    for (std::size_t i = 0; i < vector; ++i)
      arm[i] = Real(points[i / 3][i % 3] - coarse.centre[3 * coarse.aggregate[i / 3] + i % 3]);
    arm_.assign(arm);
    compliance_.assign(coarse.compliance);
    partial_.resize(rigid_modes * block_lanes * of_block.size());
    for (auto* array : {&resultant_, &movement_}) array->resize(rigid_modes * std::size_t(coarse.count()));
  }
  /// Bytes that write() takes at most.
  static std::size_t bytes(std::size_t nodes, int aggregates) {
    const std::size_t movements = rigid_modes * std::size_t(aggregates), blocks = nodes / nodes_per_block + aggregates;
    return (15 * sizeof(Real) + 2 * sizeof(int)) * nodes + (2 * std::size_t(aggregates) + 2 + blocks) * sizeof(int) +
           (movements * (movements + 2) + rigid_modes * block_lanes * blocks) * sizeof(double);
  }
  BalanceView<Real> view(const BodyView<Real>& body, const GroupView<Real>& groups) {
    return {.body = body,
            .groups = groups,
            .residual = residual_.data(),
            .preconditioned = preconditioned_.data(),
            .direction = direction_.data(),
            .product = product_.data(),
            .aggregate_count = static_cast<int>(movement_.size() / rigid_modes),
            .aggregate = aggregate_.data(),
            .aggregate_first = first_.data(),
            .aggregate_node = node_.data(),
            .aggregate_block = first_block_.data(),
            .block_aggregate = of_block_.data(),
            .arm = arm_.data(),
            .compliance = compliance_.data(),
            .partial = partial_.data(),
            .resultant = resultant_.data(),
            .movement = movement_.data()};
  }
  BalanceMeasure sums(Exec& exec, const BalanceView<Real>& view) {
    const auto s = exec.template combine<balance_sum_count>(view.body.nodes.node_count, BalanceSums<Real>{view});
    return {std::sqrt(s[balance_residual]), s[balance_preconditioned]};
  }
  double along(Exec& exec, const BalanceView<Real>& view) {
    return exec.template combine<1>(view.body.nodes.node_count, BalanceAlong<Real>{view})[0];
  }
  void precondition(Exec& exec, const BalanceView<Real>& view) {
    exec.for_each(view.groups.group_count, BalancePrecondition<Real>{view});
    exec.for_each(block_lanes * static_cast<int>(of_block_.size()), BalanceRestrict<Real>{view});
    exec.for_each(rigid_modes * block_lanes * view.aggregate_count, BalanceLanes<Real>{view});
    exec.for_each(rigid_modes * view.aggregate_count, BalanceResultant<Real>{view});
    exec.for_each(rigid_modes * view.aggregate_count, BalanceCoarse<Real>{view});
    exec.for_each(view.body.nodes.node_count, BalanceProlong<Real>{view});
  }

 private:
  template <class T>
  using Array = typename Exec::template Array<T>;
  Array<Real> residual_, preconditioned_, direction_, product_, arm_;
  Array<int> aggregate_, first_, node_, first_block_, of_block_;
  Array<double> compliance_, partial_, resultant_, movement_;
};

}  // namespace ashlar
