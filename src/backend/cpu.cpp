#include "backend/cpu_phases.hpp"

namespace ashlar {

std::unique_ptr<Backend> make_cpu_backend(const Setup& setup, Precision precision, int threads) {
  return precision == Precision::single_precision ? cpu_phases<float>(setup, threads)
                                                  : cpu_phases<double>(setup, threads);
}

}  // namespace ashlar
