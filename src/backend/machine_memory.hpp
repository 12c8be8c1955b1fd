#pragma once
#include <cstddef>

namespace ashlar {

/// What the arrays of all backends of this thread hold.
struct MachineMemory {
  inline static thread_local std::size_t bytes = 0;
  inline static thread_local unsigned long changes = 0;  ///< of devices: captured launches hold addresses
};

}  // namespace ashlar
