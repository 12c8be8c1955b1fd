#pragma once
#include "model/mesh.hpp"

namespace ashlar {

/// What tells a sound element from a bad one.
struct ElementMeasures {
  double smallest_gauss_jacobian = 0;  ///< over the Gauss points, in the scale of the shape's derivative table
  double smallest_corner = 0;          ///< smallest corner Jacobian over the lengths of its three edges, -1 .. 1
  double volume = 0;                   ///< m^3, by the quadrature that the element forces use
  double shortest_edge = 0, longest_edge = 0;  ///< m

  /// smallest_corner over that of the ideal shape: 1 in a cube, in a right wedge on an equilateral triangle and in a
  /// regular tetrahedron; 0 in a flat element.
  double scaled_jacobian(Shape shape) const;
};
ElementMeasures measure_element(const Mesh& mesh, int element);

/// Length of the element across cracks normal to x, y and z, m: what laws release the energy of a crack over.
Vec3<double> lengths_across(const Mesh& mesh, int element);

}  // namespace ashlar
