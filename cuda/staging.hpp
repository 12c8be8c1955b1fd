#pragma once
#include <cstdint>

/// Copies between global and shared memory by one thread group: 16 bytes a thread where both sides are aligned alike.
namespace ashlar {

template <class Real>
inline constexpr int reals_in_16_bytes = 16 / static_cast<int>(sizeof(Real));

/// How far number i of an array lies behind the last 16-byte border; its place in shared memory has to lie as far.
template <class Real>
__device__ __forceinline__ int behind_border(int i) {
  return i & (reals_in_16_bytes<Real> - 1);
}

/// Starts a copy of one number from global to shared memory that needs no register.
template <class Real>
__device__ __forceinline__ void copy_async(Real* shared, const Real* global) {
  const unsigned to = static_cast<unsigned>(__cvta_generic_to_shared(shared));
  asm volatile("cp.async.ca.shared.global [%0], [%1], %2;\n" ::"r"(to), "l"(global), "n"(sizeof(Real)));
}
__device__ __forceinline__ void copy_16_bytes_async(void* shared, const void* global) {
  const unsigned to = static_cast<unsigned>(__cvta_generic_to_shared(shared));
  asm volatile("cp.async.cg.shared.global [%0], [%1], 16;\n" ::"r"(to), "l"(global));
}
__device__ __forceinline__ void wait_for_copies() { asm volatile("cp.async.wait_all;\n" ::: "memory"); }

/// Calls single(i) and whole(i) for the numbers of a span: those before the first and behind the last 16-byte border
/// one by one, the others 16 bytes at a time.
template <class Real, int threads, class Single, class Whole>
__device__ __forceinline__ void each_16_bytes(int first, int count, const Single& single, const Whole& whole) {
  constexpr int per = reals_in_16_bytes<Real>;
  const int until = (per - behind_border<Real>(first)) & (per - 1);
  const int head = until < count ? until : count;
  const int wholes = (count - head) / per, tail = head + wholes * per;
  const int t = threadIdx.x;
  if (t < head) single(t);
  if (t < count - tail) single(tail + t);
  for (int i = t; i < wholes; i += threads) whole(head + i * per);
}

/// Starts the copy of array[first .. first + count) to shared memory; see behind_border() for `shared`.
template <int threads, class Real>
__device__ __forceinline__ void load_span(Real* shared, const Real* array, int first, int count) {
  each_16_bytes<Real, threads>(
      first, count, [&](int i) { copy_async(shared + i, array + first + i); },
      [&](int i) { copy_16_bytes_async(shared + i, array + first + i); });
}
template <int threads, class Real>
__device__ __forceinline__ void store_span(Real* array, int first, int count, const Real* shared) {
  each_16_bytes<Real, threads>(
      first, count, [&](int i) { array[first + i] = shared[i]; },
      [&](int i) {
        *reinterpret_cast<uint4*>(array + first + i) = *reinterpret_cast<const uint4*>(shared + i);
      });
}

/// Asks for array[first .. first + count) in the second-level cache, where the device can; one thread does.
template <class T>
__device__ __forceinline__ void prefetch_span(const T* array, int first, int count) {
#if __CUDA_ARCH__ >= 900
  const auto begin = reinterpret_cast<std::uintptr_t>(array + first) & ~std::uintptr_t{15};
  const auto end = reinterpret_cast<std::uintptr_t>(array + first + count) & ~std::uintptr_t{15};
  if (end > begin)
    asm volatile("cp.async.bulk.prefetch.L2.global [%0], %1;\n" ::"l"(begin), "r"(static_cast<unsigned>(end - begin)));
#endif
}

}  // namespace ashlar
