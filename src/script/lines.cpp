#include "script/lines.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

namespace ashlar {
namespace {

struct Token {
  enum Kind { word, text, symbol } kind;
  std::string value;
  int line;
};

class Lexer {
 public:
  explicit Lexer(const std::string& source) : s_(source) {}

  std::vector<Token> tokens() {
    std::vector<Token> found;
    while (skip_space(), at_ < s_.size()) {
      const char c = s_[at_];
      const int line = line_;
      if (std::isalpha(static_cast<unsigned char>(c)) || c == '_') {
        const std::size_t start = at_;
        while (at_ < s_.size() && (std::isalnum(static_cast<unsigned char>(s_[at_])) || s_[at_] == '_')) ++at_;
        found.push_back({Token::word, s_.substr(start, at_ - start), line});
      } else if (std::isdigit(static_cast<unsigned char>(c))) {
        while (at_ < s_.size() && (std::isalnum(static_cast<unsigned char>(s_[at_])) || s_[at_] == '.')) ++at_;
        found.push_back({Token::symbol, "0", line});
      } else if (c == '"' || c == '\'') {
        found.push_back({Token::text, short_string(c), line});
      } else if (c == '[' && long_level() >= 0) {
        found.push_back({Token::text, long_string(), line});
      } else if (c == '=' && s_.compare(at_, 2, "==") == 0) {
        at_ += 2;
        found.push_back({Token::symbol, "==", line});
      } else {
        ++at_;
        found.push_back({Token::symbol, std::string(1, c), line});
      }
    }
    return found;
  }

 private:
  void step() {
    if (s_[at_++] == '\n') ++line_;
  }
  void skip_space() {
    while (at_ < s_.size()) {
      if (std::isspace(static_cast<unsigned char>(s_[at_]))) {
        step();
      } else if (s_.compare(at_, 2, "--") == 0 || (at_ == 0 && s_[0] == '#')) {
        at_ += s_[at_] == '#' ? 1 : 2;
        if (at_ < s_.size() && s_[at_] == '[' && long_level() >= 0)
          long_string();
        else
          while (at_ < s_.size() && s_[at_] != '\n') ++at_;
      } else {
        return;
      }
    }
  }
  /// Number of '=' of a long bracket at the cursor, -1 if it is none.
  int long_level() const {
    std::size_t i = at_ + 1;
    while (i < s_.size() && s_[i] == '=') ++i;
    return i < s_.size() && s_[i] == '[' ? static_cast<int>(i - at_ - 1) : -1;
  }
  std::string long_string() {
    const std::string close = "]" + std::string(long_level(), '=') + "]";
    at_ += close.size();
    const std::size_t start = at_;
    while (at_ < s_.size() && s_.compare(at_, close.size(), close) != 0) step();
    const std::string value = s_.substr(start, at_ - start);
    at_ += close.size();
    return value;
  }
  std::string short_string(char quote) {
    std::string value;
    ++at_;
    while (at_ < s_.size() && s_[at_] != quote && s_[at_] != '\n') {
      if (s_[at_] == '\\' && at_ + 1 < s_.size()) step();
      value += s_[at_];
      step();
    }
    ++at_;
    return value;
  }

  const std::string& s_;
  std::size_t at_ = 0;
  int line_ = 1;
};

/// An open table constructor.
struct Frame {
  int literal = -1;  ///< the call that it belongs to, -1: none
  std::string path;  ///< "" for the call's own table, "water." inside its key `water`
  std::string key;   ///< key of the field being read
  int position = 0;  ///< of the last positional field
  int nested = 0;    ///< open parentheses and function bodies inside the field
  bool field_start = true;
};

/// Names that a deck declares, and whether they are used as factors while they are seen.
class Locals {
 public:
  explicit Locals(const std::vector<Token>& tokens) : tokens_(tokens) {}

  std::vector<LocalName> all() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (is(i, "repeat") || is(i, "if")) ++depth_;
      if (is(i, "do")) {
        ++depth_;
        for (const std::size_t name : std::exchange(loop_, {})) declare(name, true);
      }
      if (is(i, "end") || is(i, "until")) leave();
      if (is(i, "for")) loop_ = names_from(i + 1);
      if (is(i, "function")) enter_function(i);
      if (is(i, "local") && is(i + 1, "function")) declare(i + 2, false);
      if (is(i, "local") && !is(i + 1, "function"))
        for (const std::size_t name : names_from(i + 1)) declare(name, false);
      if (i > 1 && tokens_[i].kind == Token::word && (is(i - 1, "*") || is(i - 1, "/")) && is(i - 2, "0"))
        use(tokens_[i].value);
    }
    return std::move(found_);
  }

 private:
  bool is(std::size_t i, const char* word) const {
    return i < tokens_.size() && tokens_[i].kind != Token::text && tokens_[i].value == word;
  }
  /// Places of the names of `a, b, c` from a place on; attributes such as <const> are passed.
  std::vector<std::size_t> names_from(std::size_t i) const {
    std::vector<std::size_t> names;
    while (i < tokens_.size() && tokens_[i].kind == Token::word) {
      names.push_back(i++);
      if (is(i, "<")) i += 3;
      if (!is(i, ",")) break;
      ++i;
    }
    return names;
  }
  void enter_function(std::size_t i) {
    ++depth_;
    while (i < tokens_.size() && !is(i, "(")) ++i;
    for (const std::size_t name : names_from(i + 1)) declare(name, true);
  }
  void declare(std::size_t i, bool of_block) {
    if (i >= tokens_.size() || tokens_[i].kind != Token::word) return;
    seen_.push_back({found_.size(), depth_});
    found_.push_back({tokens_[i].value, tokens_[i].line, of_block || depth_ > 0, false});
  }
  void leave() {
    if (depth_ > 0) --depth_;
    while (!seen_.empty() && seen_.back().depth > depth_) seen_.pop_back();
  }
  void use(const std::string& name) {
    for (auto seen = seen_.rbegin(); seen != seen_.rend(); ++seen)
      if (LocalName& local = found_[seen->index]; local.name == name) {
        local.is_factor = true;
        return;
      }
  }

  struct Seen {
    std::size_t index;
    int depth;
  };
  const std::vector<Token>& tokens_;
  std::vector<LocalName> found_;
  std::vector<Seen> seen_;         ///< those in whose block the cursor is
  int depth_ = 0;                  ///< of blocks that are open
  std::vector<std::size_t> loop_;  ///< names of a loop whose `do` is still to come
};

bool opens(const Token& t) {
  if (t.kind == Token::symbol) return t.value == "(";
  return t.kind == Token::word && (t.value == "function" || t.value == "do" || t.value == "if" || t.value == "repeat");
}
bool closes(const Token& t) {
  if (t.kind == Token::symbol) return t.value == ")";
  return t.kind == Token::word && (t.value == "end" || t.value == "until");
}

}  // namespace

DeckLines::DeckLines(const std::string& text) {
  const auto tokens = Lexer(text).tokens();
  locals_ = Locals(tokens).all();
  std::vector<Frame> frames;
  auto is = [&](std::size_t i, const char* symbol) {
    return i < tokens.size() && tokens[i].kind == Token::symbol && tokens[i].value == symbol;
  };
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const Token& t = tokens[i];
    Frame* frame = frames.empty() ? nullptr : &frames.back();
    if (frame && frame->field_start && frame->nested == 0 && !is(i, "}")) {
      frame->field_start = false;
      frame->key.clear();
      if (t.kind == Token::word && is(i + 1, "=")) frame->key = t.value;
      if (is(i, "[") && i + 3 < tokens.size() && tokens[i + 1].kind == Token::text && is(i + 3, "="))
        frame->key = tokens[i + 1].value;
      if (frame->key.empty()) frame->key = std::to_string(++frame->position);
      if (frame->literal >= 0) literals_[frame->literal].keys.emplace(frame->path + frame->key, t.line);
    }
    if (is(i, "{")) {
      // noun {, noun "name" {, noun ({, noun "name" ({
      std::size_t before = i;
      if (before > 0 && is(before - 1, "(")) --before;
      // noun("name" .. i) {
      if (before > 0 && is(before - 1, ")")) {
        int open = 0;
        do {
          --before;
          open += is(before, ")") - is(before, "(");
        } while (open > 0 && before > 0);
      }
      std::string name;
      if (before > 0 && tokens[before - 1].kind == Token::text) name = tokens[--before].value;
      Frame opened;
      if (before > 0 && tokens[before - 1].kind == Token::word && tokens[before - 1].value != "return") {
        opened.literal = static_cast<int>(literals_.size());
        literals_.push_back({tokens[before - 1].value, name, tokens[before - 1].line, {}});
      } else if (frame && frame->literal >= 0) {
        opened.literal = frame->literal;
        opened.path = frame->path + frame->key + ".";
      }
      frames.push_back(opened);
    } else if (frame && is(i, "}")) {
      frames.pop_back();
    } else if (frame && opens(t)) {
      ++frame->nested;
    } else if (frame && closes(t)) {
      --frame->nested;
    } else if (frame && frame->nested == 0 && (is(i, ",") || is(i, ";"))) {
      frame->field_start = true;
    }
  }
}

int DeckLines::line(int call_line, const std::string& noun, const std::string& name, std::string key) const {
  while (!key.empty()) {
    for (const auto& literal : literals_)
      if (literal.line == call_line && literal.noun == noun && (literal.name.empty() || literal.name == name))
        if (auto found = literal.keys.find(key); found != literal.keys.end()) return found->second;
    const auto dot = key.rfind('.');
    key = dot == std::string::npos ? "" : key.substr(0, dot);
  }
  return call_line;
}

}  // namespace ashlar
