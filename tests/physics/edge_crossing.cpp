#include "physics/edge_crossing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace ashlar {
namespace {

/// Two wedges with a right angle, the lower one's edge along x, the upper one's turned about z, edge to edge.
struct Wedges {
  std::array<Vec3<double>, 4> own{Vec3<double>{-1, -1.2, 0}, {1.1, 1, 0}, {-2, 1, 1.3}, {1, -2, 1.1}};
  std::array<Vec3<double>, 4> other{Vec3<double>{-2, 0, 0}, {1, 0, 0}, {-1, 1, -1}, {-1, -1, -1}};
  EdgeCrossing<double> cross() const {
    const Vec3<double>& o = other[0];
    return cross_edges(own[0] - o, own[1] - o, own[2] - o, own[3] - o, other[1] - o, other[2] - o, other[3] - o);
  }
};

TEST(edge_crossing, the_gap_is_how_far_the_own_body_has_been_lifted) {
  for (const double lifted : {-0.01, 0.0, 0.3}) {
    Wedges wedges;
    for (Vec3<double>& p : wedges.own) p.z += lifted;
    const EdgeCrossing<double> crossing = wedges.cross();
    EXPECT_FALSE(crossing.parallel);
    EXPECT_NEAR(crossing.gap, lifted, 1e-14);
    EXPECT_NEAR(crossing.normal.z, 1, 1e-14);
    EXPECT_LT(std::max(crossing.own_leans, crossing.other_leans), 0) << "all four faces fall away";
  }
}

TEST(edge_crossing, forces_have_a_potential_the_gap_changes_by_normal_times_weights) {
  Wedges wedges;
  wedges.own[0].z = 0.2;  // not level
  const EdgeCrossing<double> at = wedges.cross();
  constexpr double step = 1e-6;
  for (int k = 0; k < 4; ++k)
    for (int i = 0; i < 3; ++i) {
      Wedges more = wedges, less = wedges;
      Vec3<double>& up = k < 2 ? more.own[k] : more.other[k - 2];
      Vec3<double>& down = k < 2 ? less.own[k] : less.other[k - 2];
      up[i] += step;
      down[i] -= step;
      const double weight = k == 0 ? 1 - at.own : k == 1 ? at.own : k == 2 ? at.other - 1 : -at.other;
      EXPECT_NEAR((more.cross().gap - less.cross().gap) / (2 * step), weight * at.normal[i], 1e-9) << k << " " << i;
    }
}

TEST(edge_crossing, bodies_beside_each_other_do_not_touch_by_edges_that_face_away) {
  Wedges wedges;
  for (Vec3<double>& p : wedges.own) p.z = -p.z;  // the own body hangs below its edge, as the other one does
  const EdgeCrossing<double> crossing = wedges.cross();
  EXPECT_GT(std::max(crossing.own_leans, crossing.other_leans), 0);
}

TEST(edge_crossing, parallel_edges_do_not_cross) {
  Wedges wedges;
  wedges.own[0] = {-1, 0.1, 0};
  wedges.own[1] = {1, 0.1, 0};
  EXPECT_TRUE(wedges.cross().parallel);
}

}  // namespace
}  // namespace ashlar
