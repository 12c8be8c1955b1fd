#include "physics/turning.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "physics/laws/elastic.hpp"

namespace ashlar {
namespace {

/// Stress of the elastic law, and the energy of all points.
struct Keeper {
  Elastic::Point<double> law = Elastic{30e9, 0.2, 0}.prepare<double>();
  double density = 0, energy = 0;
  Sym3<double> operator()(int, const Sym3<double>& strain) {
    const Sym3<double> s = law.stress(strain);
    density = 0;
    for (int c = 0; c < 6; ++c) density += s[c] * strain[c] / 2;
    return s;
  }
  void volume(double volume) { energy += density * volume; }
};

template <class Element>
class Turning : public testing::Test {
 protected:
  static constexpr int corners = Element::corners;
  using Vectors = double[3][corners];
  /// Corners of the reference element, none of its faces along an axis.
  Turning() {
    const double hex[8][3] = {{0, 0, 0},   {1, 0.1, 0}, {1.1, 1, 0.1}, {0, 1, 0},
                              {0, 0, 1.2}, {1, 0, 0.9}, {1, 1.2, 1},   {0.1, 1, 1}};
    const int wedge[6] = {0, 1, 3, 4, 5, 7}, tet[4] = {0, 1, 3, 4};
    for (int k = 0; k < corners; ++k)
      for (int i = 0; i < 3; ++i) x[i][k] = hex[corners == 8 ? k : corners == 6 ? wedge[k] : tet[k]][i];
  }
  /// Displacement of a turn about an axis through the origin after `before`, and a shift.
  void turn(double angle, const Vectors& before, Vectors& u) const {
    const double c = std::cos(angle), s = std::sin(angle);
    for (int k = 0; k < corners; ++k) {
      const double p[3] = {x[0][k] + before[0][k], x[1][k] + before[1][k], x[2][k] + before[2][k]};
      const double q[3] = {c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]};
      const double r[3] = {q[0] + 7, c * q[1] - s * q[2], s * q[1] + c * q[2] - 3};
      for (int i = 0; i < 3; ++i) u[i][k] = r[i] - x[i][k];
    }
  }
  void stretched(double size, Vectors& u) const {
    for (int k = 0; k < corners; ++k)
      for (int i = 0; i < 3; ++i) u[i][k] = size * std::sin(1.0 + 3 * i + 7 * k);
  }
  double energy(const Vectors& u) const {
    Keeper keeper;
    double f[3][corners];
    Element::force(x, u, f, keeper);
    return keeper.energy;
  }
  Vectors x{};
};
using Elements = testing::Types<TurningHex8<double>, TurningWedge6<double>, TurningTet4<double>>;
TYPED_TEST_SUITE(Turning, Elements);

TYPED_TEST(Turning, a_body_that_turns_and_moves_as_a_whole_bears_no_force) {
  constexpr int corners = TypeParam::corners;
  double none[3][corners] = {}, u[3][corners], f[3][corners];
  for (const double angle : {0.1, 1.0, 3.0}) {
    this->turn(angle, none, u);
    Keeper keeper;
    TypeParam::force(this->x, u, f, keeper);
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < corners; ++k) EXPECT_NEAR(f[i][k], 0, 30e9 * 1e-13);
  }
}

TYPED_TEST(Turning, its_energy_does_not_know_how_the_body_has_turned) {
  constexpr int corners = TypeParam::corners;
  double before[3][corners], u[3][corners];
  this->stretched(0.01, before);
  this->turn(2.0, before, u);
  EXPECT_NEAR(this->energy(u), this->energy(before), 1e-12 * this->energy(before));
}

TYPED_TEST(Turning, forces_are_the_derivative_of_its_energy) {
  constexpr int corners = TypeParam::corners;
  double before[3][corners], u[3][corners], f[3][corners], largest = 0;
  this->stretched(0.05, before);
  this->turn(1.0, before, u);
  Keeper keeper;
  TypeParam::force(this->x, u, f, keeper);
  for (const auto& row : f)
    for (const double force : row) largest = std::max(largest, std::abs(force));
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < corners; ++k) {
      constexpr double step = 1e-6;
      const double at = u[i][k];
      u[i][k] = at + step;
      const double above = this->energy(u);
      u[i][k] = at - step;
      const double below = this->energy(u);
      u[i][k] = at;
      EXPECT_NEAR((above - below) / (2 * step), f[i][k], 1e-7 * largest);
    }
}

TYPED_TEST(Turning, small_movements_bear_the_force_of_small_strain) {
  constexpr int corners = TypeParam::corners;
  using Small =
      std::conditional_t<corners == 8, Hex8<double>, std::conditional_t<corners == 6, Wedge6<double>, Tet4<double>>>;
  double u[3][corners], f[3][corners], small[3][corners], largest = 0;
  this->stretched(1e-8, u);
  Keeper keeper, other;
  TypeParam::force(this->x, u, f, keeper);
  Small::force(this->x, u, small, other);
  for (const auto& row : small)
    for (const double force : row) largest = std::max(largest, std::abs(force));
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < corners; ++k) EXPECT_NEAR(f[i][k], small[i][k], 1e-6 * largest);
}

}  // namespace
}  // namespace ashlar
