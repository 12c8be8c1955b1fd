#pragma once
/// The one place, beside cuda/, that knows CUDA: marks functions that run on both machines.

#if defined(__CUDACC__)
#define ASHLAR_HD __host__ __device__ __forceinline__
#define ASHLAR_UNROLL _Pragma("unroll")
#else
#define ASHLAR_HD inline __attribute__((always_inline))
#define ASHLAR_UNROLL _Pragma("GCC unroll 16")
#endif
