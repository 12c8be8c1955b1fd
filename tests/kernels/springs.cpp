#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernels/spring_advance.hpp"
#include "kernels/spring_break.hpp"
#include "kernels/spring_force.hpp"

namespace ashlar {
namespace {

/// Contact points between nodes, each with its own normal, run on the host.
struct Springs {
  std::vector<int> node_a, node_b, interface, node, node_first, node_contact;
  std::vector<double> normal, area, normal_stiffness, shear_stiffness, slip, force;
  std::vector<ContactState> state;
  std::vector<SpringLaw<double>> laws;

  void add(int a, int b, Vec3<double> n, double area_of_it, double k_n, double k_s) {
    node_a.push_back(a), node_b.push_back(b), interface.push_back(0);
    for (int i = 0; i < 3; ++i) normal.push_back(n[i]), slip.push_back(0), force.push_back(0);
    area.push_back(area_of_it), normal_stiffness.push_back(k_n), shear_stiffness.push_back(k_s);
    state.push_back(ContactState::intact);
  }
  void link(int nodes) {
    node_first = {0};
    for (int n = 0; n < nodes; ++n) {
      for (int c = 0; c < static_cast<int>(node_a.size()); ++c) {
        if (node_a[c] == n) node_contact.push_back(c);
        if (node_b[c] == n) node_contact.push_back(-1 - c);
      }
      if (static_cast<int>(node_contact.size()) == node_first.back()) continue;
      node.push_back(n);
      node_first.push_back(static_cast<int>(node_contact.size()));
    }
  }
  SpringView<double> view() {
    SpringView<double> v;
    v.contact_count = static_cast<int>(node_a.size()), v.node_count = static_cast<int>(node.size());
    v.node_a = node_a.data(), v.node_b = node_b.data(), v.normal = normal.data(), v.area = area.data();
    v.normal_stiffness = normal_stiffness.data(), v.shear_stiffness = shear_stiffness.data();
    v.interface = interface.data(), v.laws = laws.data(), v.state = state.data(), v.slip = slip.data();
    v.force = force.data(), v.node = node.data(), v.node_first = node_first.data();
    v.node_contact = node_contact.data();
    return v;
  }
  /// Internal force of the springs at displacement u.
  std::vector<double> pull(std::vector<double> u) {
    std::vector<double> f(u.size(), 0.0);
    const auto springs = view();
    for (int c = 0; c < springs.contact_count; ++c) SpringForce<double>{springs, {u.data()}}(c);
    for (int i = 0; i < springs.node_count; ++i) GatherSpring<double>{springs, f.data()}(i);
    return f;
  }
  double largest_utilisation(std::vector<double> u) {
    double most = 0;
    for (int c = 0; c < static_cast<int>(state.size()); ++c)
      most = std::max(most, SpringUtilisation<double>{view(), {u.data()}}.of(c).largest());
    return most;
  }
  void break_springs(std::vector<double> u, double threshold) {
    double lost[3];
    for (int c = 0; c < static_cast<int>(state.size()); ++c) BreakSprings<double>{{view(), {u.data()}}, threshold}(c, lost);
  }
};

constexpr double degree = 3.14159265358979323846 / 180;
const SpringLaw<double> elastic{.bonded = true};
const SpringLaw<double> brittle{1e6, 1.5e6, std::tan(40 * degree), true, true};

// P33: n blocks of height h on a base, nu = 0, springs between them and under them.
// Settlement of the top: sum_i [(n-i) w / k_n + ((n-i-1) w + w/2) h / E], per unit area.
TEST(springs, P33_a_stack_settles_by_its_blocks_and_by_its_contacts) {
  const int n = 6;
  const double height = 2, young = 20e9, weight = 2400 * 9.81 * height, k_n = 1e11;
  Springs springs;
  springs.laws = {elastic};
  // Block i has nodes 2i (bottom) and 2i+1 (top); node 2n is the base. One contact point of 1 m^2 under every block.
  for (int i = 0; i < n; ++i) springs.add(i == 0 ? 2 * n : 2 * i - 1, 2 * i, {0, 0, 1}, 1, k_n, k_n);
  springs.link(2 * n + 1);

  std::vector<double> u(3 * (2 * n + 1), 0.0), v(u.size(), 0.0);
  for (int step = 0; step < 20000; ++step) {
    auto f = springs.pull(u);
    for (int i = 0; i < n; ++i) {
      const double column = young / height * (u[6 * i + 5] - u[6 * i + 2]);
      f[6 * i + 2] -= column, f[6 * i + 5] += column;
    }
    for (int node = 0; node < 2 * n; ++node) {
      const int z = 3 * node + 2;
      const double mass = 1.05 / 4 * (2 * k_n + 2 * young / height);
      v[z] = 0.97 * v[z] + (-weight / 2 - f[z]) / mass;
      u[z] += v[z];
    }
  }
  double settlement = 0;
  for (int i = 0; i < n; ++i)
    settlement += (n - i) * weight / k_n + ((n - i - 1) * weight + weight / 2) * height / young;
  EXPECT_NEAR(-u[3 * (2 * n - 1) + 2], settlement, 1e-9 * settlement);
}

TEST(springs, forces_on_the_two_sides_cancel) {
  Springs springs;
  springs.laws = {brittle};
  springs.add(0, 1, {0.6, 0, 0.8}, 0.3, 1e11, 4e10);
  springs.add(1, 2, {0, 1, 0}, 0.7, 2e11, 1e11);
  springs.add(2, 0, {0, 0, 1}, 0.2, 3e11, 1e11);
  springs.link(3);
  const auto f = springs.pull({1e-6, 2e-6, -3e-6, 4e-6, 0, 1e-6, -2e-6, 5e-6, 2e-6});
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(f[k] + f[3 + k] + f[6 + k], 0, 1e-9);
}

TEST(springs, a_rigid_translation_costs_nothing) {
  Springs springs;
  springs.laws = {elastic};
  springs.add(0, 1, {0.6, 0, 0.8}, 0.3, 1e11, 4e10);
  springs.link(2);
  for (const double f : springs.pull({1e-3, 2e-3, 3e-3, 1e-3, 2e-3, 3e-3})) EXPECT_EQ(f, 0);
}

TEST(springs, a_motion_books_the_fracture_energy_of_what_softens_and_water_follows_it) {
  Springs springs;
  springs.laws = {{.tensile_strength = 2e6, .cohesion = 3e6, .bonded = true, .fracture_energy = 100}};
  springs.add(0, 1, {0, 0, 1}, 0.25, 1e12, 1e12);
  springs.link(2);
  std::vector<double> damage(1), water{5e4}, dissipation(3), u(6), v{0, 0, 0, 0, 0, 1e-3};
  auto view = springs.view();
  view.damage = damage.data(), view.water = water.data();
  for (int step = 0; step <= 120; ++step) {
    u[5] = step * 1e-6;
    SpringForce<double>{view, {u.data()}}(0);
    const double line = step <= 2 ? step * 1e6 : step < 100 ? 2e6 * (100 - step) / 98 : 0;
    AdvanceSprings<double>{view,          {u.data()},        v.data(), step > 0 ? 1e-3 : 0, springs.slip.data(),
                           damage.data(), dissipation.data()}(0);
    EXPECT_NEAR(springs.force[2], 0.25 * (line - damage[0] * 5e4), 1e-3);
  }
  EXPECT_EQ(springs.state[0], ContactState::cracked_in_tension);
  EXPECT_NEAR(dissipation[0], 25, 1e-9);
  EXPECT_EQ(dissipation[1] + dissipation[2], 0);
}

TEST(springs, P36_direct_shear_of_a_face_of_four_contacts) {
  Springs springs;
  springs.laws = {{0.5e6, 1e6, std::tan(40 * degree), true, true}};
  for (int c = 0; c < 4; ++c) springs.add(2 * c, 2 * c + 1, {0, 0, 1}, 0.25, 1e11, 1e11);
  springs.link(8);
  std::vector<double> u(24, 0.0);
  double peak = 0, residual = 0;
  for (int step = 1; step <= 40000; ++step) {
    for (int c = 0; c < 4; ++c) u[6 * c + 3] = step * 1e-9, u[6 * c + 5] = -0.5e6 / 1e11;
    const auto f = springs.pull(u);
    residual = f[3] + f[9] + f[15] + f[21];
    peak = std::max(peak, residual);
    springs.break_springs(u, 1);
  }
  for (const auto state : springs.state) EXPECT_EQ(state, ContactState::cracked_in_shear);
  EXPECT_NEAR(peak, 1.41955e6, 1e-4 * peak);
  EXPECT_NEAR(residual, 0.41955e6, 1e-4 * residual);
}

TEST(springs, only_the_worst_group_breaks) {
  Springs springs;
  springs.laws = {brittle};
  for (int c = 0; c < 3; ++c) springs.add(2 * c, 2 * c + 1, {0, 0, 1}, 1, 1e11, 1e11);
  springs.link(6);
  std::vector<double> u(18, 0.0);
  u[5] = 1.0040e-5, u[11] = 1.0035e-5, u[17] = 1.0020e-5;  // T / k_n = 1e-5
  const double worst = springs.largest_utilisation(u);
  EXPECT_NEAR(worst, 1.004, 1e-12);
  springs.break_springs(u, 0.999 * worst);
  EXPECT_EQ(springs.state[0], ContactState::cracked_in_tension);
  EXPECT_EQ(springs.state[1], ContactState::cracked_in_tension);
  EXPECT_EQ(springs.state[2], ContactState::intact);
  EXPECT_NEAR(springs.largest_utilisation(u), 1.002, 1e-12);
}

TEST(springs, crossing_is_where_the_strength_is_used_up) {
  Springs springs;
  springs.laws = {brittle};
  springs.add(0, 1, {0, 0, 1}, 1, 1e11, 1e11);
  springs.link(2);
  const std::vector<std::vector<double>> before{
      {0, 0, 0, 1e-6, 2e-6, -4e-6}, {0, 0, 0, 0, 0, 0}, {0, 0, 0, -3e-6, 0, 2e-6}};
  const std::vector<std::vector<double>> after{{0, 0, 0, 3e-5, 2e-6, -5e-6},
                                               {0, 0, 0, 1e-6, 0, 4e-5},
                                               {0, 0, 0, 1e-5, 4e-5, -3e-6},
                                               {0, 0, 0, 2e-5, -3e-5, 6e-6},
                                               {0, 0, 0, 0, 1e-4, -1e-4}};
  for (auto from : before)
    for (auto to : after) {
      const double fraction = SpringCrossing<double>{springs.view(), {from.data()}, {to.data()}}.fraction(0);
      ASSERT_LE(fraction, 1);
      std::vector<double> there(6);
      for (int i = 0; i < 6; ++i) there[i] = from[i] + fraction * (to[i] - from[i]);
      EXPECT_NEAR(springs.largest_utilisation(there), 1, 1e-12);
    }
}

TEST(springs, a_path_below_the_strength_has_no_crossing) {
  Springs springs;
  springs.laws = {brittle};
  springs.add(0, 1, {0, 0, 1}, 1, 1e11, 1e11);
  springs.link(2);
  std::vector<double> from{0, 0, 0, 1e-6, 0, 0};
  for (auto to :
       {std::vector<double>{0, 0, 0, 2e-6, 0, -1e-3}, {0, 0, 0, 1e-5, 0, -1e-5}, {0, 0, 0, 0, 0, 9e-6}}) {
    EXPECT_GT((SpringCrossing<double>{springs.view(), {from.data()}, {to.data()}}.fraction(0)), 1);
  }
}

}  // namespace
}  // namespace ashlar
