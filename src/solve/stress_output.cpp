#include "solve/stress_output.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <optional>

#include "model/check_mesh.hpp"
#include "physics/shapes/hex8.hpp"
#include "physics/shapes/tet4.hpp"
#include "physics/shapes/wedge6.hpp"
#include "solve/incompatible_modes.hpp"

namespace ashlar {

namespace {

/// Corner values from Gauss-point values: inverse of the shape functions at the Gauss points.
template <class Element>
Eigen::MatrixXd extrapolation() {
  if constexpr (Element::gauss_points == 1) {
    return Eigen::MatrixXd::Ones(Element::corners, 1);
  } else {
    Eigen::MatrixXd shape(Element::gauss_points, Element::corners);
    for (int g = 0; g < Element::gauss_points; ++g)
      for (int k = 0; k < Element::corners; ++k) shape(g, k) = Element::shape(g, k);
    return shape.inverse();
  }
}

const Eigen::MatrixXd& extrapolation_of(Shape shape) {
  static const Eigen::MatrixXd matrices[shape_count] = {extrapolation<Hex8<double>>(), extrapolation<Wedge6<double>>(),
                                                        extrapolation<Tet4<double>>()};
  return matrices[static_cast<int>(shape)];
}

/// Gauss-point values of one mesh element: [points x 6].
Eigen::MatrixXd gauss_values(const Batch& batch, int element, std::span<const double> gauss) {
  const int points = gauss_count(batch.shape);
  Eigen::MatrixXd values(points, 6);
  for (int g = 0; g < points; ++g)
    for (int c = 0; c < 6; ++c)
      values(g, c) = gauss[6 * static_cast<std::size_t>(batch.gauss(element - batch.first_element, g)) + c];
  return values;
}

/// Runs work(i) for all i < n on all cores.
template <class Work>
void side_by_side(int n, const Work& work) {
#pragma omp parallel for schedule(static) if (n > 1000)
  for (int i = 0; i < n; ++i) work(i);
}

/// Stress at the corners of an element that averages over it and its neighbours start from: [corners x 6].
Eigen::MatrixXd corner_stress(const Problem& p, const Batch& batch, int e, std::span<const double> gauss, bool bbar,
                              const std::optional<Elastic::Point<double>>& elastic) {
  Eigen::MatrixXd values = gauss_values(batch, e, gauss);
  // Initial stress is given, not the answer of elements to a movement; a law that flows bounds its stress already.
  if (elastic) {
    Eigen::MatrixXd initial = Eigen::MatrixXd::Zero(values.rows(), 6);
    if (!p.initial.stress.empty()) initial = gauss_values(batch, e, p.initial.stress);
    values = initial + without_incompatible(p.model.mesh, p.discretisation.source_element[e], bbar, *elastic,
                                            values - initial);
  }
  return extrapolation_of(batch.shape) * values;
}

}  // namespace

std::vector<double> gauss_stress(const Problem& p) {
  p.backend->run(Phase::block_stress);
  std::vector<double> stress = p.backend->read(Field::stress);
  for (std::size_t i = 0; i < p.initial.stress.size(); ++i) stress[i] += p.initial.stress[i];
  return stress;
}

std::vector<double> element_stress(const Problem& p, std::span<const double> gauss) {
  std::vector<double> stress(6 * static_cast<std::size_t>(p.model.mesh.element_count()));
  for (const Batch& batch : p.discretisation.batches)
    side_by_side(batch.element_count, [&](int i) {
      const int e = batch.first_element + i;
      const Eigen::MatrixXd values = gauss_values(batch, e, gauss);
      const auto element = static_cast<std::size_t>(p.discretisation.source_element[e]);
      for (int c = 0; c < 6; ++c) stress[6 * element + c] = values.col(c).mean();
    });
  return stress;
}

std::vector<double> nodal_stress(const Problem& p, std::span<const double> gauss) {
  const Mesh& mesh = p.model.mesh;
  const auto nodes = static_cast<std::size_t>(p.blocks.node_count());
  std::vector<int> region(nodes, static_cast<int>(mesh.region_names.size()));
  for (int e = 0; e < mesh.element_count(); ++e)
    for (int s = mesh.first_corner[e]; s < mesh.first_corner[e + 1]; ++s)
      region[p.blocks.corners[s]] = std::min(region[p.blocks.corners[s]], mesh.regions[e]);
  const Setup setup = p.setup();
  std::vector<double> stress(6 * nodes), weight(nodes);
  constexpr int at_once = 1 << 16;  // elements: found on all cores, then summed in their order
  std::vector<Eigen::MatrixXd> corner;
  for (const Batch& batch : p.discretisation.batches) {
    const BlockLaw& law = setup.laws[batch.material];
    std::optional<Elastic::Point<double>> elastic;
    if (history_size(law) == 0)
      elastic = std::visit([](const auto& l) { return l.template prepare<double>().elastic(); }, law);
    const int end = batch.first_element + batch.element_count;
    for (int first = batch.first_element; first < end; first += at_once) {
      corner.resize(std::min(at_once, end - first));
      side_by_side(static_cast<int>(corner.size()), [&](int i) {
        corner[i] = corner_stress(p, batch, first + i, gauss, setup.bbar[batch.material], elastic);
      });
      for (std::size_t i = 0; i < corner.size(); ++i) {
        const int element = p.discretisation.source_element[first + static_cast<int>(i)];
        const double w = element_volume(mesh, element);
        for (int k = 0; k < corner[i].rows(); ++k) {
          const auto n = static_cast<std::size_t>(p.blocks.corners[mesh.first_corner[element] + k]);
          if (region[n] != mesh.regions[element]) continue;
          weight[n] += w;
          for (int c = 0; c < 6; ++c) stress[6 * n + c] += w * corner[i](k, c);
        }
      }
    }
  }
  for (std::size_t n = 0; n < nodes; ++n)
    for (int c = 0; c < 6; ++c) stress[6 * n + c] /= weight[n];
  return stress;
}

std::vector<double> principal_stress(std::span<const double> stress) {
  std::vector<double> principal(stress.size() / 2);
  side_by_side(static_cast<int>(stress.size() / 6), [&](int i) {
    const double* s = &stress[6 * static_cast<std::size_t>(i)];
    Eigen::Matrix3d tensor;
    tensor << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
    const Eigen::Vector3d values =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(tensor, Eigen::EigenvaluesOnly).eigenvalues();
    for (int k = 0; k < 3; ++k) principal[3 * static_cast<std::size_t>(i) + k] = values[2 - k];
  });
  return principal;
}

}  // namespace ashlar
