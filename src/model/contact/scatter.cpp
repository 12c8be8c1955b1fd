#include "model/contact/scatter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ashlar {

namespace {

constexpr double least_share = 0.01;  // of the mean strength, where the tail of a distribution ends

/// Standard deviation over mean of Weibull's distribution.
double weibull_variation(double modulus) {
  const double mean = std::tgamma(1 + 1 / modulus);
  return std::sqrt(std::tgamma(1 + 2 / modulus) / (mean * mean) - 1);
}

}  // namespace

StrengthShares::StrengthShares(const Scatter& scatter) : scatter_(scatter), state_(scatter.seed) {
  if (scatter.kind != Scatter::Kind::weibull) return;
  double low = 0.5, high = 1e4;
  for (int round = 0; round < 100; ++round) {
    modulus_ = 0.5 * (low + high);
    (weibull_variation(modulus_) > scatter.variation ? low : high) = modulus_;
  }
  scale_ = 1 / std::tgamma(1 + 1 / modulus_);
}

/// SplitMix64 (Steele, Lea & Flood 2014).
double StrengthShares::uniform() {
  std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  z ^= z >> 31;
  return (static_cast<double>(z >> 11) + 0.5) * 0x1p-53;
}

double StrengthShares::next() {
  const double one = uniform(), other = uniform();
  double share = 1;
  if (scatter_.kind == Scatter::Kind::weibull) share = scale_ * std::pow(-std::log(one), 1 / modulus_);
  if (scatter_.kind == Scatter::Kind::normal)
    share += scatter_.variation * std::sqrt(-2 * std::log(one)) * std::cos(2 * std::numbers::pi * other);
  return std::max(share, least_share);
}

}  // namespace ashlar
