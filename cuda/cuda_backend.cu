#include <cuda_runtime.h>

#include <utility>

#include "backend/phases.hpp"
#include "base/error.hpp"
#include "cuda_backend.hpp"

namespace ashlar {

namespace {

void check(cudaError_t code, const char* what) {
  if (code != cudaSuccess) throw ResourceError(std::string("CUDA: ") + what + ": " + cudaGetErrorString(code));
}

template <class Kernel>
__global__ void run_kernel(int first, int n, const Kernel kernel) {
  const int i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i < n) kernel(first + i);
}

/// Memory and loops of one NVIDIA device.
class CudaExec {
 public:
  template <class T>
  class Array {
   public:
    Array() = default;
    Array(const Array&) = delete;
    Array& operator=(const Array&) = delete;
    ~Array() { cudaFree(data_); }

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

   private:
    void allocate(std::size_t n) {
      check(cudaFree(data_), "free memory");
      data_ = nullptr;
      size_ = n;
      if (n > 0) check(cudaMalloc(&data_, n * sizeof(T)), "allocate memory");
    }
    T* data_ = nullptr;
    std::size_t size_ = 0;
  };

  explicit CudaExec(int device) {
    check(cudaSetDevice(device), "select device");
    cudaDeviceProp properties{};
    check(cudaGetDeviceProperties(&properties, device), "ask device");
    name_ = properties.name;
  }
  std::string name() const { return name_; }

  template <class Kernel>
  void for_each(int n, const Kernel& kernel) const {
    for_range(0, n, kernel);
  }

  /// Corner forces of every element, then the sums of each patch.
  template <template <class> class Element, bool Warm, class Point, class Real>
  void block_forces(const BodyView<Real>& body, const BatchView& batch, const Point& law, const Discretisation& d,
                    int b) const {
    for_each(batch.element_count, BlockForce<Element, Point, Real, Warm>{body, batch, law});
    const int first = d.blocks.patch_first_entry[d.batches[b].first_patch];
    const int last = d.blocks.patch_first_entry[d.batches[b].first_patch + d.batches[b].patch_count];
    for_range(first, last - first, GatherPatch<Real, 3>{body.nodes, body.corner_force, body.partial, body.force});
  }

 private:
  template <class Kernel>
  void for_range(int first, int n, const Kernel& kernel) const {
    constexpr int group = 128;
    if (n <= 0) return;
    run_kernel<<<(n + group - 1) / group, group>>>(first, n, kernel);
    check(cudaGetLastError(), "launch");
  }
  std::string name_;
};

}  // namespace

int cuda_device_count() {
  int count = 0;
  return cudaGetDeviceCount(&count) == cudaSuccess ? count : 0;
}

std::unique_ptr<Backend> make_cuda_backend(const Setup& setup, Precision precision, int device) {
  if (precision == Precision::single_precision)
    return std::make_unique<Phases<CudaExec, float>>(setup, CudaExec(device));
  return std::make_unique<Phases<CudaExec, double>>(setup, CudaExec(device));
}

}  // namespace ashlar
