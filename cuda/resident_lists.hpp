#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "cuda_array.hpp"
#include "model/discretisation.hpp"

/// How patches exchange the sums of nodes that they share. Every patch has an inbox in shared memory: for each such
/// node the sums of all its patches, its own among them, in the model's order.
namespace ashlar {

struct InboxHead {
  int first_letter, letters;  ///< what other patches send
};
/// A sum to be fetched: whose, and its place in the inbox.
struct Letter {
  int entry, place;
};
/// Places in the inbox of one entry's sums.
struct alignas(8) InboxPlaces {
  std::uint16_t first, end, own;
};

struct ResidentListsView {
  const InboxHead* heads = nullptr;  ///< [patches]
  const Letter* letters = nullptr;
  const InboxPlaces* places = nullptr;  ///< [entries]; of those on patch boundaries
};

class ResidentLists {
 public:
  explicit ResidentLists(const Topology& t) {
    std::vector<InboxHead> heads;
    std::vector<Letter> letters;
    std::vector<InboxPlaces> places(t.entry_count());
    for (int p = 0; p + 1 < static_cast<int>(t.patch_first_entry.size()); ++p) {
      InboxHead head{static_cast<int>(letters.size()), 0};
      int room = 0;
      for (int e = t.patch_first_entry[p] + t.patch_interior[p]; e < t.patch_first_entry[p + 1]; ++e) {
        const int b = t.entry_node[e] - t.interior_count;
        places[e].first = static_cast<std::uint16_t>(room);
        for (int j = t.boundary_first[b]; j < t.boundary_first[b + 1]; ++j, ++room) {
          if (t.boundary_entry[j] == e)
            places[e].own = static_cast<std::uint16_t>(room);
          else
            letters.push_back({t.boundary_entry[j], room});
        }
        places[e].end = static_cast<std::uint16_t>(room);
      }
      head.letters = static_cast<int>(letters.size()) - head.first_letter;
      most_places_ = std::max(most_places_, room);
      heads.push_back(head);
    }
    heads_.assign(heads);
    letters_.assign(letters);
    places_.assign(places);
  }
  ResidentListsView view() const { return {heads_.data(), letters_.data(), places_.data()}; }
  /// Sums in the inbox of a patch at most.
  int most_places() const { return most_places_; }

 private:
  CudaArray<InboxHead> heads_;
  CudaArray<Letter> letters_;
  CudaArray<InboxPlaces> places_;
  int most_places_ = 0;
};

}  // namespace ashlar
