#include "physics/interface_laws/interface_laws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace ashlar {
namespace {

using Vector = Vec3<double>;

constexpr double degree = 3.14159265358979323846 / 180;
const Where here{"dam.lua", 7};

/// One contact point between two sides, driven by hand.
struct Contact {
  SpringLaw<double> law;
  SpringStiffness<double> stiffness{1e11, 4e10};
  Vector normal{0, 0, 1};
  ContactState state = ContactState::intact;
  Vector slip{};

  Vector pull(const Vector& gap) {
    const auto answer = spring_traction(law.holds(state), law.tan_friction, stiffness, split(gap, normal), slip);
    slip = answer.slip;
    return joined(answer.traction, normal);
  }
  /// The test of a converged state: cracks where the strength is used up.
  void test_strength(const Vector& traction) {
    if (!law.can_break(state)) return;
    const auto used = utilisation(law, split(traction, normal));
    if (used.largest() >= 1) state = used.mode();
  }
};

Contact contact(const std::string& name, std::map<std::string, double> values) {
  return {interface_constants(name, values, here, "joint 'base'").law};
}
Contact brittle() {
  return contact("brittle", {{"tensile_strength", 1e6}, {"cohesion", 1.5e6}, {"friction", 40 * degree}});
}
Contact frictional() { return contact("frictional", {{"friction", 35 * degree}}); }

double shear_of(const Vector& traction) { return std::hypot(traction.x, traction.y); }

TEST(interface_laws, every_law_documents_every_key) {
  const auto docs = interface_law_docs();
  ASSERT_EQ(docs.size(), 4u);
  for (const auto& law : docs) {
    EXPECT_FALSE(law.doc.empty());
    for (const auto& key : law.keys) {
      EXPECT_FALSE(key.doc.empty()) << law.name << "." << key.name;
      if (key.fallback && given(*key.fallback)) {
        EXPECT_TRUE(key.range.contains(*key.fallback)) << law.name << "." << key.name;
      }
    }
  }
}

TEST(interface_laws, stiffness_comes_from_the_deck_or_from_the_factor) {
  const auto given = interface_constants("elastic", {{"normal_stiffness", 1e10}}, here, "joint 'base'");
  EXPECT_EQ(given.stiffness.normal_stiffness, 1e10);
  EXPECT_EQ(given.stiffness.shear_stiffness, 0);
  EXPECT_EQ(given.stiffness.stiffness_factor, 100);
}

TEST(interface_laws, a_tensile_strength_beyond_the_tip_of_the_shear_line_is_refused) {
  try {
    contact("brittle", {{"tensile_strength", 2e6}, {"cohesion", 1e6}, {"friction", 45 * degree}});
    FAIL();
  } catch (const DeckError& error) {
    EXPECT_STREQ(
        error.what(),
        "dam.lua:7: joint 'base': tensile_strength = 2e+06 Pa is above cohesion / tan(friction) = 1e+06 Pa, where "
        "shear strength ends: lower tensile_strength, or raise cohesion to at least 2e+06 Pa");
  }
}

TEST(interface_laws, an_unknown_law_names_the_valid_ones) {
  try {
    contact("britle", {});
    FAIL();
  } catch (const DeckError& error) {
    EXPECT_STREQ(error.what(),
                 "dam.lua:7: joint 'base': no interface law 'britle'; there are: elastic, brittle, frictional, "
                 "softening");
  }
}

TEST(interface_laws, intact_springs_are_linear_and_isotropic_in_their_plane) {
  for (auto spring : {contact("elastic", {}), brittle()}) {
    const Vector t = spring.pull({2e-6, -3e-6, 5e-6});
    EXPECT_DOUBLE_EQ(t.x, 8e4);
    EXPECT_DOUBLE_EQ(t.y, -1.2e5);
    EXPECT_DOUBLE_EQ(t.z, 5e5);
    EXPECT_EQ(norm(spring.slip), 0);
  }
}

TEST(interface_laws, actions_do_not_depend_on_which_side_is_called_a) {
  const Vector n{0.6, 0, 0.8};
  for (const Vector gap : {Vector{1e-6, 2e-6, -9e-6}, Vector{5e-6, 1e-6, 4e-6}, Vector{-3e-6, 8e-6, -5e-6}})
    for (auto spring : {contact("elastic", {}), brittle(), frictional()}) {
      auto other = spring;
      spring.normal = n;
      other.normal = -1.0 * n;
      const Vector there = spring.pull(gap), back = other.pull(-1.0 * gap);
      for (int i = 0; i < 3; ++i) EXPECT_EQ(there[i], -back[i]);
    }
}

TEST(interface_laws, a_bond_cracks_in_tension_exactly_at_its_tensile_strength) {
  auto spring = brittle();
  spring.test_strength(spring.pull({0, 0, 1e-5 * (1 - 1e-12)}));
  EXPECT_EQ(spring.state, ContactState::intact);
  spring.test_strength(spring.pull({0, 0, 1e-5 * (1 + 1e-12)}));
  EXPECT_EQ(spring.state, ContactState::cracked_in_tension);
}

TEST(interface_laws, an_elastic_interface_never_cracks) {
  auto spring = contact("elastic", {});
  spring.test_strength(spring.pull({1, 1, 1}));
  EXPECT_EQ(spring.state, ContactState::intact);
  EXPECT_NEAR(spring.pull({0, 0, 1}).z, 1e11, 1);
}

// P36: direct shear, A = 1 m^2, c = 1 MPa, phi = 40 deg, N = 0.5 MN: peak cA + N tan(phi) = 1.41955 MN, residual
// 0.41955 MN.
TEST(interface_laws, P36_direct_shear_peak_and_residual) {
  auto spring = contact("brittle", {{"tensile_strength", 0.5e6}, {"cohesion", 1e6}, {"friction", 40 * degree}});
  const double closure = -0.5e6 / spring.stiffness.normal;
  double peak = 0, residual = 0;
  for (int step = 1; step <= 200000; ++step) {
    const Vector t = spring.pull({step * 1e-9, 0, closure});
    peak = std::max(peak, shear_of(t));
    residual = shear_of(t);
    spring.test_strength(t);
  }
  EXPECT_EQ(spring.state, ContactState::cracked_in_shear);
  EXPECT_NEAR(peak, 1.41955e6, 1e-4 * peak);
  EXPECT_NEAR(residual, 0.41955e6, 1e-4 * residual);
}

TEST(interface_laws, a_cracked_contact_carries_no_tension_and_stays_inside_the_friction_cone) {
  auto spring = frictional();
  for (int step = 0; step < 1000; ++step) {
    const Vector gap{1e-5 * std::sin(0.11 * step), 1e-5 * std::cos(0.37 * step), 1e-5 * std::sin(0.23 * step)};
    const Vector t = spring.pull(gap);
    EXPECT_LE(t.z, 0);
    EXPECT_LE(shear_of(t), -t.z * spring.law.tan_friction * (1 + 1e-12) + 1e-6);
    if (gap.z > 0) {
      EXPECT_EQ(norm(t), 0);
    }
  }
}

TEST(interface_laws, a_crack_closes_again_with_its_full_stiffness_and_without_shear_memory) {
  auto spring = brittle();
  spring.test_strength(spring.pull({0, 0, 2e-5}));
  ASSERT_EQ(spring.state, ContactState::cracked_in_tension);
  EXPECT_EQ(norm(spring.pull({3e-5, 0, 2e-5})), 0);
  const Vector closed = spring.pull({3e-5, 0, -1e-5});
  EXPECT_DOUBLE_EQ(closed.z, -1e6);
  EXPECT_NEAR(shear_of(closed), 0, 1e-6);
}

TEST(interface_laws, sliding_is_opposed_along_its_direction) {
  auto spring = frictional();
  const Vector t = spring.pull({3e-3, 4e-3, -1e-5});
  const double limit = 1e6 * spring.law.tan_friction;
  EXPECT_NEAR(t.x, 0.6 * limit, 1e-9 * limit);
  EXPECT_NEAR(t.y, 0.8 * limit, 1e-9 * limit);
  EXPECT_NEAR(spring.slip.y / spring.slip.x, 4.0 / 3, 1e-12);
}

/// Work done on a contact over one closed loop of its gap, J/m^2, trapezoid rule.
double work_of_loop(Contact spring, const std::function<Vector(double)>& gap, int steps) {
  double work = 0;
  for (int warm_up = 0; warm_up < 2; ++warm_up) {  // the second loop starts and ends in the same state
    work = 0;
    Vector before = gap(0), pulled = spring.pull(before);
    for (int step = 1; step <= steps; ++step) {
      const Vector now = gap(double(step) / steps), t = spring.pull(now);
      work += 0.5 * dot(pulled + t, now - before);
      before = now;
      pulled = t;
    }
  }
  return work;
}

TEST(interface_laws, closed_loops_never_create_energy_and_elastic_ones_lose_none) {
  const double turn = 360 * degree;
  const std::vector<std::function<Vector(double)>> loops{
      [&](double s) {
        return Vector{2e-5 * std::cos(turn * s), 2e-5 * std::sin(turn * s), -1e-5};
      },
      [&](double s) {
        return Vector{2e-5 * std::sin(turn * s), 0, -1e-5 + 0.5e-5 * std::cos(turn * s)};
      },
      [&](double s) {
        return Vector{0, 0, 1e-5 * std::sin(turn * s)};
      },
  };
  const double size = 1e11 * 1e-5 * 1e-5;  // energy that the springs hold at these gaps
  for (const auto& loop : loops) {
    EXPECT_NEAR(work_of_loop(contact("elastic", {}), loop, 20000), 0, 1e-6 * size);
    EXPECT_GE(work_of_loop(frictional(), loop, 20000), -1e-6 * size);
  }
  EXPECT_GT(work_of_loop(frictional(), loops[0], 20000), size);
  EXPECT_NEAR(work_of_loop(frictional(), loops[2], 20000), 0, 1e-6 * size);
}

TEST(interface_laws, slow_circular_sliding_dissipates_friction_times_path) {
  auto spring = frictional();
  const double radius = 1e-2, closure = -1e-5, turn = 360 * degree;
  const double work = work_of_loop(
      spring,
      [&](double s) {
        return Vector{radius * std::cos(turn * s), radius * std::sin(turn * s), closure};
      },
      100000);
  EXPECT_NEAR(work, 1e6 * spring.law.tan_friction * turn * radius, 1e-4 * work);
}

}  // namespace
}  // namespace ashlar
