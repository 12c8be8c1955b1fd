#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "cuda_array.hpp"
#include "model/discretisation.hpp"

/// What one thread group needs to know of its patch: the model's own order of sums (Topology) in the form that reads
/// best, 16 bytes a lane. Element forces of a patch lie in shared memory as [component][corner][element].
namespace ashlar {

struct PatchHead {
  int first_entry, entries, interior;  ///< of Topology
  int first_node;                      ///< interior entries are nodes first_node, first_node + 1, ...
  int first_element, elements;         ///< counted in the batch
  int first_row, rows_per_lane;        ///< of the gather lists
};

/// Eight places of one entry's corner values in shared memory; unused ones hold `nowhere`, where a zero lies.
struct alignas(16) GatherRow {
  std::uint16_t place[8];
};

struct PatchListsView {
  const PatchHead* heads = nullptr;  ///< [patches]
  const GatherRow* rows = nullptr;   ///< per patch: entries in groups of 32 lanes, rows_per_lane rows a group
};

class PatchLists {
 public:
  /// @param slots corner slots that shared memory has room for; behind them lies a zero
  PatchLists(const Discretisation& d, const Topology& t, int slots) : most_entries_(d.batches.size()) {
    std::vector<PatchHead> heads(d.patch_count());
    std::vector<GatherRow> rows;
    for (int p = 0; p < d.patch_count(); ++p) {
      const Batch& b = d.batch_of_patch(p);
      const int corners = corner_count(b.shape);
      PatchHead& h = heads[p];
      h.first_entry = t.patch_first_entry[p];
      h.entries = t.patch_first_entry[p + 1] - h.first_entry;
      h.interior = t.patch_interior[p];
      h.first_node = h.entries > 0 ? t.entry_node[h.first_entry] : 0;
      h.first_element = d.patch_first_element[p] - b.first_element;
      h.elements = d.patch_first_element[p + 1] - d.patch_first_element[p];
      int& most = most_entries_[d.patch_batch[p]];
      most = std::max(most, h.entries);

      int longest = 1;
      for (int e = h.first_entry; e < h.first_entry + h.entries; ++e)
        longest = std::max(longest, t.entry_first_slot[e + 1] - t.entry_first_slot[e]);
      h.rows_per_lane = (longest + 7) / 8;
      h.first_row = static_cast<int>(rows.size());
      GatherRow empty;
      std::fill(std::begin(empty.place), std::end(empty.place), static_cast<std::uint16_t>(slots));
      rows.resize(rows.size() + std::size_t((h.entries + 31) / 32) * 32 * h.rows_per_lane, empty);
      const int first_slot = b.first_slot + h.first_element * corners;
      const int lane_places = 8 * h.rows_per_lane;
      const std::vector<int> usual = usual_places(t, h, corners, first_slot);
      for (int l = 0; l < h.entries; ++l) {
        const int first = t.entry_first_slot[h.first_entry + l], last = t.entry_first_slot[h.first_entry + l + 1];
        for (int j = first, place = 0; j < last; ++j, ++place) {
          const int slot = t.entry_slot[j] - first_slot;
          if (!usual.empty()) place = std::max(place, std::min(usual[slot % corners], lane_places - (last - j)));
          GatherRow& row = rows[h.first_row + (l / 32 * h.rows_per_lane + place / 8) * 32 + l % 32];
          row.place[place % 8] = static_cast<std::uint16_t>(slot % corners * (slots / corners) + slot / corners);
        }
      }
    }
    heads_.assign(heads);
    rows_.assign(rows);
  }

  PatchListsView view() const { return {heads_.data(), rows_.data()}; }
  int most_entries(int batch) const { return most_entries_[batch]; }

 private:
  /// Place of each corner in the list of the node with most elements; nodes with fewer of them leave gaps, so that
  /// lanes read the same corner of neighbouring elements, each from its own bank. Empty if corners repeat there.
  static std::vector<int> usual_places(const Topology& t, const PatchHead& h, int corners, int first_slot) {
    int fullest = h.first_entry;
    const auto length = [&](int e) { return t.entry_first_slot[e + 1] - t.entry_first_slot[e]; };
    for (int e = h.first_entry; e < h.first_entry + h.entries; ++e)
      if (length(e) > length(fullest)) fullest = e;
    std::vector<int> usual(corners, -1);
    for (int i = 0; i < length(fullest); ++i) {
      int& place = usual[(t.entry_slot[t.entry_first_slot[fullest] + i] - first_slot) % corners];
      if (place >= 0) return {};
      place = i;
    }
    return usual;
  }

  CudaArray<PatchHead> heads_;
  CudaArray<GatherRow> rows_;
  std::vector<int> most_entries_;  ///< [batches]
};

}  // namespace ashlar
