#pragma once
#include "backend/backend.hpp"

namespace ashlar {

/// Number of usable NVIDIA devices; 0 without a driver.
int cuda_device_count();

/// The phases on one device. Throws ResourceError: no such device, out of memory, a failed launch.
std::unique_ptr<Backend> make_cuda_backend(const Setup& setup, Precision precision, int device);

}  // namespace ashlar
