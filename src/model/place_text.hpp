#pragma once
#include <cstdio>
#include <string>

#include "base/tensor.hpp"

/// Numbers and places as messages show them.
namespace ashlar {

inline std::string number_text(double v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", v);
  return text;
}

/// "(x, y, z)"
inline std::string place_text(const Vec3<double>& p) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.6g, %.6g, %.6g)", p.x + 0.0, p.y + 0.0, p.z + 0.0);  // no -0
  return text;
}

}  // namespace ashlar
