#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "script/quantity.hpp"
#include "script/sandbox.hpp"
#include "script/schema.hpp"

namespace ashlar {

/// What a condition or solve noun returns to the deck: its index in the model; -1 if it had errors.
struct Handle {
  NounKind kind;
  int index;
};
void push_handle(lua_State* L, const Handle& handle);

/// A function of the deck, kept in the Lua registry for as long as its sandbox lives.
struct DeckFunction {
  int reference = 0;
};

/// The checked table of one noun call. Asking for a key that is absent and has no default is an error of this program.
class Fields {
 public:
  bool has(const std::string& key) const { return values_.contains(key); }
  double number(const std::string& key) const { return values_.at(key).quantities.at(0).value; }
  std::optional<double> maybe(const std::string& key) const;
  const Quantity& quantity(const std::string& key, int i = 0) const { return values_.at(key).quantities.at(i); }
  std::vector<double> numbers(const std::string& key) const;
  std::vector<std::vector<std::array<double, 2>>> outlines(const std::string& key) const { return values_.at(key).outlines; }
  Vec3<double> vector(const std::string& key, int i = 0) const;
  int integer(const std::string& key) const { return static_cast<int>(number(key)); }
  bool flag(const std::string& key) const { return number(key) != 0; }
  std::string text(const std::string& key) const { return has(key) ? values_.at(key).texts.at(0) : ""; }
  std::vector<std::string> texts(const std::string& key) const;
  /// Key and value of a `counts` or `renames` table, as texts.
  const std::map<std::string, std::string>& renames(const std::string& key) const { return values_.at(key).renames; }
  const Value& value(const std::string& key) const { return values_.at(key).value; }
  std::optional<Value> maybe_value(const std::string& key) const;
  const std::vector<int>& handles(const std::string& key) const { return values_.at(key).handles; }
  /// Numbers that follow time, by key.
  std::vector<InTime> in_time() const;
  DeckFunction function(const std::string& key) const { return values_.at(key).function; }
  Where where;                             ///< of the call
  Where at(const std::string& key) const;  ///< of the key
  std::map<std::string, double> law_values;

 private:
  friend class FieldReader;
  struct Field {
    std::vector<Quantity> quantities;
    std::vector<std::vector<std::array<double, 2>>> outlines;
    std::vector<std::string> texts;
    std::map<std::string, std::string> renames;
    Value value;
    std::optional<InTime> in_time;
    std::vector<int> handles;
    DeckFunction function;
    Where where;
  };
  std::map<std::string, Field> values_;
};

/// "material 'concrete'" or "gravity".
std::string title(const std::string& noun, const std::string& name);

/// Checks the table at `index` against the noun's schema. Every complaint goes to the sandbox; nothing is returned if
/// there was one.
std::optional<Fields> read_fields(Sandbox& sandbox, const NounRule& noun, const std::string& name, int index);

/// What is wrong with a number for a key, "" if nothing: "is 30 m; expected a pressure ...".
std::string number_complaint(const KeyRule& rule, const Quantity& quantity);

}  // namespace ashlar
