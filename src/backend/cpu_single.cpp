#include "backend/cpu_exec.hpp"
#include "backend/cpu_phases.hpp"

namespace ashlar {

template <>
std::unique_ptr<Backend> cpu_phases<float>(const Setup& setup, int threads) {
  return std::make_unique<Phases<CpuExec, float>>(setup, CpuExec(threads));
}

}  // namespace ashlar
