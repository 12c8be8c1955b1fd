#pragma once
#include "model/mesh.hpp"
#include "physics/bbar.hpp"
#include "physics/turning.hpp"

namespace ashlar {

/// An element type as a value, for generic lambdas.
template <template <class> class E>
struct ElementTag {
  template <class V>
  using Element = E<V>;
};

/// Calls work(element tag): the one place where shape and formulation become types; `bbar` as in Setup.
template <class Work>
auto with_element(Shape shape, int bbar, const Work& work) {
  switch (shape) {
    case Shape::hex8: return bbar ? work(ElementTag<Hex8BBar>{}) : work(ElementTag<Hex8>{});
    case Shape::wedge6: return bbar ? work(ElementTag<Wedge6BBar>{}) : work(ElementTag<Wedge6>{});
    case Shape::tet4: break;
  }
  return bbar == 2 ? work(ElementTag<Tet4Averaged>{}) : work(ElementTag<Tet4>{});
}
/// The same of elements in large displacement.
template <class Work>
auto with_turning_element(Shape shape, const Work& work) {
  switch (shape) {
    case Shape::hex8: return work(ElementTag<TurningHex8>{});
    case Shape::wedge6: return work(ElementTag<TurningWedge6>{});
    case Shape::tet4: break;
  }
  return work(ElementTag<TurningTet4>{});
}

}  // namespace ashlar
