#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "backend/clusters.hpp"
#include "cuda_array.hpp"

/// Clusters in the form that thread groups read: whole clusters a group, as many as it has room for.
namespace ashlar {

inline constexpr int cluster_members = 128, cluster_pairs = 256;  ///< of one thread group at most

/// Whole clusters that one thread group steps.
struct ClusterHead {
  int first_member, members, first_pair, pairs;
};
/// Members at both ends of a spring, counted in the thread group.
struct ClusterEnds {
  std::uint8_t a, b;
};

struct ClusterListsView {
  const ClusterHead* heads = nullptr;
  const int* node = nullptr;                ///< [members] block node
  const std::uint8_t* place = nullptr;      ///< [block nodes] which member of its thread group the node is
  const std::uint16_t* uses_end = nullptr;  ///< [members] end of its springs in `use`, from 2 * first_pair of its group
  const ClusterEnds* ends = nullptr;        ///< [pairs]
  const std::uint16_t* use = nullptr;       ///< spring of a member, counted in the group, times two; odd: it is side b
};

class ClusterLists {
 public:
  explicit ClusterLists(const Clusters& clusters) {
    const std::vector<int>& cluster_of = clusters.first_node;
    const int node_count = static_cast<int>(cluster_of.size()), pairs = static_cast<int>(clusters.pair.size());
    std::vector<int> member_count(node_count), pair_count(node_count);
    for (const int n : cluster_of) ++member_count[n];
    for (const int n : clusters.node_a) ++pair_count[cluster_of[n]];
    std::vector<ClusterHead> heads;
    std::vector<int> next_member(node_count), group_of(node_count);
    for (int n = 0; n < node_count; ++n) {
      if (cluster_of[n] != n) continue;
      fits_ = fits_ && member_count[n] <= cluster_members && pair_count[n] <= cluster_pairs;
      if (heads.empty() || heads.back().members + member_count[n] > cluster_members ||
          heads.back().pairs + pair_count[n] > cluster_pairs) {
        const ClusterHead last = heads.empty() ? ClusterHead{} : heads.back();
        heads.push_back({last.first_member + last.members, 0, last.first_pair + last.pairs, 0});
      }
      ClusterHead& h = heads.back();
      group_of[n] = static_cast<int>(heads.size()) - 1;
      next_member[n] = h.first_member + h.members;
      h.members += member_count[n];
      h.pairs += pair_count[n];
    }
    if (!fits_) return;
    std::vector<int> node(node_count), use_count(node_count);
    std::vector<std::uint8_t> place(node_count);
    for (int n = 0; n < node_count; ++n) {
      const int at = next_member[cluster_of[n]]++;
      node[at] = n;
      place[n] = static_cast<std::uint8_t>(at - heads[group_of[cluster_of[n]]].first_member);
    }
    std::vector<ClusterEnds> ends(pairs);
    for (int i = 0; i < pairs; ++i) {
      const int a = clusters.node_a[clusters.pair[i]], b = clusters.node_b[clusters.pair[i]];
      ends[i] = {place[a], place[b]};
      ++use_count[a];
      ++use_count[b];
    }
    // A member's uses follow those of the members before it, all groups one after the other: 2 * first_pair of its
    // group is where they begin.
    std::vector<std::uint16_t> uses_end(node_count), use(2 * std::size_t(pairs));
    std::vector<std::size_t> next_use(node_count);
    std::size_t uses = 0;
    for (const ClusterHead& h : heads)
      for (int m = h.first_member; m < h.first_member + h.members; ++m) {
        next_use[node[m]] = uses;
        uses += use_count[node[m]];
        uses_end[m] = static_cast<std::uint16_t>(uses - 2 * std::size_t(h.first_pair));
      }
    for (const ClusterHead& h : heads)
      for (int i = h.first_pair; i < h.first_pair + h.pairs; ++i) {
        const int c = clusters.pair[i], in_group = i - h.first_pair;
        use[next_use[clusters.node_a[c]]++] = static_cast<std::uint16_t>(2 * in_group);
        use[next_use[clusters.node_b[c]]++] = static_cast<std::uint16_t>(2 * in_group + 1);
      }
    count_ = static_cast<int>(heads.size());
    heads_.assign(heads);
    node_.assign(node);
    place_.assign(place);
    uses_end_.assign(uses_end);
    ends_.assign(ends);
    use_.assign(use);
  }

  /// Whether every cluster has room in a thread group.
  bool fits() const { return fits_; }
  int count() const { return count_; }
  ClusterListsView view() const {
    return {heads_.data(), node_.data(), place_.data(), uses_end_.data(), ends_.data(), use_.data()};
  }

 private:
  bool fits_ = true;
  int count_ = 0;
  CudaArray<ClusterHead> heads_;
  CudaArray<int> node_;
  CudaArray<std::uint8_t> place_;
  CudaArray<std::uint16_t> uses_end_, use_;
  CudaArray<ClusterEnds> ends_;
};

}  // namespace ashlar
