#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "backend/pack.hpp"
#include "physics/laws/laws.hpp"

namespace ashlar {
namespace {

using Strain = Sym3<double>;
using Stress = Sym3<double>;
using Vector = Vec3<double>;

constexpr double degree = 3.14159265358979323846 / 180;
constexpr double young = 30e9, poisson = 0.2, tensile = 2.5e6, energy = 100;

Breakage concrete() {
  Breakage law;
  law.young = young;
  law.poisson = poisson;
  law.tensile_strength = tensile;
  law.fracture_energy = energy;
  law.cohesion = 4e6;
  law.friction = 35 * degree;
  return law;
}
Damage crumbling() {
  Damage law;
  law.young = young;
  law.poisson = poisson;
  law.tensile_strength = tensile;
  law.fracture_energy = energy;
  return law;
}
Jointed slate(double dip) {
  Jointed law;
  law.young = young;
  law.poisson = poisson;
  law.dip = dip;
  law.cohesion = 2e6;
  law.friction = 25 * degree;
  return law;
}

/// One point of an element that is `size` across in every direction.
template <class Point>
struct Specimen {
  Point law;
  double size = 0;
  typename Point::template History<double> history{};
  Strain strain{};
  Stress stress{};

  Stress answer(const Strain& e, typename Point::template History<double>& h) const {
    if constexpr (Point::sized)
      return law.stress(e, h, [&](int, const Vector&) { return size; });
    else
      return law.stress(e, h);
  }
  void go_to(const Strain& e) {
    strain = e;
    stress = answer(e, history);
  }
  /// zz of the strain given, lateral strains so that lateral stress is `lateral`.
  void stretch_to(double zz, double lateral = 0) {
    Strain e = strain;
    e.zz = zz;
    for (int i = 0; i < 400; ++i) {
      auto h = history;
      const Stress s = answer(e, h);
      if (std::abs(s.xx - lateral) + std::abs(s.yy - lateral) < 1e-3) break;
      e.xx -= 0.7 * (s.xx - lateral) / young;
      e.yy -= 0.7 * (s.yy - lateral) / young;
    }
    go_to(e);
  }
};
template <class Law>
auto specimen(const Law& law, double size) {
  const auto point = law.template prepare<double>();
  return Specimen<std::decay_t<decltype(point)>>{point, size};
}

/// Work done on the point of a bar that is pulled until nothing holds, times its length: J/m^2.
template <class Law>
double energy_of_a_crack(const Law& law, double size) {
  auto s = specimen(law, size);
  const double end = 2.2 * energy / (tensile * size);
  double work = 0;
  constexpr int steps = 2000;
  for (int i = 1; i <= steps; ++i) {
    const double before = s.stress.zz;
    s.stretch_to(end * i / steps);
    work += 0.5 * (before + s.stress.zz) * end / steps;
  }
  EXPECT_LT(s.stress.zz, 1e-3 * tensile);
  EXPECT_NEAR(s.history[7] * size, work * size, 2e-3 * energy);  // what it says it released
  return work * size;
}

TEST(breakage, a_crack_takes_the_fracture_energy_whatever_the_size) {
  for (const double size : {0.05, 0.2, 0.6}) EXPECT_NEAR(energy_of_a_crack(concrete(), size), energy, 3e-3 * energy);
}

TEST(breakage, a_point_that_is_held_does_not_open_but_slides) {
  auto s = specimen(concrete(), 0.2);
  s.history.length = CrackPoint<double>::held;
  s.stretch_to(1.5 * tensile / young);
  EXPECT_NEAR(s.stress.zz, 1.5 * tensile, 1e-3 * tensile);
  EXPECT_EQ(s.history.damage, 0);
  s.stretch_to(-20e6 / young);  // more than 2 c cos(phi) / (1 - sin(phi)) = 15.4 MPa
  EXPECT_GT(s.history.damage, 0);
  EXPECT_GT(s.history.length, 0);
}

TEST(damage, a_crack_takes_the_fracture_energy_whatever_the_size) {
  for (const double size : {0.05, 0.2, 0.6}) EXPECT_NEAR(energy_of_a_crack(crumbling(), size), energy, 3e-3 * energy);
}

TEST(breakage, closes_with_full_stiffness_and_opens_again_on_the_secant) {
  auto s = specimen(concrete(), 0.2);
  const double first = tensile / young, open = 4 * first;
  for (int i = 1; i <= 100; ++i) s.stretch_to(open * i / 100);
  const double left = s.stress.zz;
  EXPECT_GT(left, 0.1 * tensile);
  EXPECT_LT(left, 0.9 * tensile);
  s.stretch_to(open / 2);
  EXPECT_NEAR(s.stress.zz, left / 2, 1e-3 * tensile);  // secant
  s.stretch_to(-open);
  EXPECT_NEAR(s.stress.zz, -young * open, 1e-6 * young * open);  // as if it had never cracked
  s.stretch_to(open);
  EXPECT_NEAR(s.stress.zz, left, 1e-3 * tensile);
}

TEST(breakage, reaches_tensile_strength_in_any_direction_and_marks_the_plane) {
  const Vector n = (1 / std::sqrt(14.0)) * Vector{1, 2, 3};
  auto s = specimen(concrete(), 0.2);
  double most = 0;
  for (int i = 1; i <= 400; ++i) {
    const double e = 1e-6 * i;
    s.go_to({e * n.x * n.x, e * n.y * n.y, e * n.z * n.z, 2 * e * n.x * n.y, 2 * e * n.y * n.z, 2 * e * n.z * n.x});
    most = std::max(most, dot(traction(s.stress, n), n));
  }
  EXPECT_NEAR(most, tensile, 0.02 * tensile);
  EXPECT_NEAR(std::abs(dot(s.history.normal, n)), 1, 1e-9);
}

/// Strain of an opening across n.
Strain opened(double e, const Vector& n) {
  return {e * n.x * n.x, e * n.y * n.y, e * n.z * n.z, 2 * e * n.x * n.y, 2 * e * n.y * n.z, 2 * e * n.z * n.x};
}

TEST(breakage, an_opening_plane_turns_with_the_tension_until_half_of_its_strength_is_lost) {
  const double size = 0.05, end = 2 * energy / (tensile * size);  // strain at which nothing holds
  const auto at = [](double angle) { return Vector{std::sin(angle * degree), 0, std::cos(angle * degree)}; };
  auto s = specimen(concrete(), size);
  double angle = 0;
  for (int i = 1; i <= 200; ++i) {  // it turns by 25 degrees while it opens to four tenths
    angle = 25 * std::min(1.0, i / 180.0);
    s.go_to(opened(0.4 * end * i / 200, at(angle)));
    ASSERT_LE(principal(s.stress).value[0], tensile * (1 + 1e-9)) << i;
  }
  EXPECT_NEAR(std::abs(dot(s.history.normal, at(angle))), 1, 1e-9);
  for (int i = 1; i <= 200; ++i) s.go_to(opened(end * (0.4 + 0.7 * i / 200), at(angle)));
  EXPECT_NEAR(s.history.dissipation * size, energy, 0.01 * energy);  // that of one crack
  s.go_to(opened(end, at(60)));
  EXPECT_NEAR(std::abs(dot(s.history.normal, at(angle))), 1, 1e-9);  // as it stays
}

TEST(breakage, work_of_a_turning_crack_is_what_it_releases) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  Breakage law = concrete();
  law.cohesion = 100e6;
  for (int loop = 0; loop < 30; ++loop) {
    auto s = specimen(law, 0.2);
    double work = 0;
    Strain from{};
    for (int leg = 0; leg < 6; ++leg) {
      Strain to{};
      if (leg < 5)
        for (int c = 0; c < 6; ++c) to[c] = 1e-4 * normal(random);
      for (int i = 1; i <= 4000; ++i) {
        const Stress before = s.stress;
        Strain e;
        for (int c = 0; c < 6; ++c) e[c] = from[c] + (to[c] - from[c]) * i / 4000;
        s.go_to(e);
        for (int c = 0; c < 6; ++c) work += 0.5 * (before[c] + s.stress[c]) * (to[c] - from[c]) / 4000;
      }
      from = to;
    }
    ASSERT_NEAR(work, s.history.dissipation, 0.01 * work + 1e-3 * tensile * tensile / young) << loop;
  }
}

TEST(breakage, compression_cracks_on_the_plane_of_mohr_coulomb) {
  const double phi = 35 * degree, c = 4e6, first = 2 * c * std::cos(phi) / (1 - std::sin(phi));
  const auto law = concrete().prepare<double>();
  const auto plane_of = [&](const Stress& stress) { return law.plane_of(stress, principal(stress), true, true).normal; };
  const Vector n = plane_of({0, 0, -1.001 * first, 0, 0, 0});
  EXPECT_NEAR(std::abs(n.z), std::cos(45 * degree + phi / 2), 1e-12);
  EXPECT_NEAR(norm(n), 1, 1e-12);
  EXPECT_EQ(norm(plane_of({0, 0, -0.999 * first, 0, 0, 0})), 0);
}

TEST(breakage, a_plane_that_slid_keeps_coulomb_friction) {
  Breakage law = concrete();
  law.cohesion = 1e6;
  law.tensile_strength = 1e6;
  auto s = specimen(law, 0.1);
  const double pressure = 3e6, bulk3 = young / (1 - 2 * poisson), e = -pressure / bulk3;
  Strain strain{e, e, e, 0, 0, 0};
  while (!(s.history.damage > 0)) {
    s.go_to(strain);
    strain.zx += 1e-6;
  }
  // From there on along the plane, so that the pressure on it stays.
  const Vector n = s.history.normal;
  Vector t = traction(s.stress, n);
  const Vector side = t - dot(t, n) * n, along = (1 / norm(side)) * side;
  for (int i = 0; i < 4000; ++i) {
    for (int c = 0; c < 3; ++c) {
      const int d = (c + 1) % 3;
      strain[c] += 2e-6 * n[c] * along[c];
      strain[3 + c] += 2e-6 * (n[c] * along[d] + n[d] * along[c]);
    }
    s.go_to(strain);
  }
  ASSERT_EQ(s.history.damage, 1);
  t = traction(s.stress, n);
  const double normal = dot(t, n), shear = norm(t - normal * n);
  EXPECT_LT(normal, 0);
  EXPECT_NEAR(shear, -normal * std::tan(law.friction), 2e-3 * pressure);
}

/// Jaeger 1960: the stress difference at which rock slips on a plane whose normal is `beta` from the largest pressure.
TEST(jointed, triaxial_strength_follows_jaegers_curve) {
  const double c = 2e6, phi = 25 * degree, confining = 1e6;
  for (const double beta : {30.0, 35.0, 45.0, 57.5, 70.0, 80.0}) {
    auto s = specimen(slate(beta * degree), 0);
    const double bulk3 = young / (1 - 2 * poisson), e = -confining / bulk3;
    s.go_to({e, e, e, 0, 0, 0});
    const double expected = 2 * (c + confining * std::tan(phi)) /
                            ((1 - std::tan(phi) / std::tan(beta * degree)) * std::sin(2 * beta * degree));
    const double reach = 2 * expected / young;
    double most = 0;
    for (int i = 1; i <= 200; ++i) {
      // Lateral strains are free, shear strains are not: the plane slips in the y z plane. Shear stress is let go.
      Strain g = s.strain;
      g.zz = e - reach * i / 200;
      for (int k = 0; k < 2000; ++k) {
        auto h = s.history;
        const Stress t = s.answer(g, h);
        const double off = std::abs(t.xx + confining) + std::abs(t.yy + confining) + std::abs(t.yz);
        if (off < 1) break;
        g.xx -= 0.5 * (t.xx + confining) / young;
        g.yy -= 0.5 * (t.yy + confining) / young;
        g.yz -= 0.5 * t.yz / young;
      }
      s.go_to(g);
      most = std::max(most, -s.stress.zz - confining);
    }
    EXPECT_NEAR(most, expected, 0.01 * expected) << beta;
  }
}

TEST(jointed, joints_too_flat_or_too_steep_to_slip_leave_the_rock_elastic) {
  for (const double dip : {0.0, 20.0, 90.0}) {
    auto s = specimen(slate(dip * degree), 0);
    s.stretch_to(-20e6 / young);
    EXPECT_NEAR(s.stress.zz, -20e6, 1e-6 * 20e6) << dip;
    EXPECT_EQ(s.history.equivalent, 0);
  }
}

TEST(jointed, the_dip_direction_turns_from_y_to_x) {
  Jointed law = slate(90 * degree);
  law.dip_direction = 90 * degree;  // vertical joints that face x
  auto s = specimen(law, 0);
  s.go_to({1e-3, 0, 0, 0, 0, 0});
  EXPECT_NEAR(s.stress.xx, 0, 1);
  s = specimen(law, 0);
  s.go_to({0, 1e-3, 0, 0, 0, 0});
  EXPECT_GT(s.stress.yy, 1e7);
}

TEST(breakage, a_loop_of_strain_makes_no_energy) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (int loop = 0; loop < 100; ++loop) {
    auto s = specimen(concrete(), 0.2);
    double work = 0, stored = 0;
    Strain from{};
    for (int leg = 0; leg < 8; ++leg) {
      Strain to{};
      if (leg % 4 < 3)
        for (int c = 0; c < 6; ++c) to[c] = 2e-4 * normal(random);
      for (int i = 1; i <= 400; ++i) {
        const Stress before = s.stress;
        Strain e;
        for (int c = 0; c < 6; ++c) e[c] = from[c] + (to[c] - from[c]) * i / 400;
        s.go_to(e);
        for (int c = 0; c < 6; ++c) work += 0.5 * (before[c] + s.stress[c]) * (to[c] - from[c]) / 400;
      }
      from = to;
      if (leg % 4 < 3) continue;
      ASSERT_GE(work, stored - 1e-3 * tensile * tensile / young) << loop;  // no less than when it was here before
      stored = work;
    }
  }
}

/// 100 000 random paths: strength is never exceeded on the plane, dissipation never falls, a vector pack gives the same
/// bits.
template <class Law, class Check>
void check_random_paths(const Law& law, double scale, Check check) {
  constexpr int width = pack_width<double>;
  using V = Pack<double, width>;
  const auto point = law.template prepare<double>();
  using Point = std::decay_t<decltype(point)>;
  std::mt19937 random(20261127);
  std::normal_distribution<double> normal;
  const auto answer = [&]<class T>(const Sym3<T>& e, typename Point::template History<T>& h) {
    if constexpr (Point::sized)
      return point.stress(e, h, [](int, const Vector&) { return 0.2; });
    else
      return point.stress(e, h);
  };
  for (int path = 0; path < 100000 / width; ++path) {
    typename Point::template History<double> h[width]{};
    typename Point::template History<V> packed{};
    for (int c = 0; c < packed.size; ++c) packed[c] = V(0.0);
    Sym3<V> all;
    for (int c = 0; c < 6; ++c) all[c] = V(0.0);
    Strain e[width]{};
    for (int step = 0; step < 8; ++step) {
      Stress s[width];
      for (int l = 0; l < width; ++l) {
        for (int c = 0; c < 6; ++c) {
          e[l][c] += scale * normal(random);
          set_lane(all[c], l, e[l][c]);
        }
        const double lost = h[l][7];
        s[l] = answer(e[l], h[l]);
        ASSERT_GE(h[l][7], lost - 1e-12 * std::abs(lost));
        check(point, s[l], h[l]);
      }
      const Sym3<V> t = answer(all, packed);
      for (int l = 0; l < width; ++l) {
        for (int c = 0; c < 6; ++c) ASSERT_EQ(lane(t[c], l), s[l][c]);
        for (int c = 0; c < packed.size; ++c) ASSERT_EQ(lane(packed[c], l), h[l][c]);
      }
    }
  }
}

TEST(breakage, random_paths_only_lose_energy_and_packs_give_the_same_bits) {
  check_random_paths(concrete(), 4e-5, [](const auto& law, const Stress& s, const auto& h) {
    if (!(h.damage > 0)) {
      ASSERT_LE(principal(s).value[0], tensile * (1 + 1e-9));
      return;
    }
    const Vector t = traction(s, h.normal);
    const double normal = dot(t, h.normal), shear = norm(t - normal * h.normal);
    const double friction = normal < 0 ? -normal * law.tan_friction : 0;
    ASSERT_LE(normal, tensile * (1 + 1e-9));
    ASSERT_LE(shear, (friction + law.cohesion) * (1 + 1e-9));
  });
}

TEST(damage, random_paths_only_lose_energy_and_packs_give_the_same_bits) {
  check_random_paths(crumbling(), 4e-5, [](const auto& law, const Stress& s, const auto&) {
    ASSERT_LE(law.used(invariants(s), principal(s)), 1 + 1e-4);
  });
}

TEST(jointed, random_paths_stay_on_or_inside_the_surface_and_only_lose_energy) {
  check_random_paths(slate(0.7), 1e-4, [](const auto& law, const Stress& s, const auto&) {
    const auto on = law.test(s);
    ASSERT_LE(on.normal, law.tension + 1e-8 * law.cohesion);
    ASSERT_LE(on.shear, law.cohesion - on.normal * law.tan_friction + 1e-8 * law.cohesion);
  });
}

Stress turned(const double (&q)[3][3], const Stress& s, double shear_factor) {
  const double m[3][3] = {{s.xx, s.xy / shear_factor, s.zx / shear_factor},
                          {s.xy / shear_factor, s.yy, s.yz / shear_factor},
                          {s.zx / shear_factor, s.yz / shear_factor, s.zz}};
  double r[3][3] = {};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) r[i][j] += q[i][k] * m[k][l] * q[j][l];
  return {r[0][0], r[1][1], r[2][2], shear_factor * r[0][1], shear_factor * r[1][2], shear_factor * r[2][0]};
}

/// Two points, the second in axes turned by q, go the same random ways.
template <class Law>
void check_turned(const Law& law, const Law& law_there, const double (&q)[3][3], double scale, std::mt19937& random) {
  std::normal_distribution<double> normal;
  auto here = specimen(law, 0.2), there = specimen(law_there, 0.2);
  Strain e{};
  for (int step = 0; step < 8; ++step) {
    for (int c = 0; c < 6; ++c) e[c] += scale * normal(random);
    here.go_to(e);
    there.go_to(turned(q, e, 2));
    const Stress back = turned(q, here.stress, 1);
    for (int c = 0; c < 6; ++c) ASSERT_NEAR(there.stress[c], back[c], 1e-6 * tensile);
  }
}

TEST(cracking_laws, do_not_depend_on_the_axes) {
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  for (int path = 0; path < 20000; ++path) {
    double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
    const double n = std::sqrt(w * w + x * x + y * y + z * z);
    w /= n, x /= n, y /= n, z /= n;
    const double q[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
                            {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
                            {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
    Breakage opens = concrete();  // of the two planes that shear alike none is the first
    opens.cohesion = 100e6;
    check_turned(opens, opens, q, 4e-5, random);
    check_turned(crumbling(), crumbling(), q, 4e-5, random);
    Jointed rock = slate(0.7), moved = rock;  // turned about z, which turns the dip direction back
    const double angle = 3 * normal(random), c = std::cos(angle), s = std::sin(angle);
    rock.dip_direction = 0.3;
    moved.dip_direction = 0.3 - angle;
    const double about_z[3][3] = {{c, -s, 0}, {s, c, 0}, {0, 0, 1}};
    check_turned(rock, moved, about_z, 1e-4, random);
  }
}

TEST(damage, begins_at_the_uniaxial_strengths) {
  Damage law = crumbling();
  law.compressive_strength = 12 * tensile;
  const auto point = law.prepare<double>();
  const auto used = [&](const Stress& s) { return point.used(invariants(s), principal(s)); };
  EXPECT_NEAR(used({0, 0, tensile, 0, 0, 0}), 1, 1e-9);
  EXPECT_NEAR(used({0, 0, -12 * tensile, 0, 0, 0}), 1, 1e-9);
}

TEST(cracking_laws, say_the_largest_block_that_does_not_snap_back) {
  EXPECT_NEAR(largest_length(BlockLaw(concrete())), 2 * young * energy / (tensile * tensile), 1e-9);
  EXPECT_NEAR(largest_length(BlockLaw(crumbling())), 2 * young * energy / (tensile * tensile), 1e-9);
  EXPECT_TRUE(std::isinf(largest_length(BlockLaw(slate(0)))));
}

}  // namespace
}  // namespace ashlar
