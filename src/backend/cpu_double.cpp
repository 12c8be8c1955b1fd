#include "backend/cpu_exec.hpp"
#include "backend/cpu_phases.hpp"

namespace ashlar {

template <>
std::unique_ptr<Backend> cpu_phases<double>(const Setup& setup, int threads) {
  return std::make_unique<Phases<CpuExec, double>>(setup, CpuExec(threads));
}

}  // namespace ashlar
