#pragma once
#include "physics/gauss_table.hpp"

/// Heat conduction in one element (paper (6)-(10)), the same source for every machine and number type.
namespace ashlar {

/// Heat that leaves through the corners, W: flow_i = integral of k grad N_i . grad T dV. Symmetric in T and flow.
/// x [component][corner, VTK order] m, temperature degC, conductivity W/(m K).
template <class Element, class V>
ASHLAR_HD void heat_flow(const V (&x)[3][Element::corners], const V (&temperature)[Element::corners],
                         const V& conductivity, V (&flow)[Element::corners]) {
  using S = Scalar<V>;
  using Lines = GaussTable<Element>;
  const ElementGeometry<Element, V> geometry(x);
  const typename Lines::Table heat = Lines::of(temperature);
  typename Lines::Table through;
  const V zero = V(S(0)), weighted = V(S(Lines::factor)) * conductivity;
  for (int g = 0; g < Element::gauss_points; ++g) Lines::put(through, g, {zero, zero, zero});
  ASHLAR_UNROLL
  for (int g = 0; g < Element::gauss_points; ++g) {
    const Jacobian<V> j = geometry.jacobian_at(g);
    const V by_volume = weighted * reciprocal(j.det);
    const Vec3<V> h = Lines::at(heat, g);
    Vec3<V> flux;
    for (int i = 0; i < 3; ++i) flux[i] = by_volume * fma(h.z, j.ab[i], fma(h.y, j.ca[i], h.x * j.bc[i]));
    const Vec3<V> p = Lines::at(through, g);
    Lines::put(through, g,
               {fma(flux.z, j.bc.z, fma(flux.y, j.bc.y, fma(flux.x, j.bc.x, p.x))),
                fma(flux.z, j.ca.z, fma(flux.y, j.ca.y, fma(flux.x, j.ca.x, p.y))),
                fma(flux.z, j.ab.z, fma(flux.y, j.ab.y, fma(flux.x, j.ab.x, p.z)))});
  }
  Lines::to_corners(through, flow);
}

/// A corner field at Gauss point g, in the order of the stress routine.
template <class Element, class V>
ASHLAR_HD V at_gauss_point(const V (&corner)[Element::corners], int g) {
  using S = Scalar<V>;
  V value = V(S(Element::shape(g, 0))) * corner[0];
  for (int k = 1; k < Element::corners; ++k) value = fma(V(S(Element::shape(g, k))), corner[k], value);
  return value;
}

}  // namespace ashlar
