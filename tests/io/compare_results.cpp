#include "io/compare_results.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "io/result_file.hpp"
#include "io/sample_model.hpp"

namespace ashlar {
namespace {

/// Results of one stage whose displacement is `u` of every node's place.
template <class Function>
std::string written(const TemporaryFolder& place, const SampleModel& sample, Function u) {
  ResultFile file(place.path(), "ashlar test", sample.model, sample.blocks, sample.contacts);
  Snapshot snapshot = sample.snapshot("gravity", 1, 1, true);
  for (std::size_t n = 0; n < sample.blocks.mesh_node.size(); ++n)
    for (int k = 0; k < 3; ++k)
      snapshot.displacement[3 * n + k] = u(n, sample.model.mesh.points[sample.blocks.mesh_node[n]])[k];
  file.append(snapshot);
  return place.file("results.vtkhdf");
}

Vec3<double> linear(std::size_t, const Vec3<double>& p) { return {0.25 * p.x + 2, p.y - p.z, 0}; }

const FieldDifference& field(const Comparison& c, const std::string& name) {
  for (const FieldDifference& f : c.stages.at(0).fields)
    if (f.field == name) return f;
  throw std::logic_error("no field " + name);
}

TEST(CompareResults, TheLargestDifferenceIsFoundWhereItIsAndTakenOverTheLargestValue) {
  const SampleModel sample;
  TemporaryFolder here, there;
  constexpr std::size_t node = 7;
  const auto moved = [&](std::size_t n, const Vec3<double>& p) {
    return linear(n, p) + (n == node ? Vec3<double>{0.003, 0, 0.004} : Vec3<double>{});
  };
  ResultReader a(written(here, sample, moved)), b(written(there, sample, linear));
  const Comparison comparison = compare_results(a, b);
  double largest = 0;
  for (const int n : sample.blocks.mesh_node) largest = std::max(largest, norm(linear(0, sample.model.mesh.points[n])));
  const FieldDifference& d = field(comparison, "displacement");
  EXPECT_NEAR(d.largest, 0.005, 1e-15);
  EXPECT_NEAR(d.largest_relative, 0.005 / largest, 1e-15);
  EXPECT_NEAR(d.mean_relative, 0.005 / largest / sample.blocks.node_count(), 1e-15);
  EXPECT_EQ(d.index, node);
  const Vec3<double> place = sample.model.mesh.points[sample.blocks.mesh_node[node]];
  for (int k = 0; k < 3; ++k) EXPECT_EQ(d.place[k], place[k]);
  EXPECT_EQ(comparison.largest_relative(), d.largest_relative);
  EXPECT_EQ(field(comparison, "temperature").largest, 0);
  EXPECT_TRUE(comparison.missing.empty());
}

TEST(CompareResults, AnOutputThatOneRunLacksIsSaid) {
  const SampleModel sample;
  TemporaryFolder here, there;
  const std::string one = written(here, sample, linear);
  ResultFile file(there.path(), "ashlar test", sample.model, sample.blocks, sample.contacts);
  file.append(sample.snapshot("winter", 2, 2, true));
  ResultReader a(one), b(there.file("results.vtkhdf"));
  const Comparison comparison = compare_results(a, b);
  EXPECT_TRUE(comparison.stages.empty());
  ASSERT_EQ(comparison.missing.size(), 2u);
  EXPECT_NE(comparison.missing[0].find("no output of stage winter"), std::string::npos);
}

TEST(CompareResults, AFieldWithoutValuesInOneRunIsInfinitelyFar) {
  const SampleModel sample;
  TemporaryFolder here, there;
  const auto broken = [](std::size_t n, const Vec3<double>& p) {
    return n == 3 ? Vec3<double>{NAN, 0, 0} : linear(n, p);
  };
  ResultReader a(written(here, sample, broken)), b(written(there, sample, linear));
  EXPECT_TRUE(std::isinf(compare_results(a, b).largest_relative()));
  EXPECT_EQ(field(compare_results(a, a), "displacement").largest, 0);
}

TEST(CompareResults, ALinearFieldIsReadExactlyAlongALine) {
  const SampleModel sample;
  TemporaryFolder here, there;
  const auto twice = [](std::size_t n, const Vec3<double>& p) { return 2.0 * linear(n, p); };
  ResultReader a(written(here, sample, twice)), b(written(there, sample, linear));
  const auto tables = compare_along(a, b, "gravity", {0, 0.5, 0.1}, {4, 0.5, 0.1}, "displacement.x");
  ASSERT_EQ(tables.size(), 1u);
  EXPECT_EQ(tables[0].unit, "m");
  ASSERT_EQ(tables[0].samples.size(), 11u);
  for (const LineSample& s : tables[0].samples) {
    EXPECT_EQ(s.inside, s.place.x <= 2.3) << s.place.x;  // the slant side of the tet
    if (!s.inside) continue;
    EXPECT_NEAR(s.b, 0.25 * s.place.x + 2, 1e-12);
    EXPECT_NEAR(s.a, 2 * s.b, 1e-12);
  }
  EXPECT_THROW(compare_along(a, b, "gravity", {9, 9, 9}, {10, 9, 9}, ""), DeckError);
  EXPECT_THROW(compare_along(a, b, "gravty", {0, 0, 0}, {1, 0, 0}, ""), DeckError);
}

TEST(CompareResults, MeshesThatDifferAreRefused) {
  SampleModel sample, other;
  other.model.mesh.points[0].x -= 0.25;
  TemporaryFolder here, there;
  ResultReader a(written(here, sample, linear)), b(written(there, other, linear));
  try {
    compare_results(a, b);
    FAIL();
  } catch (const DeckError& error) {
    EXPECT_NE(std::string(error.what()).find("node 0 has x = 0 and -0.25 m"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace ashlar
