#pragma once
#include <cmath>

#include "base/hd.hpp"

/// Arithmetic that gives the same bits on every machine: + - * / sqrt and explicit fma (numerics 8).
/// Physics is templated on the number type V: float, double, or a vector pack of either (backend/pack.hpp);
/// packs bring their own overloads, found by argument-dependent lookup.
namespace ashlar {

ASHLAR_HD double fma(double a, double b, double c) { return ::fma(a, b, c); }
ASHLAR_HD float fma(float a, float b, float c) { return ::fmaf(a, b, c); }
ASHLAR_HD double root(double a) { return ::sqrt(a); }
ASHLAR_HD float root(float a) { return ::sqrtf(a); }

/// 1 / a of a normal number whose reciprocal is normal, correctly rounded. Devices begin with their own estimate and
/// refine it (Markstein 1990): a general division would branch, and a branch keeps the compiler from weaving the Gauss
/// points of an element together.
ASHLAR_HD double reciprocal(double a) {
#ifdef __CUDA_ARCH__
  double r;
  asm("rcp.approx.ftz.f64 %0, %1;" : "=d"(r) : "d"(a));
  double e = ::fma(-a, r, 1.0);
  e = ::fma(e, e, e);
  r = ::fma(e, r, r);
  return ::fma(::fma(-a, r, 1.0), r, r);
#else
  return 1 / a;
#endif
}
ASHLAR_HD float reciprocal(float a) {
#ifdef __CUDA_ARCH__
  float r;
  asm("rcp.approx.ftz.f32 %0, %1;" : "=f"(r) : "f"(a));
  return ::fmaf(::fmaf(-a, r, 1.0f), r, r);
#else
  return 1 / a;
#endif
}

/// sqrt(a) of a between 1e-28 (1e-280 in double) and 1e28, correctly rounded. Devices take the compiler's own steps
/// without the branch it puts before them for other numbers.
ASHLAR_HD double normal_root(double a) {
#ifdef __CUDA_ARCH__
  double r;
  asm("rsqrt.approx.ftz.f64 %0, %1;" : "=d"(r) : "d"(a));
  const double e = ::fma(r * r, -a, 1.0);
  r = ::fma(::fma(e, 0.375, 0.5), r * e, r);
  const double g = a * r;
  return ::fma(::fma(g, -g, a), 0.5 * r, g);
#else
  return ::sqrt(a);
#endif
}
ASHLAR_HD float normal_root(float a) {
#ifdef __CUDA_ARCH__
  float r;
  asm("rsqrt.approx.ftz.f32 %0, %1;" : "=f"(r) : "f"(a));
  const float g = a * r;
  return ::fmaf(::fmaf(-g, g, a), 0.5f * r, g);
#else
  return ::sqrtf(a);
#endif
}
/// What a sum of squares begins with that is to go into normal_root(): nothing beside stresses in Pa.
template <class T>
inline constexpr T least_square = sizeof(T) == 4 ? T(1e-28f) : T(1e-280);

/// Keeps a device's compiler from keeping, instead of working out again, what it has worked out from `a`: registers are
/// dearer than arithmetic there.
template <class V>
ASHLAR_HD void forget(V& a) {
#ifdef __CUDA_ARCH__
  if constexpr (sizeof(V) == 8)
    asm volatile("" : "+d"(a));
  else
    asm volatile("" : "+f"(a));
#else
  (void)a;
#endif
}

/// a < b ? x : y, lane by lane.
template <class T>
ASHLAR_HD T if_less(T a, T b, T x, T y) {
  return a < b ? x : y;
}
template <class T>
ASHLAR_HD T larger(T a, T b) {
  return if_less(a, b, b, a);
}
template <class T>
ASHLAR_HD T smaller(T a, T b) {
  return if_less(b, a, b, a);
}

/// The scalar behind a number type: float for float, double for double; packs specialise it.
template <class V>
struct ScalarOf {
  using type = V;
};
template <class V>
using Scalar = typename ScalarOf<V>::type;

/// Lanes of a number type, for the few things that are done lane by lane; packs bring their own.
template <class V>
inline constexpr int lane_count = 1;
template <class T>
ASHLAR_HD T lane(T a, int) {
  return a;
}
template <class T>
ASHLAR_HD void set_lane(T& a, int, T value) {
  a = value;
}

}  // namespace ashlar
