#include "io/abaqus_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <climits>
#include <cmath>
#include <optional>

#include "io/abaqus_elements.hpp"

namespace ashlar {

int abaqus_face(Shape shape, int label) {
  const auto faces = abaqus_faces(shape);
  if (label < 0 || label >= static_cast<int>(faces.size())) return -1;
  auto corners = faces[label];
  std::sort(corners.begin(), corners.end());
  for (int face = 0; face < face_count(shape); ++face) {
    const auto local = face_corners(shape, face);
    std::vector<int> own(local.begin(), local.end());
    std::sort(own.begin(), own.end());
    if (own == corners) return face;
  }
  return -1;
}

namespace {

struct Field {
  std::string_view text;
  std::size_t position = 0;
};

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

std::string shown(std::string_view text) {
  std::string result(text.substr(0, 40));
  for (char& c : result)
    if (static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126) c = '?';
  return "'" + result + "'";
}

Field trimmed(Field field) {
  auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '"'; };
  while (!field.text.empty() && is_blank(field.text.front())) field.text.remove_prefix(1), ++field.position;
  while (!field.text.empty() && is_blank(field.text.back())) field.text.remove_suffix(1);
  return field;
}

/// Between commas; an empty last one (the line goes on) is left out.
std::vector<Field> split(const Field& line) {
  std::vector<Field> fields;
  for (std::size_t begin = 0; begin <= line.text.size();) {
    const auto comma = std::min(line.text.find(',', begin), line.text.size());
    fields.push_back(trimmed({line.text.substr(begin, comma - begin), line.position + begin}));
    begin = comma + 1;
  }
  if (fields.back().text.empty()) fields.pop_back();
  return fields;
}

/// A keyword line: "*ELEMENT, TYPE=C3D8, ELSET=dam".
struct Card {
  std::string keyword;  ///< upper case
  std::size_t position = 0;
  std::map<std::string, Field> parameters;  ///< by upper-case name
};

struct NumberSet {
  std::string name;         ///< as first written
  bool by_keyword = false;  ///< of *ELSET, not only of *ELEMENT
  std::vector<long> numbers;
  std::size_t position = 0;
};

/// Sets in the order of the file, found without regard to case.
class NumberSets {
 public:
  NumberSet& make(const Field& name) {
    const auto [it, is_new] = index_.try_emplace(upper(name.text), sets_.size());
    if (is_new) sets_.push_back({std::string(name.text), false, {}, name.position});
    return sets_[it->second];
  }
  const NumberSet* find(std::string_view name) const {
    const auto it = index_.find(upper(name));
    return it == index_.end() ? nullptr : &sets_[it->second];
  }
  const std::vector<NumberSet>& all() const { return sets_; }

 private:
  std::map<std::string, std::size_t> index_;
  std::vector<NumberSet> sets_;
};

struct ElementType {
  const char* name;
  std::optional<Cell> cell;  ///< none: a line, which only marks its nodes
};
constexpr ElementType element_types[] = {
    {"C3D8", Cell::hex8},   {"C3D8I", Cell::hex8},   {"C3D8R", Cell::hex8},  {"C3D6", Cell::wedge6},
    {"C3D4", Cell::tet4},   {"CPS3", Cell::tri3},    {"CPE3", Cell::tri3},   {"S3", Cell::tri3},
    {"S3R", Cell::tri3},    {"M3D3", Cell::tri3},    {"SFM3D3", Cell::tri3}, {"CPS4", Cell::quad4},
    {"CPE4", Cell::quad4},  {"S4", Cell::quad4},     {"S4R", Cell::quad4},   {"M3D4", Cell::quad4},
    {"M3D4R", Cell::quad4}, {"SFM3D4", Cell::quad4}, {"T3D2", {}},
};

class Reader {
 public:
  explicit Reader(Scanner& scanner) : scanner_(scanner) {}
  MeshContent read();

 private:
  std::optional<Field> peek_line();
  Field take_line();
  std::optional<Field> data_line();
  Card read_card();
  void skip_data() {
    while (data_line()) {
    }
  }

  long integer(const Field& field, const char* expected) const;
  double real(const Field& field, const char* expected) const;
  const Field& parameter(const Card& card, const char* name) const;
  void refuse_parameters(const Card& card, std::initializer_list<const char*> names) const;

  void read_nodes(const Card& card);
  void read_elements(const Card& card);
  void read_set(const Card& card, const char* name_parameter, NumberSets& sets);
  void check_growth(long more, std::size_t position);
  void read_surface(const Card& card);

  void resolve_elements();
  int element_index(long number, std::size_t position) const;
  std::vector<int> volumes_of(const NumberSet& set) const;
  std::string assign_regions(const std::vector<const NumberSet*>& sets, std::size_t& place,
                             std::vector<int>& region) const;
  void resolve_regions();
  void resolve_facet_groups();
  void resolve_surfaces();
  void resolve_node_sets();

  struct RawElement {
    const ElementType* type;
    long id;
    std::size_t position;
    std::size_t first_node;
  };
  struct RawSurface {
    Field name;
    std::vector<std::pair<Field, Field>> faces;  ///< element or set, label
  };
  Scanner& scanner_;
  std::size_t at_ = 0;
  long generated_ = 0;  ///< members of sets that no line lists
  MeshContent content_;
  NumberSets element_sets_, node_sets_;
  std::vector<RawElement> elements_;
  std::vector<long> element_nodes_;
  std::vector<Field> sections_;
  std::vector<RawSurface> surfaces_;
  std::vector<std::pair<long, int>> element_index_;  ///< sorted; volumes from 0 up, facets from -1 down, lines INT_MIN
  std::optional<NodeIndex> nodes_;
};

// ---------------------------------------------------------------- lines

/// The next line that is neither empty nor a comment.
std::optional<Field> Reader::peek_line() {
  const std::string_view text = scanner_.text();
  while (at_ < text.size()) {
    const auto end = std::min(text.find('\n', at_), text.size());
    const Field line = trimmed({text.substr(at_, end - at_), at_});
    if (!line.text.empty() && !line.text.starts_with("**")) return line;
    at_ = end + 1;
  }
  return {};
}

Field Reader::take_line() {
  const Field line = *peek_line();
  at_ = std::min(scanner_.text().find('\n', at_), scanner_.text().size()) + 1;
  return line;
}

std::optional<Field> Reader::data_line() {
  const auto line = peek_line();
  if (!line || line->text[0] == '*') return {};
  return take_line();
}

Card Reader::read_card() {
  Field line = take_line();
  if (line.text[0] != '*')
    scanner_.fail(line.position, "expected a keyword line that begins with '*', found " + shown(line.text));
  Card card;
  card.position = line.position;
  auto fields = split(line);
  if (fields.empty()) scanner_.fail(line.position, "there is no keyword after '*'");
  while (line.text.back() == ',') {
    const auto more = data_line();
    if (!more) break;
    line = *more;
    for (const Field& field : split(line)) fields.push_back(field);
  }
  for (const char c : upper(fields[0].text.substr(1)))
    if (c != ' ' || !card.keyword.ends_with(' ')) card.keyword += c;
  for (std::size_t i = 1; i < fields.size(); ++i) {
    const auto equals = std::min(fields[i].text.find('='), fields[i].text.size());
    const Field name = trimmed({fields[i].text.substr(0, equals), fields[i].position});
    const auto value = std::min(equals + 1, fields[i].text.size());
    card.parameters[upper(name.text)] = trimmed({fields[i].text.substr(value), fields[i].position + value});
  }
  return card;
}

long Reader::integer(const Field& field, const char* expected) const {
  long value = 0;
  const char* end = field.text.data() + field.text.size();
  const auto [stop, error] = std::from_chars(field.text.data(), end, value);
  if (error != std::errc() || stop != end)
    scanner_.fail(field.position, std::string("expected ") + expected + ", found " + shown(field.text));
  return value;
}

double Reader::real(const Field& field, const char* expected) const {
  std::string text(field.text);
  for (char& c : text)
    if (c == 'd' || c == 'D') c = 'e';
  const char* begin = text.c_str() + (text.starts_with('+') ? 1 : 0);
  double value = 0;
  const auto [stop, error] = std::from_chars(begin, text.c_str() + text.size(), value);
  if (error != std::errc() || stop != text.c_str() + text.size() || !std::isfinite(value))
    scanner_.fail(field.position, std::string("expected ") + expected + ", found " + shown(field.text));
  return value;
}

const Field& Reader::parameter(const Card& card, const char* name) const {
  const auto it = card.parameters.find(name);
  if (it == card.parameters.end() || it->second.text.empty())
    scanner_.fail(card.position, "*" + card.keyword + " needs " + name + "=...");
  return it->second;
}

void Reader::refuse_parameters(const Card& card, std::initializer_list<const char*> names) const {
  for (const char* name : names)
    if (card.parameters.contains(name))
      scanner_.fail(card.position, "*" + card.keyword + " with " + name +
                                       " is not read; list everything in this file, in global Cartesian coordinates");
}

// ---------------------------------------------------------------- keywords

void Reader::read_nodes(const Card& card) {
  refuse_parameters(card, {"INPUT", "SYSTEM"});
  const auto set = card.parameters.find("NSET");
  NumberSet* nodes = set == card.parameters.end() ? nullptr : &node_sets_.make(parameter(card, "NSET"));
  while (const auto line = data_line()) {
    const auto fields = split(*line);
    if (fields.size() != 4)
      scanner_.fail(line->position, "expected a node number and three coordinates, found " +
                                        std::to_string(fields.size()) + " entries");
    const long id = integer(fields[0], "a node number");
    if (content_.node_ids.size() == INT_MAX) scanner_.fail(line->position, "more than 2^31 nodes");
    content_.node_ids.push_back(id);
    content_.points.push_back(
        {real(fields[1], "a coordinate x"), real(fields[2], "a coordinate y"), real(fields[3], "a coordinate z")});
    if (nodes) nodes->numbers.push_back(id);
  }
}

void Reader::read_elements(const Card& card) {
  refuse_parameters(card, {"INPUT", "FILE", "OFFSET"});
  const Field& given = parameter(card, "TYPE");
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
  NumberSet* set = card.parameters.contains("ELSET") ? &element_sets_.make(parameter(card, "ELSET")) : nullptr;
  const std::size_t wanted = 1 + (type->cell ? corner_count(*type->cell) : 2);
  while (const auto line = data_line()) {
    auto fields = split(*line);
    while (fields.size() < wanted) {
      const auto more = data_line();
      if (!more)
        scanner_.fail(line->position, "an element " + name + " has " + std::to_string(wanted - 1) + " nodes, found " +
                                          std::to_string(fields.size() - 1));
      for (const Field& field : split(*more)) fields.push_back(field);
    }
    if (fields.size() > wanted)
      scanner_.fail(line->position, "an element " + name + " has " + std::to_string(wanted - 1) + " nodes, found " +
                                        std::to_string(fields.size() - 1));
    const long id = integer(fields[0], "an element number");
    elements_.push_back({type, id, line->position, element_nodes_.size()});
    for (std::size_t i = 1; i < wanted; ++i) element_nodes_.push_back(integer(fields[i], "a node number"));
    if (set) set->numbers.push_back(id);
  }
}

/// A damaged range must not fill the memory: every member is in the file, in few sets.
void Reader::check_growth(long more, std::size_t position) {
  const auto limit = 64 * static_cast<long>(scanner_.text().size());
  if (more > limit || (generated_ += more) > limit)
    scanner_.fail(position, "the sets have more members than a file of this size can hold");
}

void Reader::read_set(const Card& card, const char* name_parameter, NumberSets& sets) {
  refuse_parameters(card, {"INPUT", "INSTANCE"});
  if (name_parameter == std::string("NSET")) refuse_parameters(card, {"ELSET"});
  NumberSet& set = sets.make(parameter(card, name_parameter));
  set.by_keyword = true;
  while (const auto line = data_line()) {
    const auto fields = split(*line);
    if (card.parameters.contains("GENERATE")) {
      if (fields.size() < 2 || fields.size() > 3)
        scanner_.fail(line->position, "expected first, last and step of a range");
      const long first = integer(fields[0], "the first number of a range");
      const long last = integer(fields[1], "the last number of a range");
      const long step = fields.size() == 3 ? integer(fields[2], "the step of a range") : 1;
      if (first < 1 || last < first || step < 1)
        scanner_.fail(line->position, "expected a range with 1 <= first <= last and a step of 1 or more");
      const long steps = (last - first) / step;
      check_growth(steps, line->position);
      for (long i = 0; i <= steps; ++i) set.numbers.push_back(first + i * step);
      continue;
    }
    for (const Field& field : fields) {
      if (!field.text.empty() && std::isdigit(static_cast<unsigned char>(field.text[0]))) {
        set.numbers.push_back(integer(field, "a number or the name of a set"));
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

void Reader::read_surface(const Card& card) {
  const auto type = card.parameters.find("TYPE");
  if (type != card.parameters.end() && upper(type->second.text) != "ELEMENT") return skip_data();
  refuse_parameters(card, {"COMBINE"});
  RawSurface surface{parameter(card, "NAME"), {}};
  for (const auto& other : surfaces_)
    if (upper(other.name.text) == upper(surface.name.text))
      scanner_.fail(card.position, "surface " + shown(surface.name.text) + " is given twice, first at " +
                                       scanner_.place(other.name.position));
  while (const auto line = data_line()) {
    const auto fields = split(*line);
    if (fields.empty() || fields.size() > 2)
      scanner_.fail(line->position, "expected an element or an element set, and a face such as S1");
    surface.faces.push_back({fields[0], fields.size() == 2 ? fields[1] : Field{}});
  }
  surfaces_.push_back(std::move(surface));
}

// ---------------------------------------------------------------- what the whole file means

void Reader::resolve_elements() {
  nodes_.emplace(scanner_, content_.node_ids);
  content_.used_by_volume.assign(content_.points.size(), 0);
  content_.used_at_all.assign(content_.points.size(), 0);
  std::array<int, 8> indices;
  for (const RawElement& element : elements_) {
    const int corners = element.type->cell ? corner_count(*element.type->cell) : 2;
    for (int i = 0; i < corners; ++i) {
      const long node = element_nodes_[element.first_node + i];
      indices[i] = nodes_->find(node);
      if (indices[i] < 0)
        scanner_.fail(element.position, "element " + std::to_string(element.id) + " (" + element.type->name +
                                            ") uses node " + std::to_string(node) + ", which *NODE does not give");
      content_.used_at_all[indices[i]] = 1;
    }
    int place = INT_MIN;
    if (element.type->cell) {
      const Cell cell = *element.type->cell;
      place = is_volume(cell) ? content_.volumes.count() : -1 - content_.facets.count();
      content_.add_element(scanner_, cell, element.id, element.position, std::span(indices.data(), corners), 0);
    }
    element_index_.push_back({element.id, place});
  }
  std::sort(element_index_.begin(), element_index_.end());
  for (std::size_t i = 1; i < element_index_.size(); ++i)
    if (element_index_[i].first == element_index_[i - 1].first)
      scanner_.fail_file("element " + std::to_string(element_index_[i].first) + " is given twice");
}

int Reader::element_index(long number, std::size_t position) const {
  const auto it = std::lower_bound(element_index_.begin(), element_index_.end(), std::pair{number, INT_MIN});
  if (it == element_index_.end() || it->first != number)
    scanner_.fail(position, "there is no element " + std::to_string(number));
  return it->second;
}

std::vector<int> Reader::volumes_of(const NumberSet& set) const {
  std::vector<int> volumes;
  for (const long number : set.numbers)
    if (const int e = element_index(number, set.position); e >= 0) volumes.push_back(e);
  return volumes;
}

/// Region of every volume element from sets that must hold each once; otherwise the complaint and its place.
std::string Reader::assign_regions(const std::vector<const NumberSet*>& sets, std::size_t& place,
                                   std::vector<int>& region) const {
  const auto& volumes = content_.volumes;
  region.assign(volumes.count(), -1);
  auto label = [&](int e) {
    place = volumes.positions[e];
    return std::string(cell_name(volumes.cells[e])) + " element " + std::to_string(volumes.ids[e]);
  };
  for (std::size_t s = 0; s < sets.size(); ++s)
    for (const int e : volumes_of(*sets[s])) {
      if (region[e] >= 0 && region[e] != static_cast<int>(s))
        return label(e) + " is in two element sets, '" + sets[region[e]]->name + "' and '" + sets[s]->name +
               "'; every element must be in exactly one: name those that are regions by *SOLID SECTION";
      region[e] = static_cast<int>(s);
    }
  const auto loose = std::find(region.begin(), region.end(), -1);
  if (loose == region.end()) return {};
  return label(static_cast<int>(loose - region.begin())) +
         " is in no element set that is a region; give every element one, by *SOLID SECTION";
}

void Reader::resolve_regions() {
  std::vector<const NumberSet*> regions;
  std::vector<int> region;
  std::size_t place = 0;
  std::string complaint;
  if (!sections_.empty()) {
    for (const Field& section : sections_) {
      const NumberSet* set = element_sets_.find(section.text);
      if (!set) scanner_.fail(section.position, "there is no element set " + shown(section.text));
      if (std::find(regions.begin(), regions.end(), set) == regions.end()) regions.push_back(set);
    }
    complaint = assign_regions(regions, place, region);
  } else {
    std::vector<const NumberSet*> everything;
    for (const NumberSet& set : element_sets_.all()) {
      auto volumes = volumes_of(set);
      std::sort(volumes.begin(), volumes.end());
      const auto different = std::unique(volumes.begin(), volumes.end()) - volumes.begin();
      if (!set.by_keyword || different == 0) continue;
      (different == content_.volumes.count() ? everything : regions).push_back(&set);
    }
    if (regions.empty() && !everything.empty()) regions.push_back(everything.front());
    if (!regions.empty()) complaint = assign_regions(regions, place, region);
    if (regions.empty() || !complaint.empty()) {
      std::vector<const NumberSet*> of_elements;
      for (const NumberSet& set : element_sets_.all())
        if (!set.by_keyword && !volumes_of(set).empty()) of_elements.push_back(&set);
      if (!of_elements.empty()) {
        const std::string second = assign_regions(of_elements, place, region);
        if (second.empty() || complaint.empty()) complaint = second, regions = of_elements;
      }
    }
  }
  if (!complaint.empty()) scanner_.fail(place, complaint);
  if (regions.empty()) region.assign(content_.volumes.count(), 0);
  for (std::size_t r = 0; r < std::max<std::size_t>(regions.size(), 1); ++r) {
    const int number = static_cast<int>(r) + 1;
    content_.names[{3, number}] = regions.empty() ? "region_1" : regions[r]->name;
    content_.memberships.push_back({number, {number}});
  }
  content_.volumes.membership = region;
}

/// Sets of *ELSET with facets become surfaces; a facet in none of them goes by the set that *ELEMENT names.
void Reader::resolve_facet_groups() {
  std::vector<std::vector<int>> groups(content_.facets.count());
  for (const bool by_keyword : {true, false}) {
    int number = 0;
    for (const NumberSet& set : element_sets_.all()) {
      ++number;
      for (const long member : set.numbers) {
        const int place = element_index(member, set.position);
        if (set.by_keyword != by_keyword || place >= 0 || place == INT_MIN) continue;
        auto& own = groups[-1 - place];
        if (!by_keyword && !own.empty()) continue;
        if (own.empty() || own.back() != number) own.push_back(number);
        content_.names[{2, number}] = set.name;
      }
    }
  }
  std::map<std::vector<int>, int> membership_of;
  for (int f = 0; f < content_.facets.count(); ++f) {
    const auto [it, is_new] = membership_of.try_emplace(groups[f], static_cast<int>(content_.memberships.size()));
    if (is_new) content_.memberships.push_back({0, groups[f]});
    content_.facets.membership[f] = it->second;
  }
}

void Reader::resolve_surfaces() {
  for (const RawSurface& surface : surfaces_) {
    MeshContent::FaceSet faces{std::string(surface.name.text), {}, {}};
    for (const auto& [member, label] : surface.faces) {
      std::vector<int> elements;
      if (const NumberSet* set = element_sets_.find(member.text)) {
        for (const long number : set->numbers) elements.push_back(element_index(number, set->position));
      } else if (!member.text.empty() && std::isdigit(static_cast<unsigned char>(member.text[0]))) {
        elements.push_back(element_index(integer(member, "an element number"), member.position));
      } else {
        scanner_.fail(member.position, "there is no element set " + shown(member.text));
      }
      for (const int e : elements) {
        if (e < 0)
          scanner_.fail(member.position, shown(member.text) +
                                             " has elements that are no volumes; a surface is read "
                                             "from faces of volume elements");
        if (label.text.empty()) {
          faces.free_elements.push_back(e);
          continue;
        }
        const Shape shape = shape_of(content_.volumes.cells[e]);
        const bool well_formed = label.text.size() == 2 && upper(label.text)[0] == 'S';
        const int face = well_formed ? abaqus_face(shape, label.text[1] - '1') : -1;
        if (face < 0)
          scanner_.fail(label.position, "a " + std::string(shape_name(shape)) + " element has the faces S1 to S" +
                                            std::to_string(face_count(shape)) + ", found " + shown(label.text));
        faces.facets.push_back({e, face});
      }
    }
    content_.face_sets.push_back(std::move(faces));
  }
}

void Reader::resolve_node_sets() {
  for (const NumberSet& set : node_sets_.all()) {
    MeshContent::NodeSet nodes{set.name, {}};
    for (const long number : set.numbers) {
      nodes.nodes.push_back(nodes_->find(number));
      if (nodes.nodes.back() < 0)
        scanner_.fail(set.position,
                      "node set '" + set.name + "' has node " + std::to_string(number) + ", which *NODE does not give");
    }
    content_.node_sets.push_back(std::move(nodes));
  }
}

MeshContent Reader::read() {
  while (peek_line()) {
    const Card card = read_card();
    const std::string& keyword = card.keyword;
    if (keyword == "NODE") {
      read_nodes(card);
    } else if (keyword == "ELEMENT") {
      read_elements(card);
    } else if (keyword == "ELSET") {
      read_set(card, "ELSET", element_sets_);
    } else if (keyword == "NSET") {
      read_set(card, "NSET", node_sets_);
    } else if (keyword == "SURFACE") {
      read_surface(card);
    } else if (keyword == "SOLID SECTION") {
      sections_.push_back(parameter(card, "ELSET"));
      skip_data();
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
      skip_data();
    }
  }
  if (content_.points.empty())
    scanner_.fail_file("there is no *NODE: this is no Abaqus or CalculiX mesh, or the file is truncated");
  resolve_elements();
  resolve_regions();
  resolve_facet_groups();
  resolve_surfaces();
  resolve_node_sets();
  return std::move(content_);
}

}  // namespace

MeshContent read_abaqus(Scanner& scanner) { return Reader(scanner).read(); }

}  // namespace ashlar
