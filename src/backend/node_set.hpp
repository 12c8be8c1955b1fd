#pragma once
#include <cstdint>

#include "model/discretisation.hpp"
#include "model/view.hpp"

namespace ashlar {

/// Node set arrays in a machine's memory.
template <class Exec>
class NodeSet {
 public:
  explicit NodeSet(const Topology& t) {
    corner_entry_.assign(t.corner_entry);
    patch_first_entry_.assign(t.patch_first_entry);
    patch_interior_.assign(t.patch_interior);
    entry_node_.assign(t.entry_node);
    entry_first_slot_.assign(t.entry_first_slot);
    entry_slot_.assign(t.entry_slot);
    boundary_first_.assign(t.boundary_first);
    boundary_entry_.assign(t.boundary_entry);
    view_.node_count = t.node_count;
    view_.interior_count = t.interior_count;
    view_.entry_count = t.entry_count();
    view_.corner_entry = corner_entry_.data();
    view_.patch_first_entry = patch_first_entry_.data();
    view_.patch_interior = patch_interior_.data();
    view_.entry_node = entry_node_.data();
    view_.entry_first_slot = entry_first_slot_.data();
    view_.entry_slot = entry_slot_.data();
    view_.boundary_first = boundary_first_.data();
    view_.boundary_entry = boundary_entry_.data();
  }
  const NodeSetView& view() const { return view_; }

 private:
  template <class T>
  using Array = typename Exec::template Array<T>;
  Array<int> patch_first_entry_, patch_interior_, entry_node_, entry_first_slot_, entry_slot_,
      boundary_first_, boundary_entry_;
  Array<std::uint16_t> corner_entry_;
  NodeSetView view_;
};

}  // namespace ashlar
