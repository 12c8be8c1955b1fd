#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cluster_kernel.hpp"
#include "cuda_array.hpp"
#include "kernels/gather.hpp"
#include "kernels/sum.hpp"
#include "patch_kernels.hpp"
#include "resident_kernel.hpp"

namespace ashlar {

template <class Kernel>
__global__ void run_kernel(int first, int n, const Kernel kernel) {
  const int i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i < n) kernel(first + i);
}

/// One chunk of items a thread group -> its numbers by halves (kernels/sum.hpp).
template <int count, class How, class Terms>
__global__ void __launch_bounds__(chunk_items) combine_chunk(int n, const Terms terms, double* of_chunk) {
  __shared__ double value[count][chunk_items];
  const int item = blockIdx.x * chunk_items + threadIdx.x;
  double term[count];
  for (int k = 0; k < count; ++k) term[k] = How::start;
  if (item < n) terms(item, term);
  for (int k = 0; k < count; ++k) value[k][threadIdx.x] = term[k];
  for (int half = chunk_items / 2; half > 0; half /= 2) {
    __syncthreads();
    if (threadIdx.x < half)
      for (int k = 0; k < count; ++k)
        value[k][threadIdx.x] = How::of(value[k][threadIdx.x], value[k][threadIdx.x + half]);
  }
  if (threadIdx.x == 0)
    for (int k = 0; k < count; ++k) of_chunk[blockIdx.x * count + k] = value[k][0];
}

/// Memory and loops of one NVIDIA device: launches and copies go to the stream of the thread that made it and alone
/// uses it, in order. Lanes are threads, so that neither waits for the other's stream, on one device or on two.
class CudaExec {
 public:
  template <class T>
  using Array = CudaArray<T>;
  static constexpr bool marches = true;

  explicit CudaExec(int device) : device_(device) {
    select();
    cudaDeviceProp properties{};
    check(cudaGetDeviceProperties(&properties, device), "ask device");
    name_ = properties.name;
    shared_bytes_ = properties.sharedMemPerBlockOptin;
    processors_ = properties.multiProcessorCount;
  }
  std::string name() const { return name_; }
  void select() const { check(cudaSetDevice(device_), "select device"); }
  void finish() const { check(cudaStreamSynchronize(cudaStreamPerThread), "wait for the device"); }
  template <class Real>
  void set_patches(const Discretisation& d) {
    blocks_ = std::make_unique<PatchLists>(d, d.blocks, most_patch_slots<Real>);
    heat_ = std::make_unique<PatchLists>(d, d.heat, most_patch_slots<Real>);
  }

  void set_clusters(const Clusters& clusters) {
    if (!clusters.pair.empty()) clusters_ = std::make_unique<ClusterLists>(clusters);
    if (clusters_ && !clusters_->fits()) clusters_.reset();
  }
  bool has_clusters() const { return clusters_ != nullptr; }
  /// Springs between node pairs, then one step of every node.
  template <class Real>
  void step_clusters(const SpringView<Real>& springs, const GroupView<Real>& groups, const MoveNode<Real>& step) const {
    ashlar::step_clusters<<<clusters_->count(), cluster_members, 0, cudaStreamPerThread>>>(clusters_->view(), springs,
                                                                                           groups, step);
    check(cudaGetLastError(), "launch");
  }

  template <class Kernel>
  void for_each(int n, const Kernel& kernel) const {
    for_range(0, n, kernel);
  }

  /// Combines what `terms(item, values)` says of n items, in the order of kernels/sum.hpp.
  template <int count, class How = Sum, class Terms>
  std::array<double, count> combine(int n, const Terms& terms) {
    std::array<double, count> total;
    total.fill(How::start);
    if (n == 0) return total;
    double* const first = sums(count, n);
    int chunks = chunk_count(n);
    combine_chunk<count, How><<<chunks, chunk_items, 0, cudaStreamPerThread>>>(n, terms, first);
    double* last = first;
    while (chunks > 1) {
      double* const next = last + count * chunks;
      combine_chunk<count, How>
          <<<chunk_count(chunks), chunk_items, 0, cudaStreamPerThread>>>(chunks, ChunkTerms<count>{last}, next);
      chunks = chunk_count(chunks);
      last = next;
    }
    check(cudaGetLastError(), "launch");
    check(cudaMemcpyAsync(total.data(), last, sizeof total, cudaMemcpyDeviceToHost, cudaStreamPerThread), "copy sums");
    finish();
    return total;
  }

  /// Corner forces of every element, summed patch by patch.
  template <template <class> class Element, bool Warm, class Point, class Real>
  void block_forces(const BodyView<Real>& body, const BatchView& batch, const Point& law, const Discretisation& d,
                    int b) const {
    if (fits<Element, Real>(b)) return step_blocks<Element, Warm>(body, batch, law, d, b, StoreSum<Real>{body.force});
    for_each(batch.element_count, BlockForce<Element, Point, Real, Warm>{body, batch, law});
    const int first = d.blocks.patch_first_entry[d.batches[b].first_patch];
    const int last = d.blocks.patch_first_entry[d.batches[b].first_patch + d.batches[b].patch_count];
    for_range(first, last - first, GatherPatch<Real, 3>{body.nodes, body.corner_force, body.partial, body.force});
  }

  /// Whether a patch of the batch has room in shared memory.
  template <template <class> class Element, class Real>
  bool fits(int b) const {
    return patch_bytes<Real, 3>(capacity(*blocks_, b)) <= shared_bytes_;
  }

  /// Forces of one batch; every node that lies inside a patch makes its step at once.
  template <template <class> class Element, bool Warm, class Point, class Real, class NodeStep>
  void step_blocks(const BodyView<Real>& body, const BatchView& batch, const Point& law, const Discretisation& d, int b,
                   const NodeStep& step) const {
    patches(StressPatch<Element, Warm, Point, Real>{body, batch, law}, *blocks_, d, b, step);
  }
  /// Steps of a model whose patches can all run at once, in one launch; false if they cannot.
  /// @param batches all of them, one after the other; `laws` [batches]
  template <template <class> class Element, bool Warm, class Point, class Real>
  bool march_blocks(const BodyView<Real>& body, const std::vector<BatchView>& batches, const std::vector<Point>& laws,
                    const Discretisation& d, const MoveNode<Real>& step, int steps) {
    using Work = StressPatch<Element, Warm, Point, Real>;
    const auto* const kernel = reinterpret_cast<const void*>(march_patches<Work>);
    int entries = 0;
    for (int b = 0; b < static_cast<int>(batches.size()); ++b) entries = std::max(entries, capacity(*blocks_, b));
    const bool other = kernel != resident_kernel_;
    if (other) resident_bytes_ = bytes_at_once<Work>(d, entries);
    resident_kernel_ = kernel;
    if (resident_bytes_ == 0) return false;

    if (other || sent_changes_ != MachineMemory::changes) {
      std::vector<Work> works;
      for (std::size_t b = 0; b < batches.size(); ++b) works.push_back({body, batches[b], laws[b]});
      const auto* first = reinterpret_cast<const std::byte*>(works.data());
      works_.assign(std::vector<std::byte>(first, first + works.size() * sizeof(Work)));
      message_room_.resize(4 * std::size_t(Messages<Real>::words) * d.blocks.entry_count());
      sent_changes_ = MachineMemory::changes;
    }
    const auto* sent = reinterpret_cast<const Work*>(works_.data());
    int batch_count = static_cast<int>(batches.size());
    PatchListsView lists = blocks_->view();
    Messages<Real> messages{reinterpret_cast<typename Messages<Real>::Word*>(message_room_.data()),
                            d.blocks.entry_count()};
    MoveNode<Real> move = step;
    ResidentListsView exchange = exchange_->view();
    void* arguments[] = {&sent, &batch_count, &lists, &exchange, &messages, &entries, &move, &step_number_, &steps};
    check(cudaLaunchCooperativeKernel(kernel, d.patch_count(), Work::group.threads, arguments, resident_bytes_,
                                      cudaStreamPerThread),
          "launch");
    step_number_ += steps;
    return true;
  }
  /// The other nodes.
  template <class Real, class NodeStep>
  void step_boundary(const BodyView<Real>& body, const Discretisation& d, const NodeStep& step) const {
    for_each(d.blocks.boundary_count(), StepBoundary<Real, 3, NodeStep>{body.nodes, body.partial, body.u, step});
  }

  /// The same for heat: flows of one batch, then the other nodes. A patch of one number a node always fits.
  template <template <class> class Element, class Real, class NodeStep>
  void heat_flows(ElementTag<Element>, const HeatView<Real>& heat, const BatchView& batch, Real conductivity,
                  const Summed<Real>& field, const Discretisation& d, int b, const NodeStep& step) const {
    patches(HeatPatch<Element, Real>{heat, batch, conductivity, field}, *heat_, d, b, step);
  }
  template <class Real, class NodeStep>
  void heat_boundary(const HeatView<Real>& heat, const Summed<Real>& field, const Discretisation& d,
                     const NodeStep& step) const {
    for_each(d.heat.boundary_count(), StepBoundary<Real, 1, NodeStep>{heat.nodes, heat.partial, field, step});
  }

  /// Runs the launches of `work` `times` times: captured once as a graph for each `kind` of work, then sent as a whole.
  template <class Work>
  void repeat(const std::string& kind, int times, const Work& work) {
    for (Graph& g : graphs_)
      if (g.kind == kind && g.times == times && g.changes == MachineMemory::changes)
        return check(cudaGraphLaunch(g.graph.get(), cudaStreamPerThread), "launch a graph");
    std::erase_if(graphs_, [](const Graph& g) { return g.changes != MachineMemory::changes; });
    check(cudaStreamBeginCapture(cudaStreamPerThread, cudaStreamCaptureModeThreadLocal), "capture");
    for (int i = 0; i < times; ++i) work();
    cudaGraph_t captured = nullptr;
    check(cudaStreamEndCapture(cudaStreamPerThread, &captured), "end capture");
    cudaGraphExec_t graph = nullptr;
    check(cudaGraphInstantiate(&graph, captured, 0), "make a graph");
    check(cudaGraphDestroy(captured), "drop a graph");
    graphs_.push_back({kind, times, MachineMemory::changes, {graph, cudaGraphExecDestroy}});
    check(cudaGraphLaunch(graph, cudaStreamPerThread), "launch a graph");
  }

 private:
  struct Graph {
    std::string kind;
    int times;
    unsigned long changes;
    std::unique_ptr<CUgraphExec_st, cudaError_t (*)(cudaGraphExec_t)> graph;
  };

  /// Room for the sums of every round.
  double* sums(int count, int n) {
    std::size_t room = 0;
    for (int chunks = chunk_count(n);; chunks = chunk_count(chunks)) {
      room += std::size_t(count) * chunks;
      if (chunks <= 1) break;
    }
    if (sums_.size() < room) sums_.resize(room);
    return sums_.data();
  }
  /// Shared memory of a thread group if all patches can run at once, else 0.
  template <class Work>
  std::size_t bytes_at_once(const Discretisation& d, int entries) {
    int groups = 2048 / Work::group.threads;  // of a processor, at the very most
    if (d.patch_count() > groups * processors_) return 0;
    if (!exchange_) exchange_ = std::make_unique<ResidentLists>(d.blocks);
    const auto kernel = march_patches<Work>;
    const std::size_t size = resident_bytes<typename Work::Real>(entries, exchange_->most_places());
    if (size > shared_bytes_) return 0;
    check(cudaFuncSetAttribute(kernel, cudaFuncAttributeMaxDynamicSharedMemorySize, static_cast<int>(size)),
          "ask for shared memory");
    check(cudaOccupancyMaxActiveBlocksPerMultiprocessor(&groups, kernel, Work::group.threads, size),
          "ask for occupancy");
    return d.patch_count() <= groups * processors_ ? size : 0;
  }
  static int capacity(const PatchLists& lists, int b) { return (lists.most_entries(b) + 3) / 4 * 4; }
  template <class Work, class NodeStep>
  void patches(const Work& work, const PatchLists& lists, const Discretisation& d, int b, const NodeStep& step) const {
    const auto kernel = run_patch<Work, NodeStep>;
    const int entries = capacity(lists, b);
    const std::size_t size = patch_bytes<typename Work::Real, Work::width>(entries);
    check(cudaFuncSetAttribute(kernel, cudaFuncAttributeMaxDynamicSharedMemorySize, static_cast<int>(size)),
          "ask for shared memory");
    kernel<<<d.batches[b].patch_count, Work::group.threads, size, cudaStreamPerThread>>>(
        work, lists.view(), d.batches[b].first_patch, processors_ * Work::group.per_processor, entries, step);
    check(cudaGetLastError(), "launch");
  }
  template <class Kernel>
  void for_range(int first, int n, const Kernel& kernel) const {
    constexpr int group = 128;
    if (n <= 0) return;
    run_kernel<<<(n + group - 1) / group, group, 0, cudaStreamPerThread>>>(first, n, kernel);
    check(cudaGetLastError(), "launch");
  }

  int device_;
  std::string name_;
  std::size_t shared_bytes_ = 0;
  int processors_ = 1;
  std::unique_ptr<PatchLists> blocks_, heat_;
  std::unique_ptr<ClusterLists> clusters_;
  CudaArray<double> sums_;
  std::unique_ptr<ResidentLists> exchange_;
  CudaArray<std::byte> works_;
  const void* resident_kernel_ = nullptr;  ///< what works_ are for
  std::size_t resident_bytes_ = 0;         ///< of shared memory a thread group of it; 0: not all can run at once
  unsigned long sent_changes_ = 0;
  CudaArray<unsigned long long> message_room_;
  unsigned step_number_ = 1;  ///< of the next resident step
  std::vector<Graph> graphs_;
};

}  // namespace ashlar
