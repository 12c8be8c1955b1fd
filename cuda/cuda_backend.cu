#include "backend/phases.hpp"
#include "cuda_backend.hpp"
#include "cuda_exec.hpp"

namespace ashlar {

int cuda_device_count() {
  int count = 0;
  return cudaGetDeviceCount(&count) == cudaSuccess ? count : 0;
}

std::unique_ptr<Backend> make_cuda_backend(const Setup& setup, Precision precision, int device) {
  if (precision == Precision::single_precision)
    return std::make_unique<Phases<CudaExec, float>>(setup, CudaExec(device));
  return std::make_unique<Phases<CudaExec, double>>(setup, CudaExec(device));
}

}  // namespace ashlar
