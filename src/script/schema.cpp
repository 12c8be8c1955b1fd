#include "script/schema.hpp"

#include "physics/interface_laws/interface_laws.hpp"
#include "physics/laws/laws.hpp"
#include "script/schema_keys.hpp"

namespace ashlar {

const std::vector<NounRule>& nouns() {
  using namespace schema;
  static const std::vector<NounRule> all = body_nouns() + condition_nouns() + stage_nouns() + result_nouns();
  return all;
}

const NounRule* find_noun(const std::string& name) {
  for (const auto& noun : nouns())
    if (noun.name == name) return &noun;
  return nullptr;
}

std::vector<LawDoc> laws_of(const NounRule& noun) {
  if (noun.laws == Laws::material) return material_law_docs();
  if (noun.laws == Laws::interface) return interface_law_docs();
  return {};
}

KeyRule rule_of(const Key& law_key) {
  KeyRule rule = schema::number(law_key.name.c_str(), law_key.dimension, law_key.range, law_key.doc.c_str());
  rule.required = !law_key.fallback;
  if (!law_key.choices.empty()) {
    rule.type = KeyType::choice;
    rule.choices = law_key.choices;
    if (law_key.fallback) rule.fallback_text = rule.choices[static_cast<std::size_t>(*law_key.fallback)];
  } else if (law_key.fallback && given(*law_key.fallback)) {
    rule.fallback = law_key.fallback;
  }
  return rule;
}

}  // namespace ashlar
