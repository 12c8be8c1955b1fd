#pragma once
/// All, beside cuda/ and the reciprocal in number.hpp, that knows CUDA: marks functions that run on both machines.
/// _CALL: long ones that few points need, kept out of the loops that call them. _HOST_CALL: a call on the CPU, in line on
/// a device.

#if defined(__CUDACC__)
#define ASHLAR_HD __host__ __device__ __forceinline__
#define ASHLAR_HD_CALL __host__ __device__ __noinline__
#define ASHLAR_HD_HOST_CALL __host__ __device__ __forceinline__
#define ASHLAR_UNROLL _Pragma("unroll")
#else
#define ASHLAR_HD inline __attribute__((always_inline))
#define ASHLAR_HD_CALL inline __attribute__((noinline))
#define ASHLAR_HD_HOST_CALL inline __attribute__((noinline))
#define ASHLAR_UNROLL _Pragma("GCC unroll 16")
#endif
