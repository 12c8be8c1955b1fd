#include "io/mesh_content.hpp"

#include <algorithm>
#include <climits>

namespace ashlar {

void MeshContent::add_element(const Scanner& scanner, Cell cell, long id, std::size_t position,
                              std::span<const int> element_nodes, int membership) {
  auto& list = is_volume(cell) ? volumes : facets;
  if (list.nodes.size() + element_nodes.size() > INT_MAX) scanner.fail(position, "more than 2^31 element corners");
  for (const int node : element_nodes) {
    used_at_all[node] = 1;
    if (is_volume(cell)) used_by_volume[node] = 1;
    list.nodes.push_back(node);
  }
  list.cells.push_back(cell);
  list.ids.push_back(id);
  list.positions.push_back(position);
  list.membership.push_back(membership);
  list.first_node.push_back(static_cast<int>(list.nodes.size()));
}

NodeIndex::NodeIndex(const Scanner& scanner, const std::vector<long>& ids) {
  sorted_.reserve(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) sorted_.push_back({ids[i], static_cast<int>(i)});
  if (!std::is_sorted(sorted_.begin(), sorted_.end())) std::sort(sorted_.begin(), sorted_.end());
  for (std::size_t i = 1; i < sorted_.size(); ++i)
    if (sorted_[i].first == sorted_[i - 1].first)
      scanner.fail_file("node " + std::to_string(sorted_[i].first) + " is given twice");
}

int NodeIndex::find(long id) const {
  if (sorted_.empty() || id < sorted_.front().first || id > sorted_.back().first) return -1;
  const auto guess = static_cast<std::size_t>(id) - static_cast<std::size_t>(sorted_.front().first);
  if (guess < sorted_.size() && sorted_[guess].first == id) return sorted_[guess].second;
  const auto it = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair{id, 0});
  return it != sorted_.end() && it->first == id ? it->second : -1;
}

}  // namespace ashlar
