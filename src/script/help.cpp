#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <numbers>
#include <sstream>

#include "base/nearest_name.hpp"
#include "script/deck.hpp"
#include "script/function_docs.hpp"
#include "script/quantity.hpp"
#include "script/schema.hpp"

namespace ashlar {
namespace {

constexpr std::size_t width = 100;

std::string padded(std::string text, std::size_t size) {
  text.resize(std::max(text.size() + 1, size), ' ');
  return text;
}

/// `text` broken at spaces; lines after the first start with `indent` spaces, the first is already `used` wide.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t used) {
  std::istringstream words(text);
  std::string all;
  for (std::string word; words >> word;) {
    const bool first = all.empty();
    if (!first && used + 1 + word.size() > width) {
      all += "\n" + std::string(indent, ' ');
      used = indent;
    } else if (!first) {
      all += ' ';
      ++used;
    }
    all += word;
    used += word.size();
  }
  return all;
}

/// The first sentence of a doc.
std::string headline(const std::string& doc) { return doc.substr(0, std::min(doc.find(". "), doc.size() - 1)); }

std::string form(const KeyRule& k) {
  const std::string unit = unit_symbol(k.dimension, k.dimension == dimension::temperature);
  switch (k.type) {
    case KeyType::number: return k.any_dimension ? "value" : k.is_angle() ? "rad" : unit.empty() ? "number" : unit;
    case KeyType::integer: return "whole";
    case KeyType::flag: return "true/false";
    case KeyType::text: return "text";
    case KeyType::choice: return "choice";
    case KeyType::choices: return "choices";
    case KeyType::names: return "name(s)";
    case KeyType::vector: return unit.empty() ? "{x,y,z}" : "{x,y,z} " + unit;
    case KeyType::field: return unit + " or function";
    case KeyType::outline: return "{{x,z},...} " + unit;
    case KeyType::outlines: return "{{{x,z},...},...} " + unit;
    case KeyType::vectors: return "{{x,y,z},{x,y,z}}";
    case KeyType::integers: return "{1,2,...}";
    case KeyType::counts: return "{[1]=4,...}";
    case KeyType::renames: return "{old=\"new\"}";
    case KeyType::interval: return "{low,high}";
    case KeyType::zero: return "0";
    case KeyType::solve: return "solve";
    case KeyType::conditions: return "list";
    case KeyType::function: return "function";
  }
  return "";
}

/// A number as the deck would write it.
std::string deck_number(const KeyRule& k, double value) {
  return k.is_angle() && value != 0 ? decimal_text(std::round(value * 180 / std::numbers::pi * 100) / 100) + "*deg"
                                    : decimal_text(value);
}

/// What the range of a key says beyond what its kind does; empty where nothing is left.
std::string range_note(const KeyRule& k) {
  const bool low = std::isfinite(k.range.low), high = std::isfinite(k.range.high) && k.range.high < 1e6;
  if (k.any_dimension || (!low && !high)) return "";
  if (k.type == KeyType::integer && !high) return "";
  if (low && high)
    return (k.range.open_low ? "above " : "") + deck_number(k, k.range.low) +
           (k.range.open_low ? ", at most " : " to ") + deck_number(k, k.range.high);
  if (low) return (k.range.open_low ? "above " : "at least ") + deck_number(k, k.range.low);
  return "at most " + deck_number(k, k.range.high);
}

std::string key_line(const KeyRule& k) {
  std::string line = padded("  " + k.name, 24) + padded(form(k), 20);
  std::string doc = k.doc;
  if (!k.choices.empty()) {
    doc += ": ";
    for (const auto& choice : k.choices) doc += (&choice == &k.choices.front() ? "\"" : ", \"") + choice + "\"";
  }
  if (k.in_time) doc += k.type == KeyType::field ? "; may change in time, with function(x, y, z, t) too" : "; may change in time";
  std::string facts = range_note(k);
  const auto add = [&](const std::string& fact) { facts += (facts.empty() ? "" : "; ") + fact; };
  if (k.required)
    add("required");
  else if (!k.fallback_text.empty())
    add("default \"" + k.fallback_text + "\"");
  else if (k.fallback && k.type == KeyType::flag)
    add(*k.fallback != 0 ? "default true" : "default false");
  else if (k.fallback)
    add("default " + deck_number(k, *k.fallback));
  if (!facts.empty()) doc += " (" + facts + ")";
  return line + wrapped(doc, 44, line.size()) + "\n";
}

std::string help_units() {
  std::string all = "Unit constants. Bare numbers are SI; temperatures are degrees Celsius.\n\n";
  for (const auto& unit : units()) all += padded("  " + unit.name, 14) + unit.doc + "\n";
  return all + "\nUse them in products: 30*GPa, 2.6*W/(m*K), 42*deg. Sums of different dimensions are errors.\n";
}

constexpr const char* lua_words[] = {
    "and",    "break",  "do",       "else",     "elseif",         "end",    "false",  "for",    "function",
    "goto",   "if",     "in",       "local",    "nil",            "not",    "or",     "repeat", "return",
    "then",   "true",   "until",    "while",    "assert",         "error",  "ipairs", "print",  "select",
    "string", "table",  "tonumber", "tostring", "math",           "type",   "utf8",   "setmetatable"};

std::string help_functions() {
  std::string all = "Functions of the deck language, beside Lua's own table, string, math and utf8.\n\n";
  for (const auto& function : function_docs()) all += function.text;
  return all;
}

std::string help_function(const std::string& name) {
  std::string all;
  for (const auto& function : function_docs())
    if (std::find(function.words.begin(), function.words.end(), name) != function.words.end()) all += function.text;
  if (!all.empty()) return "Functions\n\n" + all + "\n`ashlar help functions` shows the others.\n";
  if (std::find(std::begin(lua_words), std::end(lua_words), name) == std::end(lua_words)) return "";
  return "'" + name + "' is a word of Lua 5.4, which decks are written in: https://www.lua.org/manual/5.4\n";
}

std::string law_text(const LawDoc& law) {
  std::string all = "law = \"" + law.name + "\": " + wrapped(law.doc, 4, law.name.size() + 10) + "\n";
  for (const auto& key : law.keys) all += key_line(rule_of(key));
  return all;
}

/// A law of materials, of interfaces, or of both; "" if none has the name.
std::string help_law(const std::string& name) {
  std::string all;
  for (const Laws kind : {Laws::material, Laws::interface}) {
    std::string owners, example, text;
    for (const auto& noun : nouns()) {
      if (noun.laws != kind) continue;
      for (const auto& law : laws_of(noun))
        if (law.name == name) text = law_text(law);
      owners += (owners.empty() ? "" : " and ") + noun.name;
      if (example.empty()) example = noun.name;
    }
    if (!text.empty())
      all += (all.empty() ? "" : "\n") + ("A law of " + owners + ".\n\n") + text + "\n`ashlar help " + example +
             "` shows the keys beside those of the law, and the other laws.\n";
  }
  return all;
}

/// Everything that takes keys: nouns, and laws of nouns.
struct Owner {
  std::string title;
  std::vector<KeyRule> keys;
};
std::vector<Owner> owners() {
  std::vector<Owner> all;
  for (const auto& noun : nouns()) {
    all.push_back({noun.name, noun.keys});
    for (const auto& law : laws_of(noun)) {
      all.push_back({noun.name + ", law = \"" + law.name + "\"", {}});
      for (const auto& key : law.keys) all.back().keys.push_back(rule_of(key));
    }
  }
  return all;
}

/// The keys that are asked for, each with its owners.
template <class Wanted>
std::string key_lines(Wanted wanted) {
  std::vector<std::pair<std::string, std::string>> found;  // line of a key, owners
  for (const auto& owner : owners())
    for (const auto& key : owner.keys) {
      if (!wanted(key)) continue;
      const std::string line = key_line(key);
      const auto same = std::find_if(found.begin(), found.end(), [&](const auto& f) { return f.first == line; });
      if (same == found.end())
        found.emplace_back(line, owner.title);
      else
        same->second += "; " + owner.title;
    }
  std::string all;
  for (const auto& [line, titles] : found) all += wrapped(titles, 0, 0) + "\n" + line;
  return all;
}

/// Where a key is used; "" if nowhere.
std::string help_key(const std::string& name) {
  const std::string all = key_lines([&](const KeyRule& key) { return key.name == name; });
  return all.empty() ? all : "A key of\n\n" + all + "\n`ashlar help NOUN` shows all keys of a noun.\n";
}

/// A word that a key may take: formulation = "bbar".
std::string help_choice(const std::string& name) {
  const std::string all = key_lines([&](const KeyRule& key) {
    return std::find(key.choices.begin(), key.choices.end(), name) != key.choices.end();
  });
  return all.empty() ? all : "\"" + name + "\" is a choice of\n\n" + all;
}

std::string unit_of(const KeyRule& k) { return unit_symbol(k.dimension, k.dimension == dimension::temperature); }

/// A unit constant, with the others of its dimension and the keys that take them.
std::string help_unit(const std::string& name) {
  for (const auto& unit : units()) {
    if (unit.name != name) continue;
    std::string others;
    for (const auto& u : units())
      if (u.dimension == unit.dimension && u.name != name && u.name != "percent" && name != "percent")
        others += (others.empty() ? "" : ", ") + u.name;
    std::string keys;
    for (const auto& owner : owners())
      for (const auto& k : owner.keys) {
        const bool takes = unit.dimension == dimension::none ? k.is_angle() && name != "percent"
                                                             : k.dimension == unit.dimension && k.type != KeyType::flag;
        if (takes && (", " + keys + ",").find(", " + k.name + ",") == std::string::npos)
          keys += (keys.empty() ? "" : ", ") + k.name;
      }
    return "Unit constant " + name + ": " + unit.doc + ". Numbers are multiplied by it, as in 3*" + name + ".\n" +
           (others.empty() ? "" : "Others of its kind: " + others + "\n") +
           (keys.empty() ? "" : "Keys that take it: " + wrapped(keys, 2, 20) + "\n") +
           "`ashlar help units` shows all.\n";
  }
  const std::string all = key_lines([&](const KeyRule& key) { return !name.empty() && unit_of(key) == name; });
  return all.empty() ? all : "A unit of\n\n" + all;
}

/// A value that the functions of `expect` find in a result: .safety_factor
std::string help_result(const std::string& name) {
  const std::string& doc = find_noun("expect")->doc;
  for (std::size_t at = 0; (at = doc.find("." + name, at)) != std::string::npos; ++at) {
    const char after = doc[at + name.size() + 1];
    if (doc[at - 1] == ' ' && !std::isalnum(static_cast<unsigned char>(after)) && after != '_')
      return "A value of results, in functions of `expect`:\n\n" + wrapped(doc, 0, 0) + "\n";
  }
  return "";
}

/// All that a word means beside a noun.
std::string other_meanings(const std::string& name) {
  std::string all;
  for (const std::string& page : {help_law(name), help_key(name), help_choice(name), help_unit(name),
                                  help_function(name), help_result(name)})
    if (!page.empty()) all += (all.empty() ? "" : "\n") + page;
  return all;
}

/// Every word that a deck may contain, but those of Lua.
std::vector<std::string> known_words() {
  std::vector<std::string> all = {"units", "functions"};
  const auto add = [&](const std::string& word) {
    if (std::find(all.begin(), all.end(), word) == all.end()) all.push_back(word);
  };
  for (const auto& noun : nouns()) {
    add(noun.name);
    for (const auto& law : laws_of(noun)) add(law.name);
  }
  for (const auto& owner : owners())
    for (const auto& key : owner.keys) {
      add(key.name);
      for (const auto& choice : key.choices) add(choice);
    }
  for (const auto& unit : units()) add(unit.name);
  for (const auto& function : function_docs())
    for (const auto& word : function.words) add(word);
  return all;
}

/// Nouns whose help speaks of something that is no word of the language.
std::string nouns_that_mention(const std::string& name) {
  const auto speaks = [&](const std::string& doc) { return doc.find(name) != std::string::npos; };
  std::string all;
  for (const auto& noun : nouns()) {
    bool found = speaks(noun.doc);
    for (const auto& key : noun.keys) found = found || speaks(key.doc);
    for (const auto& law : laws_of(noun)) {
      found = found || speaks(law.doc);
      for (const auto& key : law.keys) found = found || speaks(key.doc);
    }
    if (found) all += (all.empty() ? "" : ", ") + noun.name;
  }
  return all;
}

}  // namespace

std::string help_index() {
  std::string all = "Nouns of the deck language; `ashlar help NOUN` shows the keys.\n\n";
  for (const auto& noun : nouns()) {
    const std::string line = padded("  " + noun.name, 24);
    all += line + wrapped(headline(noun.doc), 24, line.size()) + "\n";
  }
  return all +
         "\n  units                 unit constants\n  functions             deck.args, deck.read_table, in_time, interpolate, "
         "...\n\n`ashlar help WORD` knows every word of a deck: laws (brittle), keys (film), choices (bbar), units (MPa), functions.\n";
}

std::string help(const std::string& name) {
  if (name == "units") return help_units();
  if (name == "functions") return help_functions();
  const NounRule* noun = find_noun(name);
  if (!noun) {
    const std::string page = other_meanings(name);
    if (!page.empty()) return page;
    // "displacement.x", "math.sin": what stands before the dot.
    if (const auto dot = name.find('.'); dot != std::string::npos && dot > 0) return help(name.substr(0, dot));
    const std::vector<std::string> words = known_words();
    constexpr std::size_t telling = 4;  // letters of a word that is worth a search
    const auto alike = std::find_if(words.begin(), words.end(), [&](const std::string& word) {
      return std::equal(word.begin(), word.end(), name.begin(), name.end(),
                        [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); });
    });
    const std::string near = alike != words.end() ? *alike : key_meant(name, words);
    const std::string mentioned = near.empty() && name.size() >= telling ? nouns_that_mention(name) : "";
    throw DeckError({}, "help: '" + name + "' is no word of the deck language" +
                            (!near.empty()        ? ": did you mean '" + near + "'?"
                             : !mentioned.empty() ? "; the help of these nouns speaks of it: " + mentioned
                                                  : "; `ashlar help` lists its nouns"));
  }
  std::string all = noun->name +
                    (noun->naming == Naming::required   ? " \"name\" { ... }"
                     : noun->naming == Naming::optional ? " \"name\" { ... }   or   " + noun->name + " { ... }"
                                                        : " { ... }") +
                    "\n\n" + wrapped(noun->doc, 0, 0) + "\n\n";
  auto keys = noun->keys;
  const auto laws = laws_of(*noun);
  for (auto& key : keys)
    if (key.name == "law")
      for (const auto& law : laws) key.choices.push_back(law.name);
  for (const auto& key : keys) all += key_line(key);
  for (const auto& law : laws) all += "\n" + law_text(law);
  all += "\nExample\n  " + noun->example + "\n";
  std::string keyed;
  for (const auto& owner : owners())
    for (const auto& key : owner.keys)
      if (key.name == name && owner.title != name) keyed += (keyed.empty() ? "" : "; ") + owner.title;
  if (!keyed.empty()) all += "\n`" + name + "` is also a key of " + wrapped(keyed, 0, name.size() + 20) + "\n";
  const std::string choice = help_choice(name);
  return choice.empty() ? all : all + "\n" + choice;
}

}  // namespace ashlar
