#pragma once

namespace ashlar {

/// Corner forces of one hexahedron as a textbook program computes them: gradients of the shape functions at each of 2x2x2
/// Gauss points, strain, stress, their products summed (T. Belytschko, W. K. Liu, B. Moran, Nonlinear Finite Elements
/// for Continua and Structures, box 4.3). What serial programs are commonly written like: the yardstick of `bench`.
/// Corners in VTK order; x in m, u in m, f in N.
void textbook_hex8_force(const double (&x)[8][3], const double (&u)[8][3], double lambda, double shear,
                         double (&f)[8][3]);

}  // namespace ashlar
