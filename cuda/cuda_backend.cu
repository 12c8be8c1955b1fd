#include "backend/device.hpp"
#include "cuda_check.hpp"
#include "cuda_phases.hpp"

namespace ashlar {

CudaSupport cuda_support() {
  CudaSupport support{true, {}, {}};
  int count = 0;
  const cudaError_t code = cudaGetDeviceCount(&count);
  if (code != cudaSuccess || count == 0) {
    support.missing = std::string("no usable NVIDIA device (") +
                      (code == cudaSuccess ? "none found" : cudaGetErrorString(code)) + ")";
    return support;
  }
  for (int i = 0; i < count; ++i) {
    cudaDeviceProp properties{};
    check(cudaGetDeviceProperties(&properties, i), "ask device");
    CudaDevice device{properties.name, properties.major, properties.minor, 0, 0};
    check(cudaSetDevice(i), "select device");
    check(cudaMemGetInfo(&device.free_bytes, &device.memory_bytes), "ask for memory");
    support.devices.push_back(device);
  }
  return support;
}

std::unique_ptr<Backend> make_cuda_backend(const Setup& setup, Precision precision, int device) {
  return precision == Precision::single_precision ? cuda_phases<float>(setup, device)
                                                  : cuda_phases<double>(setup, device);
}

}  // namespace ashlar
