#pragma once
#include <Eigen/Core>

#include "model/mesh.hpp"
#include "physics/laws/elastic.hpp"

namespace ashlar {

/// Stress at the Gauss points of one element, without what its incompatible modes (Wilson 1973) would relax.
///
/// Corners of a linear element cannot follow a strain that varies along its own direction: a bent one is sheared, and
/// warmth that grows towards a face cannot swell it as it would. What that leaves at the Gauss points is the largest
/// error of nodal stress once extrapolated. The modes take it out as they do in Wilson's element, but after the
/// solution: displacements stay what they are, and so does the mean stress of an element. tet4 has none.
/// @param bbar whether the element's change of volume is that of its mean
/// @param stress [Gauss points x 6] Pa, xx yy zz xy yz zx
Eigen::MatrixXd without_incompatible(const Mesh& mesh, int element, bool bbar, const Elastic::Point<double>& law,
                                     const Eigen::MatrixXd& stress);

}  // namespace ashlar
