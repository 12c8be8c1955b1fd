#include "io/abaqus_lines.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace ashlar::abaqus {

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

std::string shown(std::string_view text) {
  std::string result(text.substr(0, 40));
  for (char& c : result)
    if (static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126) c = '?';
  return "'" + result + "'";
}

static Field trimmed(Field field) {
  auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '"'; };
  while (!field.text.empty() && is_blank(field.text.front())) field.text.remove_prefix(1), ++field.position;
  while (!field.text.empty() && is_blank(field.text.back())) field.text.remove_suffix(1);
  return field;
}

std::vector<Field> split(const Field& line) {
  std::vector<Field> fields;
  for (std::size_t begin = 0; begin <= line.text.size();) {
    const auto comma = std::min(line.text.find(',', begin), line.text.size());
    fields.push_back(trimmed({line.text.substr(begin, comma - begin), line.position + begin}));
    begin = comma + 1;
  }
  if (fields.back().text.empty()) fields.pop_back();
  return fields;
}

/// The next line that is neither empty nor a comment.
std::optional<Field> Lines::peek() {
  const std::string_view text = scanner_.text();
  while (at_ < text.size()) {
    const auto end = std::min(text.find('\n', at_), text.size());
    const Field line = trimmed({text.substr(at_, end - at_), at_});
    if (!line.text.empty() && !line.text.starts_with("**")) return line;
    at_ = end + 1;
  }
  return {};
}

Field Lines::take() {
  const Field line = *peek();
  at_ = std::min(scanner_.text().find('\n', at_), scanner_.text().size()) + 1;
  return line;
}

std::optional<Field> Lines::data() {
  const auto line = peek();
  if (!line || line->text[0] == '*') return {};
  return take();
}

Card Lines::card() {
  Field line = take();
  if (line.text[0] != '*')
    scanner_.fail(line.position, "expected a keyword line that begins with '*', found " + shown(line.text));
  Card card;
  card.position = line.position;
  auto fields = split(line);
  if (fields.empty()) scanner_.fail(line.position, "there is no keyword after '*'");
  while (line.text.back() == ',') {
    const auto more = data();
    if (!more) break;
    line = *more;
    for (const Field& field : split(line)) fields.push_back(field);
  }
  for (const char c : upper(fields[0].text.substr(1)))
    if (c != ' ' || !card.keyword.ends_with(' ')) card.keyword += c;
  for (std::size_t i = 1; i < fields.size(); ++i) {
    const auto equals = std::min(fields[i].text.find('='), fields[i].text.size());
    const Field name = trimmed({fields[i].text.substr(0, equals), fields[i].position});
    const auto value = std::min(equals + 1, fields[i].text.size());
    card.parameters[upper(name.text)] = trimmed({fields[i].text.substr(value), fields[i].position + value});
  }
  return card;
}

long Lines::integer(const Field& field, const char* expected) const {
  long value = 0;
  const char* end = field.text.data() + field.text.size();
  const auto [stop, error] = std::from_chars(field.text.data(), end, value);
  if (error != std::errc() || stop != end)
    scanner_.fail(field.position, std::string("expected ") + expected + ", found " + shown(field.text));
  return value;
}

double Lines::real(const Field& field, const char* expected) const {
  std::string text(field.text);
  for (char& c : text)
    if (c == 'd' || c == 'D') c = 'e';
  const char* begin = text.c_str() + (text.starts_with('+') ? 1 : 0);
  double value = 0;
  const auto [stop, error] = std::from_chars(begin, text.c_str() + text.size(), value);
  if (error != std::errc() || stop != text.c_str() + text.size() || !std::isfinite(value))
    scanner_.fail(field.position, std::string("expected ") + expected + ", found " + shown(field.text));
  return value;
}

const Field& Lines::parameter(const Card& card, const char* name) const {
  const auto it = card.parameters.find(name);
  if (it == card.parameters.end() || it->second.text.empty())
    scanner_.fail(card.position, "*" + card.keyword + " needs " + name + "=...");
  return it->second;
}

void Lines::refuse_parameters(const Card& card, std::initializer_list<const char*> names) const {
  for (const char* name : names)
    if (card.parameters.contains(name))
      scanner_.fail(card.position, "*" + card.keyword + " with " + name +
                                       " is not read; list everything in this file, in global Cartesian coordinates");
}

}  // namespace ashlar::abaqus
