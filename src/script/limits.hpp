#pragma once
#include <cstddef>

namespace ashlar {

struct ScriptLimits {
  std::size_t memory = std::size_t{512} << 20;  ///< bytes
  long instructions = 50'000'000;               ///< while the deck is read; a tenth of it in one call of a function
  double seconds = 30;                          ///< wall clock, behind the two others: the process exits with code 2
};

}  // namespace ashlar
