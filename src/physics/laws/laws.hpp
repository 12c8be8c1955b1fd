#pragma once
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "physics/laws/elastic.hpp"

/// The register of block laws. Adding one: its header, its name in this list, its test.
namespace ashlar {

using BlockLaws = std::tuple<Elastic>;

std::vector<LawDoc> material_law_docs();

/// A law with its members set from the deck's values; keys that are missing take their fallback (the schema has refused
/// missing required keys before).
template <class Law>
Law make_law(const std::map<std::string, double>& values) {
  Law law;
  for (const auto& key : Law::keys) {
    const auto found = values.find(key.name);
    if (found != values.end()) law.*key.member = found->second;
    else if (key.fallback) law.*key.member = *key.fallback;
  }
  return law;
}

}  // namespace ashlar
