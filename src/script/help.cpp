#include <cmath>
#include <numbers>
#include <sstream>

#include "base/nearest_name.hpp"
#include "script/deck.hpp"
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

std::string help_functions() {
  return R"(Functions of the deck language, beside Lua's own table, string, math and utf8.

  deck.args { size = { default = 4, unit = m, range = {1, 20}, doc = "element size" } }
      declares arguments and returns their values; ashlar run dam.lua --set size=2 changes one.
      Bare numbers are in the argument's unit. Defaults may be texts, true or false too.
  deck.read_table "air.csv"     deck.read_table("air.csv", { time = days, temperature = degC })
      columns of numbers by the names in the first line: air.time[1], air.temperature[1]. Without names they are time,
      value, value_2, ... Numbers are SI (seconds) or in the units given by column.
      The file lies beside the file that names it, or below.
  in_time { {0*days, -2*degC}, {180*days, 28*degC} }     in_time(function(t) return 10 + 8*math.sin(t/5e6) end)
      values that follow time, for every key that "may change in time"; straight lines between rows, constant before
      the first and after the last. Bare rows do too: ambient = { {0*days, 5*degC}, {30*days, 9*degC} }. So does a table
      read from a file with one column beside time; of more columns: in_time(air.time, air.temperature).
      Time is that of the run, in seconds: the durations of thermal, coupled and dynamic stages, one after the other. Other stages
      take no time: they see the values of the time reached. A function of t is sampled when the deck has been read;
      a function of position is written function(x, y, z), one of both function(x, y, z, t): it is sampled at so many
      times, when its stage begins, that straight lines between them are 1e-4 of the change off at most.
  in_stage { ... }   in_stage(function(t) ... end)
      the same, with time counted from the beginning of the stage where the condition first acts, as for a shaken base.
  interpolate(places, values, x)
      value at x of the polyline through the points; places ascend; constant beyond the ends.
  pairs(t)
      visits keys in a fixed order: numbers, then texts, each ascending.
  strict(t, "what")
      t, which from then on answers a wrong key with the right ones.
  require "seasons"
      runs seasons.lua beside the deck, once, and returns what it returns.
)";
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

/// Where a key is used; "" if nowhere.
std::string help_key(const std::string& name) {
  std::string all;
  for (const auto& noun : nouns()) {
    for (const auto& key : noun.keys)
      if (key.name == name) all += noun.name + "\n" + key_line(key);
    for (const auto& law : laws_of(noun))
      for (const auto& key : law.keys)
        if (key.name == name) all += noun.name + ", law = \"" + law.name + "\"\n" + key_line(rule_of(key));
  }
  return all.empty() ? all : "A key, no noun. It belongs to\n\n" + all + "\n`ashlar help NOUN` shows all keys of a noun.\n";
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
         "...\n\n`ashlar help NAME` also knows laws (jointed, brittle, ...) and keys (film, young, ...).\n";
}

std::string help(const std::string& name) {
  if (name == "units") return help_units();
  if (name == "functions") return help_functions();
  const NounRule* noun = find_noun(name);
  if (!noun) {
    for (const std::string& page : {help_law(name), help_key(name)})
      if (!page.empty()) return page;
    std::vector<std::string> valid = {"units", "functions"}, laws;
    for (const auto& n : nouns()) {
      valid.push_back(n.name);
      for (const auto& law : laws_of(n)) laws.push_back(law.name);
    }
    if (nearest_name(name, valid).empty() && !nearest_name(name, laws).empty()) valid = laws;
    throw DeckError({}, "help: there is no noun '" + name + "'" + suggest_name(name, valid));
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
  return all + "\nExample\n  " + noun->example + "\n";
}

}  // namespace ashlar
