#include "physics/interface_laws/interface_laws.hpp"

#include "physics/laws/laws.hpp"

namespace ashlar {

namespace {

template <class... Law>
std::vector<LawDoc> docs(std::tuple<Law...>*) {
  return {law_doc<Law>()...};
}

/// Fills `constants` if `Law` is the one asked for.
template <class Law>
bool prepared(const std::string& name, const std::map<std::string, double>& values, const Where& where,
              const std::string& what, InterfaceConstants& constants) {
  if (name != Law::name) return false;
  const auto law = make_law<Law>(values);
  constants = {law.prepare(where, what), law};
  if constexpr (requires { law.stiffness_ratio(); }) constants.stiffness_ratio = law.stiffness_ratio();
  return true;
}

template <class... Law>
bool prepared_by_one_of(std::tuple<Law...>*, const std::string& name, const std::map<std::string, double>& values,
                        const Where& where, const std::string& what, InterfaceConstants& constants) {
  return (prepared<Law>(name, values, where, what, constants) || ...);
}

}  // namespace

std::vector<LawDoc> interface_law_docs() { return docs(static_cast<InterfaceLaws*>(nullptr)); }

InterfaceConstants interface_constants(const std::string& law, const std::map<std::string, double>& values,
                                       const Where& where, const std::string& what) {
  InterfaceConstants constants;
  if (!prepared_by_one_of(static_cast<InterfaceLaws*>(nullptr), law, values, where, what, constants)) {
    std::string names;
    for (const auto& doc : interface_law_docs()) names += (names.empty() ? "" : ", ") + doc.name;
    throw DeckError(where, what + ": no interface law '" + law + "'; there are: " + names);
  }
  return constants;
}

}  // namespace ashlar
