#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "kernels/gather.hpp"
#include "kernels/heat_flow.hpp"
#include "kernels/heat_gauss.hpp"
#include "kernels/heat_step.hpp"
#include "model/discretisation.hpp"
#include "model/loads.hpp"
#include "support/brick.hpp"

namespace ashlar {
namespace {

/// The thermal lane on the host, kernels run one index after the other.
class Lane {
 public:
  Mesh mesh;
  Discretisation d;
  std::vector<double> x, temperature, heat, inverse_capacity, flow, corner, partial, bound, film_value, film_flow;
  std::vector<std::uint8_t> held;
  std::vector<int> film_node, film_first, film_column;
  HeatView<double> view;

  Lane(Mesh m, int patch_size) : mesh(std::move(m)) {
    Blocks blocks;
    blocks.corners = mesh.corners;
    blocks.mesh_node.resize(mesh.node_count());
    std::iota(blocks.mesh_node.begin(), blocks.mesh_node.end(), 0);
    d = discretise(mesh, blocks, {0}, 8 * patch_size);
    const Topology& t = d.heat;
    x = places_in_patches<double>(t, d.heat_points);
    for (auto* a : {&temperature, &heat, &inverse_capacity, &flow}) a->assign(t.node_count, 0);
    held.assign(t.node_count, 0);
    bound.assign(2 * t.node_count, 0);
    corner.assign(2 * d.slot_count, 0);
    partial.assign(2 * t.entry_count(), 0);
    view.nodes = {.node_count = t.node_count,
                  .interior_count = t.interior_count,
                  .entry_count = t.entry_count(),
                  .corner_entry = t.corner_entry.data(),
                  .patch_first_entry = t.patch_first_entry.data(),
                  .patch_interior = t.patch_interior.data(),
                  .entry_node = t.entry_node.data(),
                  .entry_first_slot = t.entry_first_slot.data(),
                  .entry_slot = t.entry_slot.data(),
                  .boundary_first = t.boundary_first.data(),
                  .boundary_entry = t.boundary_entry.data()};
    view.x = x.data();
    view.temperature = {temperature.data()};
    view.heat = heat.data();
    view.inverse_capacity = inverse_capacity.data();
    view.held = held.data();
    view.flow = flow.data();
    view.corner = corner.data();
    view.partial = partial.data();
    view.bound = bound.data();
  }

  void film(const FilmMatrix& m) {
    film_node = m.node, film_first = m.first, film_column = m.column, film_value = m.value;
    view.film_node_count = static_cast<int>(film_node.size());
    view.film_node = film_node.data();
    view.film_first = film_first.data();
    view.film_column = film_column.data();
    view.film_value = film_value.data();
    film_flow.assign(view.nodes.node_count, 0);
    view.film_flow = film_flow.data();
  }

  template <class Kernel>
  static void each(int n, const Kernel& kernel) {
    for (int i = 0; i < n; ++i) kernel(i);
  }
  template <class Work>
  void each_batch(Work work) {
    for (const Batch& b : d.batches) {
      const BatchView batch{b.first_patch, b.patch_size, b.element_count, b.first_slot, b.first_gauss};
      if (b.shape == Shape::hex8) work(Hex8<double>{}, batch);
      if (b.shape == Shape::wedge6) work(Wedge6<double>{}, batch);
      if (b.shape == Shape::tet4) work(Tet4<double>{}, batch);
    }
  }
  template <int width>
  void gather(std::vector<double>& sum) {
    each(d.heat.entry_count(), GatherPatch<double, width>{view.nodes, view.corner, view.partial, sum.data()});
    each(d.heat.boundary_count(), GatherBoundary<double, width>{view.nodes, view.partial, sum.data()});
  }
  template <template <class> class E>
  void flow_of(E<double>, const BatchView& batch, double conductivity) {
    each(batch.element_count, HeatFlow<E, double>{view, batch, conductivity, view.temperature});
  }
  template <template <class> class E>
  void bound_of(E<double>, const BatchView& batch, double conductivity) {
    each(batch.element_count, HeatBound<E, double>{view, batch, conductivity});
  }
  template <template <class> class E>
  void gauss_of(E<double>, const BatchView& batch, double reference, std::vector<double>& warming) {
    each(batch.element_count, GaussTemperature<E, double>{view, batch, reference, warming.data()});
  }
  void find_flow(double conductivity) {
    each_batch([&](auto e, const BatchView& b) { flow_of(e, b, conductivity); });
    gather<1>(flow);
    each(view.film_node_count, FilmFlow<double>{view, view.temperature});
    each(view.film_node_count, AddFilm<double>{view});
  }
  void find_bound(double conductivity) {
    each_batch([&](auto e, const BatchView& b) { bound_of(e, b, conductivity); });
    gather<2>(bound);
    each(view.film_node_count, FilmBound<double>{view});
  }
};

/// 3 x 4 x 5 cells, inner nodes moved, so that patches of 7 elements share many nodes.
Mesh warped(Shape shape) {
  return brick(
      {3, 4, 5},
      [](const Vec3<double>& p) {
        const double inside = p.x * (1 - p.x) * p.y * (1 - p.y) * p.z * (1 - p.z);
        return Vec3<double>{3 * p.x + 4 * inside * std::sin(9 * p.y), 4 * p.y + 5 * inside * std::sin(7 * p.z + 1),
                            5 * p.z + 5 * inside * std::sin(8 * p.x + 2)};
      },
      shape);
}

FilmMatrix film_on_top(const Lane& lane, double film) {
  Condition air;
  air.noun = "convection";
  air.kind = Convection{{0, {}}, film, {}, {}};
  const ThermalBoundary b = thermal_boundary(lane.mesh, lane.mesh.corners, lane.mesh.node_count(),
                                             std::vector<ActingCondition>{{&air, {lane.mesh.find_surface("top")}}});
  return film_matrix(b.films, {}, lane.d.heat.new_node);
}

class HeatOnShape : public testing::TestWithParam<Shape> {};
INSTANTIATE_TEST_SUITE_P(Shapes, HeatOnShape, testing::Values(Shape::hex8, Shape::wedge6, Shape::tet4),
                         [](const auto& info) { return shape_name(info.param); });

TEST_P(HeatOnShape, a_linear_field_conducts_through_inner_nodes_and_leaves_the_faces_with_the_exact_flux) {
  Lane lane(warped(GetParam()), 7);
  for (int n = 0; n < lane.d.heat.node_count; ++n) lane.temperature[n] = 10 + 2 * lane.d.heat_points[n].z;
  lane.find_flow(2.7);
  double out_top = 0;
  for (int n = 0; n < lane.d.heat.node_count; ++n) {
    const Vec3<double>& p = lane.d.heat_points[n];
    const bool inner = p.z > 1e-9 && p.z < 5 - 1e-9;
    if (inner) {
      EXPECT_NEAR(lane.flow[n], 0, 1e-12);
    }
    if (p.z > 5 - 1e-9) out_top += lane.flow[n];
  }
  EXPECT_NEAR(out_top, 2.7 * 2 * 12, 1e-11);
}

TEST_P(HeatOnShape, bounds_are_the_diagonal_and_at_least_the_row_sum_of_what_the_flow_does) {
  Lane lane(warped(GetParam()), 7);
  lane.film(film_on_top(lane, 15));
  lane.find_bound(2.7);
  const int nodes = lane.d.heat.node_count;
  std::vector<double> row_sum(nodes, 0);
  for (int n = 0; n < nodes; ++n) {
    lane.temperature[n] = 1;
    lane.find_flow(2.7);
    lane.temperature[n] = 0;
    EXPECT_NEAR(lane.bound[2 * n], lane.flow[n], 1e-12 * lane.flow[n]);
    for (int m = 0; m < nodes; ++m) row_sum[m] += std::abs(lane.flow[m]);
  }
  for (int n = 0; n < nodes; ++n) {
    EXPECT_GE(lane.bound[2 * n + 1], row_sum[n] * (1 - 1e-12));
    EXPECT_LE(lane.bound[2 * n + 1], 2 * row_sum[n]);
  }
}

TEST_P(HeatOnShape, film_on_a_face_takes_h_area_times_temperature) {
  Lane lane(warped(GetParam()), 7);
  lane.film(film_on_top(lane, 15));
  std::fill(lane.temperature.begin(), lane.temperature.end(), 3);
  lane.find_flow(2.7);
  EXPECT_NEAR(std::accumulate(lane.flow.begin(), lane.flow.end(), 0.0), 15 * 12 * 3, 1e-9);
}

TEST_P(HeatOnShape, gauss_points_get_a_linear_field_at_their_own_place) {
  Lane lane(warped(GetParam()), 7);
  std::vector<double> warming(lane.d.gauss_count, 0), mean(lane.d.element_count, 0);
  for (int n = 0; n < lane.d.heat.node_count; ++n) lane.temperature[n] = 15 + lane.d.heat_points[n].x;
  lane.each_batch([&](auto e, const BatchView& b) { lane.gauss_of(e, b, 15, warming); });
  for (const Batch& b : lane.d.batches)
    for (int i = 0; i < b.element_count; ++i) {
      double sum = 0, low = 1e9, high = -1e9;
      for (int g = 0; g < gauss_count(b.shape); ++g) sum += warming[b.gauss(i, g)] / gauss_count(b.shape);
      for (const int n : lane.mesh.element(lane.d.source_element[b.first_element + i])) {
        low = std::min(low, lane.mesh.points[n].x);
        high = std::max(high, lane.mesh.points[n].x);
      }
      // symmetric rules: the mean over the points is the mean over the corners
      EXPECT_NEAR(sum, lane.mesh.centroid(lane.d.source_element[b.first_element + i]).x, 1e-13);
      for (int g = 0; g < gauss_count(b.shape); ++g) {
        EXPECT_GT(warming[b.gauss(i, g)], low);
        EXPECT_LT(warming[b.gauss(i, g)], high);
      }
    }
}

TEST(HeatStep, heat_into_a_free_body_raises_its_mean_by_energy_over_capacity_and_held_nodes_stay) {
  Lane lane(warped(Shape::hex8), 7);
  const int nodes = lane.d.heat.node_count;
  Model model;
  model.mesh = lane.mesh;
  model.materials.resize(1);
  model.materials[0].regions = {"body"};
  model.materials[0].density = 2400;
  model.materials[0].heat_capacity = 960;
  const std::vector<double> capacity = lumped_capacity(model, model.mesh.corners, nodes);
  EXPECT_NEAR(std::accumulate(capacity.begin(), capacity.end(), 0.0), 60 * 2400 * 960.0, 1e-4);
  for (int n = 0; n < nodes; ++n) {
    const int m = lane.d.heat.new_node[n];
    lane.inverse_capacity[m] = 1 / capacity[n];
    lane.temperature[m] = 20 * std::sin(n);
    lane.heat[m] = n;
  }
  const auto energy = [&] {
    double sum = 0;
    for (int n = 0; n < nodes; ++n) sum += capacity[n] * lane.temperature[lane.d.heat.new_node[n]];
    return sum;
  };
  const double before = energy(), heat = std::accumulate(lane.heat.begin(), lane.heat.end(), 0.0);
  lane.find_flow(2.7);
  const double time_step = 3600;
  Lane::each(nodes, StepHeat<double>{lane.view, &time_step});
  EXPECT_NEAR(energy() - before, heat * 3600, 1e-12 * std::abs(before) + 1e-9 * heat * 3600);

  lane.held[5] = 1;
  lane.temperature[5] = 7;
  Lane::each(nodes, StepHeat<double>{lane.view, &time_step});
  EXPECT_EQ(lane.temperature[5], 7);
}

}  // namespace
}  // namespace ashlar
