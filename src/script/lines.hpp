#pragma once
#include <map>
#include <string>
#include <vector>

namespace ashlar {

/// Lines of the keys of literal tables in a deck. Lua keeps one line per call; this lexer over the deck's text
/// maps each key of `noun "name" { key = ... }` to its own line.
class DeckLines {
 public:
  DeckLines() = default;
  explicit DeckLines(const std::string& text);
  /// Line of `key` ("young", "water.default", "section.3") in the table that `noun "name"` was given on `call_line`;
  /// of the nearest enclosing key, else `call_line` itself (a table held in a variable).
  int line(int call_line, const std::string& noun, const std::string& name, std::string key) const;

 private:
  struct Literal {
    std::string noun, name;
    int line = 0;
    std::map<std::string, int> keys;
  };
  std::vector<Literal> literals_;
};

}  // namespace ashlar
