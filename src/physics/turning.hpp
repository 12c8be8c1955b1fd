#pragma once
#include "physics/shapes/hex8.hpp"
#include "physics/shapes/tet4.hpp"
#include "physics/shapes/wedge6.hpp"

/// Elements that turn and move as far as they like: Green's strain through the law of small strain (St. Venant and
/// Kirchhoff). Rigid movements of any size cost nothing, forces follow from one energy, and where nothing turns they
/// are those of small strain.
namespace ashlar {

template <class Base, class V>
struct Turning : Base {
  static constexpr int corners = Base::corners;

  template <class Stress>
  struct GreenStress {
    static constexpr bool turning = true;
    Stress& stress;
    ASHLAR_HD auto operator()(int g, const Sym3<V>& strain) const { return stress(g, strain); }
    ASHLAR_HD void volume(const V& volume) const
        requires(requires(Stress& s) { s.volume(volume); }) {
      stress.volume(volume);
    }
  };

  /// Corner forces, N; see Hex8::force.
  template <class Stress>
  ASHLAR_HD static void force(const V (&x)[3][corners], const V (&u)[3][corners], V (&f)[3][corners], Stress& stress) {
    GreenStress<Stress> green{stress};
    Base::force(x, u, f, green);
  }
};

template <class V>
struct TurningHex8 : Turning<Hex8<V>, V> {};
template <class V>
struct TurningWedge6 : Turning<Wedge6<V>, V> {};
template <class V>
struct TurningTet4 : Turning<Tet4<V>, V> {};

}  // namespace ashlar
