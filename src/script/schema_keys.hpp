#pragma once
#include <string>
#include <vector>

#include "script/schema.hpp"

/// What the schema's files are written with.
namespace ashlar::schema {

using Type = KeyType;
using Keys = std::vector<KeyRule>;

inline KeyRule key(const char* name, Type type, const char* doc) {
  KeyRule rule;
  rule.name = name;
  rule.type = type;
  rule.doc = doc;
  if (type == Type::integer) rule.range = {1, 1e9};
  return rule;
}
inline KeyRule number(const char* name, Dimension dimension, Range range, const char* doc) {
  return key(name, Type::number, doc).in(dimension, range);
}
template <class Rule>
std::vector<Rule> operator+(std::vector<Rule> a, const std::vector<Rule>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Above absolute zero; 283 given for 10 degC falls inside, so K is refused where degC is meant.
constexpr Range celsius{-273.15, 5000};

/// The nouns by topic, each in the order of the help index.
std::vector<NounRule> body_nouns();
std::vector<NounRule> condition_nouns();
std::vector<NounRule> stage_nouns();
std::vector<NounRule> result_nouns();

}  // namespace ashlar::schema
