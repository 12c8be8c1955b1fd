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

template <class Work>
static auto of_point(const BlockLaw& law, Work work) {
  return std::visit([&]<class Law>(const Law&) {
    return work.template operator()<decltype(std::declval<Law>().template prepare<double>())>();
  }, law);
}

int history_size(const BlockLaw& law) {
  return of_point(law, []<class Point>() { return Point::history_size; });
}
Measure measure(const std::string& name) {
  return of_point(make_block_law(name, {}), []<class Point>() { return Point::measure; });
}
bool has_crack_plane(const std::string& name) {
  return of_point(make_block_law(name, {}), []<class Point>() { return Point::has_plane; });
}

double largest_length(const BlockLaw& law) {
  return std::visit([](const auto& l) { return l.largest_length(); }, law);
}
BlockLaw weakened(const BlockLaw& law, double factor) {
  return std::visit([&](const auto& l) -> BlockLaw { return l.weakened(factor); }, law);
}

}  // namespace ashlar
