#pragma once
#include <map>
#include <string>
#include <vector>

namespace ashlar {

/// A name that a deck gives to something of its own: `local s = 3`, `local function s()`, `for s = ...`, `function(s)`.
struct LocalName {
  std::string name;
  int line = 0;
  bool of_block = false;   ///< a parameter, or of a loop, a branch or a function: seen in a few lines only
  bool is_factor = false;  ///< stands behind a number and * or / where it is seen, as a unit does
};

/// Lines of the keys of literal tables in a deck. Lua keeps one line per call; this lexer over the deck's text
/// maps each key of `noun "name" { key = ... }` to its own line.
class DeckLines {
 public:
  DeckLines() = default;
  explicit DeckLines(const std::string& text);
  /// Line of `key` ("young", "water.default", "section.3") in the table that `noun "name"` was given on `call_line`;
  /// of the nearest enclosing key, else `call_line` itself (a table held in a variable).
  int line(int call_line, const std::string& noun, const std::string& name, std::string key) const;
  const std::vector<LocalName>& locals() const { return locals_; }

 private:
  struct Literal {
    std::string noun, name;
    int line = 0;
    std::map<std::string, int> keys;
  };
  std::vector<Literal> literals_;
  std::vector<LocalName> locals_;
};

}  // namespace ashlar
