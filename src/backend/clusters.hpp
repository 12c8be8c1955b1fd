#pragma once
#include <algorithm>
#include <numeric>
#include <vector>

namespace ashlar {

/// Block nodes in clusters: those that the springs between node pairs tie to each other, directly or through others,
/// and single ones. In a cracked body they are the copies of one mesh node. A machine keeps the pairs of a cluster side
/// by side.
struct Clusters {
  std::vector<int> node_a, node_b;  ///< [pairs] in the model's order
  std::vector<int> first_node;      ///< [block nodes] lowest node of its cluster, which names it
  std::vector<int> pair;            ///< [pairs] by cluster: which of the model's; inside a cluster ascending

  Clusters(int node_count, std::vector<int> a, std::vector<int> b)
      : node_a(std::move(a)), node_b(std::move(b)), first_node(node_count), pair(node_a.size()) {
    std::iota(first_node.begin(), first_node.end(), 0);
    const auto find = [&](int n) {
      while (first_node[n] != n) n = first_node[n] = first_node[first_node[n]];
      return n;
    };
    for (std::size_t c = 0; c < pair.size(); ++c) {
      const int one = find(node_a[c]), other = find(node_b[c]);
      first_node[std::max(one, other)] = std::min(one, other);
    }
    for (int n = 0; n < node_count; ++n) first_node[n] = find(n);
    std::vector<int> next(node_count + 1);
    for (const int n : node_a) ++next[first_node[n] + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    for (std::size_t c = 0; c < pair.size(); ++c) pair[next[first_node[node_a[c]]]++] = static_cast<int>(c);
  }
};

}  // namespace ashlar
