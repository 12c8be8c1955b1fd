#pragma once
#include <cmath>
#include <vector>

#include "backend/backend.hpp"
#include "backend/node_set.hpp"
#include "backend/summed_array.hpp"
#include "kernels/element_types.hpp"
#include "kernels/gather.hpp"
#include "kernels/heat_flow.hpp"
#include "kernels/heat_gauss.hpp"
#include "kernels/heat_search.hpp"
#include "kernels/heat_step.hpp"
#include "kernels/relaxation_sums.hpp"

namespace ashlar {

/// The thermal lane in a machine's memory and its phases; shares nothing with the mechanical lane but the Gauss-point
/// warming that it hands over.
template <class Exec, class Real>
class HeatLane {
 public:
  explicit HeatLane(const Setup& setup)
      : discretisation_(setup.discretisation),
        conductivity_(setup.conductivity),
        reference_(Real(setup.reference_temperature)),
        nodes_(setup.discretisation.heat) {
    const Discretisation& d = discretisation_;
    conductivity_.resize(setup.laws.size());
    const std::size_t nodes = d.heat.node_count;
    x_.assign(places_in_patches<Real>(d.heat, d.heat_points));
    temperature.resize(nodes);
    for (auto* a : {&heat, &inverse_capacity, &flow, &residual_, &direction_}) a->resize(nodes);
    held.resize(nodes);
    bound.resize(2 * nodes);
    corner_.resize(2 * std::size_t(d.slot_count));
    partial_.resize(2 * std::size_t(d.heat.entry_count()));
    time_step_.resize(1);
    view_ = {.nodes = nodes_.view(),
             .x = x_.data(),
             .temperature = temperature.view(),
             .heat = heat.data(),
             .inverse_capacity = inverse_capacity.data(),
             .held = held.data(),
             .given_temperature = nullptr,  // named: nvcc 13 shifts the initialisers behind a member that is left out
             .flow = flow.data(),
             .corner = corner_.data(),
             .partial = partial_.data(),
             .bound = bound.data(),
             .residual = residual_.data(),
             .direction = direction_.data(),
             .film_node_count = 0,
             .film_node = nullptr,
             .film_first = nullptr,
             .film_column = nullptr,
             .film_value = nullptr,
             .film_flow = nullptr};
  }

  void write_films(const FilmMatrix& films) {
    film_node_.assign(films.node);
    film_first_.assign(films.first);
    film_column_.assign(films.column);
    film_value.assign(std::vector<Real>(films.value.begin(), films.value.end()));
    film_flow_.resize(films.node.empty() ? 0 : view_.nodes.node_count);
    view_.film_node_count = static_cast<int>(films.node.size());
    view_.film_node = film_node_.data();
    view_.film_first = film_first_.data();
    view_.film_column = film_column_.data();
    view_.film_value = film_value.data();
    view_.film_flow = films.node.empty() ? nullptr : film_flow_.data();
  }

  void give_temperature(std::size_t nodes) {
    given_temperature.resize(nodes);
    view_.given_temperature = nodes > 0 ? given_temperature.data() : nullptr;
  }
  void find_flow(Exec& exec) { find_flow_of(exec, view_.temperature); }
  void find_search_flow(Exec& exec) { find_flow_of(exec, {view_.direction}); }
  void step(Exec& exec, double time_step) {
    set_time_step(time_step);
    exec.for_each(node_count(), step_heat());
  }
  /// Steps of a transient as the machine does them best.
  void march(Exec& exec, double time_step, int steps) {
    if constexpr (Exec::marches) {
      set_time_step(time_step);
      exec.repeat("heat", steps, [&] {
        film_flow(exec, view_.temperature);
        each_batch([&](auto element, const BatchView& batch, Real conductivity, int b) {
          exec.heat_flows(element, view_, batch, conductivity, view_.temperature, discretisation_, b, step_heat());
        });
        exec.heat_boundary(view_, view_.temperature, discretisation_, step_heat());
      });
    }
  }
  void find_bound(Exec& exec) {
    each_batch([&](auto element, const BatchView& batch, Real conductivity, int) {
      bound_of(exec, element, batch, conductivity);
    });
    exec.for_each(view_.nodes.entry_count, GatherPatch<Real, 2>{view_.nodes, view_.corner, view_.partial, view_.bound});
    gather_boundary<2>(exec, view_.bound);
    exec.for_each(view_.film_node_count, FilmBound<Real>{view_});
  }
  void start_search(Exec& exec) { exec.for_each(node_count(), StartSearch<Real>{view_}); }
  void advance_search(Exec& exec, double length) {
    exec.for_each(node_count(), AdvanceSearch<Real>{view_, Real(length)});
  }
  void turn_search(Exec& exec, double keep) { exec.for_each(node_count(), TurnSearch<Real>{view_, Real(keep)}); }
  HeatMeasure sums(Exec& exec) {
    const auto s = exec.template combine<heat_sum_count>(node_count(), HeatSums<Real>{view_});
    return {std::sqrt(s[sum_residual]), s[sum_preconditioned], s[sum_along]};
  }
  void warm_gauss_points(Exec& exec, Real* warming) {
    each_batch([&](auto element, const BatchView& batch, Real, int) { gauss_of(exec, element, batch, warming); });
  }

 private:
  template <class T>
  using Array = typename Exec::template Array<T>;
  int node_count() const { return view_.nodes.node_count; }

  StepHeat<Real> step_heat() { return {view_, time_step_.data()}; }
  void set_time_step(double time_step) {
    if (Real(time_step) != last_time_step_) time_step_.upload({Real(time_step)});
    last_time_step_ = Real(time_step);
  }

  /// Calls work(element tag, batch view, conductivity, batch index) for every batch.
  template <class Work>
  void each_batch(Work work) const {
    for (int i = 0; i < static_cast<int>(discretisation_.batches.size()); ++i) {
      const Batch& b = discretisation_.batches[i];
      const BatchView batch{b.first_patch, b.patch_size, b.element_count, b.first_slot, b.first_gauss};
      const Real conductivity = Real(conductivity_[b.material]);
      switch (b.shape) {
        case Shape::hex8: work(ElementTag<Hex8>{}, batch, conductivity, i); break;
        case Shape::wedge6: work(ElementTag<Wedge6>{}, batch, conductivity, i); break;
        case Shape::tet4: work(ElementTag<Tet4>{}, batch, conductivity, i); break;
      }
    }
  }
  template <template <class> class E>
  void bound_of(Exec& exec, ElementTag<E>, const BatchView& batch, Real conductivity) {
    exec.for_each(batch.element_count, HeatBound<E, Real>{view_, batch, conductivity});
  }
  template <template <class> class E>
  void gauss_of(Exec& exec, ElementTag<E>, const BatchView& batch, Real* warming) {
    exec.for_each(batch.element_count, GaussTemperature<E, Real>{view_, batch, reference_, warming});
  }
  template <int width>
  void gather_boundary(Exec& exec, Real* sum) {
    exec.for_each(discretisation_.heat.boundary_count(), GatherBoundary<Real, width>{view_.nodes, view_.partial, sum});
  }
  void film_flow(Exec& exec, const Summed<Real>& field) {
    exec.for_each(view_.film_node_count, FilmFlow<Real>{view_, field});
  }
  void find_flow_of(Exec& exec, const Summed<Real>& field) {
    each_batch([&](auto element, const BatchView& batch, Real conductivity, int b) {
      exec.heat_flows(element, view_, batch, conductivity, field, discretisation_, b, StoreSum<Real>{view_.flow});
    });
    gather_boundary<1>(exec, view_.flow);
    film_flow(exec, field);
    exec.for_each(view_.film_node_count, AddFilm<Real>{view_});
  }

  const Discretisation& discretisation_;
  std::vector<double> conductivity_;
  Real reference_;
  NodeSet<Exec> nodes_;
  Array<Real> x_, residual_, direction_, corner_, partial_, film_flow_, time_step_;
  Real last_time_step_ = 0;
  Array<int> film_node_, film_first_, film_column_;
  HeatView<Real> view_;

 public:
  SummedArray<Exec, Real> temperature;
  Array<Real> heat, inverse_capacity, flow, bound, film_value, given_temperature;
  Array<std::uint8_t> held;
};

}  // namespace ashlar
