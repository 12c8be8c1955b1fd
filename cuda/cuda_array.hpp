#pragma once
#include <stdexcept>
#include <utility>
#include <vector>

#include "backend/machine_memory.hpp"
#include "cuda_check.hpp"

namespace ashlar {

/// Device memory of trivially copyable elements. Copies go behind what runs in the stream of the present thread.
template <class T>
class CudaArray {
 public:
  CudaArray() = default;
  CudaArray(CudaArray&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}
  ~CudaArray() {
    MachineMemory::book(size_ * sizeof(T), 0);
    cudaFree(data_);
  }

  void resize(std::size_t n) {
    allocate(n);
    if (data_) check(cudaMemsetAsync(data_, 0, n * sizeof(T), cudaStreamPerThread), "clear memory");
  }
  void assign(const std::vector<T>& values) {
    allocate(values.size());
    upload(values);
  }
  void upload(const std::vector<T>& values) {
    if (!data_) return;
    check(cudaMemcpyAsync(data_, values.data(), size_ * sizeof(T), cudaMemcpyHostToDevice, cudaStreamPerThread),
          "copy to device");
  }
  void download(std::vector<T>& values) const {
    values.resize(size_);
    if (size_ == 0) return;
    check(cudaMemcpyAsync(values.data(), data_, size_ * sizeof(T), cudaMemcpyDeviceToHost, cudaStreamPerThread),
          "copy from device");
    check(cudaStreamSynchronize(cudaStreamPerThread), "wait for a copy");
  }
  /// From an array of this size, on this device or on another, whose stream has nothing left to do.
  void copy(const CudaArray& other) {
    if (other.size_ != size_) throw std::logic_error("copy of another size");
    if (size_ == 0) return;
    int here = 0;
    cudaPointerAttributes there{};
    check(cudaGetDevice(&here), "ask for the device");
    check(cudaPointerGetAttributes(&there, other.data_), "ask for the device");
    let_peers_meet(here, there.device);
    check(cudaMemcpyPeerAsync(data_, here, other.data_, there.device, size_ * sizeof(T), cudaStreamPerThread),
          "copy between devices");
  }
  std::size_t size() const { return size_; }
  T* data() { return data_; }
  const T* data() const { return data_; }

 private:
  /// Copies go straight from one device to the other where the machine can; else the driver takes them by the host.
  static void let_peers_meet(int here, int there) {
    int can = 0;
    if (here == there || cudaDeviceCanAccessPeer(&can, here, there) != cudaSuccess || !can) return;
    if (cudaDeviceEnablePeerAccess(there, 0) != cudaSuccess) cudaGetLastError();  // mostly: they have met before
  }
  void allocate(std::size_t n) {
    if (n == size_) return;
    check(cudaFree(data_), "free memory");
    data_ = nullptr;
    ++MachineMemory::changes;
    const bool fits = MachineMemory::book(std::exchange(size_, n) * sizeof(T), n * sizeof(T));
    if (n > 0 && fits) check(cudaMalloc(&data_, n * sizeof(T)), "allocate memory");
  }
  T* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace ashlar
