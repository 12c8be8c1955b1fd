#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "physics/interface_laws/interface_laws.hpp"

namespace ashlar {
namespace {

using Vector = Vec3<double>;

constexpr double degree = 3.14159265358979323846 / 180;
const Where here{"dam.lua", 7};

/// One contact point of 1 m^2 with normal z whose bond softens, driven by hand; keeps what every step leaves.
struct Bond {
  SpringLaw<double> law;
  SpringStiffness<double> stiffness;
  double damage = 0, work = 0;
  Vector gap{}, slip{}, traction{};
  ContactState state = ContactState::intact;
  Dissipation<double> lost{};

  SofteningAnswer<double> answer(const Vector& to) const {
    return softening_traction(law, stiffness, split(to, Vector{0, 0, 1}), slip, damage, state);
  }
  /// Energy held at a gap if damage and slip stay as they are, J.
  double held(const Vector& at) const {
    const double shear = 0.5 * stiffness.shear * (at.x * at.x + at.y * at.y),
                 normal = 0.5 * stiffness.normal * at.z * at.z;
    if (at.z > 0) return (1 - damage) * (normal + shear);
    const double x = at.x - slip.x, y = at.y - slip.y;
    return normal + (1 - damage) * shear + damage * 0.5 * stiffness.shear * (x * x + y * y);
  }
  /// One straight step; returns what it took out, J.
  double step_to(const Vector& to) {
    const auto now = answer(to);
    const double before = held(to);
    const Vector pull = joined(now.traction, Vector{0, 0, 1});
    work += 0.5 * dot(pull + traction, to - gap);
    damage = now.damage;
    slip = now.slip;
    state = now.state;
    lost = lost + now.lost;
    gap = to;
    traction = pull;
    return before - held(to);
  }
  void go_to(const Vector& to, int steps) {
    const Vector from = gap;
    for (int i = 1; i <= steps; ++i) step_to(from + (double(i) / steps) * (to - from));
  }
};

/// T = 2 MPa, c = 3 MPa, G_I = 100 J/m^2, G_II = 300 J/m^2, k_n = 1e12 Pa/m: R = 50, full separation at 0.1 mm.
constexpr double strength = 2e6, cohesion = 3e6, energy = 100, shear_energy = 300, k_n = 1e12;
InterfaceConstants constants(double friction = 0) {
  return interface_constants("softening",
                             {{"tensile_strength", strength},
                              {"cohesion", cohesion},
                              {"friction", friction},
                              {"fracture_energy", energy},
                              {"shear_fracture_energy", shear_energy},
                              {"normal_stiffness", k_n}},
                             here, "joint 'base'");
}
Bond bond(double friction = 0) {
  const InterfaceConstants c = constants(friction);
  return {c.law, {k_n, c.stiffness_ratio * k_n}};
}

TEST(softening, opens_along_a_straight_line_from_its_strength_to_nothing) {
  Bond b = bond();
  const double first = strength / k_n, last = 2 * energy / strength;
  for (double w = first / 10; w < 1.2 * last; w += first / 10) {
    b.step_to({0, 0, w});
    const double line = w <= first ? k_n * w : w < last ? strength * (last - w) / (last - first) : 0;
    EXPECT_NEAR(b.traction.z, line, 1e-9 * strength) << w;
  }
  EXPECT_EQ(b.state, ContactState::cracked_in_tension);
  EXPECT_NEAR(b.work, energy, 1e-3 * energy);
  EXPECT_NEAR(b.lost.opening, energy, 1e-9 * energy);
  EXPECT_EQ(b.lost.shear, 0);
}

TEST(softening, shears_along_a_straight_line_and_takes_its_own_energy) {
  Bond b = bond();
  const double last = 2 * shear_energy / cohesion;
  b.go_to({0.6 * 1.1 * last, -0.8 * 1.1 * last, 0}, 10000);
  EXPECT_EQ(b.state, ContactState::cracked_in_shear);
  EXPECT_NEAR(b.work, shear_energy, 1e-3 * shear_energy);
  EXPECT_NEAR(b.lost.shear, shear_energy, 1e-9 * shear_energy);
  b = bond();
  b.go_to({0, last / 2, 0}, 1000);
  EXPECT_NEAR(norm(b.traction), cohesion * (last / 2) / (last - cohesion / b.stiffness.shear), 1e-6 * cohesion);
}

TEST(softening, every_mixture_takes_its_share_of_both_energies) {
  for (const double angle : {5.0, 30.0, 45.0, 70.0, 85.0}) {
    Bond b = bond();
    const double a = angle * degree;
    b.go_to({3e-4 * std::sin(a), 0, 3e-4 * std::cos(a)}, 20000);
    ASSERT_EQ(b.damage, 1);
    EXPECT_NEAR(b.lost.opening / energy + b.lost.shear / shear_energy, 1, 1e-9) << angle;
    EXPECT_NEAR(b.work, b.lost.sum(), 1e-3 * energy) << angle;
  }
}

TEST(softening, begins_on_the_ellipse_of_both_strengths) {
  for (const double angle : {10.0, 45.0, 80.0}) {
    const double t = strength * std::cos(angle * degree), s = cohesion * std::sin(angle * degree);
    for (const double part : {1 - 1e-9, 1 + 1e-9}) {
      Bond b = bond();
      b.step_to(part * Vector{s / b.stiffness.shear, 0, t / b.stiffness.normal});
      EXPECT_EQ(b.state, part < 1 ? ContactState::intact : ContactState::softening) << angle;
    }
  }
}

TEST(softening, unloading_goes_to_the_origin_and_creates_nothing) {
  Bond b = bond();
  b.go_to({0, 0, 4e-5}, 1000);
  const double pull = b.traction.z, spent = b.work;
  b.go_to({0, 0, 2e-5}, 100);
  EXPECT_NEAR(b.traction.z, pull / 2, 1e-9 * strength);
  b.go_to({0, 0, 0}, 100);
  EXPECT_NEAR(spent - b.work, 0.5 * pull * 4e-5, 1e-9 * energy);
  EXPECT_NEAR(b.work, b.lost.sum(), 1e-3 * energy);
  b.go_to({0, 0, -3e-6}, 10);
  EXPECT_NEAR(b.traction.z, -3e-6 * k_n, 1e-6);  // closed, with its full stiffness
  b.go_to({0, 0, 2e-4}, 5000);
  EXPECT_NEAR(b.work, energy, 2e-3 * energy);
}

// P36 with softening: c = 3 MPa, phi = 40 deg, 1 MPa of pressure: peak c + p tan(phi), residual p tan(phi).
TEST(softening, shears_under_pressure_by_mohr_coulomb_and_then_rubs) {
  Bond b = bond(40 * degree);
  b.step_to({0, 0, -1e6 / k_n});
  double peak = 0;
  for (int i = 1; i <= 40000; ++i) {
    b.step_to({i * 1e-8, 0, -1e6 / k_n});
    peak = std::max(peak, b.traction.x);
  }
  const double friction = 1e6 * std::tan(40 * degree);
  EXPECT_NEAR(peak, cohesion + friction, 1e-2 * peak);
  EXPECT_NEAR(b.traction.x, friction, 1e-6 * friction);
  EXPECT_NEAR(b.lost.shear, shear_energy, 1e-2 * shear_energy);
}

TEST(softening, one_long_step_ends_where_many_short_ones_do) {
  for (const double pressure : {0.0, 1e6}) {
    Bond one = bond(40 * degree), many = one;
    for (Bond* b : {&one, &many}) b->step_to({0, 0, -pressure / k_n});
    one.step_to({3e-4, 0, -pressure / k_n});
    many.go_to({3e-4, 0, -pressure / k_n}, 1000);
    EXPECT_NEAR(one.traction.x, many.traction.x, 1e-6 * cohesion);
  }
}

TEST(softening, random_paths_never_create_energy_nor_take_more_than_the_bond_has) {
  std::mt19937_64 random(7);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  double least = 0, most_lost = 0, most_off = 0;
  for (int path = 0; path < 100000; ++path) {
    Bond b = bond(path % 2 ? 35 * degree : 0);
    double reach = 4e-6;
    for (int leg = 0; leg < 6; ++leg, reach *= 2.2) {
      const Vector to{reach * (2 * uniform() - 1), reach * (2 * uniform() - 1), reach * (1.6 * uniform() - 0.6)};
      const Vector from = b.gap;
      for (int i = 1; i <= 12; ++i) least = std::min(least, b.step_to(from + (i / 12.0) * (to - from)));
    }
    most_lost = std::max(most_lost, b.lost.opening / energy + b.lost.shear / shear_energy);
    if (path % 100 == 0) {  // the same against work, in steps so fine that its sum is right
      Bond fine = bond();
      reach = 4e-6;
      for (int leg = 0; leg < 6; ++leg, reach *= 2.2)
        fine.go_to({reach * (2 * uniform() - 1), reach * (2 * uniform() - 1), reach * (1.6 * uniform() - 0.6)}, 4000);
      most_off = std::max(most_off, std::abs(fine.work - fine.held(fine.gap) - fine.lost.sum()));
    }
  }
  EXPECT_GE(least, -1e-12 * energy);
  EXPECT_LE(most_lost, 1 + 1e-12);
  EXPECT_GT(most_lost, 0.9);
  EXPECT_LT(most_off, 1e-3 * energy);
}

std::string refusal(std::map<std::string, double> values) {
  std::map<std::string, double> all{{"tensile_strength", 2e6}, {"cohesion", 3e6}, {"fracture_energy", 100}};
  for (const auto& [key, value] : values) all[key] = value;
  try {
    interface_constants("softening", all, here, "joint 'base'");
  } catch (const DeckError& error) {
    return error.what();
  }
  return "";
}

TEST(softening, springs_that_hold_more_energy_than_cracking_takes_are_refused) {
  EXPECT_EQ(refusal({{"normal_stiffness", 2.1e10}}), "");
  EXPECT_EQ(
      refusal({{"normal_stiffness", 1e10}}),
      "dam.lua:7: joint 'base': fracture_energy = 100 J/m^2 is less than the 200 J/m^2 that a spring of 1e+10 Pa/m "
      "holds at its tensile strength of 2e+06 Pa: it would snap back; give normal_stiffness above 2e+10 Pa/m (or a "
      "larger stiffness_factor), or more fracture_energy");
}

TEST(softening, shear_energy_and_shear_stiffness_are_one_choice) {
  EXPECT_NE(refusal({{"shear_fracture_energy", 300}, {"shear_stiffness", 1e12}}).find("leave one out"),
            std::string::npos);
  EXPECT_NEAR(constants().stiffness_ratio, 2.25 / 3, 1e-12);
}

}  // namespace
}  // namespace ashlar
