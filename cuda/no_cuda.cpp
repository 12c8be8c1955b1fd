#include "backend/device.hpp"
#include "base/error.hpp"

/// What a build without nvcc says.
namespace ashlar {

CudaSupport cuda_support() { return {false, "this build has no CUDA backend, nvcc was not found when it was made", {}}; }

std::unique_ptr<Backend> make_cuda_backend(const Setup&, Precision, int) { throw ResourceError(cuda_support().missing); }

}  // namespace ashlar
