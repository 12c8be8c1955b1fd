#include "model/loads.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>
#include <stdexcept>

#include "model/locate.hpp"
#include "model/place_text.hpp"
#include "physics/gauss_table.hpp"

namespace ashlar {

namespace {

template <class Element>
std::array<double, 8> volumes_of(const Mesh& mesh, int element) {
  const std::span<const int> nodes = mesh.element(element);
  double x[3][Element::corners], volumes[Element::corners];
  for (int k = 0; k < Element::corners; ++k)
    for (int i = 0; i < 3; ++i) x[i][k] = mesh.points[nodes[k]][i];
  corner_volumes<Element>(x, volumes);
  std::array<double, 8> all{};
  std::copy(volumes, volumes + Element::corners, all.begin());
  return all;
}

/// Integral of N_k dV of one element, m^3.
std::array<double, 8> element_corner_volumes(const Mesh& mesh, int element) {
  switch (mesh.shapes[element]) {
    case Shape::hex8: return volumes_of<Hex8<double>>(mesh, element);
    case Shape::wedge6: return volumes_of<Wedge6<double>>(mesh, element);
    case Shape::tet4: break;
  }
  return volumes_of<Tet4<double>>(mesh, element);
}

struct BodyPoint {
  std::array<double, 8> shape{};  ///< N_k of the element's corners
  double volume = 0;              ///< m^3
};

template <class Element>
std::vector<BodyPoint> points_of(const Mesh& mesh, int element) {
  const std::span<const int> nodes = mesh.element(element);
  double x[3][Element::corners];
  for (int k = 0; k < Element::corners; ++k)
    for (int i = 0; i < 3; ++i) x[i][k] = mesh.points[nodes[k]][i];
  const ElementGeometry<Element, double> geometry(x);
  std::vector<BodyPoint> points(Element::gauss_points);
  for (int g = 0; g < Element::gauss_points; ++g) {
    points[g].volume = GaussTable<Element>::factor * geometry.jacobian_at(g).det;
    for (int k = 0; k < Element::corners; ++k) points[g].shape[k] = Element::shape(g, k);
  }
  return points;
}

std::vector<BodyPoint> body_points(const Mesh& mesh, int element) {
  switch (mesh.shapes[element]) {
    case Shape::hex8: return points_of<Hex8<double>>(mesh, element);
    case Shape::wedge6: return points_of<Wedge6<double>>(mesh, element);
    case Shape::tet4: break;
  }
  const double volume = points_of<Tet4<double>>(mesh, element)[0].volume;
  constexpr double near = 0.58541019662496845, far = 0.13819660112501052;  // (5 + 3 root 5)/20, (5 - root 5)/20
  std::vector<BodyPoint> points;
  for (int k = 0; k < 4; ++k) {
    points.push_back({{far, far, far, far}, volume / 4});
    points.back().shape[k] = near;
  }
  return points;
}

void add_force(std::span<double> force, const std::array<int, 4>& nodes, const std::array<double, 4>& shape,
               const Vec3<double>& f) {
  for (int k = 0; k < 4; ++k)
    for (int i = 0; i < 3; ++i) force[3 * nodes[k] + i] += shape[k] * f[i];
}

/// Chooses by height. The slack, 1e-9 of the mesh's height, keeps nodes that lie on the level up to rounding.
struct HeightFilter {
  double slack = 0;
  explicit HeightFilter(const Mesh& mesh) {
    const auto lower = [](const Vec3<double>& p, const Vec3<double>& q) { return p.z < q.z; };
    const auto [low, high] = std::minmax_element(mesh.points.begin(), mesh.points.end(), lower);
    if (low != mesh.points.end()) slack = 1e-9 * (high->z - low->z);
  }
  bool keeps(double z, const std::optional<double>& below, const std::optional<double>& above) const {
    return (!below || z <= *below + slack) && (!above || z >= *above - slack);
  }
};

FilmFacet film_facet(const Mesh& mesh, std::span<const int> corners, const Facet& facet, double film) {
  FilmFacet f{facet_nodes(mesh, corners, facet), {}};
  for (const FacetPoint& point : facet_points(facet_corners(mesh, facet))) {
    const double weight = film * norm(point.area);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) f.matrix[i][j] += weight * point.shape[i] * point.shape[j];
  }
  return f;
}

/// Adds the integral of N_i q dA, W.
void add_heat(const Mesh& mesh, std::span<const int> corners, const Facet& facet, const Value& value, double factor,
              std::span<double> heat) {
  const std::array<int, 4> nodes = facet_nodes(mesh, corners, facet);
  for (const FacetPoint& point : facet_points(facet_corners(mesh, facet))) {
    const double through = factor * value(point.position) * norm(point.area);
    for (int i = 0; i < 4; ++i) heat[nodes[i]] += point.shape[i] * through;
  }
}

}  // namespace

std::array<int, 4> facet_nodes(const Mesh& mesh, std::span<const int> corners, const Facet& facet) {
  const std::span<const int> local = face_corners(mesh.shapes[facet.element], facet.face);
  std::array<int, 4> nodes;
  for (std::size_t k = 0; k < 4; ++k)
    nodes[k] = corners[mesh.first_corner[facet.element] + local[std::min(k, local.size() - 1)]];
  return nodes;
}

FacetCorners facet_corners(const Mesh& mesh, const Facet& facet) {
  FacetCorners x;
  const std::array<int, 4> nodes = facet_nodes(mesh, mesh.corners, facet);
  for (int k = 0; k < 4; ++k) x[k] = mesh.points[nodes[k]];
  return x;
}

std::vector<int> surface_nodes(const Mesh& mesh, std::span<const int> corners, const Surface& surface) {
  std::vector<int> nodes;
  for (const Facet& facet : surface.facets)
    for (const int n : facet_nodes(mesh, corners, facet)) nodes.push_back(n);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

void add_nodal_areas(const Mesh& mesh, std::span<const int> corners, const Surface& surface, std::span<double> area) {
  for (const Facet& facet : surface.facets) add_heat(mesh, corners, facet, Value{1, {}}, 1, area);
}

SurfaceArea surface_area(const Mesh& mesh, const Surface& surface) {
  SurfaceArea sum;
  for (const Facet& facet : surface.facets)
    for (const FacetPoint& point : facet_points(facet_corners(mesh, facet))) {
      const double area = norm(point.area);
      sum.area += area;
      sum.moment = sum.moment + area * point.position;
    }
  return sum;
}

Resultant resultant(std::span<const Vec3<double>> points, std::span<const double> force, std::span<const int> nodes) {
  Resultant sum;
  for (const int n : nodes) {
    const Vec3<double> f{force[3 * n], force[3 * n + 1], force[3 * n + 2]};
    sum.force = sum.force + f;
    sum.moment = sum.moment + cross(points[n], f);
  }
  return sum;
}

void add_gravity(const Model& model, std::span<const int> corners, const Vec3<double>& g, std::span<double> force) {
  const Mesh& mesh = model.mesh;
  const std::vector<const Material*> materials = materials_by_region(model);
  for (int e = 0; e < mesh.element_count(); ++e) {
    const std::array<double, 8> volume = element_corner_volumes(mesh, e);
    const double density = materials[mesh.regions[e]]->density;
    for (int k = 0; k < corner_count(mesh.shapes[e]); ++k)
      for (int i = 0; i < 3; ++i) force[3 * corners[mesh.first_corner[e] + k] + i] += volume[k] * density * g[i];
  }
}

void add_water_pressure(const Mesh& mesh, std::span<const int> corners, const Surface& surface,
                        const WaterPressure& water, std::span<double> force) {
  for (const Facet& facet : surface.facets) {
    const std::array<int, 4> nodes = facet_nodes(mesh, corners, facet);
    for (const FacetPoint& point : facet_points_below(facet_corners(mesh, facet), water.level)) {
      const double pressure = water.density * water.gravity * (water.level - point.position.z);
      add_force(force, nodes, point.shape, -pressure * point.area);
    }
  }
}

void add_traction(const Mesh& mesh, std::span<const int> corners, const Surface& surface, const Traction& traction,
                  std::span<double> force) {
  for (const Facet& facet : surface.facets) {
    const std::array<int, 4> nodes = facet_nodes(mesh, corners, facet);
    for (const FacetPoint& point : facet_points(facet_corners(mesh, facet))) {
      const Vec3<double>& p = point.position;
      const Vec3<double> t{traction.x(p), traction.y(p), traction.z(p)};
      add_force(force, nodes, point.shape, norm(point.area) * t);
    }
  }
}

void add_pressure(const Mesh& mesh, std::span<const int> corners, const Surface& surface, const Pressure& pressure,
                  std::span<double> force) {
  for (const Facet& facet : surface.facets) {
    const std::array<int, 4> nodes = facet_nodes(mesh, corners, facet);
    for (const FacetPoint& point : facet_points(facet_corners(mesh, facet)))
      add_force(force, nodes, point.shape, -pressure.value(point.position) * point.area);
  }
}

LevelLine uplift_line(const Uplift& uplift, double low, double high) {
  const double heel = uplift.heel.value_or(low), toe = uplift.toe.value_or(high);
  if (heel == toe)
    throw std::invalid_argument("'heel' and 'toe' are the same place; on an upright face use water_pressure");
  LevelLine line{{heel, uplift.upstream_level}};
  if (uplift.drain) {
    const double share = (*uplift.drain - heel) / (toe - heel);
    if (!(share > 0 && share < 1)) {
      char text[160];
      std::snprintf(text, sizeof text,
                    "the drain at x = %.6g m is not between the heel at %.6g m and the toe at %.6g m", *uplift.drain,
                    heel, toe);
      throw std::invalid_argument(text);
    }
    const double straight = uplift.upstream_level + share * (uplift.downstream_level - uplift.upstream_level);
    const double base = std::max(uplift.downstream_level, uplift.gallery.value_or(uplift.downstream_level));
    line.push_back({*uplift.drain, base + (1 - uplift.drain_efficiency) * std::max(straight - base, 0.0)});
    line.back()[1] = std::min(line.back()[1], straight);
  }
  line.push_back({toe, uplift.downstream_level});
  if (heel > toe) std::reverse(line.begin(), line.end());
  return line;
}

void add_uplift(const Mesh& mesh, std::span<const int> corners, const Surface& surface, const Uplift& uplift,
                const Where& where, std::span<double> force) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Facet& facet : surface.facets)
    for (const Vec3<double>& p : facet_corners(mesh, facet)) low = std::min(low, p.x), high = std::max(high, p.x);
  LevelLine line;
  try {
    line = uplift_line(uplift, low, high);
  } catch (const std::invalid_argument& error) {
    throw DeckError(where, std::string("uplift on surface '") + surface.name + "': " + error.what());
  }
  const std::size_t pieces = line.size() + 1;
  for (const Facet& facet : surface.facets) {
    const std::array<int, 4> nodes = facet_nodes(mesh, corners, facet);
    const FacetCorners x = facet_corners(mesh, facet);
    for (std::size_t k = 0; k < pieces; ++k) {
      const auto& from = line[k == 0 ? 0 : k - 1];
      const auto& to = line[k == line.size() ? k - 1 : k];
      const double slope = k == 0 || k == line.size() ? 0 : (to[1] - from[1]) / (to[0] - from[0]);
      const double level0 = from[1] - slope * from[0];  // level = level0 + slope x
      std::vector<HalfSpace> halves{{{-slope, 0, 1}, level0}};
      if (k > 0) halves.push_back({{-1, 0, 0}, -from[0]});
      if (k < line.size()) halves.push_back({{1, 0, 0}, to[0]});
      for (const FacetPoint& point : facet_points_inside(x, halves)) {
        const double head = level0 + slope * point.position.x - point.position.z;
        add_force(force, nodes, point.shape, (-uplift.density * uplift.gravity * head) * point.area);
      }
    }
  }
}

void add_point_load(const Mesh& mesh, std::span<const int> corners, const PointLoad& load, const Where& where,
                    std::span<double> force) {
  const auto place = locate(mesh, load.at);
  if (!place) throw DeckError(where, "point_load: " + place_text(load.at) + " is outside the body");
  for (std::size_t k = 0; k < place->weights.size(); ++k)
    for (int i = 0; i < 3; ++i)
      force[3 * corners[mesh.first_corner[place->element] + k] + i] += place->weights[k] * load.force[i];
}

bool is_surface_load(const Condition& condition) {
  return std::holds_alternative<WaterPressure>(condition.kind) || std::holds_alternative<Traction>(condition.kind) ||
         std::holds_alternative<Pressure>(condition.kind) || std::holds_alternative<Uplift>(condition.kind);
}

void add_loads(const Model& model, std::span<const int> corners, std::span<const ActingCondition> acting,
               std::span<double> force) {
  for (const ActingCondition& a : acting) {
    if (const auto* gravity = std::get_if<Gravity>(&a.condition->kind))
      add_gravity(model, corners, gravity->acceleration, force);
    if (const auto* load = std::get_if<PointLoad>(&a.condition->kind))
      add_point_load(model.mesh, corners, *load, a.condition->where, force);
    for (const Surface* surface : a.surfaces) {
      if (const auto* water = std::get_if<WaterPressure>(&a.condition->kind))
        add_water_pressure(model.mesh, corners, *surface, *water, force);
      if (const auto* traction = std::get_if<Traction>(&a.condition->kind))
        add_traction(model.mesh, corners, *surface, *traction, force);
      if (const auto* pressure = std::get_if<Pressure>(&a.condition->kind))
        add_pressure(model.mesh, corners, *surface, *pressure, force);
      if (const auto* uplift = std::get_if<Uplift>(&a.condition->kind))
        add_uplift(model.mesh, corners, *surface, *uplift, a.condition->where, force);
    }
  }
}

void add_heat_source(const Mesh& mesh, std::span<const int> corners, std::span<const int> regions, const Value& value,
                     std::span<double> heat) {
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (!std::binary_search(regions.begin(), regions.end(), mesh.regions[e])) continue;
    const std::span<const int> nodes = mesh.element(e);
    for (const BodyPoint& point : body_points(mesh, e)) {
      Vec3<double> position;
      for (std::size_t k = 0; k < nodes.size(); ++k) position = position + point.shape[k] * mesh.points[nodes[k]];
      const double made = value(position) * point.volume;
      for (std::size_t k = 0; k < nodes.size(); ++k) heat[corners[mesh.first_corner[e] + k]] += point.shape[k] * made;
    }
  }
}

ThermalBoundary thermal_boundary(const Mesh& mesh, std::span<const int> corners, int node_count,
                                 std::span<const ActingCondition> acting) {
  ThermalBoundary boundary;
  boundary.heat.assign(node_count, 0);
  std::vector<Vec3<double>> points(node_count);
  for (std::size_t c = 0; c < corners.size(); ++c) points[corners[c]] = mesh.points[mesh.corners[c]];
  std::vector<std::optional<double>> fixed(node_count);
  const HeightFilter filter(mesh);

  for (const ActingCondition& a : acting)
    if (const auto* source = std::get_if<HeatSource>(&a.condition->kind))
      add_heat_source(mesh, corners, a.regions, source->value, boundary.heat);
  for (const ActingCondition& a : acting)
    for (const Surface* surface : a.surfaces) {
      if (const auto* f = std::get_if<FixedTemperature>(&a.condition->kind)) {
        for (const int n : surface_nodes(mesh, corners, *surface))
          if (filter.keeps(points[n].z, f->below, f->above)) fixed[n] = f->value(points[n]);
      } else if (const auto* c = std::get_if<Convection>(&a.condition->kind)) {
        for (const Facet& facet : surface->facets) {
          if (!filter.keeps(mesh.facet_centroid(facet).z, c->below, c->above)) continue;
          boundary.films.push_back(film_facet(mesh, corners, facet, c->film));
          add_heat(mesh, corners, facet, c->ambient, c->film, boundary.heat);
        }
      } else if (const auto* q = std::get_if<Flux>(&a.condition->kind)) {
        for (const Facet& facet : surface->facets) add_heat(mesh, corners, facet, q->value, 1, boundary.heat);
      }
    }

  for (int n = 0; n < node_count; ++n)
    if (fixed[n]) {
      boundary.fixed_nodes.push_back(n);
      boundary.fixed_temperature.push_back(*fixed[n]);
    }
  return boundary;
}

FilmMatrix film_matrix(std::span<const FilmFacet> films, std::span<const HeatLink> links,
                       std::span<const int> new_node) {
  std::map<std::pair<int, int>, double> entries;
  for (const FilmFacet& f : films)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) entries[{new_node[f.nodes[i]], new_node[f.nodes[j]]}] += f.matrix[i][j];
  for (const HeatLink& link : links)
    for (std::size_t i = 0; i < link.nodes.size(); ++i)
      for (std::size_t j = 0; j < link.nodes.size(); ++j)
        entries[{new_node[link.nodes[i]], new_node[link.nodes[j]]}] +=
            link.conductance * link.weights[i] * link.weights[j];
  FilmMatrix m;
  for (const auto& [place, value] : entries) {
    if (m.node.empty() || m.node.back() != place.first) {
      m.node.push_back(place.first);
      m.first.push_back(m.first.back());
    }
    m.column.push_back(place.second);
    m.value.push_back(value);
    ++m.first.back();
  }
  return m;
}

std::vector<double> lumped_capacity(const Model& model, std::span<const int> corners, int node_count) {
  const Mesh& mesh = model.mesh;
  const std::vector<const Material*> materials = materials_by_region(model);
  Complaints complaints;
  for (const Material& material : model.materials)
    if (!material.heat_capacity)
      complaints.add(material.where, "material '" + material.name +
                                         "': missing 'heat_capacity' [J/(kg K)], needed by a transient thermal stage");
  complaints.raise();
  std::vector<double> capacity(node_count, 0);
  for (int e = 0; e < mesh.element_count(); ++e) {
    const std::array<double, 8> volume = element_corner_volumes(mesh, e);
    const Material& material = *materials[mesh.regions[e]];
    for (int k = 0; k < corner_count(mesh.shapes[e]); ++k)
      capacity[corners[mesh.first_corner[e] + k]] += volume[k] * material.density * *material.heat_capacity;
  }
  return capacity;
}

}  // namespace ashlar
