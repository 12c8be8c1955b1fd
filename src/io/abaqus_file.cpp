#include "io/abaqus_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <climits>
#include <map>
#include <optional>

#include "io/abaqus_elements.hpp"
#include "io/abaqus_keywords.hpp"

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

using namespace abaqus;

/// Looks up what the keywords name by numbers and sets.
class Reader {
 public:
  explicit Reader(Scanner& scanner) : scanner_(scanner), found_(read_keywords(scanner)) {}
  MeshContent read();

 private:
  void resolve_elements();
  int element_index(long number, std::size_t position) const;
  std::vector<int> volumes_of(const NumberSet& set) const;
  std::string assign_regions(const std::vector<const NumberSet*>& sets, std::size_t& place,
                             std::vector<int>& region) const;
  void resolve_regions();
  void resolve_facet_groups();
  void resolve_surfaces();
  void resolve_node_sets();

  Scanner& scanner_;
  Keywords found_;
  MeshContent content_;
  std::vector<std::pair<long, int>> element_index_;  ///< sorted; volumes from 0 up, facets from -1 down, lines INT_MIN
  std::optional<NodeIndex> nodes_;
};

void Reader::resolve_elements() {
  nodes_.emplace(scanner_, content_.node_ids);
  content_.used_by_volume.assign(content_.points.size(), 0);
  content_.used_at_all.assign(content_.points.size(), 0);
  std::array<int, 8> indices;
  for (const RawElement& element : found_.elements) {
    const int corners = element.type->cell ? corner_count(*element.type->cell) : 2;
    for (int i = 0; i < corners; ++i) {
      const long node = found_.element_nodes[element.first_node + i];
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
  if (!found_.sections.empty()) {
    for (const Field& section : found_.sections) {
      const NumberSet* set = found_.element_sets.find(section.text);
      if (!set) scanner_.fail(section.position, "there is no element set " + shown(section.text));
      if (std::find(regions.begin(), regions.end(), set) == regions.end()) regions.push_back(set);
    }
    complaint = assign_regions(regions, place, region);
  } else {
    std::vector<const NumberSet*> everything;
    for (const NumberSet& set : found_.element_sets.all()) {
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
      for (const NumberSet& set : found_.element_sets.all())
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
    for (const NumberSet& set : found_.element_sets.all()) {
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
  for (const RawSurface& surface : found_.surfaces) {
    MeshContent::FaceSet faces{std::string(surface.name.text), {}, {}};
    for (const auto& [member, label] : surface.faces) {
      std::vector<int> elements;
      if (const NumberSet* set = found_.element_sets.find(member.text)) {
        for (const long number : set->numbers) elements.push_back(element_index(number, set->position));
      } else if (!member.text.empty() && std::isdigit(static_cast<unsigned char>(member.text[0]))) {
        elements.push_back(
            element_index(abaqus::Lines(scanner_).integer(member, "an element number"), member.position));
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
  for (const NumberSet& set : found_.node_sets.all()) {
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
  content_.node_ids = found_.node_ids;
  content_.points = found_.points;
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
