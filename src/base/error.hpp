#pragma once
#include <stdexcept>
#include <string>
#include <vector>

namespace ashlar {

/// Place in a deck. An empty file means that the thing was not declared by a deck (built in code).
struct Where {
  std::string file;
  int line = 0;
  /// "dam.lua:14: " or "" without a file.
  std::string prefix() const { return file.empty() ? "" : file + ":" + std::to_string(line) + ": "; }
};

/// What an engineer reads when the deck, a mesh file or a combination of declarations is wrong. Exit code 2.
/// Holds every complaint found, each already a whole line: "dam.lua:14: material 'concrete': missing 'density' [kg/m^3]".
class DeckError : public std::runtime_error {
 public:
  explicit DeckError(std::vector<std::string> lines) : std::runtime_error(joined(lines)), lines_(std::move(lines)) {}
  DeckError(const Where& where, const std::string& message) : DeckError(std::vector{where.prefix() + message}) {}
  const std::vector<std::string>& lines() const { return lines_; }

 private:
  static std::string joined(const std::vector<std::string>& lines) {
    std::string all;
    for (const auto& line : lines) all += (all.empty() ? "" : "\n") + line;
    return all;
  }
  std::vector<std::string> lines_;
};

/// Memory, disk or device is missing. Exit code 5.
class ResourceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Collects complaints so that all of them are reported at once.
class Complaints {
 public:
  void add(const Where& where, const std::string& message) { lines_.push_back(where.prefix() + message); }
  bool empty() const { return lines_.empty(); }
  void raise() const {
    if (!lines_.empty()) throw DeckError(lines_);
  }

 private:
  std::vector<std::string> lines_;
};

}  // namespace ashlar
