#include "model/contact/scatter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ashlar {
namespace {

std::vector<double> draws(const Scatter& scatter, int count) {
  StrengthShares shares(scatter);
  std::vector<double> drawn(count);
  for (double& d : drawn) d = shares.next();
  return drawn;
}

TEST(scatter, has_mean_one_and_the_variation_asked_for) {
  for (const auto kind : {Scatter::Kind::normal, Scatter::Kind::weibull})
    for (const double variation : {0.05, 0.12, 0.3}) {
      const auto drawn = draws({kind, variation, 3}, 200000);
      double sum = 0, squares = 0;
      for (const double d : drawn) sum += d, squares += d * d;
      const double mean = sum / drawn.size(), deviation = std::sqrt(squares / drawn.size() - mean * mean);
      EXPECT_NEAR(mean, 1, 0.003) << variation;
      EXPECT_NEAR(deviation, variation, 0.01 * variation + 1e-3);
      EXPECT_GT(*std::min_element(drawn.begin(), drawn.end()), 0);
    }
}

// Weibull 1951: modulus 10 has a variation of 0.12046; its median is (ln 2)^(1/10) of the scale, mean Gamma(1.1) of it.
TEST(scatter, follows_weibulls_distribution) {
  auto drawn = draws({Scatter::Kind::weibull, 0.12046, 11}, 200001);
  std::nth_element(drawn.begin(), drawn.begin() + 100000, drawn.end());
  EXPECT_NEAR(drawn[100000], std::pow(std::log(2.0), 0.1) / std::tgamma(1.1), 1e-3);
}

TEST(scatter, is_the_same_for_the_same_seed_and_another_for_another) {
  const Scatter scatter{Scatter::Kind::normal, 0.1, 5};
  EXPECT_EQ(draws(scatter, 100), draws(scatter, 100));
  EXPECT_NE(draws(scatter, 100), draws({Scatter::Kind::normal, 0.1, 6}, 100));
}

}  // namespace
}  // namespace ashlar
