#pragma once
#include <cstdint>

#include "model/model.hpp"

namespace ashlar {

/// Shares of the mean strength for one contact face after another: positive, of mean 1 and of the scatter's variation,
/// the same ones for the same seed on every machine.
class StrengthShares {
 public:
  explicit StrengthShares(const Scatter& scatter);
  double next();

 private:
  double uniform();  ///< in (0, 1)
  Scatter scatter_;
  std::uint64_t state_;
  double modulus_ = 0, scale_ = 1;  ///< of Weibull's distribution
};

}  // namespace ashlar
