#pragma once
#include <array>
#include <utility>

#include "backend/springs.hpp"
#include "kernels/spring_advance.hpp"
#include "kernels/spring_break.hpp"
#include "kernels/sum.hpp"

namespace ashlar {

/// Looks at all contact points at once, at equilibria: which is worst, what cracks, what is kept, what came loose.
template <class Exec, class Real>
class CrackLane {
 public:
  /// `springs` outlives this.
  explicit CrackLane(Springs<Exec, Real>& springs) : springs_(springs) {}

  double largest = 0;       ///< what the last look found; behind break_at(): what the worst uses
  CrackMeasure cracked;     ///< by the last break_at() or keep()
  ChangedContacts changed;  ///< since somebody took it

  void find_worst(Exec& exec, const Summed<Real>& u) {
    largest = combine<1, Largest>(
        exec, [&](auto springs, int) { return SpringUtilisation<Real, decltype(springs)>{springs, u}; })[0];
  }
  void find_crossing(Exec& exec, const Summed<Real>& before, const Summed<Real>& u) {
    largest = combine<1, Largest>(
        exec, [&](auto springs, int) { return SpringCrossing<Real, decltype(springs)>{springs, before, u}; })[0];
  }
  /// The worst, which uses `largest` of its strength, and all at or above `threshold`.
  void break_at(Exec& exec, const Summed<Real>& u, double threshold) {
    const double worst = combine<1, Largest>(exec, [&](auto springs, int first) {
      return WorstSpring<Real, decltype(springs)>{{springs, u}, largest, springs_.number() + first};
    })[0];
    list_to_break(exec, u, threshold);
    const auto sum = combine<3>(
        exec, [&](auto springs, int) { return BreakSprings<Real, decltype(springs)>{{springs, u}, threshold}; });
    cracked = {static_cast<int>(sum[2]), CrackKey::number(worst), CrackKey::mode(worst), {sum[0], sum[1], 0}};
  }
  void keep(Exec& exec, const Summed<Real>& u) {
    double key = Largest::start;
    if (springs_.damage.size() > 0) {
      changed.known = false;
      key = combine<1, Largest>(exec, [&](auto springs, int first) {
        return FirstSoftened<Real, decltype(springs)>{memory_of(springs, u, first), springs_.number() + first};
      })[0];
    }
    const auto sum = combine<4>(exec, [&](auto springs, int first) {
      return KeepSprings<Real, decltype(springs)>{memory_of(springs, u, first)};
    });
    cracked = {static_cast<int>(sum[3]), CrackKey::number(key), CrackKey::mode(key), {sum[0], sum[1], sum[2]}};
  }
  void look(Exec& exec, const Summed<Real>& u) {
    largest = combine<1>(exec, [&](auto springs, int first) {
      return LookAtSprings<Real, decltype(springs)>{memory_of(springs, u, first), springs_.joined.data() + first};
    })[0];
  }

 private:
  /// Combines terms_of(springs, their first contact point) over all contact points.
  template <int count, class How = Sum, class TermsOf>
  std::array<double, count> combine(Exec& exec, const TermsOf& terms_of) {
    const int pairs = springs_.pairs().contact_count, overlaps = springs_.overlaps().contact_count;
    auto all = exec.template combine<count, How>(pairs, terms_of(springs_.pairs(), 0));
    if (overlaps == 0) return all;
    const auto more = exec.template combine<count, How>(overlaps, terms_of(springs_.overlaps(), pairs));
    for (int k = 0; k < count; ++k) all[k] = How::of(all[k], more[k]);
    return all;
  }
  template <class View>
  SpringMemory<Real, View> memory_of(const View& springs, const Summed<Real>& u, int first) {
    return {springs, u, springs_.slip.data() + 3 * first, springs_.damage_from(first)};
  }
  /// Adds those to `changed` one by one, as long as they are few.
  void list_to_break(Exec& exec, const Summed<Real>& u, double threshold) {
    constexpr int few = 64;
    double last = -Largest::start;
    for (int found = 0; changed.known; ++found) {
      last = combine<1, Largest>(exec, [&](auto springs, int first) {
        return NextToBreak<Real, decltype(springs)>{{springs, u}, threshold, last, springs_.number() + first};
      })[0];
      if (last == Largest::start) return;
      changed.points.push_back(CrackKey::number(last));
      changed.known = found < few;
    }
  }

  Springs<Exec, Real>& springs_;
};

}  // namespace ashlar
