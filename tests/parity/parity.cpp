#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iomanip>

#include "io/mesh_file.hpp"
#include "model/loads.hpp"
#include "solve/elastic_start.hpp"
#include "solve/problem.hpp"
#include "solve/stage_conditions.hpp"
#include "solve/virtual_mass.hpp"

/// Parity: the same bits on every machine and with every number of threads. An equality test, not a tolerance.
namespace ashlar {
namespace {

enum class Blocks {
  continuous,
  mixed,
  tetrahedra,
  plastic,
  breaking,
  jointed,
  unmatched,
  softening,
  exploded,
  cracked
};

Condition condition(const char* noun, const char* surface, Condition::Kind kind) {
  Condition c;
  c.noun = noun;
  if (surface) c.surfaces = {surface};
  c.kind = std::move(kind);
  return c;
}

/// The same nodes, every third hexahedron cut into two wedges.
Mesh cut_into_wedges(const Mesh& hexahedra) {
  Mesh m = hexahedra;
  m.shapes.clear(), m.regions.clear(), m.corners.clear(), m.first_corner = {0};
  const auto add = [&](Shape shape, int e, std::initializer_list<int> corners) {
    for (const int k : corners) m.corners.push_back(hexahedra.element(e)[k]);
    m.shapes.push_back(shape);
    m.regions.push_back(hexahedra.regions[e]);
    m.first_corner.push_back(static_cast<int>(m.corners.size()));
  };
  for (int e = 0; e < hexahedra.element_count(); ++e)
    if (e % 3 > 0) {
      add(Shape::hex8, e, {0, 1, 2, 3, 4, 5, 6, 7});
    } else {
      add(Shape::wedge6, e, {0, 1, 2, 4, 5, 6});
      add(Shape::wedge6, e, {0, 2, 3, 4, 6, 7});
    }
  return m;
}

/// The same nodes, every hexahedron cut into tetrahedra from its smallest node.
Mesh cut_into_tetrahedra(const Mesh& hexahedra) {
  Mesh m = hexahedra;
  m.shapes.clear(), m.regions.clear(), m.corners.clear(), m.source_ids.clear(), m.first_corner = {0};
  std::vector<int> first{0};  // of each hexahedron
  for (int e = 0; e < hexahedra.element_count(); ++e) {
    const auto corners = hexahedra.element(e);
    const int apex = *std::min_element(corners.begin(), corners.end());
    for (int f = 0; f < 6; ++f) {
      std::vector<int> quad;
      for (int i = 0; i < 4; ++i) quad.push_back(corners[face_corners(Shape::hex8, f)[i]]);
      const auto smallest = std::min_element(quad.begin(), quad.end());
      if (*smallest == apex) continue;
      std::rotate(quad.begin(), smallest, quad.end());
      for (const int k : {1, 2})
        m.add_element(Shape::tet4, std::vector{quad[0], quad[k + 1], quad[k], apex}, hexahedra.regions[e], 0);
    }
    first.push_back(m.element_count());
  }
  for (std::size_t s = 0; s < m.surfaces.size(); ++s) {
    m.surfaces[s].facets.clear();
    for (const Facet& facet : hexahedra.surfaces[s].facets) {
      const std::vector<int> whole = hexahedra.facet_nodes(facet);
      for (int e = first[facet.element]; e < first[facet.element + 1]; ++e)
        for (int f = 0; f < 4; ++f) {
          const std::vector<int> part = m.facet_nodes({e, f});
          const auto on_it = [&](int n) { return std::find(whole.begin(), whole.end(), n) != whole.end(); };
          if (std::all_of(part.begin(), part.end(), on_it)) m.surfaces[s].facets.push_back({e, f});
        }
    }
  }
  return m;
}

/// Concrete of one mesh on rock of another, surfaces of both; their nodes are their own.
Mesh meshed_apart(const Mesh& concrete, const Mesh& rock) {
  Mesh m;
  m.region_names = {"rock", "concrete"};
  for (const auto& [source, region] : {std::pair{&rock, "rock"}, {&concrete, "concrete"}}) {
    std::vector<int> node(source->node_count(), -1), element(source->element_count(), -1);
    for (int e = 0; e < source->element_count(); ++e) {
      if (source->region_names[source->regions[e]] != region) continue;
      std::vector<int> corners;
      for (const int n : source->element(e)) {
        if (node[n] < 0) {
          node[n] = m.node_count();
          m.points.push_back(source->points[n]);
        }
        corners.push_back(node[n]);
      }
      element[e] = m.element_count();
      m.add_element(source->shapes[e], corners, m.find_region(region), element[e] + 1);
    }
    for (const Surface& surface : source->surfaces) {
      auto at =
          std::find_if(m.surfaces.begin(), m.surfaces.end(), [&](const Surface& s) { return s.name == surface.name; });
      if (at == m.surfaces.end()) at = m.surfaces.insert(at, Surface{surface.name, {}});
      for (const Facet& f : surface.facets)
        if (element[f.element] >= 0) at->facets.push_back({element[f.element], f.face});
    }
  }
  return m;
}

/// Dam D0 with gravity and water; as one body, the same with materials that flow, crack or have joints, on rock that
/// was meshed apart, or as one block an element with bonded or with sliding contacts.
Model dam(const char* file, Blocks blocks) {
  Model m;
  m.mesh = read_mesh(std::string(ASHLAR_TEST_DATA) + "/" + file, {});
  if (blocks == Blocks::mixed) m.mesh = cut_into_wedges(m.mesh);
  if (blocks == Blocks::tetrahedra) m.mesh = cut_into_tetrahedra(m.mesh);
  if (blocks == Blocks::unmatched)
    m.mesh = meshed_apart(m.mesh, read_mesh(std::string(ASHLAR_TEST_DATA) + "/dam_D0_r2_ny4.msh", {}));
  m.reference_temperature = 15;
  Material rock{"rock", {},  {"rock"}, "elastic",
                2650,   3.0, 850.0,    {{"young", 30e9}, {"poisson", 0.25}, {"expansion", 8e-6}}};
  Material concrete{"concrete", {},  {"concrete"}, "elastic",
                    2400,       2.7, 960.0,        {{"young", 20e9}, {"poisson", 0.2}, {"expansion", 1e-5}}};
  m.materials = {rock, concrete};
  m.conditions = {condition("gravity", nullptr, Gravity{{0, 0, -9.81}}),
                  condition("water_pressure", "up_wet", WaterPressure{55}),
                  condition("fix", "bottom", Fix{true, true, true, false}),
                  condition("fix", "xside", Fix{true, false, false, false}),
                  condition("fix", "yside", Fix{false, true, false, false})};
  if (blocks == Blocks::tetrahedra) {  // elastic and plastic, both with means over neighbours
    for (Material& material : m.materials) material.bbar = true;
    m.materials[1].law = "mohr_coulomb";
    m.materials[1].values.merge(std::map<std::string, double>{{"cohesion", 1e4}, {"friction", 0.5}, {"dilation", 0.1}});
  } else if (blocks == Blocks::plastic) {
    for (Material& material : m.materials) material.law = "drucker_prager";
    m.materials[0].values.merge(std::map<std::string, double>{
        {"cohesion", 2e4}, {"friction", 0.4}, {"dilation", 0.2}, {"tension_cutoff", 1e4}, {"hardening", -1e6}});
    m.materials[1].law = "mohr_coulomb";
    m.materials[1].values.merge(std::map<std::string, double>{
        {"cohesion", 1e4}, {"friction", 0.5}, {"dilation", 0.1}, {"tensile_strength", 1e4}});
  } else if (blocks == Blocks::breaking) {
    m.materials[0].law = "breakage";
    m.materials[0].values.merge(std::map<std::string, double>{
        {"tensile_strength", 1e4}, {"fracture_energy", 1}, {"cohesion", 2e4}, {"friction", 0.5}});
    m.materials[1].law = "damage";
    m.materials[1].values.merge(std::map<std::string, double>{{"tensile_strength", 1e4}, {"fracture_energy", 1}});
  } else if (blocks == Blocks::jointed) {
    for (Material& material : m.materials) material.law = "jointed";
    m.materials[0].values.merge(std::map<std::string, double>{
        {"dip", 0.5}, {"dip_direction", 1.5}, {"cohesion", 1e4}, {"friction", 0.4}, {"dilation", 0.1}});
    m.materials[1].values.merge(std::map<std::string, double>{
        {"dip", 1.2}, {"dip_direction", 0.3}, {"cohesion", 1e4}, {"friction", 0.4}, {"tensile_strength", 5e3}});
  } else if (blocks != Blocks::continuous && blocks != Blocks::mixed) {
    Interface i;
    i.name = "all";
    i.crackable = blocks != Blocks::unmatched;
    i.regions = {"rock", "concrete"};
    i.law = blocks == Blocks::cracked ? "frictional" : blocks == Blocks::softening ? "softening" : "brittle";
    i.values = {{"friction", 0.7}};
    if (blocks == Blocks::softening) {
      i.values.merge(std::map<std::string, double>{
          {"tensile_strength", 1e4}, {"cohesion", 2e4}, {"fracture_energy", 1}, {"shear_fracture_energy", 3}});
      i.scatter = {Scatter::Kind::weibull, 0.2, 4};
      m.conditions.push_back(condition("crack_water", nullptr, CrackWater{{"all"}, 55}));
    } else if (blocks != Blocks::cracked) {
      i.values["tensile_strength"] = 1e6;
      i.values["cohesion"] = 2e6;
    }
    if (blocks == Blocks::cracked) i.opening = 1e-5;
    m.interfaces = {i};
  }
  m.stages.resize(1);
  m.stages[0].name = "gravity";
  return m;
}

/// Bit patterns; doubles that hold widened floats compare the same way.
void expect_same_bits(const std::vector<double>& a, const std::vector<double>& b, const char* what) {
  ASSERT_EQ(a.size(), b.size());
  std::size_t different = 0, first = 0;
  for (std::size_t i = a.size(); i-- > 0;)
    if (std::memcmp(&a[i], &b[i], sizeof a[i]) != 0) {
      ++different;
      first = i;
    }
  EXPECT_EQ(different, 0u) << what << ": " << different << " of " << a.size() << " numbers differ, first number " << first
                           << ": " << std::setprecision(17) << a[first] << " and " << b[first];
}

/// Set-up, every mechanical phase for `steps` steps, stress, strength; heat steps and the warming that they leave.
struct Outcome {
  std::vector<double> stiffness, displacement, velocity, force, slip, state, joined, cracks, stress, history,
      temperature, warming, sums, searched, path;
};
void write_heat(const Problem& p, Backend& b) {
  std::vector<double> temperature(p.discretisation.heat_points.size());
  for (std::size_t n = 0; n < temperature.size(); ++n) {
    const auto& x = p.discretisation.heat_points[n];
    temperature[n] = 15 + 10 * std::sin(0.05 * x.x) - 0.1 * x.z;
  }
  b.write(Field::temperature, temperature);
  std::vector<double> inverse_capacity =
      p.discretisation.batches.empty() ? std::vector<double>{} : std::vector<double>(temperature.size());
  const std::vector<double> capacity = lumped_capacity(p.model, p.model.mesh.corners, p.model.mesh.node_count());
  for (std::size_t n = 0; n < capacity.size(); ++n)
    inverse_capacity[p.discretisation.heat.new_node[n]] = 1 / capacity[n];
  b.write(Field::inverse_capacity, inverse_capacity);
}
/// Three tenths of the way to the present displacement, then straight on to half of it, then to its end: where that is
/// and how far from the last equilibrium.
std::vector<double> walk(Backend& b) {
  std::vector<double> all;
  const auto look = [&] {
    const std::vector<double> u = b.read(Field::displacement);
    all.insert(all.end(), u.begin(), u.end());
    all.push_back(b.moved_since_equilibrium());
  };
  b.keep_equilibrium(0);
  b.write(Field::displacement_before, std::vector<double>(b.size(Field::displacement_before)));
  b.keep_way_end();
  b.go_part_of_way(0.3);
  look();
  b.keep_equilibrium(0.3);
  b.leave_equilibrium(0.2);
  look();
  b.go_to_way_end();
  look();
  return all;
}
Outcome march(const Problem& p, Backend& b, int steps) {
  Outcome out;
  const MechanicalConditions conditions = mechanical_conditions(p, 0);
  b.write(Field::load, p.to_machine(conditions.load, 3));
  b.write(Field::fixed, p.to_machine(conditions.fixed, 1));
  if (b.size(Field::crack_water) > 0) b.write(Field::crack_water, conditions.crack_water);
  set_virtual_mass(p, b, {});
  out.stiffness = b.read(Field::stiffness);

  write_heat(p, b);
  Controls heat;
  heat.time_step = 3600;
  for (int step = 0; step < steps; ++step) {
    b.run(Phase::heat_flow);
    b.run(Phase::step_heat, heat);
  }
  b.run(Phase::gauss_temperature);
  b.use_warming(true);
  out.temperature = b.read(Field::temperature);
  out.warming = b.read(Field::warming);

  Controls controls;
  controls.local_damping = 0.05;
  controls.viscous_damping = 0.1;
  for (int step = 0; step < steps; ++step) {
    b.run(Phase::block_force);
    b.run(Phase::gather_force);
    b.run(Phase::spring_force);
    if (step == steps / 2) b.run(Phase::advance_history);
    if (step + 2 == steps) b.run(Phase::keep_force);
    if (step + 1 == steps) {
      const RelaxationMeasure m = b.relaxation_sums();
      out.sums = {m.unbalanced, m.load, m.reaction, m.kinetic, m.load_work, m.force_work, m.curvature, m.motion};
    }
    b.run(Phase::move_nodes, controls);
  }
  if (p.contacts.count() > 0) {
    b.loosened_springs();
    out.joined = b.read(Field::joined);
    const double used = b.largest_utilisation();
    const CrackMeasure kept = b.keep_springs(), broken = b.break_springs(used, 0.9);
    b.write(Field::displacement_before, std::vector<double>(3 * p.blocks.node_count()));
    b.keep_way_end();
    out.cracks = {used, b.first_crossing(), double(b.loosened_springs())};
    for (const CrackMeasure& m : {kept, broken})
      out.cracks.insert(out.cracks.end(), {double(m.count), double(m.worst), double(m.mode), m.lost.opening,
                                           m.lost.shear, m.lost.friction});
  }
  b.run(Phase::advance_history);
  b.run(Phase::block_stress);
  out.path = walk(b);
  out.displacement = b.read(Field::displacement);
  out.velocity = b.read(Field::velocity);
  out.force = b.read(Field::force);
  out.slip = b.read(Field::slip);
  out.state = b.read(Field::contact_state);
  out.stress = b.read(Field::stress);
  out.history = b.read(Field::history);

  ElasticStart search(p, b);
  if (search.applies()) search.run({.tolerance = 1e-12}, 0, [](long iteration, double) { return iteration == 20; });
  out.searched = b.read(Field::displacement);
  return out;
}

/// Displacements on a straight way are in proportion.
void expect_straight(const std::vector<double>& path, const std::vector<double>& u, double error) {
  const std::size_t n = u.size() + 1;
  ASSERT_EQ(path.size(), 3 * n);
  double most = 0;
  for (const double c : u) most = std::max(most, std::abs(c));
  for (std::size_t i = 0; i + 1 < n; ++i) {
    EXPECT_NEAR(path[i], 0.3 * u[i], error);
    EXPECT_NEAR(path[n + i], 0.5 * u[i], error);
    EXPECT_EQ(path[2 * n + i], u[i]);
  }
  EXPECT_NEAR(path[n - 1], 0.3 * most, error);
  EXPECT_NEAR(path[2 * n - 1], 0.2 * most, error);
  EXPECT_NEAR(path[3 * n - 1], 0.7 * most, error);
}

void expect_same(const Outcome& a, const Outcome& b) {
  expect_same_bits(a.stiffness, b.stiffness, "stiffness bound");
  expect_same_bits(a.displacement, b.displacement, "displacement");
  expect_same_bits(a.velocity, b.velocity, "velocity");
  expect_same_bits(a.force, b.force, "force");
  expect_same_bits(a.slip, b.slip, "slip");
  expect_same_bits(a.state, b.state, "contact state");
  expect_same_bits(a.joined, b.joined, "joined");
  expect_same_bits(a.cracks, b.cracks, "what cracked");
  expect_same_bits(a.stress, b.stress, "stress");
  expect_same_bits(a.history, b.history, "history");
  expect_same_bits(a.temperature, b.temperature, "temperature");
  expect_same_bits(a.warming, b.warming, "warming");
  expect_same_bits(a.sums, b.sums, "relaxation sums");
  expect_same_bits(a.searched, b.searched, "elastic search");
  expect_same_bits(a.path, b.path, "path of loads");
}

/// A motion in time with every damping, springs cracking and sliding: all that it leaves, one after the other.
std::vector<double> move(const Problem& p, Backend& b, int steps) {
  const MechanicalConditions conditions = mechanical_conditions(p, 0);
  b.write(Field::load, p.to_machine(conditions.load, 3));
  b.write(Field::fixed, p.to_machine(conditions.fixed, 1));
  if (b.size(Field::crack_water) > 0) b.write(Field::crack_water, conditions.crack_water);
  b.run(Phase::stiffness_bound);
  std::vector<double> inverse_mass = b.read(Field::stiffness);
  for (double& m : inverse_mass) m = 1 / (1e-6 * m);  // a stable step of 2e-3 s without springs
  b.write(Field::inverse_mass, inverse_mass);
  b.run(Phase::start_motion);
  Controls controls;
  controls.velocity_step = controls.time_step = controls.step_before = 1e-4;
  controls.local_damping = 0.05;
  controls.mass_damping = 3;
  controls.stiffness_damping = 1e-5;
  MotionMeasure m;
  for (int step = 0; step < steps; ++step) {
    if (step == steps / 2 && b.size(Field::initial_gap) > 0) {  // grouted
      std::vector<double> gap = b.read(Field::initial_gap);
      for (double& g : gap) g *= 0.5;
      b.write(Field::initial_gap, gap);
    }
    b.run(Phase::block_force);
    b.run(Phase::gather_force);
    b.run(Phase::advance_springs, controls);
    b.run(Phase::spring_force);
    b.run(Phase::damping_force, controls);
    if (step + 1 == steps) m = b.motion_sums(controls.time_step);
    b.run(Phase::step_motion, controls);
  }
  std::vector<double> all{m.kinetic, m.potential, m.rest_work, m.supplied, m.damped};
  for (const Field f : {Field::displacement, Field::velocity, Field::force, Field::slip, Field::contact_state,
                        Field::contact_damage, Field::spring_dissipation})
    for (const double value : b.read(f)) all.push_back(value);
  return all;
}

/// A motion in large displacement, contacts searched again on the way.
std::vector<double> tumble(const Problem& p, Backend& b, int steps) {
  const MechanicalConditions conditions = mechanical_conditions(p, 0);
  b.write(Field::load, p.to_machine(conditions.load, 3));
  b.write(Field::fixed, p.to_machine(conditions.fixed, 1));
  b.run(Phase::stiffness_bound);
  std::vector<double> inverse_mass = b.read(Field::stiffness);
  for (double& m : inverse_mass) m = 1 / (1e-6 * m);
  b.write(Field::inverse_mass, inverse_mass);
  b.use_large_displacement();
  b.run(Phase::start_motion);
  const auto search = [&] {
    const std::vector<double> u = b.read(Field::displacement);
    std::vector<Vec3<double>> places = p.discretisation.block_points;
    for (std::size_t n = 0; n < places.size(); ++n)
      for (int i = 0; i < 3; ++i) places[n][i] += u[3 * n + i];
    b.write_candidates(find_candidates(p.surface, places), u);
  };
  search();
  Controls controls;
  controls.velocity_step = controls.time_step = 1e-4;
  controls.contact_damping = 1e-4;
  controls.mass_damping = 3;
  MotionMeasure m;
  std::vector<double> all;
  for (int step = 0; step < steps; ++step) {
    b.run(Phase::block_force);
    b.run(Phase::gather_force);
    b.run(Phase::moving_contacts, controls);
    controls.step_before = controls.time_step;
    m = b.motion_sums(controls.time_step);
    b.run(Phase::step_motion, controls);
    all.push_back(b.moved_far(1e-9 * step, 0));
    if (step % 20 == 19) search();
  }
  b.run(Phase::block_stress);
  all.insert(all.begin(), {m.kinetic, m.potential, m.rubbed, m.supplied, m.damped});
  for (const Field f :
       {Field::displacement, Field::velocity, Field::force, Field::probe_memory, Field::probe_loss, Field::stress})
    for (const double value : b.read(f)) all.push_back(value);
  return all;
}

/// Steps in a row, as machines fuse them: cold, then warm.
std::vector<double> relax(const Problem& p, Backend& b, int steps) {
  const MechanicalConditions conditions = mechanical_conditions(p, 0);
  b.write(Field::load, p.to_machine(conditions.load, 3));
  b.write(Field::fixed, p.to_machine(conditions.fixed, 1));
  if (b.size(Field::crack_water) > 0) b.write(Field::crack_water, conditions.crack_water);
  set_virtual_mass(p, b, {});
  Controls controls;
  controls.local_damping = 0.05;
  controls.viscous_damping = 0.1;
  b.relax(controls, steps);
  std::vector<double> warming(b.size(Field::warming));
  for (std::size_t g = 0; g < warming.size(); ++g) warming[g] = std::sin(0.1 * double(g));
  b.write(Field::warming, warming);
  b.use_warming(true);
  controls.viscous_damping = 0.2;
  b.relax(controls, steps);
  std::vector<double> all = b.read(Field::displacement);
  write_heat(p, b);
  b.write_films({{0, 1}, {0, 2, 4}, {0, 1, 0, 1}, {50, 20, 20, 50}});
  controls.time_step = 3600;
  b.march_heat(controls, steps);
  for (const Field f : {Field::velocity, Field::temperature})
    for (const double value : b.read(f)) all.push_back(value);
  return all;
}

class Parity : public testing::TestWithParam<std::tuple<Precision, Blocks, const char*>> {
 protected:
  static constexpr int steps = 100;
  Parity()
      : model_(dam(std::get<2>(GetParam()), std::get<1>(GetParam()))), problem_(model_, {std::get<0>(GetParam()), 1}) {}
  Outcome on_one_thread() { return march(problem_, *problem_.backend, steps); }
  Model model_;
  Problem problem_;
};

TEST_P(Parity, EveryNumberOfThreadsGivesTheSameBits) {
  const Outcome one = on_one_thread();
  double moved = 0;
  for (const double u : one.displacement) moved = std::max(moved, std::abs(u));
  EXPECT_GT(moved, 1e-6) << "nothing moved: the comparison would be empty";
  expect_straight(one.path, one.displacement, 1e-12 * moved);
  if (!one.history.empty()) {
    int remembered = 0;
    for (const BlockLaw& law : problem_.setup().laws) remembered = std::max(remembered, history_size(law));
    const std::size_t points = one.history.size() / remembered;
    long flowed = 0;
    for (std::size_t i = measure_number * points; i < (measure_number + 1) * points; ++i) flowed += one.history[i] > 0;
    EXPECT_GT(flowed, points / 20) << "hardly anything flowed";
    EXPECT_LT(flowed, points) << "nothing stayed elastic";
  }
  for (const int threads : {2, 3}) {
    const auto backend = make_cpu_backend(problem_.setup(), std::get<0>(GetParam()), threads);
    expect_same(one, march(problem_, *backend, steps));
  }
}

TEST_P(Parity, EveryNumberOfThreadsMovesByTheSameBits) {
  const auto precision = std::get<0>(GetParam());
  const auto one = move(problem_, *make_cpu_backend(problem_.setup(), precision, 1), steps);
  EXPECT_GT(one[0], 0) << "nothing moved: the comparison would be empty";
  EXPECT_TRUE(std::isfinite(one[0]));
  for (const int threads : {2, 3})
    expect_same_bits(one, move(problem_, *make_cpu_backend(problem_.setup(), precision, threads), steps), "motion");
}

TEST_P(Parity, EveryNumberOfThreadsRelaxesByTheSameBits) {
  const auto precision = std::get<0>(GetParam());
  expect_same_bits(relax(problem_, *make_cpu_backend(problem_.setup(), precision, 2), steps),
                   relax(problem_, *make_cpu_backend(problem_.setup(), precision, 1), steps), "relaxation");
}

TEST_P(Parity, AnNvidiaDeviceGivesTheSameBits) {
  if (cuda_support().devices.empty()) GTEST_SKIP() << cuda_support().missing;
  const auto precision = std::get<0>(GetParam());
  const auto cpu_backend = [&] { return make_cpu_backend(problem_.setup(), precision, 0); };
  const auto device_backend = [&] { return make_cuda_backend(problem_.setup(), precision, 0); };
  const Outcome device = march(problem_, *device_backend(), steps);
  const Outcome cpu = on_one_thread();
  expect_same(cpu, device);
  expect_same_bits(move(problem_, *cpu_backend(), steps), move(problem_, *device_backend(), steps), "motion");
  expect_same_bits(relax(problem_, *cpu_backend(), steps), relax(problem_, *device_backend(), steps), "relaxation");
  std::printf("  %s: %zu displacements, %zu stresses, %zu temperatures compared bit by bit after %d steps\n",
              device_backend()->name().c_str(), cpu.displacement.size(), cpu.stress.size(), cpu.temperature.size(),
              steps);
}

TEST(LargeDisplacement, EveryMachineMovesByTheSameBits) {
  Model model = dam("dam_D0_r1_ny2.msh", Blocks::cracked);
  model.interfaces[0].values.merge(std::map<std::string, double>{{"normal_stiffness", 1e9}, {"shear_stiffness", 5e8}});
  model.stages[0].solve = DynamicSolve{.duration = 1, .large_displacement = true};
  const auto precision = Precision::double_precision;
  const Problem problem(model, {precision, 1});
  const auto one = tumble(problem, *problem.backend, 100);
  EXPECT_GT(one[0], 0) << "nothing moved: the comparison would be empty";
  EXPECT_GT(one[2], 0) << "nothing rubbed: the comparison would be empty";
  expect_same_bits(one, tumble(problem, *make_cpu_backend(problem.setup(), precision, 3), 100), "3 threads");
  if (cuda_support().devices.empty()) GTEST_SKIP() << cuda_support().missing;
  expect_same_bits(one, tumble(problem, *make_cuda_backend(problem.setup(), precision, 0), 100), "device");
}

std::string case_name(const testing::TestParamInfo<Parity::ParamType>& info) {
  const auto [precision, blocks, file] = info.param;
  std::string name = precision == Precision::double_precision ? "double" : "single";
  name += blocks == Blocks::continuous   ? "_continuous"
          : blocks == Blocks::mixed      ? "_mixed"
          : blocks == Blocks::tetrahedra ? "_tetrahedra"
          : blocks == Blocks::plastic    ? "_plastic"
          : blocks == Blocks::breaking   ? "_breaking"
          : blocks == Blocks::jointed    ? "_jointed"
          : blocks == Blocks::unmatched  ? "_unmatched"
          : blocks == Blocks::softening  ? "_softening"
          : blocks == Blocks::exploded   ? "_exploded"
                                         : "_sliding";
  name += std::string(file).find("r2") != std::string::npos ? "_r2" : "_r1";
  return name;
}

INSTANTIATE_TEST_SUITE_P(DamD0, Parity,
                         testing::Combine(testing::Values(Precision::double_precision, Precision::single_precision),
                                          testing::Values(Blocks::continuous, Blocks::exploded, Blocks::cracked),
                                          testing::Values("dam_D0_r1_ny2.msh", "dam_D0_r2_ny4.msh")),
                         case_name);

INSTANTIATE_TEST_SUITE_P(OtherD0, Parity,
                         testing::Combine(testing::Values(Precision::double_precision, Precision::single_precision),
                                          testing::Values(Blocks::mixed, Blocks::tetrahedra, Blocks::plastic,
                                                          Blocks::breaking, Blocks::jointed, Blocks::unmatched,
                                                          Blocks::softening),
                                          testing::Values("dam_D0_r1_ny2.msh")),
                         case_name);

}  // namespace
}  // namespace ashlar
