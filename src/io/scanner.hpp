#pragma once
#include <cstddef>
#include <string>
#include <string_view>

#include "base/error.hpp"

namespace ashlar {

/// Words and numbers of a file held in memory: text, or text with stretches of little-endian binary numbers. Every
/// failure is a DeckError that names the file and the line; in a file with binary stretches, the byte.
class Scanner {
 public:
  /// Reads the whole file. Throws DeckError if it cannot be read.
  Scanner(const std::string& path, const Where& where);

  bool at_end();                       ///< nothing but white space left
  std::string_view word();             ///< next word; empty at the end of the file
  long integer(const char* expected);  ///< `expected` completes "expected ...", as in "a node number"
  int small_integer(const char* expected);
  double number(const char* expected);  ///< finite
  /// How many things follow: not negative and not more than the rest of the file can hold, so that memory may be
  /// reserved for them.
  long count(const char* expected);
  std::string quoted(const char* expected);
  void keyword(std::string_view expected);
  /// Skips to just behind the word `keyword`; false if the file ends first.
  bool skip_past(std::string_view keyword);

  /// From the next line on, integer() reads `integer_bytes` (4 or 8) bytes, small_integer() 4 and number() 8, until
  /// end_binary().
  void begin_binary(int integer_bytes);
  void end_binary() { integer_bytes_ = 0; }

  /// Which list is being read: completes messages about a file with too few or too many entries.
  void begin_list(const char* things, long promised);
  void next() { ++read_; }
  void end_list() { things_ = nullptr; }

  std::size_t position() const { return at_; }
  const std::string& text() const { return text_; }  ///< the whole file
  /// Complains about the line at `position`.
  [[noreturn]] void fail(std::size_t position, const std::string& message) const;
  /// Complains about the word read last.
  [[noreturn]] void fail(const std::string& message) const { fail(word_start_, message); }
  /// Complains about the file as a whole.
  [[noreturn]] void fail_file(const std::string& message) const;
  /// "line 12" or "byte 345".
  std::string place(std::size_t position) const;

 private:
  /// The next bytes of a binary stretch as a number.
  template <typename Number>
  Number raw(const char* expected);
  std::string number_of_place(std::size_t position) const;
  [[noreturn]] void fail_expected(const std::string& expected, std::string_view found) const;

  std::string path_;
  Where where_;
  std::string text_;
  std::size_t at_ = 0;
  std::size_t word_start_ = 0;
  int integer_bytes_ = 0;  ///< 0 in text
  bool has_binary_ = false;
  const char* things_ = nullptr;
  long promised_ = 0;
  long read_ = 0;
};

}  // namespace ashlar
