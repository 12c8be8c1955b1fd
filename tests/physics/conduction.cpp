#include "physics/conduction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ashlar {
namespace {

/// Textbook element, written without anything of the product: shape functions and derivatives at natural coordinates,
/// inverse Jacobian and the matrix of gradients at every Gauss point.
struct GaussPoint {
  double weight;
  std::vector<double> shape;
  std::vector<std::array<double, 3>> derivative;
};

const double hex_signs[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};

std::vector<GaussPoint> textbook_points(int corners) {
  const double g = 1 / std::sqrt(3.0);
  std::vector<GaussPoint> points;
  if (corners == 8) {
    for (double c : {-g, g})  // the order of the product: bits (xi, eta, zeta)
      for (double b : {-g, g})
        for (double a : {-g, g}) {
          GaussPoint p{1, {}, {}};
          for (const auto& s : hex_signs) {
            const double x = 1 + s[0] * a, y = 1 + s[1] * b, z = 1 + s[2] * c;
            p.shape.push_back(x * y * z / 8);
            p.derivative.push_back({s[0] * y * z / 8, s[1] * x * z / 8, s[2] * x * y / 8});
          }
          points.push_back(p);
        }
  } else if (corners == 6) {
    for (double c : {-g, g})
      for (const auto& [r, s] :
           {std::pair{1 / 6.0, 1 / 6.0}, std::pair{2 / 3.0, 1 / 6.0}, std::pair{1 / 6.0, 2 / 3.0}}) {
        GaussPoint p{1 / 6.0, {}, {}};
        const double area[3] = {1 - r - s, r, s}, dr[3] = {-1, 1, 0}, ds[3] = {-1, 0, 1};
        for (double side : {-1.0, 1.0})
          for (int i = 0; i < 3; ++i) {
            p.shape.push_back(area[i] * (1 + side * c) / 2);
            p.derivative.push_back({dr[i] * (1 + side * c) / 2, ds[i] * (1 + side * c) / 2, side * area[i] / 2});
          }
        points.push_back(p);
      }
  } else {
    points.push_back({1 / 6.0, {.25, .25, .25, .25}, {{-1, -1, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
  }
  return points;
}

struct Gradients {
  double volume;                                // det * weight
  std::vector<std::array<double, 3>> gradient;  // of every shape function
};

template <int n>
Gradients gradients_at(const GaussPoint& p, const double (&x)[3][n]) {
  double j[3][3] = {};  // j[a][i] = dx_i/dxi_a
  for (int a = 0; a < 3; ++a)
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < n; ++k) j[a][i] += p.derivative[k][a] * x[i][k];
  double cofactor[3][3];
  for (int a = 0; a < 3; ++a)
    for (int i = 0; i < 3; ++i)
      cofactor[a][i] = j[(a + 1) % 3][(i + 1) % 3] * j[(a + 2) % 3][(i + 2) % 3] -
                       j[(a + 1) % 3][(i + 2) % 3] * j[(a + 2) % 3][(i + 1) % 3];
  const double det = j[0][0] * cofactor[0][0] + j[0][1] * cofactor[0][1] + j[0][2] * cofactor[0][2];
  Gradients result{det * p.weight, {}};
  for (int k = 0; k < n; ++k) {
    std::array<double, 3> grad{};
    for (int i = 0; i < 3; ++i)
      for (int a = 0; a < 3; ++a) grad[i] += cofactor[a][i] / det * p.derivative[k][a];
    result.gradient.push_back(grad);
  }
  return result;
}

template <class Element>
class Conduction : public testing::Test {
 protected:
  static constexpr int n = Element::corners;
  double x[3][n];

  Conduction() {
    const double wedge[6][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
    const double tet[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int k = 0; k < n; ++k)
      for (int i = 0; i < 3; ++i) {
        const double reference = n == 8 ? 0.5 + 0.5 * hex_signs[k][i] : n == 6 ? wedge[k % 6][i] : tet[k % 4][i];
        x[i][k] = (1.0 + i) * reference + 0.15 * std::sin(7.0 * k + 3.0 * i + 1);
      }
  }
};
using Elements = testing::Types<Hex8<double>, Wedge6<double>, Tet4<double>>;
TYPED_TEST_SUITE(Conduction, Elements);

TYPED_TEST(Conduction, heat_flow_of_a_distorted_element_is_the_textbook_integral) {
  constexpr int n = TypeParam::corners;
  const double conductivity = 2.7;
  double temperature[n], flow[n], expected[n] = {}, scale = 0;
  for (int k = 0; k < n; ++k) temperature[k] = 20 * std::cos(5.0 * k);
  for (const GaussPoint& p : textbook_points(n)) {
    const Gradients at = gradients_at(p, this->x);
    ASSERT_GT(at.volume, 0);
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < n; ++k)
        for (int d = 0; d < 3; ++d)
          expected[i] += conductivity * at.volume * at.gradient[i][d] * at.gradient[k][d] * temperature[k];
  }
  heat_flow<TypeParam>(this->x, temperature, conductivity, flow);
  for (int i = 0; i < n; ++i) scale = std::max(scale, std::abs(expected[i]));
  for (int i = 0; i < n; ++i) EXPECT_NEAR(flow[i], expected[i], 1e-13 * scale) << "corner " << i;
}

TYPED_TEST(Conduction, single_precision_agrees_with_double_to_its_rounding) {
  constexpr int n = TypeParam::corners;
  using Single = std::conditional_t<n == 8, Hex8<float>, std::conditional_t<n == 6, Wedge6<float>, Tet4<float>>>;
  double temperature[n], flow[n], scale = 0;
  float x[3][n], single_temperature[n], single_flow[n];
  for (int k = 0; k < n; ++k) {
    single_temperature[k] = static_cast<float>(20 * std::cos(5.0 * k));
    temperature[k] = single_temperature[k];
    for (int i = 0; i < 3; ++i) this->x[i][k] = x[i][k] = static_cast<float>(this->x[i][k]);
  }
  heat_flow<TypeParam>(this->x, temperature, 2.7, flow);
  heat_flow<Single>(x, single_temperature, 2.7f, single_flow);
  for (int i = 0; i < n; ++i) scale = std::max(scale, std::abs(flow[i]));
  for (int i = 0; i < n; ++i) EXPECT_NEAR(single_flow[i], flow[i], 2e-6 * scale);
}

TYPED_TEST(Conduction, a_uniform_temperature_drives_no_heat_at_all) {
  constexpr int n = TypeParam::corners;
  double temperature[n], flow[n];
  for (double& t : temperature) t = 28.2;
  heat_flow<TypeParam>(this->x, temperature, 2.7, flow);
  for (int i = 0; i < n; ++i) EXPECT_EQ(flow[i], 0);
}

TYPED_TEST(Conduction, a_linear_field_flows_out_of_every_corner_as_the_exact_flux_through_its_share_of_the_surface) {
  // grad T constant: flow_i = k grad T . integral of grad N_i dV, and sum_i flow_i x_i = k V grad T (divergence
  // theorem)
  constexpr int n = TypeParam::corners;
  const double gradient[3] = {3, -2, 5}, conductivity = 2.7;
  double temperature[n], flow[n], volumes[n], volume = 0, sum = 0;
  for (int k = 0; k < n; ++k) {
    temperature[k] = 15;
    for (int i = 0; i < 3; ++i) temperature[k] += gradient[i] * this->x[i][k];
  }
  heat_flow<TypeParam>(this->x, temperature, conductivity, flow);
  corner_volumes<TypeParam>(this->x, volumes);
  for (double v : volumes) volume += v;
  for (int k = 0; k < n; ++k) sum += flow[k];
  EXPECT_NEAR(sum, 0, 1e-13 * conductivity * volume * 10);
  for (int i = 0; i < 3; ++i) {
    double moment = 0;
    for (int k = 0; k < n; ++k) moment += flow[k] * this->x[i][k];
    EXPECT_NEAR(moment, conductivity * volume * gradient[i], 1e-12 * conductivity * volume);
  }
}

TYPED_TEST(Conduction, corner_volumes_are_the_textbook_integrals_of_the_shape_functions) {
  constexpr int n = TypeParam::corners;
  double volumes[n], expected[n] = {}, total = 0;
  for (const GaussPoint& p : textbook_points(n)) {
    const double volume = gradients_at(p, this->x).volume;
    total += volume;
    for (int k = 0; k < n; ++k) expected[k] += p.shape[k] * volume;
  }
  corner_volumes<TypeParam>(this->x, volumes);
  for (int k = 0; k < n; ++k) EXPECT_NEAR(volumes[k], expected[k], 1e-14 * total);
}

TYPED_TEST(Conduction, temperature_at_gauss_points_is_interpolated_with_the_shape_functions) {
  constexpr int n = TypeParam::corners;
  double temperature[n];
  for (int k = 0; k < n; ++k) temperature[k] = 20 * std::cos(5.0 * k);
  const auto points = textbook_points(n);
  ASSERT_EQ(static_cast<int>(points.size()), TypeParam::gauss_points);
  for (int g = 0; g < TypeParam::gauss_points; ++g) {
    double expected = 0;
    for (int k = 0; k < n; ++k) expected += points[g].shape[k] * temperature[k];
    EXPECT_NEAR(at_gauss_point<TypeParam>(temperature, g), expected, 1e-14 * 20);
  }
}

}  // namespace
}  // namespace ashlar
