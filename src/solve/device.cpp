#include "backend/device.hpp"

#include <charconv>

#include "base/error.hpp"

namespace ashlar {

std::optional<DeviceChoice> device_choice(const std::string& text) {
  if (text == "cpu") return DeviceChoice{DeviceChoice::cpu};
  if (text == "auto") return DeviceChoice{DeviceChoice::automatic};
  if (text == "cuda") return DeviceChoice{DeviceChoice::cuda};
  if (!text.starts_with("cuda:")) return {};
  DeviceChoice choice{DeviceChoice::cuda};
  const char* const end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data() + 5, end, choice.index);
  if (error != std::errc() || last != end || choice.index < 0) return {};
  return choice;
}

std::optional<LaneChoice> lane_choice(const std::string& text) {
  const std::string first = "stress=", second = ",thermal=";
  const std::size_t comma = text.find(second);
  if (!text.starts_with(first) || comma == std::string::npos) return {};
  const auto stress = device_choice(text.substr(first.size(), comma - first.size()));
  const auto thermal = device_choice(text.substr(comma + second.size()));
  if (!stress || !thermal) return {};
  return LaneChoice{*stress, thermal};
}

std::unique_ptr<Backend> make_backend(const Setup& setup, Precision precision, const DeviceChoice& choice,
                                      int threads) {
  if (choice.kind == DeviceChoice::cpu) return make_cpu_backend(setup, precision, threads);
  const CudaSupport support = cuda_support();
  if (choice.kind == DeviceChoice::automatic && support.devices.empty())
    return make_cpu_backend(setup, precision, threads);
  if (support.devices.empty())
    throw ResourceError("--device cuda: " + support.missing + "; --device cpu, or no --device, runs on the CPU");
  const int count = static_cast<int>(support.devices.size());
  if (choice.index >= count)
    throw ResourceError("--device cuda:" + std::to_string(choice.index) + ": there " +
                        (count == 1 ? "is one NVIDIA device, cuda:0"
                                    : "are " + std::to_string(count) + " NVIDIA devices, cuda:0 to cuda:" +
                                          std::to_string(count - 1)));
  return make_cuda_backend(setup, precision, choice.index);
}

}  // namespace ashlar
