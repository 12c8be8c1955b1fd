#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/error.hpp"
#include "base/tensor.hpp"
#include "model/mesh.hpp"
#include "model/mesher/closed_surface.hpp"

/// The model: what the deck says, on the host, immutable during a run. SI units, temperatures in degrees Celsius.
/// Filled by script/, or by hand in tests. Every declaration carries the deck line for messages.
namespace ashlar {

/// A number, or a function of position that is called once per node (or quadrature point) when a stage is set up.
struct Value {
  double constant = 0;
  std::function<double(const Vec3<double>&)> at;  ///< empty: constant
  double operator()(const Vec3<double>& p) const { return at ? at(p) : constant; }
};

// ---------------------------------------------------------------- geometry

/// `extrude "dam" { section = {{x,z},...}, length =, size =, layers =, ... }`. Section in the x-z plane, extruded along y from 0.
struct Extrude {
  std::string name;                           ///< becomes the region's name
  Where where;
  std::vector<std::array<double, 2>> section; ///< (x, z) outline, either orientation, closed implicitly
  std::vector<std::vector<std::array<double, 2>>> holes;  ///< outlines of galleries and the like, inside the section
  double y0 = 0;                              ///< where the extrusion starts, m
  double length = 0;                          ///< along y, m
  double size = 0;                            ///< target element edge, m
  double layer_size = 0;                      ///< target edge along y; 0: as size
  int layers = 0;                             ///< along y; 0: from layer_size
  std::vector<int> corners;                   ///< four 1-based indices into section; empty: by angle
  std::map<int, int> divisions;               ///< 1-based side (between chosen corners) -> divisions asked; else by size
  double hole_size = 0;                       ///< target element edge at the holes, m; 0: as size
  double grow = 0;                            ///< growth from one element to the next, away from finer neighbours and holes up to `size`
                                              ///< (1: uniform); 0: 1 in a logical quad, 1.3 in a section meshed free
  bool structured = true;                     ///< a logical quad is meshed in rows; false: triangulated as any other outline
  Shape shape = Shape::hex8;                  ///< hex8, or split into wedge6 or tet4
};

/// `box "bar" { from = {x,y,z}, to = {x,y,z}, cells = {nx,ny,nz} }` (or size): a block of hex8 (or wedge6, tet4 by splitting).
struct Box {
  std::string name;
  Where where;
  std::array<double, 3> from{}, to{};
  std::array<int, 3> cells{};                 ///< all >= 1 after reading (script derives them from `size`)
  Shape shape = Shape::hex8;
  std::array<std::optional<Value>, 3> bent;   ///< x, y, z to which the straight box's points move, m; empty: stays
};

/// `solid "abutment" { file = "abutment.stl", size = 5*m }`: tetrahedra inside a closed surface, which is read with the deck.
struct Solid {
  std::string name;
  Where where;
  std::string file;
  FacetSurface surface;                       ///< as the file gives it, in m
  double size = 0;                            ///< target element edge at the surface, m
  double grow = 1;                            ///< growth from one element to the next, away from the surface; 1: uniform
  double feature_angle = 0.3490658503988659;  ///< rad; edges where facets meet at more stay in the mesh
};

/// `import_mesh { file = "dam.msh", regions = {...rename} }`: the mesh itself is read by io/ when the deck is read.
struct ImportedMesh {
  std::string name;
  Where where;
  std::string file;
  Mesh mesh;
};

/// `surface "upstream" { of = "dam", ... }`: every filter given must hold. Selected from outer faces of the model that the
/// regions own, or from the groups given (select_surface.hpp says each filter's exact meaning).
struct SurfaceChoice {
  std::string name;
  Where where;
  std::vector<std::string> of;                ///< regions
  std::vector<std::string> side;              ///< left right (-x +x), front back (-y +y), bottom top (-z +z): within 30 degrees and seen from there
  std::optional<Vec3<double>> facing;         ///< direction
  double within = 0.5235987755982988;         ///< rad from `facing` (default 30 degrees)
  std::optional<std::array<Vec3<double>, 2>> box;                 ///< facet centroid inside [low, high]
  std::optional<std::pair<Vec3<double>, Vec3<double>>> plane;     ///< point, normal: all corners on the plane within 1e-6 of the model size
  std::vector<std::string> group;             ///< surfaces already in the mesh (file groups) to take the facets from; empty: all outer faces
  std::string joint;                          ///< the faces of this joint on both sides instead, for pressures in it
};

// ---------------------------------------------------------------- materials and interfaces

struct Material {
  std::string name;
  Where where;
  std::vector<std::string> regions;
  std::string law = "elastic";
  double density = 0;                         ///< kg/m^3
  std::optional<double> conductivity;         ///< W/(m K), needed by thermal stages
  std::optional<double> heat_capacity;        ///< J/(kg K), needed by transient thermal stages
  std::map<std::string, double> values;       ///< keys of the law (physics/laws)
  std::optional<bool> bbar;                   ///< elements that do not lock; without: for laws that remember
};

/// How strength differs from contact face to contact face.
struct Scatter {
  enum class Kind { none, normal, weibull } kind = Kind::none;
  double variation = 0;  ///< standard deviation over mean
  int seed = 1;
};

/// `joint "base" { between = {"dam","rock"}, law = ... }` and `crackable "body" { region = "dam", law = ... }`.
struct Interface {
  std::string name;
  Where where;
  bool crackable = false;
  std::vector<std::string> regions;           ///< joint: exactly two; crackable: one or more
  std::string law;                            ///< physics/interface_laws
  std::map<std::string, double> values;
  double tolerance =
      0;  ///< joint: distance up to which facets meshed apart are joined, m; 0: a millionth of the model's size
  double opening = 0;      ///< frictional: gap at the start, m
  double conductance = 0;  ///< joint: of heat between its faces, W/(m^2 K); 0: almost none lost
  std::optional<double> open_conductance{};  ///< joint: where it is open, W/(m^2 K); none: see resists_heat
  Scatter scatter;         ///< of tensile strength and cohesion together
  /// Whether its sides have temperatures of their own; open parts pass none unless open_conductance says so.
  bool resists_heat() const { return conductance > 0 || open_conductance; }
};

// ---------------------------------------------------------------- initial stress

/// Stress of ground at rest: vertical - unit_weight (level - z), and k0 times that sideways.
struct InSituStress {
  double level = 0, vertical = 0;             ///< m; Pa at the level, tension positive
  std::optional<double> unit_weight;          ///< N/m^3; without: gravity times the density of the region's material
  double gravity = 9.81;                      ///< m/s^2
  double k0_x = 0, k0_y = 0;
};
/// `initial_stress { region = "rock", level = 40*m, k0 = 0.6 }` or components: stress before any displacement.
struct InitialStress {
  std::string name;                           ///< may be empty
  Where where;
  std::vector<std::string> regions;           ///< empty: all
  std::optional<InSituStress> in_situ;
  std::array<Value, 6> components;            ///< Pa, xx yy zz xy yz zx; without in_situ
};

// ---------------------------------------------------------------- conditions

struct Fix { bool x = false, y = false, z = false, normal = false; };
struct Displacement { std::optional<Value> x, y, z; };             ///< m
struct Gravity { Vec3<double> acceleration; };                      ///< m/s^2
struct WaterPressure { double level = 0, density = 1000, gravity = 9.81; };  ///< p = density gravity (level - z) below the level
/// Water in what is open of interfaces, p = density gravity (level - z) below the level.
struct CrackWater {
  std::vector<std::string> interfaces;
  double level = 0, density = 1000, gravity = 9.81;
};
/// Grout fills what is open of interfaces when it first acts: they carry compression from there.
struct Grouting { std::vector<std::string> interfaces; };
struct Traction { Value x, y, z; };                                 ///< Pa
struct Pressure { Value value; };                                   ///< Pa, against the outward normal
/// Water pressure under a base, density gravity (level(x) - z) where positive. The piezometric level runs linearly in x
/// from `upstream_level` at the heel to `downstream_level` at the toe, with a kink at a line of drains (loads.hpp).
struct Uplift {
  double upstream_level = 0, downstream_level = 0;                  ///< heights z, m
  std::optional<double> heel, toe;            ///< x, m; without: lowest and highest x of the surface
  std::optional<double> drain;                ///< x of the line of drains, m
  double drain_efficiency = 0;                ///< E, 0 to 1
  std::optional<double> gallery;              ///< height z of the floor that the drains empty onto, m
  double density = 1000, gravity = 9.81;
};
struct PointLoad { Vec3<double> at, force; };                        ///< m, N
struct FixedTemperature { Value value; std::optional<double> below, above; };  ///< nodes with z <= below, z >= above only
struct Convection { Value ambient; double film = 0; std::optional<double> below, above; };  ///< facets by centroid z
struct Flux { Value value; };                                       ///< W/m^2 into the body
struct HeatSource { Value value; std::vector<std::string> regions; };  ///< W/m^3; no regions: the whole model
struct InitialTemperature { Value value; std::vector<std::string> regions; };  ///< at the first stage where it acts
struct TemperatureField { Value value; };                           ///< prescribed everywhere in a stage: degC

/// Values at ascending times, straight lines between, constant beyond the ends.
struct TimeTable {
  std::vector<double> time, value;            ///< s, at least one
  double at(double t) const;
};
/// A number of a condition that follows time (in_time.hpp).
struct InTime {
  std::string key;                            ///< of the deck, such as "ambient"
  TimeTable table;
  bool from_stage = false;                    ///< time counts from the stage where the condition first acts, not the run's start
  std::function<double(double)> function;     ///< of time, until it has been sampled into the table
  std::function<double(const Vec3<double>&, double)> field;  ///< of place and time; the table then gives the time to ask at
};

struct Condition {
  using Kind =
      std::variant<Fix, Displacement, Gravity, WaterPressure, Traction, Pressure, Uplift, PointLoad, FixedTemperature,
                   Convection, Flux, HeatSource, InitialTemperature, TemperatureField, CrackWater,
                   Grouting>;
  std::string noun;                           ///< "fix", "gravity", ... as in the deck
  std::string name;                           ///< may be empty
  Where where;
  std::vector<std::string> surfaces;          ///< empty where the noun takes none
  Kind kind;
  std::optional<std::array<Vec3<double>, 2>>
      line{};                                 ///< of a held or moved surface only nodes between these two points, m
  bool everywhere = true;                     ///< declared outside `apply`: acts in every stage
  std::vector<InTime> in_time;                ///< numbers of `kind` that are those of the run's start until with_numbers
};

// ---------------------------------------------------------------- stages

enum class Damping { adaptive, local, viscous };

struct Relaxation {
  double tolerance = 1e-6;                    ///< unbalanced force ratio (numerics 3)
  Damping damping = Damping::adaptive;
  double damping_value = 0;                   ///< local: alpha (0: 0.8); viscous: fraction of velocity lost per step (0: 0.02)
  double step_factor = 1;                     ///< <= 1; scales the pseudo time step
  long max_steps = 0;                         ///< 0: a million
  bool search = true;                         ///< conjugate gradients to the elastic balance first, where all contacts are bonded
};
struct StaticSolve {
  Relaxation relaxation;
  int increments = 0;                         ///< of what is out of balance at the start; 0: 1, or 20 with materials that remember
};
struct ThermalSolve {
  bool steady = false;
  double duration = 0;                        ///< s, transient
  double tolerance = 1e-10;                   ///< steady: residual norm over its start
  double record_every = 0;                    ///< s between history rows of a transient; 0: a hundredth of the duration
};
/// Temperature change from the end of stage `from` (or the reference temperature if empty) to the end of stage `to`, applied on
/// top of the state reached, in `increments` of the load factor, with crack events.
struct FractureSolve {
  std::string from, to;
  int increments = 10;
  Relaxation relaxation;
  long max_events = 100000;
  double event_group = 0.999;                 ///< contact points that use this share of what the worst one uses crack with it
};

/// The factor by which all strength can be divided before no equilibrium is found any more, by halving the interval.
struct StrengthReduction {
  double low = 1, high = 4;
  double width = 0.01;                        ///< of the interval at the end
  Relaxation relaxation;
};

/// Motion in time with the real mass, from rest or from the end of a dynamic stage before.
struct DynamicSolve {
  double duration = 0;                        ///< s
  double local_damping = 0;                   ///< Cundall's alpha: force that opposes motion, as a share of the unbalanced force
  double mass_damping = 0;                    ///< Rayleigh's factor of the mass, 1/s
  double stiffness_damping = 0;               ///< Rayleigh's factor of the blocks' stiffness, s
  double time_step = 0;                       ///< s; 0: time_factor of the stable one
  double time_factor = 0;                     ///< share of the stable step (0: 0.9, less where contacts separate); above 1 to see a motion run away
  double record_every = 0;                    ///< s between history rows; 0: a hundredth of the duration
  bool large_displacement = false;            ///< blocks move and turn far and meet others; needs frictional interfaces
  double contact_damping = 0;                 ///< s, large displacement: force of a speed over that of a distance
};

/// Heat and quasi-static stress together in time: heat in its own steps, equilibrium at times `every` apart.
struct CoupledSolve {
  double duration = 0;                        ///< s
  double every = 0;                           ///< s between equilibria; the last is at the end
  int increments = 1;                         ///< of the change from one equilibrium to the next
  Relaxation relaxation;
};

/// How a stage is solved.
using Solve =
    std::variant<StaticSolve, ThermalSolve, FractureSolve, DynamicSolve, StrengthReduction, CoupledSolve>;

struct Stage {
  std::string name;
  Where where;
  std::vector<int> apply;                     ///< indices into Model::conditions, from this stage on
  std::vector<std::string> remove;            ///< names of conditions that stop acting from this stage on
  Solve solve;
  bool reset_displacement = false;            ///< after this stage, output displacement counts from its end
};
/// Whether temperature is solved for, whether stress is.
inline bool is_thermal(const Stage& stage) {
  return std::holds_alternative<ThermalSolve>(stage.solve) || std::holds_alternative<CoupledSolve>(stage.solve);
}
inline bool is_mechanical(const Stage& stage) { return !std::holds_alternative<ThermalSolve>(stage.solve); }

// ---------------------------------------------------------------- what comes out

/// `history "crest" { at = {x,y,z}, record = {"displacement","temperature","stress"} }` or `{ surface = "bottom", record = {"reaction","load","area"} }`.
struct History {
  std::string name;
  Where where;
  std::optional<Vec3<double>> at;
  std::string surface;                        ///< resultants over a surface, N
  std::vector<std::string> record;
};

/// `output "fields" { record = {...}, at = "stage_end" }`.
struct Output {
  std::string name;
  Where where;
  std::vector<std::string> record;            ///< names of io/result fields
  int every = 0;                              ///< 0: stage ends only; n: also every n-th increment of fracture stages / n-th time of coupled stages / n-th record of dynamic stages
};

/// `picture "cracks" { of = "temperature", stage = "winter", ... }`: handed to the plotting program through the manifest.
struct Picture {
  std::string name;
  Where where;
  std::string of;
  std::string stage;
  double deform = 0;                          ///< magnification; 0: undeformed
  std::string section;                        ///< "" surface view; "y": section at mid y
};

struct Model {
  std::string name = "model";
  Where where;
  double reference_temperature = 0;           ///< degC, no thermal strain at this temperature; initial temperature unless given
  std::vector<Extrude> extrudes;
  std::vector<Box> boxes;
  std::vector<Solid> solids;
  std::vector<ImportedMesh> imports;
  std::vector<SurfaceChoice> surfaces;
  std::vector<Material> materials;
  std::vector<Interface> interfaces;
  std::vector<InitialStress> initial_stresses;
  std::vector<Condition> conditions;
  std::vector<Stage> stages;
  std::vector<History> histories;
  std::vector<Output> outputs;
  std::vector<Picture> pictures;
  Mesh mesh;                                  ///< whole model, filled by build_mesh
  std::vector<std::string> notes;             ///< doubts about the deck, and what build_mesh did that it does not say
};

/// Whether blocks may move far in one of the stages.
inline bool has_large_displacement(const Model& model) {
  for (const Stage& stage : model.stages)
    if (const auto* d = std::get_if<DynamicSolve>(&stage.solve); d && d->large_displacement) return true;
  return false;
}

/// Meshes every extrude, box and solid, joins imported meshes, resolves surfaces into model.mesh.surfaces.
/// Nodes of different sources that coincide are merged (conforming extrudes, touching boxes).
/// Throws DeckError with the declaration's line: empty surface, unknown region, bad elements.
void build_mesh(Model& model);

/// Everything that only shows when the model is whole (deck.md rule 6). Throws DeckError with all complaints.
void check_model(const Model& model);

}  // namespace ashlar
