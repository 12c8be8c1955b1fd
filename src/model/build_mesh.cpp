#include <algorithm>
#include <set>

#include "model/blocks.hpp"
#include "model/check_mesh.hpp"
#include "model/contact/facing.hpp"
#include "model/doubts.hpp"
#include "model/mesher/extrude.hpp"
#include "model/mesher/merge_points.hpp"
#include "model/mesher/solid.hpp"
#include "model/model.hpp"
#include "model/place_text.hpp"
#include "model/select_surface.hpp"
#include "physics/laws/laws.hpp"

namespace ashlar {

namespace {

/// Puts the meshes of all sources together: points first, then elements on merged nodes, then surfaces.
class Assembly {
 public:
  explicit Assembly(Model& model) : model_(model), mesh_(model.mesh) {}

  void run() {
    if (model_.extrudes.empty() && model_.boxes.empty() && model_.solids.empty() && model_.imports.empty())
      throw DeckError(model_.where, "the model has no geometry; declare an extrude, a box, a solid or an import_mesh");
    mesh_ = Mesh{};
    make_sources();
    merge();
    for (std::size_t s = 0; s < sources_.size(); ++s)
      add_source(static_cast<int>(s), add_region(names_[s], declared_[s], {}));
    for (std::size_t i = 0; i < model_.imports.size(); ++i)
      add_import(model_.imports[i], source_nodes(static_cast<int>(sources_.size() + i)));
    complaints_.raise();
    check_mesh(mesh_, region_declared_, joined_regions());
    note_locking();
    part_heat();
    note_packing();
    add_surfaces();
    for (const std::string& doubt : doubts(model_)) model_.notes.push_back(doubt);
  }

 private:
  /// Plastic flow keeps its volume, nearly; elements that cannot do so without stiffening give collapse loads too high.
  /// Averaged ones where strength depends on pressure, which they share, give some too low.
  void note_locking() {
    const std::string locking = " lock in plastic flow; collapse loads may come out tens of per cent too high";
    for (const Material& material : model_.materials) {
      if (!is_plastic(material.law)) continue;
      const bool averages = material.bbar.value_or(averages_tet4(material.law));
      std::set<std::string> kinds;
      for (int e = 0; e < mesh_.element_count(); ++e) {
        const std::string& region = mesh_.region_names[mesh_.regions[e]];
        if (std::find(material.regions.begin(), material.regions.end(), region) == material.regions.end()) continue;
        if (mesh_.shapes[e] != Shape::tet4) {
          if (material.bbar && !*material.bbar)
            kinds.insert("fully integrated elements" + locking + "; formulation = \"bbar\" does not");
        } else if (!averages) {
          kinds.insert("tet4" + locking + ", hex8 and wedge6 do not; formulation = \"bbar\" does not" +
                       (averages_tet4(material.law) ? "" : " in plane strain, but is too weak in triaxial states"));
        } else if (!averages_tet4(material.law)) {
          kinds.insert("tet4 that share their pressure (formulation = \"bbar\") under a law with friction meet limit "
                       "loads in plane strain, but may give way at half of the strength in triaxial states; hex8 and "
                       "wedge6 do neither");
        }
      }
      for (const std::string& kind : kinds) model_.notes.push_back("material '" + material.name + "': " + kind);
    }
  }

  /// Springs get their stiffness by how blocks lie.
  void note_packing() {
    for (const Material& material : model_.materials) {
      if (material.law != DiscreteSpring::name) continue;
      const bool bricks = make_law<DiscreteSpring>(material.values).packing == 0;
      for (int e = 0; e < mesh_.element_count(); ++e) {
        const std::string& region = mesh_.region_names[mesh_.regions[e]];
        if (std::find(material.regions.begin(), material.regions.end(), region) == material.regions.end()) continue;
        if ((mesh_.shapes[e] == Shape::hex8) == bricks) continue;
        model_.notes.push_back("material '" + material.name + "': packing = \"" + (bricks ? "bricks" : "irregular") +
                               "\" on " + shape_name(mesh_.shapes[e]) + " of region '" + region +
                               "'; its young and poisson will be others");
        break;
      }
    }
  }

  std::set<std::pair<int, int>> joined_regions() const {
    std::set<std::pair<int, int>> joined;
    for (const Interface& i : model_.interfaces)
      if (!i.crackable && i.regions.size() == 2)
        joined.insert(std::minmax(mesh_.find_region(i.regions[0]), mesh_.find_region(i.regions[1])));
    return joined;
  }

  void make_sources() {
    if (!model_.extrudes.empty()) sources_ = mesh_extrudes(model_.extrudes);
    for (const auto& extrude : model_.extrudes) {
      names_.push_back(extrude.name);
      declared_.push_back(extrude.where);
    }
    for (const auto& box : model_.boxes) {
      sources_.push_back(mesh_box(box));
      names_.push_back(box.name);
      declared_.push_back(box.where);
    }
    std::vector<std::string> lines;
    for (const auto& solid : model_.solids) try {
        sources_.push_back(mesh_solid(solid, model_.notes));
        names_.push_back(solid.name);
        declared_.push_back(solid.where);
      } catch (const DeckError& error) {
        lines.insert(lines.end(), error.lines().begin(), error.lines().end());
      }
    if (!lines.empty()) throw DeckError(lines);
  }

  void merge() {
    std::vector<Vec3<double>> points;
    std::vector<int> source;
    const auto append = [&](const std::vector<Vec3<double>>& more) {
      first_point_.push_back(static_cast<int>(points.size()));
      source.insert(source.end(), more.size(), static_cast<int>(first_point_.size()) - 1);
      points.insert(points.end(), more.begin(), more.end());
    };
    for (const auto& source : sources_)
      append(std::visit(
          [](const auto& cells) -> const auto& { return cells.points; }, source));
    for (const auto& import : model_.imports) append(import.mesh.points);
    first_point_.push_back(static_cast<int>(points.size()));
    merged_ = merge_points(points, source);
    mesh_.points = merged_.points;

    int count = 0;
    for (const auto& [a, b] : merged_.repeated)
      if (++count <= 10) repeated_node(source[a], a, b, points[a]);
    if (count > 10)
      complaints_.add(model_.where,
                      "... and " + std::to_string(count - 10) + " more nodes at the same place as others");
    complaints_.raise();
  }

  void repeated_node(int source, int a, int b, const Vec3<double>& place) {
    const int made_here = static_cast<int>(sources_.size());
    if (source < made_here) {
      complaints_.add(declared_[source], "'" + names_[source] + "' has elements of no size at " + place_text(place) +
                                             "; is it meant to be so much smaller than the rest of the model?");
      return;
    }
    const auto& import = model_.imports[source - made_here];
    complaints_.add(import.where, import.file + ": nodes " + std::to_string(a - first_point_[source] + 1) + " and " +
                                      std::to_string(b - first_point_[source] + 1) + " (counted from 1) lie at the " +
                                      "same place, " + place_text(place) +
                                      "; merge them in the mesh generator: joints are opened here, not in the file");
  }

  /// Mesh node of every point of one source.
  std::vector<int> source_nodes(int s) const {
    return {merged_.node.begin() + first_point_[s], merged_.node.begin() + first_point_[s + 1]};
  }

  int add_region(const std::string& name, const Where& where, const std::string& file) {
    const int known = mesh_.find_region(name);
    if (known >= 0) {
      const auto& first = region_declared_[known];
      complaints_.add(where, (file.empty() ? "" : file + ": ") + "region '" + name + "' exists already" +
                                 (first.file.empty() ? "" : ", from line " + std::to_string(first.line)) +
                                 "; give every region its own name" +
                                 (file.empty() ? "" : ", regions = { " + name + " = \"another name\" }"));
    }
    mesh_.region_names.push_back(name);
    region_declared_.push_back(where);
    return static_cast<int>(mesh_.region_names.size()) - 1;
  }

  void add_source(int s, int region) {
    std::visit([&](const auto& cells) { add_cells(mesh_, cells, source_nodes(s), region); }, sources_[s]);
  }

  void add_import(const ImportedMesh& import, const std::vector<int>& nodes) {
    const int first_region = static_cast<int>(mesh_.region_names.size()), first_element = mesh_.element_count();
    for (const auto& name : import.mesh.region_names) add_region(name, import.where, import.file);
    for (int e = 0; e < import.mesh.element_count(); ++e) {
      std::vector<int> corners;
      for (const int n : import.mesh.element(e)) corners.push_back(nodes[n]);
      mesh_.add_element(import.mesh.shapes[e], corners, first_region + import.mesh.regions[e],
                        import.mesh.source_ids[e]);
    }
    for (const auto& surface : import.mesh.surfaces) {
      // The same group in two files is one surface.
      auto at = std::find_if(mesh_.surfaces.begin(), mesh_.surfaces.end(),
                             [&](const Surface& known) { return known.name == surface.name; });
      if (at == mesh_.surfaces.end()) at = mesh_.surfaces.insert(at, Surface{surface.name, {}});
      for (const auto& f : surface.facets) at->facets.push_back({first_element + f.element, f.face});
    }
  }

  /// Joints that resist heat part the nodes of their sides, so that each has temperatures of its own.
  void part_heat() {
    std::set<std::pair<int, int>> parted;
    for (const Interface& i : model_.interfaces)
      if (i.resists_heat() && i.regions.size() == 2)
        parted.insert(std::minmax(mesh_.find_region(i.regions[0]), mesh_.find_region(i.regions[1])));
    if (parted.empty()) return;
    std::vector<FacePair> connecting = find_faces(mesh_).inner;
    std::erase_if(connecting, [&](const FacePair& f) {
      return parted.contains(std::minmax(mesh_.regions[f.a.element], mesh_.regions[f.b.element]));
    });
    std::vector<std::set<int>> regions(mesh_.node_count());
    for (int e = 0; e < mesh_.element_count(); ++e)
      for (const int n : mesh_.element(e)) regions[n].insert(mesh_.regions[e]);
    std::vector<char> between(mesh_.node_count(), 0);
    for (int n = 0; n < mesh_.node_count(); ++n)
      for (const auto& [a, b] : parted)
        if (regions[n].contains(a) && regions[n].contains(b)) between[n] = 1;
    const NodeCopies copies = copy_nodes(mesh_, connecting, between);
    std::vector<Vec3<double>> points;
    for (const int n : copies.mesh_node) points.push_back(mesh_.points[n]);
    mesh_.points = std::move(points);
    mesh_.corners = copies.corners;
  }

  void add_surfaces() {
    auto faces = find_faces(mesh_);
    // Faces that a joint brings together lie inside the body, like those that share their nodes.
    const std::vector<CoveredFace> covered = find_facing(model_, faces).covered;
    std::erase_if(faces.outer,
                  [&](const Facet& f) { return std::ranges::binary_search(covered, f, before, &CoveredFace::facet); });
    for (std::size_t region = 0; region < names_.size(); ++region)
      for (auto& side : region_sides(mesh_, faces, static_cast<int>(region))) mesh_.surfaces.push_back(std::move(side));
    std::vector<std::string> lines;
    for (const auto& choice : model_.surfaces) try {
        if (mesh_.find_surface(choice.name))
          throw DeckError(choice.where,
                          "surface '" + choice.name +
                              "': there is a surface of this name already, from a mesh file or an earlier " +
                              "declaration; choose another name");
        mesh_.surfaces.push_back({choice.name, select_surface(mesh_, faces, choice, model_.interfaces, covered)});
      } catch (const DeckError& error) {
        lines.insert(lines.end(), error.lines().begin(), error.lines().end());
      }
    if (!lines.empty()) throw DeckError(lines);
  }

  Model& model_;
  Mesh& mesh_;
  std::vector<MeshedSource> sources_;  ///< extrudes, boxes, solids
  std::vector<std::string> names_;     ///< [sources_]
  std::vector<Where> declared_;        ///< [sources_]
  std::vector<int> first_point_;       ///< of the sources, then of imports; one more at the end
  MergedPoints merged_;
  std::vector<Where> region_declared_;  ///< [regions]
  Complaints complaints_;
};

}  // namespace

void build_mesh(Model& model) { Assembly(model).run(); }

}  // namespace ashlar
