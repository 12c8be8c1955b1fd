#pragma once
#include <string>
#include <vector>

namespace ashlar {

/// A function of the deck language, for `ashlar help`.
struct FunctionDoc {
  std::vector<std::string> words;  ///< its name, and words of its arguments
  std::string text;
};
const std::vector<FunctionDoc>& function_docs();

}  // namespace ashlar
