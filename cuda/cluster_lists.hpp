#pragma once
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "backend/backend.hpp"
#include "cuda_array.hpp"

/// Block nodes in clusters: those that contact points tie to each other, directly or through others, and single ones.
/// In a cracked body they are the copies of one mesh node. A cluster's step needs nothing of other clusters.
namespace ashlar {

inline constexpr int cluster_members = 128, cluster_contacts = 256;  ///< of one thread group at most

/// Whole clusters that one thread group steps.
struct ClusterHead {
  int first_member, members, first_contact, contacts, first_use;
};
/// Members at both ends of a contact point, counted in the thread group.
struct ClusterEnds {
  std::uint8_t a, b;
};

struct ClusterListsView {
  const ClusterHead* heads = nullptr;
  const int* node = nullptr;            ///< [members] block node
  const std::uint8_t* place = nullptr;  ///< [block nodes] which member of its thread group the node is
  const std::uint16_t* uses_end =
      nullptr;                        ///< [members] end of its contact points in `use`, from first_use of the group
  const int* contact = nullptr;       ///< [contact points of node pairs]
  const ClusterEnds* ends = nullptr;  ///< beside contact
  const std::uint16_t* use =
      nullptr;  ///< contact point of a member, counted in the group, times two; odd: it is side b
};

class ClusterLists {
 public:
  explicit ClusterLists(const Setup& setup) {
    const Topology& blocks = setup.discretisation.blocks;
    const int node_count = blocks.node_count, contacts = setup.contacts.pair_count();
    std::vector<int> node_a(contacts), node_b(contacts), root(node_count);
    for (int c = 0; c < contacts; ++c) {
      node_a[c] = blocks.new_node[setup.contacts.node_a[c]];
      node_b[c] = blocks.new_node[setup.contacts.node_b[c]];
    }
    std::iota(root.begin(), root.end(), 0);
    const auto find = [&](int n) {
      while (root[n] != n) n = root[n] = root[root[n]];
      return n;
    };
    for (int c = 0; c < contacts; ++c) {
      const int a = find(node_a[c]), b = find(node_b[c]);
      root[std::max(a, b)] = std::min(a, b);
    }
    // Clusters in the order of their first nodes, members and contact points ascending.
    std::vector<int> member_count(node_count), contact_count(node_count);
    for (int n = 0; n < node_count; ++n) ++member_count[root[n] = find(n)];
    for (int c = 0; c < contacts; ++c) ++contact_count[root[node_a[c]]];
    std::vector<ClusterHead> heads;
    std::vector<int> first_member(node_count), first_contact(node_count), group_of(node_count);
    for (int n = 0; n < node_count; ++n) {
      if (root[n] != n) continue;
      fits_ = fits_ && member_count[n] <= cluster_members && contact_count[n] <= cluster_contacts;
      if (heads.empty() || heads.back().members + member_count[n] > cluster_members ||
          heads.back().contacts + contact_count[n] > cluster_contacts) {
        const ClusterHead last = heads.empty() ? ClusterHead{} : heads.back();
        const int next = last.first_contact + last.contacts;
        heads.push_back({last.first_member + last.members, 0, next, 0, 2 * next});
      }
      ClusterHead& h = heads.back();
      group_of[n] = static_cast<int>(heads.size()) - 1;
      first_member[n] = h.first_member + h.members;
      first_contact[n] = h.first_contact + h.contacts;
      h.members += member_count[n];
      h.contacts += contact_count[n];
    }
    if (!fits_) return;
    std::vector<int> node(node_count), contact(contacts), contact_at(contacts);
    std::vector<std::uint8_t> place(node_count);
    for (int n = 0; n < node_count; ++n) {
      const int at = first_member[root[n]]++;
      node[at] = n;
      place[n] = static_cast<std::uint8_t>(at - heads[group_of[root[n]]].first_member);
    }
    std::vector<ClusterEnds> ends(contacts);
    std::vector<std::vector<std::uint16_t>> uses(node_count);
    for (int c = 0; c < contacts; ++c) {
      const int cluster = root[node_a[c]], at = first_contact[cluster]++;
      const int in_group = at - heads[group_of[cluster]].first_contact;
      contact[at] = c;
      ends[at] = {place[node_a[c]], place[node_b[c]]};
      uses[node_a[c]].push_back(static_cast<std::uint16_t>(2 * in_group));
      uses[node_b[c]].push_back(static_cast<std::uint16_t>(2 * in_group + 1));
    }
    std::vector<std::uint16_t> uses_end(node_count), use;
    for (const ClusterHead& h : heads)
      for (int m = h.first_member; m < h.first_member + h.members; ++m) {
        use.insert(use.end(), uses[node[m]].begin(), uses[node[m]].end());
        uses_end[m] = static_cast<std::uint16_t>(use.size() - h.first_use);
      }
    count_ = static_cast<int>(heads.size());
    heads_.assign(heads);
    node_.assign(node);
    place_.assign(place);
    uses_end_.assign(uses_end);
    contact_.assign(contact);
    ends_.assign(ends);
    use_.assign(use);
  }

  /// Whether every cluster has room in a thread group.
  bool fits() const { return fits_; }
  int count() const { return count_; }
  ClusterListsView view() const {
    return {heads_.data(), node_.data(), place_.data(), uses_end_.data(), contact_.data(), ends_.data(), use_.data()};
  }

 private:
  bool fits_ = true;
  int count_ = 0;
  CudaArray<ClusterHead> heads_;
  CudaArray<int> node_, contact_;
  CudaArray<std::uint8_t> place_;
  CudaArray<std::uint16_t> uses_end_, use_;
  CudaArray<ClusterEnds> ends_;
};

}  // namespace ashlar
