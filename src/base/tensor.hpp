#pragma once
#include "base/number.hpp"

namespace ashlar {

template <class T>
struct Vec3 {
  T x{}, y{}, z{};
  ASHLAR_HD T& operator[](int i) { return (&x)[i]; }
  ASHLAR_HD const T& operator[](int i) const { return (&x)[i]; }
};

template <class T>
ASHLAR_HD Vec3<T> operator+(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
ASHLAR_HD Vec3<T> operator-(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
ASHLAR_HD Vec3<T> operator*(T s, const Vec3<T>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class T>
ASHLAR_HD T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return fma(a.z, b.z, fma(a.y, b.y, a.x * b.x));
}
template <class T>
ASHLAR_HD Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {fma(a.y, b.z, -(a.z * b.y)), fma(a.z, b.x, -(a.x * b.z)), fma(a.x, b.y, -(a.y * b.x))};
}
template <class T>
ASHLAR_HD T norm(const Vec3<T>& a) {
  return root(dot(a, a));
}

/// Symmetric second-order tensor, components xx yy zz xy yz zx.
/// A strain carries engineering shear (gamma = 2 eps) in its last three components; a stress carries sigma.
template <class T>
struct Sym3 {
  T xx{}, yy{}, zz{}, xy{}, yz{}, zx{};
  ASHLAR_HD T& operator[](int i) { return (&xx)[i]; }
  ASHLAR_HD const T& operator[](int i) const { return (&xx)[i]; }
};

}  // namespace ashlar
