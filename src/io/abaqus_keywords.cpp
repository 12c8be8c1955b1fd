#include "io/abaqus_keywords.hpp"

#include <cctype>
#include <climits>

namespace ashlar::abaqus {

NumberSet& NumberSets::make(const Field& name) {
  const auto [it, is_new] = index_.try_emplace(upper(name.text), sets_.size());
  if (is_new) sets_.push_back({std::string(name.text), false, {}, name.position});
  return sets_[it->second];
}
const NumberSet* NumberSets::find(std::string_view name) const {
  const auto it = index_.find(upper(name));
  return it == index_.end() ? nullptr : &sets_[it->second];
}

namespace {

constexpr ElementType element_types[] = {
    {"C3D8", Cell::hex8},   {"C3D8I", Cell::hex8},   {"C3D8R", Cell::hex8},  {"C3D6", Cell::wedge6},
    {"C3D4", Cell::tet4},   {"CPS3", Cell::tri3},    {"CPE3", Cell::tri3},   {"S3", Cell::tri3},
    {"S3R", Cell::tri3},    {"M3D3", Cell::tri3},    {"SFM3D3", Cell::tri3}, {"CPS4", Cell::quad4},
    {"CPE4", Cell::quad4},  {"S4", Cell::quad4},     {"S4R", Cell::quad4},   {"M3D4", Cell::quad4},
    {"M3D4R", Cell::quad4}, {"SFM3D4", Cell::quad4}, {"T3D2", {}},
};

class KeywordReader {
 public:
  explicit KeywordReader(Scanner& scanner) : scanner_(scanner), lines_(scanner) {}
  Keywords read();

 private:
  void read_nodes(const Card& card);
  void read_elements(const Card& card);
  void read_set(const Card& card, const char* name_parameter, NumberSets& sets);
  void check_growth(long more, std::size_t position);
  void read_surface(const Card& card);

  Scanner& scanner_;
  Lines lines_;
  Keywords found_;
  long generated_ = 0;  ///< members of sets that no line lists
};

void KeywordReader::read_nodes(const Card& card) {
  lines_.refuse_parameters(card, {"INPUT", "SYSTEM"});
  const auto set = card.parameters.find("NSET");
  NumberSet* nodes = set == card.parameters.end() ? nullptr : &found_.node_sets.make(lines_.parameter(card, "NSET"));
  while (const auto line = lines_.data()) {
    const auto fields = split(*line);
    if (fields.size() != 4)
      scanner_.fail(line->position, "expected a node number and three coordinates, found " +
                                        std::to_string(fields.size()) + " entries");
    const long id = lines_.integer(fields[0], "a node number");
    if (found_.node_ids.size() == INT_MAX) scanner_.fail(line->position, "more than 2^31 nodes");
    found_.node_ids.push_back(id);
    found_.points.push_back({lines_.real(fields[1], "a coordinate x"), lines_.real(fields[2], "a coordinate y"),
                             lines_.real(fields[3], "a coordinate z")});
    if (nodes) nodes->numbers.push_back(id);
  }
}

void KeywordReader::read_elements(const Card& card) {
  lines_.refuse_parameters(card, {"INPUT", "FILE", "OFFSET"});
  const Field& given = lines_.parameter(card, "TYPE");
  const std::string name = upper(given.text);
  const ElementType* type = nullptr;
  for (const auto& known : element_types)
    if (known.name == name) type = &known;
  if (!type) {
    for (const char* order : {"C3D10", "C3D15", "C3D20", "C3D27"})
      if (name.starts_with(order))
        scanner_.fail(card.position, "element type " + name +
                                         " is of second order; only first-order elements are read: mesh again with "
                                         "C3D8, C3D6 or C3D4");
    scanner_.fail(card.position, "element type " + shown(name) +
                                     " is not read; valid volume elements are C3D8, C3D8I, C3D8R, C3D6 and C3D4, "
                                     "facets S3, S4, CPS3, CPS4, CPE3, CPE4, M3D3, M3D4, SFM3D3 and SFM3D4");
  }
  NumberSet* set =
      card.parameters.contains("ELSET") ? &found_.element_sets.make(lines_.parameter(card, "ELSET")) : nullptr;
  const std::size_t wanted = 1 + (type->cell ? corner_count(*type->cell) : 2);
  while (const auto line = lines_.data()) {
    auto fields = split(*line);
    while (fields.size() < wanted) {
      const auto more = lines_.data();
      if (!more)
        scanner_.fail(line->position, "an element " + name + " has " + std::to_string(wanted - 1) + " nodes, found " +
                                          std::to_string(fields.size() - 1));
      for (const Field& field : split(*more)) fields.push_back(field);
    }
    if (fields.size() > wanted)
      scanner_.fail(line->position, "an element " + name + " has " + std::to_string(wanted - 1) + " nodes, found " +
                                        std::to_string(fields.size() - 1));
    const long id = lines_.integer(fields[0], "an element number");
    found_.elements.push_back({type, id, line->position, found_.element_nodes.size()});
    for (std::size_t i = 1; i < wanted; ++i) found_.element_nodes.push_back(lines_.integer(fields[i], "a node number"));
    if (set) set->numbers.push_back(id);
  }
}

/// A damaged range must not fill the memory: every member is in the file, in few sets.
void KeywordReader::check_growth(long more, std::size_t position) {
  const auto limit = 64 * static_cast<long>(scanner_.text().size());
  if (more > limit || (generated_ += more) > limit)
    scanner_.fail(position, "the sets have more members than a file of this size can hold");
}

void KeywordReader::read_set(const Card& card, const char* name_parameter, NumberSets& sets) {
  lines_.refuse_parameters(card, {"INPUT", "INSTANCE"});
  if (name_parameter == std::string("NSET")) lines_.refuse_parameters(card, {"ELSET"});
  NumberSet& set = sets.make(lines_.parameter(card, name_parameter));
  set.by_keyword = true;
  while (const auto line = lines_.data()) {
    const auto fields = split(*line);
    if (card.parameters.contains("GENERATE")) {
      if (fields.size() < 2 || fields.size() > 3)
        scanner_.fail(line->position, "expected first, last and step of a range");
      const long first = lines_.integer(fields[0], "the first number of a range");
      const long last = lines_.integer(fields[1], "the last number of a range");
      const long step = fields.size() == 3 ? lines_.integer(fields[2], "the step of a range") : 1;
      if (first < 1 || last < first || step < 1)
        scanner_.fail(line->position, "expected a range with 1 <= first <= last and a step of 1 or more");
      const long steps = (last - first) / step;
      check_growth(steps, line->position);
      for (long i = 0; i <= steps; ++i) set.numbers.push_back(first + i * step);
      continue;
    }
    for (const Field& field : fields) {
      if (!field.text.empty() && std::isdigit(static_cast<unsigned char>(field.text[0]))) {
        set.numbers.push_back(lines_.integer(field, "a number or the name of a set"));
        continue;
      }
      const NumberSet* other = sets.find(field.text);
      if (!other) scanner_.fail(field.position, "there is no set " + shown(field.text) + " before this line");
      // A set must not grow by itself.
      if (other == &set) scanner_.fail(field.position, "the set " + shown(field.text) + " contains itself");
      check_growth(static_cast<long>(other->numbers.size()), field.position);
      set.numbers.insert(set.numbers.end(), other->numbers.begin(), other->numbers.end());
    }
  }
}

void KeywordReader::read_surface(const Card& card) {
  const auto type = card.parameters.find("TYPE");
  if (type != card.parameters.end() && upper(type->second.text) != "ELEMENT") return lines_.skip_data();
  lines_.refuse_parameters(card, {"COMBINE"});
  RawSurface surface{lines_.parameter(card, "NAME"), {}};
  for (const auto& other : found_.surfaces)
    if (upper(other.name.text) == upper(surface.name.text))
      scanner_.fail(card.position, "surface " + shown(surface.name.text) + " is given twice, first at " +
                                       scanner_.place(other.name.position));
  while (const auto line = lines_.data()) {
    const auto fields = split(*line);
    if (fields.empty() || fields.size() > 2)
      scanner_.fail(line->position, "expected an element or an element set, and a face such as S1");
    surface.faces.push_back({fields[0], fields.size() == 2 ? fields[1] : Field{}});
  }
  found_.surfaces.push_back(std::move(surface));
}

Keywords KeywordReader::read() {
  while (lines_.peek()) {
    const Card card = lines_.card();
    const std::string& keyword = card.keyword;
    if (keyword == "NODE") {
      read_nodes(card);
    } else if (keyword == "ELEMENT") {
      read_elements(card);
    } else if (keyword == "ELSET") {
      read_set(card, "ELSET", found_.element_sets);
    } else if (keyword == "NSET") {
      read_set(card, "NSET", found_.node_sets);
    } else if (keyword == "SURFACE") {
      read_surface(card);
    } else if (keyword == "SOLID SECTION") {
      found_.sections.push_back(lines_.parameter(card, "ELSET"));
      lines_.skip_data();
    } else if (keyword == "PART" || keyword == "INSTANCE" || keyword == "ASSEMBLY") {
      scanner_.fail(card.position, "*" + keyword +
                                       " is not read; write a flat file (Abaqus/CAE: Model > Edit Attributes > 'Do not "
                                       "use parts and assemblies in input files')");
    } else if (keyword == "INCLUDE") {
      scanner_.fail(card.position, "*INCLUDE is not read; put the text of that file here");
    } else {
      for (const char* maker : {"NGEN", "NFILL", "NCOPY", "NMAP", "ELGEN", "ELCOPY", "SYSTEM", "MODEL CHANGE"})
        if (keyword == maker)
          scanner_.fail(card.position,
                        "*" + keyword + " is not read; list every node and element, in global Cartesian coordinates");
      lines_.skip_data();
    }
  }
  return std::move(found_);
}

}  // namespace

Keywords read_keywords(Scanner& scanner) { return KeywordReader(scanner).read(); }

}  // namespace ashlar::abaqus
