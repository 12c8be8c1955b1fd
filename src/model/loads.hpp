#pragma once
#include <array>
#include <span>
#include <vector>

#include "model/conditions.hpp"
#include "model/contact/heat_links.hpp"
#include "model/model.hpp"
#include "physics/facet.hpp"

/// Consistent nodal loads, mechanical and thermal, in a fixed summation order (element after element, facet after
/// facet). `corners` is parallel to Mesh::corners and numbers the nodes that receive the load: Mesh::corners itself, or
/// Blocks::corners so that a load on a facet acts on the copies that belong to the element owning it.
namespace ashlar {

// ---------------------------------------------------------------- facets

/// Nodes of a facet in the numbering of `corners`, right-hand order; a triangle repeats its last node
/// (physics/facet.hpp).
std::array<int, 4> facet_nodes(const Mesh& mesh, std::span<const int> corners, const Facet& facet);
/// Corner positions in the same order.
FacetCorners facet_corners(const Mesh& mesh, const Facet& facet);
/// Nodes of all facets of a surface in the numbering of `corners`, sorted, each once.
std::vector<int> surface_nodes(const Mesh& mesh, std::span<const int> corners, const Surface& surface);
/// Adds the integral of N_i dA, m^2, to area [nodes].
void add_nodal_areas(const Mesh& mesh, std::span<const int> corners, const Surface& surface, std::span<double> area);

/// Area and its first moment about the origin.
struct SurfaceArea {
  double area = 0;      ///< m^2
  Vec3<double> moment;  ///< integral of x dA, m^3; over area: the centroid
};
SurfaceArea surface_area(const Mesh& mesh, const Surface& surface);

/// Sum of nodal forces and of their moments about the origin.
struct Resultant {
  Vec3<double> force;   ///< N
  Vec3<double> moment;  ///< N m
};
/// `points` [nodes] m, `force` [3 * nodes] N, over the given nodes in their order.
Resultant resultant(std::span<const Vec3<double>> points, std::span<const double> force, std::span<const int> nodes);

// ---------------------------------------------------------------- forces, N, added to force [3 * nodes]

/// Integral of N_i density g dV; g in m/s^2.
void add_gravity(const Model& model, std::span<const int> corners, const Vec3<double>& g, std::span<double> force);
/// Pressure density gravity (level - z) on the part of each facet below the level, against its outward normal.
void add_water_pressure(const Mesh& mesh, std::span<const int> corners, const Surface& surface,
                        const WaterPressure& water, std::span<double> force);
/// Integral of N_i t dA; the traction, Pa, is asked at the 2x2 Gauss points of each facet.
void add_traction(const Mesh& mesh, std::span<const int> corners, const Surface& surface, const Traction& traction,
                  std::span<double> force);
/// Integral of N_i p dA against the outward normal; the pressure, Pa, is asked at the 2x2 Gauss points of each facet.
void add_pressure(const Mesh& mesh, std::span<const int> corners, const Surface& surface, const Pressure& pressure,
                  std::span<double> force);

/// Piezometric level along x: straight lines between points of ascending x, constant beyond the ends.
using LevelLine = std::vector<std::array<double, 2>>;  ///< { x, level }, m
/// Level of an uplift: straight from heel to toe, and at a line of drains
///   base + (1 - E) (straight - base), base = the higher of downstream level and gallery floor,
/// but never above the straight line (USACE EM 1110-2-2200, Gravity Dam Design, 1995, 3-3 d). `low`, `high`: smallest
/// and largest x of the surface. Throws std::invalid_argument if heel and toe coincide or the drain is not between
/// them.
LevelLine uplift_line(const Uplift& uplift, double low, double high);
/// Pressure density gravity (level(x) - z) where positive, against the outward normal. Throws DeckError with `where`.
void add_uplift(const Mesh& mesh, std::span<const int> corners, const Surface& surface, const Uplift& uplift,
                const Where& where, std::span<double> force);

/// A force at a point of the body, by the shape functions of the element that holds it (locate.hpp), so that force and
/// moment are kept. Throws DeckError with `where` if the point is outside the body.
void add_point_load(const Mesh& mesh, std::span<const int> corners, const PointLoad& load, const Where& where,
                    std::span<double> force);

/// Whether a condition is a load spread over its surfaces.
bool is_surface_load(const Condition& condition);
/// All gravity, surface and point loads among the acting conditions.
void add_loads(const Model& model, std::span<const int> corners, std::span<const ActingCondition> acting,
               std::span<double> force);

// ---------------------------------------------------------------- heat

/// Adds the integral of N_i q dV over the elements of the regions, W, to heat [nodes]; q, W/m^3, is asked at Gauss
/// points: those of stress, and four of degree 2 in a tet4.
void add_heat_source(const Mesh& mesh, std::span<const int> corners, std::span<const int> regions, const Value& value,
                     std::span<double> heat);

/// Exchange with the surroundings through one facet: heat leaving node i is sum_j matrix[i][j] (T_j - ambient), W.
struct FilmFacet {
  std::array<int, 4> nodes;                     ///< a triangle repeats its last node
  std::array<std::array<double, 4>, 4> matrix;  ///< integral of N_i N_j film dA, W/K
};

/// Thermal boundary of a stage. Nodes that no condition names are insulated.
struct ThermalBoundary {
  std::vector<int> fixed_nodes;           ///< sorted
  std::vector<double> fixed_temperature;  ///< degC, parallel to fixed_nodes
  std::vector<FilmFacet> films;
  std::vector<double> heat;  ///< [nodes] W into the body: flux, heat source and film times ambient
};
/// Later fixed temperatures override earlier ones on shared nodes; `below` and `above` choose nodes by their z for
/// fixed temperatures and facets by the z of their centroid for convection.
ThermalBoundary thermal_boundary(const Mesh& mesh, std::span<const int> corners, int node_count,
                                 std::span<const ActingCondition> acting);

/// Films and links as a matrix in rows, for machines: row i belongs to node[i], its entries first[i] .. first[i+1]-1
/// have ascending columns. Facets are summed in their order, then links.
struct FilmMatrix {
  std::vector<int> node, first{0}, column;
  std::vector<double> value;  ///< W/K
};
/// @param new_node [nodes] number on the machine of every node of the films
FilmMatrix film_matrix(std::span<const FilmFacet> films, std::span<const HeatLink> links,
                       std::span<const int> new_node);

/// Integral of N_i rho c dV, J/K, [nodes]. Throws DeckError naming materials without heat_capacity.
std::vector<double> lumped_capacity(const Model& model, std::span<const int> corners, int node_count);

}  // namespace ashlar
