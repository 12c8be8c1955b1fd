#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "backend/pack.hpp"
#include "physics/laws/laws.hpp"

namespace ashlar {
namespace {

using Strain = Sym3<double>;
using Stress = Sym3<double>;
using Values = std::map<std::string, double>;

constexpr double degree = 3.14159265358979323846 / 180;
const double root3 = std::sqrt(3.0);

ConePoint<double> drucker_prager(Values values) {
  values.insert({{"young", 100e6}, {"poisson", 0.3}});
  return make_law<DruckerPrager>(values).prepare<double>();
}
ConePoint<double> von_mises(Values values) {
  values.insert({{"young", 100e6}, {"poisson", 0.3}});
  return make_law<VonMises>(values).prepare<double>();
}

PyramidPoint<double> mohr_coulomb(Values values) {
  values.insert({{"young", 100e6}, {"poisson", 0.3}});
  return make_law<MohrCoulomb>(values).prepare<double>();
}

double overshoot(const PyramidPoint<double>& law, const Stress& s, const PlasticHistory<double>&) {
  return law.overstep(principal(s).value) / law.strength;
}

/// Yield function over k: sqrt(J2) + a I1 - k, and I1 - cut-off.
double overshoot(const ConePoint<double>& law, const Stress& s, const PlasticHistory<double>& h) {
  const auto i = invariants(s);
  return std::max(i.shear + law.slope * i.trace - law.strength_at(law.flow_of(h.equivalent)), i.trace - law.cut_off) /
         law.strength;
}

/// One material point driven by hand.
template <class Law>
struct Point {
  Law law;
  PlasticHistory<double> history{};
  Strain strain{};
  Stress stress{};

  void go_to(const Strain& e) {
    strain = e;
    stress = law.stress(strain, history);
  }
  /// Strain zz moves by `step`, lateral strains follow until lateral stresses are `lateral`.
  void compress(double step, double lateral) {
    Strain e = strain;
    e.zz += step;
    for (int i = 0; i < 400; ++i) {
      PlasticHistory<double> h = history;
      const Stress s = law.stress(e, h);
      const double off = s.xx - lateral;
      if (std::abs(off) < 1e-9 * std::abs(law.strength)) break;
      e.xx = e.yy = e.xx - off / (2 * (law.part.lambda + law.part.shear));
    }
    go_to(e);
  }
};

/// Axial stress on the plateau of a test at constant lateral stress.
template <class Law>
double plateau(const Law& law, double lateral, double step) {
  Point<Law> point{law};
  const double bulk3 = 3 * law.part.lambda + 2 * law.part.shear, e = lateral / bulk3;
  point.go_to({e, e, e, 0, 0, 0});
  for (int i = 0; i < 400; ++i) point.compress(step, lateral);
  EXPECT_NEAR(point.stress.xx, lateral, 1e-6 * law.strength);
  EXPECT_LE(overshoot(law, point.stress, point.history), 1e-8);
  return point.stress.zz;
}

struct Cone {
  double match, uniaxial, triaxial, extension, tension, strength, slope;
};
const Cone table[] = {{0, 4.610357e6, 23.061219e6, -0.911003e6, 1.650418e6, 1.403362e6, .272957},
                      {1, 2.430695e6, 14.522322e6, 4.170440e6, 1.249361e6, 0.952869e6, .185335},
                      {2, 2.357318e6, 14.234868e6, 4.419711e6, 1.229687e6, 0.933147e6, .181499}};

TEST(drucker_prager, P28_plateaus_in_compression_extension_tension_and_shear) {
  for (const Cone& cone : table)
    for (const double dilation : {0.0, 10 * degree, 35 * degree}) {
      const auto law = drucker_prager({{"cohesion", 1.2e6},
                                       {"friction", 35 * degree},
                                       {"match", cone.match},
                                       {"dilation", dilation},
                                       {"young", 10e9}});
      EXPECT_NEAR(law.slope, cone.slope, 1e-6);
      EXPECT_NEAR(law.strength, cone.strength, 1);
      const double step = 1e-5;
      EXPECT_NEAR(plateau(law, 0, -step), -cone.uniaxial, 1e-3 * cone.uniaxial);
      EXPECT_NEAR(plateau(law, -5e6, -4 * step), -cone.triaxial, 1e-3 * cone.triaxial);
      EXPECT_NEAR(plateau(law, -20e6, 4 * step), -cone.extension, 1e-3 * std::abs(cone.extension));
      EXPECT_NEAR(plateau(law, 0, step), cone.tension, 1e-3 * cone.tension);
    }
}

TEST(drucker_prager, P28_pure_shear_yields_at_k) {
  for (const Cone& cone : table) {
    Point<ConePoint<double>> point{
        drucker_prager({{"cohesion", 1.2e6}, {"friction", 35 * degree}, {"match", cone.match}, {"young", 10e9}})};
    for (int i = 1; i <= 100; ++i) point.go_to({0, 0, 0, i * 1e-5, 0, 0});
    EXPECT_NEAR(point.stress.xy, cone.strength, 1e-3 * cone.strength);
    EXPECT_LE(overshoot(point.law, point.stress, point.history), 1e-8);
  }
}

TEST(drucker_prager, P29_oedometer) {
  const double young = 100e6, poisson = 0.3, e = 0.01;
  const double bulk = young / (3 * (1 - 2 * poisson)), shear = young / (2 * (1 + poisson)), m = bulk + 4 * shear / 3;
  for (const double dilation : {0.0, 5 * degree, 10 * degree}) {
    Point<ConePoint<double>> point{
        drucker_prager({{"cohesion", 0.1e6}, {"friction", 10 * degree}, {"match", 0}, {"dilation", dilation}})};
    for (int i = 1; i <= 100; ++i) point.go_to({0, 0, -e * i / 100, 0, 0, 0});
    const double a = point.law.slope, b = point.law.trace_per_flow * point.law.bulk_ease, k = point.law.strength;
    const double d = 2 * shear / root3 - 3 * bulk * a;
    const double flow = d * (e - k / d) / (shear + 9 * bulk * a * b);
    const double axial = m * e - flow * (2 * shear / root3 - 3 * bulk * b);
    const double lateral = (bulk - 2 * shear / 3) * e + flow * (shear / root3 + 3 * bulk * b);
    EXPECT_GT(flow, 0);
    EXPECT_NEAR(-point.stress.zz, axial, 1e-6 * axial);
    EXPECT_NEAR(-point.stress.xx, lateral, 1e-6 * lateral);
    EXPECT_NEAR(overshoot(point.law, point.stress, point.history), 0, 1e-8);
  }
}

TEST(von_mises, uniaxial_hardening_follows_the_tangent_modulus) {
  const double young = 100e6, yield = 1e5, modulus = 2e6;
  Point<ConePoint<double>> point{von_mises({{"yield_stress", yield}, {"hardening", modulus}})};
  for (int i = 0; i < 400; ++i) point.compress(1e-5, 0);
  const double strain = 400 * 1e-5, tangent = young * modulus / (young + modulus);
  EXPECT_NEAR(point.stress.zz, yield + tangent * (strain - yield / young), 1e-6 * yield);
}

TEST(drucker_prager, softening_ends_at_the_residual_cohesion) {
  const auto law =
      drucker_prager({{"cohesion", 1e5}, {"friction", 20 * degree}, {"hardening", -1e6}, {"residual", 4e4}});
  const auto left = drucker_prager({{"cohesion", 4e4}, {"friction", 20 * degree}});
  EXPECT_NEAR(plateau(law, 0, -1e-3), plateau(left, 0, -1e-3), 1);
}

TEST(drucker_prager, the_cut_off_limits_mean_stress_and_hydrostatic_tension_the_tip) {
  const Values rock{{"cohesion", 1.2e6}, {"friction", 35 * degree}, {"young", 10e9}};
  Values cut = rock;
  cut["tension_cutoff"] = 0.2e6;
  Point<ConePoint<double>> tip{drucker_prager(rock)}, flat{drucker_prager(cut)};
  const Strain stretch{1e-3, 1e-3, 1e-3, 0, 0, 0};
  tip.go_to(stretch);
  flat.go_to(stretch);
  EXPECT_NEAR(tip.stress.xx, 1.2e6 / std::tan(35 * degree), 1);  // c cot(phi)
  EXPECT_NEAR(flat.stress.xx, 0.2e6, 1e-3);
}

// Without this a balanced body jumps when what it went through is taken over: the stress of a point that has flowed
// lies on the surface but for rounding, and there it has to stay.
TEST(mohr_coulomb, a_stress_that_has_flowed_stays_where_it_is) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  for (const double friction : {0.01, 1.0, 30.0})
    for (int path = 0; path < 2000; ++path) {
      const auto law = mohr_coulomb({{"cohesion", 20e3}, {"friction", friction * degree}, {"young", 10e6}});
      Point<PyramidPoint<double>> point{law};
      Strain e;
      const bool plane = path % 2 == 0;  // two equal principal stresses now and then
      for (int step = 0; step < 15; ++step) {
        for (int c = 0; c < (plane ? 3 : 6); ++c) e[c] += 0.02 * normal(random);
        if (path % 4 == 0) e.yy = e.xx;
        point.go_to(e);
        auto history = point.history;
        const Stress again = law.stress(e, history);
        for (int i = 0; i < 6; ++i) ASSERT_NEAR(again[i], point.stress[i], 1e-6 * 20e3) << friction << " " << path;
      }
    }
}

TEST(drucker_prager, a_closed_elastic_loop_comes_back_and_a_trial_leaves_nothing_behind) {
  const auto law = drucker_prager({{"cohesion", 1e5}, {"friction", 30 * degree}});
  Point<ConePoint<double>> point{law};
  point.go_to({0, 0, 1e-2, 3e-3, 0, 0});
  const auto kept = point.history;
  auto trial = kept;
  law.stress(Strain{0, 0, -5e-2, 0, 1e-2, 0}, trial);
  const Stress again = law.stress(point.strain, trial = kept);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(again[i], point.stress[i], 1e-9 * law.strength);
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

/// Flow along the normal of the surface loses the most energy that it can (Hill 1948): no admissible stress would lose
/// more, (stress - other) : plastic strain >= 0. A wrong face, edge or tip does not pass.
template <class Law>
void check_largest_dissipation(const std::function<Law(std::mt19937&)>& draw, double size) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (int path = 0; path < 500; ++path) {
    const Law law = draw(random);
    std::vector<Stress> stresses;
    std::vector<Strain> flows;
    for (int i = 0; i < 60; ++i) {
      PlasticHistory<double> h{};
      Strain e;
      const double mean = 2 * size * normal(random), axis = i % 3 == 0 ? 1e-9 : 1;  // some nearly with equal values
      for (int c = 0; c < 6; ++c) e[c] = size * normal(random) * (c == 1 || c >= 3 ? axis : 1) + (c < 3 ? mean : 0);
      stresses.push_back(law.stress(e, h));
      flows.push_back(h.strain);
    }
    for (std::size_t i = 0; i < flows.size(); ++i)
      for (std::size_t j = 0; j < stresses.size(); ++j) {
        double work = 0, scale = 0;
        for (int c = 0; c < 6; ++c) {
          work += (stresses[i][c] - stresses[j][c]) * flows[i][c];
          scale += std::abs(stresses[i][c] - stresses[j][c]) * std::abs(flows[i][c]);
        }
        ASSERT_GE(work, -1e-7 * scale - 1e-9 * law.strength * size);
      }
  }
}

/// 100 000 random paths of strain: never outside the surface, dissipation never negative, the same in turned axes, the
/// same bits in a vector pack.
template <class Draw>
void check_random_paths(Draw draw, double size) {
  std::mt19937 random(20261127);
  std::normal_distribution<double> normal;
  constexpr int width = pack_width<double>;
  using V = Pack<double, width>;
  for (int path = 0; path < 100000 / width; ++path) {
    const auto law = draw(random);
    double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
    const double n = std::sqrt(w * w + x * x + y * y + z * z);
    w /= n, x /= n, y /= n, z /= n;
    const double q[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
                            {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
                            {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
    PlasticHistory<double> h[width] = {}, h_turned[width] = {};
    PlasticHistory<V> packed;
    for (int i = 0; i < packed.size; ++i) packed[i] = V(0.0);
    Strain e[width] = {};
    for (int step = 0; step < 8; ++step) {
      Sym3<V> strain;
      for (int l = 0; l < width; ++l)
        for (int i = 0; i < 6; ++i) {
          e[l][i] += size * normal(random);
          strain[i].lanes[l] = e[l][i];
        }
      const Sym3<V> together = law.stress(strain, packed);
      for (int l = 0; l < width; ++l) {
        const double before = h[l].dissipation;
        const Stress s = law.stress(e[l], h[l]);
        ASSERT_LE(overshoot(law, s, h[l]), 1e-8);
        ASSERT_GE(h[l].dissipation - before, -1e-12 * law.strength);
        for (int i = 0; i < 6; ++i) ASSERT_EQ(together[i].lanes[l], s[i]);
        for (int i = 0; i < packed.size; ++i) ASSERT_EQ(packed[i].lanes[l], h[l][i]);
        const Stress there = law.stress(turned(q, e[l], 2), h_turned[l]), back = turned(q, s, 1);
        for (int i = 0; i < 6; ++i) ASSERT_NEAR(there[i], back[i], 1e-8 * law.strength + 1e-9 * std::abs(back[i]));
      }
    }
  }
}

TEST(drucker_prager, random_paths_stay_on_or_inside_the_surface_and_only_lose_energy) {
  check_random_paths(
      [](std::mt19937& random) {
        std::uniform_real_distribution<double> share(0, 1);
        const double friction = 45 * degree * share(random), cohesion = 1e5 * (0.1 + share(random));
        Values values{{"cohesion", cohesion},
                      {"friction", friction},
                      {"dilation", friction * share(random)},
                      {"match", std::floor(3 * share(random))},
                      {"hardening", cohesion * (40 * share(random) - 20)},
                      {"residual", cohesion * share(random)}};
        if (share(random) < 0.5) values["tension_cutoff"] = 0.5 * cohesion * share(random);
        return drucker_prager(values);
      },
      2e-3);
}

TEST(von_mises, random_paths_stay_on_or_inside_the_surface_and_only_lose_energy) {
  check_random_paths(
      [](std::mt19937& random) {
        std::uniform_real_distribution<double> share(0, 1);
        return von_mises({{"yield_stress", 1e5 * (0.1 + share(random))}, {"hardening", 1e6 * share(random)}});
      },
      2e-3);
}

TEST(mohr_coulomb, P28_plateaus_in_compression_extension_and_tension) {
  const double c = 1.2e6, s = std::sin(35 * degree), cosine = std::cos(35 * degree), step = 1e-5;
  for (const double dilation : {0.0, 10 * degree, 35 * degree}) {
    const auto law =
        mohr_coulomb({{"cohesion", c}, {"friction", 35 * degree}, {"dilation", dilation}, {"young", 10e9}});
    const double uniaxial = 2 * c * cosine / (1 - s), share = (1 + s) / (1 - s);
    EXPECT_NEAR(plateau(law, 0, -step), -uniaxial, 1e-6 * uniaxial);
    EXPECT_NEAR(plateau(law, -5e6, -4 * step), -uniaxial - 5e6 * share, 1e-3 * uniaxial);
    EXPECT_NEAR(plateau(law, -20e6, 4 * step), -(20e6 - uniaxial) / share, 1e-3 * uniaxial);
    EXPECT_NEAR(plateau(law, 0, step), 2 * c * cosine / (1 + s), 1e-3 * uniaxial);
  }
  const auto cut =
      mohr_coulomb({{"cohesion", c}, {"friction", 35 * degree}, {"tensile_strength", 4e5}, {"young", 10e9}});
  EXPECT_NEAR(plateau(cut, 0, step), 4e5, 1);
}

TEST(mohr_coulomb, P29_oedometer_without_dilation_keeps_the_active_ratio) {
  const double c = 1e4, phi = 30 * degree, s = std::sin(phi);
  Point<PyramidPoint<double>> point{mohr_coulomb(
      {{"cohesion", c}, {"friction", phi}, {"poisson", 0.1}})};  // poisson / (1 - poisson) < (1 - s) / (1 + s)
  for (int i = 1; i <= 100; ++i) point.go_to({0, 0, -1e-4 * i, 0, 0, 0});
  EXPECT_NEAR(-point.stress.zz * (1 - s), 2 * c * std::cos(phi) - point.stress.xx * (1 + s), 1e-8 * c);
  const double bulk = 100e6 / (3 * (1 - 2 * 0.1));
  EXPECT_NEAR(point.stress.xx + point.stress.yy + point.stress.zz, -3 * bulk * 1e-2, 1e-6 * bulk);
}

MohrCoulomb random_pyramid(std::mt19937& random, bool associated) {
  std::uniform_real_distribution<double> share(0, 1);
  MohrCoulomb law;
  law.young = 100e6;
  law.poisson = 0.3;
  law.friction = 45 * degree * share(random);
  law.cohesion = 1e5 * (0.1 + share(random));
  law.dilation = law.friction * (associated ? 1 : share(random));
  if (share(random) < 0.5) law.tensile_strength = law.cohesion / std::tan(law.friction) * share(random);
  return law;
}

TEST(mohr_coulomb, random_paths_stay_on_or_inside_the_surface_and_only_lose_energy) {
  check_random_paths([](std::mt19937& random) { return random_pyramid(random, false).prepare<double>(); }, 2e-3);
}

TEST(mohr_coulomb, associated_flow_loses_the_most_energy) {
  check_largest_dissipation<PyramidPoint<double>>(
      [](std::mt19937& random) { return random_pyramid(random, true).prepare<double>(); }, 2e-3);
}

TEST(drucker_prager, associated_flow_loses_the_most_energy) {
  check_largest_dissipation<ConePoint<double>>(
      [](std::mt19937& random) {
        std::uniform_real_distribution<double> share(0, 1);
        Values values{{"cohesion", 1e5}, {"friction", 45 * degree * share(random)}};
        values["dilation"] = values["friction"];
        if (share(random) < 0.5) values["tension_cutoff"] = 5e4 * share(random);
        return drucker_prager(values);
      },
      2e-3);
}

std::vector<LawComplaint> complaints(const std::string& law, Values values) {
  values.insert({{"young", 1e9}, {"poisson", 0.2}});
  return std::visit([](const auto& l) { return l.complaints(); }, make_block_law(law, values));
}

TEST(block_laws, numbers_that_contradict_each_other_are_refused) {
  const auto key = [](const std::string& law, const Values& values) {
    const auto found = complaints(law, values);
    return found.empty() ? std::string("fine") : found[0].key + (found[0].key.empty() ? found[0].message : "");
  };
  EXPECT_EQ(key("drucker_prager", {{"cohesion", 1e5}, {"friction", 0.5}}), "fine");
  EXPECT_EQ(key("drucker_prager", {{"cone_slope", 0.2}, {"cone_strength", 1e5}}), "fine");
  EXPECT_EQ(key("drucker_prager", {{"cohesion", 1e5}, {"friction", 0.5}, {"dilation", 0.6}}), "dilation");
  EXPECT_EQ(key("drucker_prager", {{"friction", 0.5}}),
            "missing 'cohesion' [Pa]: shear strength without normal stress");
  EXPECT_EQ(key("drucker_prager", {{"cohesion", 1e5}, {"friction", 0.5}, {"cone_strength", 1e5}}), "cone_slope");
  EXPECT_EQ(key("drucker_prager", {{"cone_slope", 0.2}, {"cone_strength", 1e5}, {"cone_dilation", 0.3}}),
            "cone_dilation");
  EXPECT_EQ(key("drucker_prager", {{"cohesion", 1e5}, {"friction", 0.5}, {"tension_cutoff", 2e5}}), "tension_cutoff");
  EXPECT_EQ(key("drucker_prager", {{"cohesion", 1e5}, {"friction", 0.5}, {"residual", 2e5}}), "residual");
  EXPECT_EQ(key("drucker_prager", {{"cohesion", 1e5}, {"friction", 0.5}, {"hardening", -1e12}}), "hardening");
  EXPECT_EQ(key("mohr_coulomb", {{"cohesion", 1e5}, {"friction", 0.5}, {"dilation", 0.6}}), "dilation");
  EXPECT_EQ(key("mohr_coulomb", {{"cohesion", 1e5}, {"friction", 0.5}, {"tensile_strength", 2e5}}), "tensile_strength");
  EXPECT_EQ(key("von_mises", {{"yield_stress", 1e5}, {"residual_stress", 2e5}}), "residual_stress");
}

TEST(block_laws, every_law_documents_every_key) {
  for (const auto& law : material_law_docs()) {
    EXPECT_FALSE(law.doc.empty());
    for (const auto& key : law.keys) EXPECT_FALSE(key.doc.empty()) << law.name << "." << key.name;
  }
}

}  // namespace
}  // namespace ashlar
