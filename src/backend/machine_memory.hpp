#pragma once
#include <cstddef>
#include <cstdint>

namespace ashlar {

/// What the arrays of all backends of this thread hold, and how much they may. Arrays beyond the limit are counted and
/// get no memory, so that the code that allocates also tells how much it would have needed.
struct MachineMemory {
  inline static thread_local std::size_t bytes = 0;
  inline static thread_local std::size_t counted_from = 0;        ///< bytes when the limit was set
  inline static thread_local std::ptrdiff_t limit = PTRDIFF_MAX;  ///< beyond counted_from
  inline static thread_local unsigned long changes = 0;           ///< of devices: captured launches hold addresses

  /// Counts an array of `now` instead of `before` bytes; whether it may be allocated.
  static bool book(std::size_t before, std::size_t now) {
    bytes += now - before;
    return within_limit();
  }
  /// The difference counts: arrays that end in another thread than they began in leave both sums off.
  static bool within_limit() { return static_cast<std::ptrdiff_t>(bytes - counted_from) <= limit; }
};

/// For as long as it lives, arrays may take `more` bytes beside what there are.
class MemoryLimit {
 public:
  explicit MemoryLimit(std::size_t more) {
    MachineMemory::counted_from = MachineMemory::bytes;
    MachineMemory::limit = more < PTRDIFF_MAX ? static_cast<std::ptrdiff_t>(more) : PTRDIFF_MAX;
  }
  MemoryLimit(const MemoryLimit&) = delete;
  ~MemoryLimit() { MachineMemory::limit = PTRDIFF_MAX; }
};

}  // namespace ashlar
