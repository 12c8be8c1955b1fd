#pragma once
#include <utility>
#include <vector>

#include "backend/machine_memory.hpp"
#include "cuda_check.hpp"

namespace ashlar {

/// Device memory of trivially copyable elements. Copies wait for what runs on the device.
template <class T>
class CudaArray {
 public:
  CudaArray() = default;
  CudaArray(CudaArray&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}
  ~CudaArray() {
    MachineMemory::bytes -= size_ * sizeof(T);
    cudaFree(data_);
  }

  void resize(std::size_t n) {
    allocate(n);
    if (n > 0) check(cudaMemset(data_, 0, n * sizeof(T)), "clear memory");
  }
  void assign(const std::vector<T>& values) {
    allocate(values.size());
    upload(values);
  }
  void upload(const std::vector<T>& values) {
    if (size_ > 0)
      check(cudaMemcpy(data_, values.data(), size_ * sizeof(T), cudaMemcpyHostToDevice), "copy to device");
  }
  void download(std::vector<T>& values) const {
    values.resize(size_);
    if (size_ > 0)
      check(cudaMemcpy(values.data(), data_, size_ * sizeof(T), cudaMemcpyDeviceToHost), "copy from device");
  }
  std::size_t size() const { return size_; }
  T* data() { return data_; }
  const T* data() const { return data_; }

 private:
  void allocate(std::size_t n) {
    if (n == size_) return;
    check(cudaFree(data_), "free memory");
    data_ = nullptr;
    MachineMemory::bytes += (n - size_) * sizeof(T);
    ++MachineMemory::changes;
    size_ = n;
    if (n > 0) check(cudaMalloc(&data_, n * sizeof(T)), "allocate memory");
  }
  T* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace ashlar
