#pragma once
#include "backend/device.hpp"

namespace ashlar {

/// The phases on one NVIDIA device. Each precision has a source of its own, so that two cores compile them.
template <class Real>
std::unique_ptr<Backend> cuda_phases(const Setup& setup, int device);
template <>
std::unique_ptr<Backend> cuda_phases<double>(const Setup& setup, int device);
template <>
std::unique_ptr<Backend> cuda_phases<float>(const Setup& setup, int device);

}  // namespace ashlar
