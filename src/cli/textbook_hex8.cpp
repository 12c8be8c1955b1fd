#include "cli/textbook_hex8.hpp"

#include <cmath>

namespace ashlar {

void textbook_hex8_force(const double (&x)[8][3], const double (&u)[8][3], double lambda, double shear,
                         double (&f)[8][3]) {
  constexpr double side[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                 {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
  for (auto& corner : f) corner[0] = corner[1] = corner[2] = 0;
  for (const auto& point : side) {
    double at[3], local[8][3], jacobian[3][3] = {};
    for (int i = 0; i < 3; ++i) at[i] = point[i] / std::sqrt(3.0);
    for (int k = 0; k < 8; ++k) {
      const double a = 1 + side[k][0] * at[0], b = 1 + side[k][1] * at[1], c = 1 + side[k][2] * at[2];
      local[k][0] = side[k][0] * b * c / 8;
      local[k][1] = side[k][1] * a * c / 8;
      local[k][2] = side[k][2] * a * b / 8;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) jacobian[i][j] += local[k][i] * x[k][j];
    }
    double inverse[3][3];
    const auto minor = [&](int i, int j) {
      const int p = (i + 1) % 3, q = (i + 2) % 3, r = (j + 1) % 3, s = (j + 2) % 3;
      return jacobian[p][r] * jacobian[q][s] - jacobian[p][s] * jacobian[q][r];
    };
    const double det = jacobian[0][0] * minor(0, 0) + jacobian[0][1] * minor(0, 1) + jacobian[0][2] * minor(0, 2);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) inverse[i][j] = minor(j, i) / det;

    double gradient[8][3], strain[6] = {};
    for (int k = 0; k < 8; ++k) {
      for (int i = 0; i < 3; ++i)
        gradient[k][i] = inverse[i][0] * local[k][0] + inverse[i][1] * local[k][1] + inverse[i][2] * local[k][2];
      const double *g = gradient[k], *v = u[k];
      strain[0] += g[0] * v[0];
      strain[1] += g[1] * v[1];
      strain[2] += g[2] * v[2];
      strain[3] += g[1] * v[0] + g[0] * v[1];
      strain[4] += g[2] * v[1] + g[1] * v[2];
      strain[5] += g[0] * v[2] + g[2] * v[0];
    }
    const double pressure = lambda * (strain[0] + strain[1] + strain[2]);
    const double s[6] = {pressure + 2 * shear * strain[0], pressure + 2 * shear * strain[1],
                         pressure + 2 * shear * strain[2], shear * strain[3],
                         shear * strain[4],                shear * strain[5]};
    for (int k = 0; k < 8; ++k) {
      const double* g = gradient[k];
      f[k][0] += (g[0] * s[0] + g[1] * s[3] + g[2] * s[5]) * det;
      f[k][1] += (g[1] * s[1] + g[0] * s[3] + g[2] * s[4]) * det;
      f[k][2] += (g[2] * s[2] + g[1] * s[4] + g[0] * s[5]) * det;
    }
  }
}

}  // namespace ashlar
