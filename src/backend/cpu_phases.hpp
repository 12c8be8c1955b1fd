#pragma once
#include "backend/backend.hpp"

namespace ashlar {

/// The phases on the CPU. Each precision has a source of its own, so that two cores compile them.
template <class Real>
std::unique_ptr<Backend> cpu_phases(const Setup& setup, int threads);
template <>
std::unique_ptr<Backend> cpu_phases<double>(const Setup& setup, int threads);
template <>
std::unique_ptr<Backend> cpu_phases<float>(const Setup& setup, int threads);

}  // namespace ashlar
