#pragma once
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <vector>

#include "solve/problem.hpp"

namespace ashlar {

/// The stiffness between rigid movements of node aggregates: the coarse part of the elastic search. Aggregates are the
/// patches (a boundary node belongs to the first patch that has it). Only elements and springs between aggregates, or
/// at supports, resist: the rest moves as a rigid body.
class CoarseSpace {
 public:
  /// @param fixed [block nodes] bits of held components, machine's numbering
  CoarseSpace(const Problem& problem, const std::vector<double>& fixed);

  const NodeAggregates& aggregates() const { return aggregates_; }
  /// Rigid movements [6 * aggregates] that answer to resultants [6 * aggregates].
  std::vector<double> solve(const std::vector<double>& resultants) const;

 private:
  NodeAggregates aggregates_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
};

}  // namespace ashlar
