#include "backend/phases.hpp"
#include "cuda_exec.hpp"
#include "cuda_phases.hpp"

namespace ashlar {

template <>
std::unique_ptr<Backend> cuda_phases<double>(const Setup& setup, int device) {
  return std::make_unique<Phases<CudaExec, double>>(setup, CudaExec(device));
}

}  // namespace ashlar
