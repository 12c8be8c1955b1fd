#include "physics/laws/laws.hpp"

#include <optional>
#include <stdexcept>

namespace ashlar {

template <class... Law>
static std::vector<LawDoc> docs(std::tuple<Law...>*) {
  return {law_doc<Law>()...};
}

std::vector<LawDoc> material_law_docs() { return docs(static_cast<BlockLaws*>(nullptr)); }

template <class... Law>
static BlockLaw make(const std::string& name, const std::map<std::string, double>& values, std::tuple<Law...>*) {
  std::optional<BlockLaw> law;
  ((name == Law::name ? void(law = make_law<Law>(values)) : void()), ...);
  if (!law) throw std::invalid_argument("no block law is called '" + name + "'");
  return *law;
}

BlockLaw make_block_law(const std::string& name, const std::map<std::string, double>& values) {
  return make(name, values, static_cast<BlockLaws*>(nullptr));
}

std::vector<LawComplaint> law_complaints(const std::string& name, const std::map<std::string, double>& values) {
  return std::visit([](const auto& law) { return law.complaints(); }, make_block_law(name, values));
}

bool is_plastic(const std::string& name) { return history_size(make_block_law(name, {})) > 0; }

int history_size(const BlockLaw& law) {
  return std::visit([](const auto& l) { return decltype(l.template prepare<double>())::history_size; }, law);
}

}  // namespace ashlar
