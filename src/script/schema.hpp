#pragma once
#include <string>
#include <vector>

#include "base/key.hpp"
#include "model/model.hpp"

/// The deck language as data: the one source of validation, of `ashlar help NOUN` and of the tests of both.
namespace ashlar {

enum class KeyType {
  number,  ///< number or quantity
  integer,
  flag,  ///< true or false
  text,
  choice,      ///< one of `choices`
  choices,     ///< one or several of `choices`
  names,       ///< one name or a list of names
  vector,      ///< { x, y, z }, numbers or quantities
  field,       ///< number, quantity or function(x, y, z)
  outline,     ///< { {x, z}, {x, z}, ... }
  outlines,    ///< { { {x, z}, ... }, ... }
  vectors,     ///< two vectors: { {x, y, z}, {x, y, z} }
  integers,    ///< { 1, 2, 3 }
  counts,      ///< { [1] = 4, [3] = 8 }
  renames,     ///< { old = "new" }
  interval,    ///< { low, high }, numbers or quantities
  zero,        ///< 0 or true: held
  solve,       ///< static {...}, thermal {...}, fracture {...}, coupled {...}, dynamic {...} or strength_reduction {...}
  conditions,  ///< list of conditions, lists inside lists allowed
  function,
};

struct KeyRule {
  std::string name;
  KeyType type = KeyType::number;
  std::string doc;
  Dimension dimension{};
  Range range{};
  bool in_time = false;        ///< may follow a table or function of time
  bool any_dimension = false;  ///< judged later, by what it is compared with
  bool required = false;
  std::optional<double> fallback;  ///< numbers, integers, flags
  std::string fallback_text;       ///< choices and names
  std::vector<std::string> choices;

  /// Angles have no dimension: their doc says that they may be given in *deg.
  bool is_angle() const { return dimension == Dimension{} && doc.find("*deg") != std::string::npos; }

  KeyRule in(Dimension d, Range r = range::any) const {
    return with([&](KeyRule& k) { k.dimension = d, k.range = r; });
  }
  KeyRule between(Range r) const {
    return with([&](KeyRule& k) { k.range = r; });
  }
  KeyRule need() const {
    return with([](KeyRule& k) { k.required = true; });
  }
  KeyRule otherwise(double value) const {
    return with([&](KeyRule& k) { k.fallback = value; });
  }
  KeyRule otherwise_text(const char* value) const {
    return with([&](KeyRule& k) { k.fallback_text = value; });
  }
  KeyRule changing() const {
    return with([](KeyRule& k) { k.in_time = true; });
  }
  KeyRule of(std::vector<std::string> values) const {
    return with([&](KeyRule& k) { k.choices = std::move(values); });
  }
  KeyRule of_any_dimension() const {
    return with([](KeyRule& k) { k.any_dimension = true; });
  }

 private:
  template <class Change>
  KeyRule with(Change change) const {
    KeyRule k = *this;
    change(k);
    return k;
  }
};

enum class Naming { required, optional, none };
/// What a call of the noun returns and when it acts.
enum class NounKind { declaration, condition, solve };
enum class Laws { none, material, interface };

struct NounRule {
  std::string name;
  NounKind kind = NounKind::declaration;
  Naming naming = Naming::required;
  std::string doc;
  std::vector<KeyRule> keys;
  std::string example;
  Laws laws = Laws::none;  ///< more keys come from the law that the key `law` names
};

/// In the order of the help index.
const std::vector<NounRule>& nouns();
const NounRule* find_noun(const std::string& name);
std::vector<LawDoc> laws_of(const NounRule& noun);
/// The key that a name from books or other programs stands for, as "E" for young; "" if none of `valid` is meant.
std::string key_meant(const std::string& name, const std::vector<std::string>& valid);
/// A law's number as a deck key.
KeyRule rule_of(const Key& key);

/// Names that `record` of a history or output may hold.
struct Recorded {
  std::string name;
  Dimension dimension;
  std::vector<std::string> components;  ///< of a history; empty: one number
  bool at_point, on_surface, in_output, of_model = false;
};
const std::vector<Recorded>& recorded();
/// Columns that a history will have.
std::vector<std::string> columns_of(const History& history);

}  // namespace ashlar
