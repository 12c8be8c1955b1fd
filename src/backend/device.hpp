#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "backend/backend.hpp"

/// The machines that a run can use.
namespace ashlar {

/// Where a run computes: `--device`.
struct DeviceChoice {
  enum Kind { cpu, cuda, automatic } kind = automatic;
  int index = 0;  ///< of an NVIDIA device
};
/// Where each lane of a run computes: `--devices`. Where none is given for heat, one device does both in turns.
struct LaneChoice {
  DeviceChoice stress;
  std::optional<DeviceChoice> thermal;
};
/// "stress=cuda:0,thermal=cuda:1"; empty: another text.
std::optional<LaneChoice> lane_choice(const std::string& text);

/// "cpu", "cuda", "cuda:1" or "auto"; empty: another text.
std::optional<DeviceChoice> device_choice(const std::string& text);

struct CudaDevice {
  std::string name;
  int major = 0, minor = 0;                  ///< compute capability
  std::size_t memory_bytes = 0, free_bytes = 0;
};

/// What the CUDA part of this build says; implemented in cuda/, with nvcc or without.
struct CudaSupport {
  bool built = false;                ///< compiled by nvcc
  std::string missing;               ///< why no device can be used; empty: there are some
  std::vector<CudaDevice> devices;
};
CudaSupport cuda_support();

/// The phases on one NVIDIA device. Throws ResourceError: no such device, too little memory, a failed launch.
std::unique_ptr<Backend> make_cuda_backend(const Setup& setup, Precision precision, int device);

/// Bytes of memory that this process could still take: of the machine, or of the control group that it runs in.
std::size_t available_memory();

/// The backend that was chosen; automatic: the first NVIDIA device, else the CPU. Throws ResourceError, also where its
/// arrays would not fit: nothing beyond the free memory is allocated to find out.
/// @param memory bytes that it may take; 0: what is free
std::unique_ptr<Backend> make_backend(const Setup& setup, Precision precision, const DeviceChoice& choice, int threads,
                                      std::size_t memory = 0);

}  // namespace ashlar
