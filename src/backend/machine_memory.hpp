#pragma once
#include <cstddef>
#include <limits>

namespace ashlar {

/// What the arrays of all backends of this thread hold, and how much they may. Arrays beyond the limit are counted and
/// get no memory, so that the code that allocates also tells how much it would have needed.
struct MachineMemory {
  inline static thread_local std::size_t bytes = 0;
  inline static thread_local std::size_t limit = std::numeric_limits<std::size_t>::max();
  inline static thread_local unsigned long changes = 0;  ///< of devices: captured launches hold addresses

  /// Counts an array of `now` instead of `before` bytes; whether it may be allocated.
  static bool book(std::size_t before, std::size_t now) {
    bytes += now - before;
    return within_limit();
  }
  static bool within_limit() { return bytes <= limit; }
};

/// For as long as it lives, arrays may take `more` bytes beside what there are.
class MemoryLimit {
 public:
  explicit MemoryLimit(std::size_t more) { MachineMemory::limit = MachineMemory::bytes + more; }
  MemoryLimit(const MemoryLimit&) = delete;
  ~MemoryLimit() { MachineMemory::limit = std::numeric_limits<std::size_t>::max(); }
};

}  // namespace ashlar
