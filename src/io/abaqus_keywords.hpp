#pragma once
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/tensor.hpp"
#include "io/abaqus_lines.hpp"
#include "io/mesh_content.hpp"

/// What the keywords of an Abaqus file say, before numbers and names are looked up.
namespace ashlar::abaqus {

struct NumberSet {
  std::string name;         ///< as first written
  bool by_keyword = false;  ///< of *ELSET, not only of *ELEMENT
  std::vector<long> numbers;
  std::size_t position = 0;
};

/// Sets in the order of the file, found without regard to case.
class NumberSets {
 public:
  NumberSet& make(const Field& name);
  const NumberSet* find(std::string_view name) const;  ///< null where there is none
  const std::vector<NumberSet>& all() const { return sets_; }

 private:
  std::map<std::string, std::size_t> index_;
  std::vector<NumberSet> sets_;
};

struct ElementType {
  const char* name;
  std::optional<Cell> cell;  ///< none: a line, which only marks its nodes
};
struct RawElement {
  const ElementType* type;
  long id;
  std::size_t position;
  std::size_t first_node;  ///< in Keywords::element_nodes
};

struct RawSurface {
  Field name;
  std::vector<std::pair<Field, Field>> faces;  ///< element or set, label
};

struct Keywords {
  std::vector<long> node_ids;
  std::vector<Vec3<double>> points;
  NumberSets element_sets, node_sets;
  std::vector<RawElement> elements;
  std::vector<long> element_nodes;
  std::vector<Field> sections;  ///< element sets of *SOLID SECTION
  std::vector<RawSurface> surfaces;
};

/// Throws DeckError: what is malformed, and keywords that make or move parts of the mesh.
Keywords read_keywords(Scanner& scanner);

}  // namespace ashlar::abaqus
