#pragma once
#include <string>

#include "cli/wording.hpp"

namespace ashlar {

/// Facts, one a line, under headings that are printed once; long ones are broken at their commas.
class Page {
 public:
  void line(const std::string& heading, std::string words) {
    constexpr std::size_t width = 120, indent = 10;
    std::string margin = text("%-10s", heading == last_ ? "" : heading.c_str());
    last_ = heading;
    while (indent + words.size() > width) {
      const std::size_t comma = words.rfind(", ", width - indent);
      if (comma == std::string::npos) break;
      lines_ += margin + words.substr(0, comma + 1) + "\n";
      margin = std::string(indent, ' ');
      words = "    " + words.substr(comma + 2);
    }
    lines_ += margin + words + "\n";
  }
  const std::string& lines() const { return lines_; }

 private:
  std::string lines_, last_;
};

}  // namespace ashlar
