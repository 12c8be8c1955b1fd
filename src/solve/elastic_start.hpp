#pragma once
#include "solve/coarse_balance.hpp"
#include "solve/relaxation.hpp"

namespace ashlar {

/// Conjugate gradients to the elastic balance before relaxation takes over: far fewer element passes where nothing
/// slides or cracks. Preconditioned by the virtual mass and by rigid movements of parts of the body (CoarseBalance).
/// Same element routine, same bits on any number of threads.
class ElasticStart {
 public:
  /// The supports have been written to the backend.
  ElasticStart(const Problem& problem, Backend& backend) : problem_(problem), backend_(backend) {}

  /// Whether all contacts are bonded, so that the balance is linear.
  bool applies() const;

  /// Moves the displacement in the backend towards balance with Field::load and the present temperature. Virtual mass
  /// is set.
  /// @return iterations done
  long run(const Relaxation& relaxation, double thermal_load, const RelaxationWatch& watch);

 private:
  const Problem& problem_;
  Backend& backend_;
  bool coarse_written_ = false;
};

}  // namespace ashlar
