#pragma once
#include "backend/summed_array.hpp"
#include "kernels/path.hpp"
#include "kernels/sum.hpp"

namespace ashlar {

/// Equilibria that a path of loads remembers, in a machine's memory; see Backend::keep_equilibrium().
template <class Exec, class Real>
class PathLane {
 public:
  template <class T>
  using Array = typename Exec::template Array<T>;

  SummedArray<Exec, Real> rate;  ///< [3 * block nodes] m per load factor; empty until it has been worked out
  Array<Real> kept_slip;         ///< [3 * contact points] m

  /// @param kept [3 * block nodes] m, beside kept_slip the last equilibrium
  void keep(Exec& exec, SummedArray<Exec, Real>& u, const Array<Real>& slip, SummedArray<Exec, Real>& kept,
            double advance) {
    if (advance > 0) {
      if (rate.size() != u.size()) rate.resize(u.size());
      along(exec, u.size(), rate.view(), {}, u.view(), kept.view(), 1 / advance);
    }
    kept.copy(u);
    take(kept_slip, slip);
  }
  void keep_end(const SummedArray<Exec, Real>& u, const Array<Real>& slip) {
    if (end_.size() != u.size()) end_.resize(u.size());
    end_.copy(u);
    take(end_slip_, slip);
  }
  void leave(Exec& exec, SummedArray<Exec, Real>& u, Array<Real>& slip, SummedArray<Exec, Real>& kept, double advance) {
    slip.copy(kept_slip);
    if (advance == 0)
      u.copy(kept);
    else
      along(exec, u.size(), u.view(), kept.view(), rate.view(), {}, advance);
  }
  void go_part(Exec& exec, SummedArray<Exec, Real>& u, Array<Real>& slip, SummedArray<Exec, Real>& kept,
               double fraction) {
    slip.copy(kept_slip);
    along(exec, u.size(), u.view(), kept.view(), end_.view(), kept.view(), fraction);
  }
  void go_to_end(SummedArray<Exec, Real>& u, Array<Real>& slip) const {
    u.copy(end_);
    slip.copy(end_slip_);
  }
  Summed<Real> end() { return end_.view(); }
  double largest_change(Exec& exec, SummedArray<Exec, Real>& u, SummedArray<Exec, Real>& kept) {
    return exec.template combine<1, Largest>(static_cast<int>(u.size()), LargestChange<Real>{u.view(), kept.view()})[0];
  }

 private:
  static void take(Array<Real>& to, const Array<Real>& from) {
    if (to.size() != from.size()) to.resize(from.size());
    to.copy(from);
  }
  static void along(Exec& exec, std::size_t count, const Summed<Real>& to, const Summed<Real>& start, const Summed<Real>& end,
                    const Summed<Real>& before, double factor) {
    exec.for_each(static_cast<int>(count), GoAlong<Real>{to, start, end, before, factor});
  }

  SummedArray<Exec, Real> end_;
  Array<Real> end_slip_;
};

}  // namespace ashlar
