#pragma once
#include <cuda_runtime.h>

#include <string>

#include "base/error.hpp"

namespace ashlar {

/// Throws ResourceError unless a call of the CUDA runtime succeeded.
inline void check(cudaError_t code, const char* what) {
  if (code != cudaSuccess) throw ResourceError(std::string("CUDA: ") + what + ": " + cudaGetErrorString(code));
}

}  // namespace ashlar
