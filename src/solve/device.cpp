#include "backend/device.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>

#include "backend/machine_memory.hpp"
#include "base/error.hpp"

namespace ashlar {

namespace {

constexpr std::size_t unknown = std::numeric_limits<std::size_t>::max();

/// First number behind `label` in a file, or of the file where there is no label.
std::size_t number_in(const std::string& path, const std::string& label = "") {
  std::ifstream file(path);
  std::string word;
  while (!label.empty() && file >> word && word != label) {
  }
  std::size_t number = 0;
  return file >> number ? number : unknown;  // "max": no limit
}

std::string gigabytes(std::size_t bytes) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g GB", static_cast<double>(bytes) / 1e9);
  return text;
}

/// Throws ResourceError: what a model needs, what there is, what would fit.
[[noreturn]] void refuse(const Setup& setup, Precision precision, const std::string& where, std::size_t needed,
                         std::size_t free) {
  double elements = 0;
  for (const Batch& batch : setup.discretisation.batches) elements += batch.element_count;
  const double share = static_cast<double>(free) / static_cast<double>(needed);
  char text[200];
  std::snprintf(text, sizeof text, "; about %.0f of its %.0f elements would fit: make them %.2f times as long",
                std::floor(elements * share), elements, std::ceil(100 * std::cbrt(1 / share)) / 100);
  throw ResourceError("not enough memory on " + where + ": this model needs " + gigabytes(needed) + " (" +
                      std::to_string(needed) + " bytes), " + gigabytes(free) + " (" + std::to_string(free) +
                      " bytes) are free" + text +
                      (precision == Precision::double_precision ? ", or try --precision single" : ""));
}

template <class Make>
std::unique_ptr<Backend> make_within(std::size_t free, const Setup& setup, Precision precision,
                                     const std::string& where, const Make& make) {
  const MemoryLimit limit(free);
  std::unique_ptr<Backend> backend = make();
  if (backend->memory_bytes() > free) refuse(setup, precision, where, backend->memory_bytes(), free);
  return backend;
}

}  // namespace

std::size_t available_memory() {
  std::size_t free = number_in("/proc/meminfo", "MemAvailable:");
  if (free < unknown) free *= 1024;
  struct Group {
    const char *most, *used, *statistics, *reclaimable;
  };
  for (const Group& group : {Group{"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory.current",
                                   "/sys/fs/cgroup/memory.stat", "inactive_file"},
                             Group{"/sys/fs/cgroup/memory/memory.limit_in_bytes",
                                   "/sys/fs/cgroup/memory/memory.usage_in_bytes",
                                   "/sys/fs/cgroup/memory/memory.stat", "total_inactive_file"}}) {
    const std::size_t most = number_in(group.most), used = number_in(group.used);
    if (most == unknown || used == unknown) continue;
    const std::size_t files = number_in(group.statistics, group.reclaimable);  // kept by the system until needed
    const std::size_t taken = files < used ? used - files : used;
    free = std::min(free, most > taken ? most - taken : 0);
  }
  return free;
}

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

std::unique_ptr<Backend> make_backend(const Setup& setup, Precision precision, const DeviceChoice& choice, int threads,
                                      std::size_t memory) {
  const auto on_cpu = [&] {
    return make_within(memory > 0 ? memory : available_memory(), setup, precision, "this machine",
                       [&] { return make_cpu_backend(setup, precision, threads); });
  };
  if (choice.kind == DeviceChoice::cpu) return on_cpu();
  const CudaSupport support = cuda_support();
  if (choice.kind == DeviceChoice::automatic && support.devices.empty()) return on_cpu();
  if (support.devices.empty())
    throw ResourceError("--device cuda: " + support.missing + "; --device cpu, or no --device, runs on the CPU");
  const int count = static_cast<int>(support.devices.size());
  if (choice.index >= count)
    throw ResourceError("--device cuda:" + std::to_string(choice.index) + ": there " +
                        (count == 1 ? "is one NVIDIA device, cuda:0"
                                    : "are " + std::to_string(count) + " NVIDIA devices, cuda:0 to cuda:" +
                                          std::to_string(count - 1)));
  const CudaDevice& device = support.devices[choice.index];
  return make_within(memory > 0 ? memory : device.free_bytes, setup, precision,
                     "cuda:" + std::to_string(choice.index) + " (" + device.name + ")",
                     [&] { return make_cuda_backend(setup, precision, choice.index); });
}

}  // namespace ashlar
