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

template <class T>
ASHLAR_HD T larger(T a, T b) {
  return a < b ? b : a;
}
template <class T>
ASHLAR_HD T smaller(T a, T b) {
  return b < a ? b : a;
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
