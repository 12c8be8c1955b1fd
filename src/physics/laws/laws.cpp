#include "physics/laws/laws.hpp"

namespace ashlar {

template <class... Law>
static std::vector<LawDoc> docs(std::tuple<Law...>*) {
  return {law_doc<Law>()...};
}

std::vector<LawDoc> material_law_docs() { return docs(static_cast<BlockLaws*>(nullptr)); }

}  // namespace ashlar
