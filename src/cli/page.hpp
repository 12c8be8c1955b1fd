#pragma once
#include <string>

#include "cli/wording.hpp"

namespace ashlar {

/// Facts, one a line, under headings that are printed once.
class Page {
 public:
  void line(const std::string& heading, const std::string& words) {
    lines_ += text("%-10s%s\n", heading == last_ ? "" : heading.c_str(), words.c_str());
    last_ = heading;
  }
  const std::string& lines() const { return lines_; }

 private:
  std::string lines_, last_;
};

}  // namespace ashlar
