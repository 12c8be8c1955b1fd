#pragma once
/// The one place, beside cuda/, that knows CUDA: marks functions that run on both machines.

#if defined(__CUDACC__)
#define ASHLAR_HD __host__ __device__ __forceinline__
#else
#define ASHLAR_HD inline __attribute__((always_inline))
#endif
