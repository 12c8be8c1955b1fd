#include "solve/incompatible_modes.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <vector>

#include "physics/gauss_table.hpp"

namespace ashlar {

namespace {

/// Parametric derivatives of the shapes of the modes at Gauss point g: xi^2, eta^2, zeta^2 of a hexahedron, by half.
std::vector<Vec3<double>> mode_derivatives(const Hex8<double>&, int g) {
  const double p = 1 / std::sqrt(3.0);
  return {{g & 1 ? p : -p, 0, 0}, {0, g & 2 ? p : -p, 0}, {0, 0, g & 4 ? p : -p}};
}

/// Products of two area coordinates, and zeta^2 by half, of a wedge.
std::vector<Vec3<double>> mode_derivatives(const Wedge6<double>&, int g) {
  const auto area = [&](int i) { return Wedge6<double>::area_coordinate(g % 3, i); };
  const double zeta = (g < 3 ? -1 : 1) / std::sqrt(3.0);
  return {{area(0) - area(1), -area(1), 0}, {area(2), area(1), 0}, {-area(2), area(0) - area(2), 0}, {0, 0, zeta}};
}

/// Strain of a displacement along axis c whose gradient is g, engineering shear.
Eigen::Matrix<double, 6, 1> strain_of(int c, const Vec3<double>& g) {
  Eigen::Matrix<double, 6, 1> e = Eigen::Matrix<double, 6, 1>::Zero();
  e[c] = g[c];
  e[3 + c] = g[(c + 1) % 3];            // xy of x, yz of y, zx of z
  e[3 + (c + 2) % 3] = g[(c + 2) % 3];  // zx of x, xy of y, yz of z
  return e;
}

template <class Element>
Eigen::MatrixXd relaxed(const Mesh& mesh, int element, bool bbar, const Elastic::Point<double>& law, const Eigen::MatrixXd& stress) {
  constexpr int points = Element::gauss_points;
  const std::span<const int> nodes = mesh.element(element);
  double x[3][Element::corners];
  for (int k = 0; k < Element::corners; ++k)
    for (int c = 0; c < 3; ++c) x[c][k] = mesh.points[nodes[k]][c] - mesh.points[nodes[0]][c];
  const ElementGeometry<Element, double> geometry(x);
  const int modes = 3 * static_cast<int>(mode_derivatives(Element{}, 0).size());
  Eigen::MatrixXd strain(6 * points, modes), mean = Eigen::MatrixXd::Zero(6, modes);
  Eigen::VectorXd volume(points);
  for (int g = 0; g < points; ++g) {
    const Jacobian<double> j = geometry.jacobian_at(g);
    volume[g] = j.det;
    int m = 0;
    for (const Vec3<double>& d : mode_derivatives(Element{}, g)) {
      const Vec3<double> gradient = (1 / j.det) * (d.x * j.bc + d.y * j.ca + d.z * j.ab);
      for (int c = 0; c < 3; ++c) strain.block<6, 1>(6 * g, m++) = strain_of(c, gradient);
    }
    mean += volume[g] * strain.middleRows<6>(6 * g);
  }
  mean /= volume.sum();
  Eigen::Matrix<double, 6, 6> stiffness = Eigen::Matrix<double, 6, 6>::Zero();
  stiffness.topLeftCorner<3, 3>().setConstant(law.lambda);
  stiffness.diagonal() += law.shear * (Eigen::Matrix<double, 6, 1>() << 2, 2, 2, 1, 1, 1).finished();
  Eigen::MatrixXd work = Eigen::MatrixXd::Zero(modes, modes), mode_stress(6 * points, modes);
  Eigen::VectorXd push = Eigen::VectorXd::Zero(modes);
  for (int g = 0; g < points; ++g) {
    auto e = strain.middleRows<6>(6 * g);
    e -= mean;  // a uniform stress does no work on them: patches of elements keep theirs
    if (bbar) e.topRows<3>().rowwise() -= (e.topRows<3>().colwise().sum() / 3).eval();
    mode_stress.middleRows<6>(6 * g) = stiffness * e;
    work += volume[g] * e.transpose() * mode_stress.middleRows<6>(6 * g);
    push += volume[g] * e.transpose() * stress.row(g).transpose();
  }
  const Eigen::VectorXd amount = work.ldlt().solve(push);
  Eigen::MatrixXd left = stress;
  for (int g = 0; g < points; ++g) left.row(g) -= (mode_stress.middleRows<6>(6 * g) * amount).transpose();
  return left;
}

}  // namespace

Eigen::MatrixXd without_incompatible(const Mesh& mesh, int element, bool bbar, const Elastic::Point<double>& law,
                                     const Eigen::MatrixXd& stress) {
  switch (mesh.shapes[element]) {
    case Shape::hex8: return relaxed<Hex8<double>>(mesh, element, bbar, law, stress);
    case Shape::wedge6: return relaxed<Wedge6<double>>(mesh, element, bbar, law, stress);
    case Shape::tet4: break;
  }
  return stress;
}

}  // namespace ashlar
