#include "io/scanner.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <climits>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace ashlar {

namespace {

bool is_space(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

/// A word as it is shown in a message: short and printable.
std::string shown(std::string_view word) {
  std::string text(word.substr(0, 40));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126) c = '?';
  return "'" + text + (word.size() > 40 ? "..." : "") + "'";
}

}  // namespace

Scanner::Scanner(const std::string& path, const Where& where) : path_(path), where_(where) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw DeckError(where, "there is no mesh file '" + path + "'");
  if (!std::filesystem::is_regular_file(status)) throw DeckError(where, "'" + path + "' is not a file");
  const auto size = std::filesystem::file_size(path, error);
  std::ifstream stream(path, std::ios::binary);
  if (error || !stream) throw DeckError(where, "cannot read mesh file '" + path + "': " + std::strerror(errno));
  text_.resize(size);
  stream.read(text_.data(), static_cast<std::streamsize>(size));
  if (static_cast<std::size_t>(stream.gcount()) != size)
    throw DeckError(where, "cannot read mesh file '" + path + "' to its end");
}

bool Scanner::at_end() {
  while (at_ < text_.size() && is_space(text_[at_])) ++at_;
  return at_ == text_.size();
}

std::string_view Scanner::word() {
  at_end();
  word_start_ = at_;
  while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
  return std::string_view(text_).substr(word_start_, at_ - word_start_);
}

void Scanner::begin_binary(int integer_bytes) {
  while (at_ < text_.size() && text_[at_] != '\n' && is_space(text_[at_])) ++at_;
  word_start_ = at_;
  has_binary_ = true;
  if (at_ == text_.size() || text_[at_] != '\n') fail("expected the end of the line before binary numbers");
  ++at_;
  integer_bytes_ = integer_bytes;
}

template <typename Number>
Number Scanner::raw(const char* expected) {
  word_start_ = at_;
  if (text_.size() - at_ < sizeof(Number)) fail_expected(expected, {});
  Number value;
  std::memcpy(&value, text_.data() + at_, sizeof value);
  at_ += sizeof value;
  return value;
}

int Scanner::small_integer(const char* expected) {
  const long value = integer_bytes_ ? raw<std::int32_t>(expected) : integer(expected);
  if (value > INT_MAX || value < -INT_MAX)
    fail(std::string("expected ") + expected + ", found " + std::to_string(value) + ": too large");
  return static_cast<int>(value);
}

long Scanner::integer(const char* expected) {
  if (integer_bytes_ == 4) return raw<std::int32_t>(expected);
  if (integer_bytes_ == 8) return raw<std::int64_t>(expected);
  const auto found = word();
  long value = 0;
  const char* end = found.data() + found.size();
  const auto [stop, error] = std::from_chars(found.data(), end, value);
  if (error == std::errc::result_out_of_range) fail("the number " + shown(found) + " is too large");
  if (error != std::errc() || stop != end) fail_expected(expected, found);
  return value;
}

double Scanner::number(const char* expected) {
  if (integer_bytes_) {
    const double value = raw<double>(expected);
    if (!std::isfinite(value)) fail(std::string("expected ") + expected + ", a finite number, found nan or infinity");
    return value;
  }
  const auto found = word();
  double value = 0;
  const char* begin = found.data();
  const char* end = begin + found.size();
  if (begin != end && *begin == '+') ++begin;
  const auto [stop, error] = std::from_chars(begin, end, value);
  // Denormal or overflowing text: from_chars says out of range for both; a coordinate has no use for either.
  if (error == std::errc::result_out_of_range) fail("the number " + shown(found) + " is out of range");
  if (error != std::errc() || stop != end) fail_expected(expected, found);
  if (!std::isfinite(value)) fail(std::string("expected ") + expected + ", a finite number, found " + shown(found));
  return value;
}

long Scanner::count(const char* expected) {
  const long value = integer(expected);
  if (value < 0) fail(std::string("expected ") + expected + ", found " + std::to_string(value));
  // Every entry takes at least a digit and a separator, or a binary integer.
  const auto left = (text_.size() - at_) / (integer_bytes_ ? 4 : 2);
  if (static_cast<unsigned long>(value) > left)
    fail(std::string("expected ") + expected + ", found " + std::to_string(value) + ", but the file has only " +
         std::to_string(text_.size() - at_) + " bytes left: the count is wrong or the file is truncated");
  return value;
}

std::string Scanner::quoted(const char* expected) {
  at_end();
  word_start_ = at_;
  if (at_ == text_.size() || text_[at_] != '"') fail_expected(expected, word());
  const auto close = text_.find_first_of("\"\n", at_ + 1);
  if (close == std::string::npos || text_[close] != '"') fail("the quoted name does not end on its line");
  std::string name = text_.substr(at_ + 1, close - at_ - 1);
  at_ = close + 1;
  return name;
}

void Scanner::keyword(std::string_view expected) {
  const auto found = word();
  if (found != expected) fail_expected(std::string(expected), found);
}

bool Scanner::skip_past(std::string_view keyword) {
  for (auto found = text_.find(keyword, at_); found != std::string::npos; found = text_.find(keyword, found + 1)) {
    const auto end = found + keyword.size();
    if ((found > 0 && !is_space(text_[found - 1])) || (end < text_.size() && !is_space(text_[end]))) continue;
    at_ = end;
    return true;
  }
  return false;
}

void Scanner::begin_list(const char* things, long promised) {
  things_ = things;
  promised_ = promised;
  read_ = 0;
}

void Scanner::fail_expected(const std::string& expected, std::string_view found) const {
  std::string message = "expected " + expected;
  message += found.empty() ? ", but the file ends here: it is truncated" : ", found " + shown(found);
  if (things_)
    message += " (" + std::to_string(read_) + " of the " + std::to_string(promised_) + " " + things_ +
               " that the section announces were read)";
  fail(message);
}

void Scanner::fail(std::size_t position, const std::string& message) const {
  throw DeckError(where_, path_ + (has_binary_ ? ":byte " : ":") + number_of_place(position) + ": " + message);
}

void Scanner::fail_file(const std::string& message) const { throw DeckError(where_, path_ + ": " + message); }

std::string Scanner::place(std::size_t position) const {
  return (has_binary_ ? "byte " : "line ") + number_of_place(position);
}

std::string Scanner::number_of_place(std::size_t position) const {
  const auto end = std::min(position, text_.size());
  if (has_binary_) return std::to_string(end);
  return std::to_string(1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
}

}  // namespace ashlar
