#include <gtest/gtest.h>

#include "io/mesh_file.hpp"
#include "solve/solver.hpp"

/// The public dam D0 with every element its own block, on its shared meshes, against a direct sparse solution of the
/// same springs and elements (cases.md section 6).
namespace ashlar {
namespace {

Material material(const char* name, double density, double expansion, double conductivity, double heat_capacity) {
  Material m;
  m.name = name;
  m.regions = {name};
  m.density = density;
  m.values = {{"young", 20e9}, {"poisson", 0.2}, {"expansion", expansion}};
  m.conductivity = conductivity;
  m.heat_capacity = heat_capacity;
  return m;
}

Condition condition(const char* noun, std::vector<std::string> surfaces, Condition::Kind kind, bool everywhere = true) {
  Condition c;
  c.noun = noun;
  c.surfaces = std::move(surfaces);
  c.kind = std::move(kind);
  c.everywhere = everywhere;
  return c;
}

Model dam(const std::string& mesh) {
  Model model;
  model.mesh = read_mesh(std::string(ASHLAR_TEST_DATA) + "/" + mesh, {});
  model.reference_temperature = 15;
  model.materials = {material("concrete", 2400, 1e-5, 2.7, 960), material("rock", 2650, 0.8e-5, 3.0, 850)};
  Fix all, normal;
  all.x = all.y = all.z = true;
  normal.normal = true;
  model.conditions = {condition("fix", {"bottom"}, all), condition("fix", {"xside", "yside"}, normal),
                      condition("gravity", {}, Gravity{{0, 0, -9.81}}),
                      condition("water_pressure", {"up_wet"}, WaterPressure{.level = 55})};
  return model;
}

using Values = std::map<std::string, double>;

/// Every element its own block: rock never cracks, dam and base as given.
void explode(Model& model, const Values& stiffness, const std::string& law, const Values& strength) {
  Values values = stiffness;
  values.insert(strength.begin(), strength.end());
  model.interfaces = {{"rock", {}, true, {"rock"}, "elastic", stiffness},
                      {"body", {}, true, {"concrete"}, law, values},
                      {"base", {}, false, {"rock", "concrete"}, law, values}};
}

History crest() {
  History h;
  h.name = "crest";
  h.at = Vec3<double>{0, 6, 60};
  h.record = {"displacement"};
  return h;
}

Stage stage(const char* name, decltype(Stage::solve) how, std::vector<int> apply = {}) {
  Stage s;
  s.name = name;
  s.solve = how;
  s.apply = std::move(apply);
  return s;
}

struct ExplodedCase {
  double normal_stiffness, shear_stiffness, crest_x, crest_z;
};
class ExplodedDam : public testing::TestWithParam<ExplodedCase> {};
INSTANTIATE_TEST_SUITE_P(Stiffness, ExplodedDam,
                         testing::Values(ExplodedCase{1e10, 1e10, 2.548732e-3, -5.470499e-3},
                                         ExplodedCase{1e11, 1e11, 2.322793e-3, -4.526152e-3},
                                         ExplodedCase{1e12, 1e12, 2.299855e-3, -4.430543e-3},
                                         ExplodedCase{1e11, 4e10, 2.355786e-3, -4.529769e-3}));

TEST_P(ExplodedDam, crest_moves_as_in_the_direct_solution) {
  Model model = dam("dam_D0_r1_ny2.msh");
  explode(model, {{"normal_stiffness", GetParam().normal_stiffness}, {"shear_stiffness", GetParam().shear_stiffness}},
          "elastic", {});
  model.histories = {crest()};
  model.stages = {stage("gravity", StaticSolve{{.tolerance = 1e-7}})};
  Problem problem(model, {.threads = 1});
  Observer silent;
  const RunResult result = solve(problem, silent);
  ASSERT_TRUE(result.all_converged()) << result.stages[0].stop_reason;
  const double size = std::abs(GetParam().crest_z);
  EXPECT_NEAR(result.histories[0].at("displacement.x", "gravity"), GetParam().crest_x, 2e-4 * size);
  EXPECT_NEAR(result.histories[0].at("displacement.z", "gravity"), GetParam().crest_z, 2e-4 * size);
  RecordProperty("steps", static_cast<int>(result.stages[0].steps));
}

struct StagedCase {
  const char* mesh;
  double onset, x;
};
class StagedDam : public testing::TestWithParam<StagedCase> {};
INSTANTIATE_TEST_SUITE_P(Meshes, StagedDam,
                         testing::Values(StagedCase{"dam_D0_r1_ny1.msh", .5451, 8},
                                         StagedCase{"dam_D0_r2_ny1.msh", .4744, 4}));

TEST_P(StagedDam, first_crack_on_the_way_from_summer_to_winter) {
  Model model = dam(GetParam().mesh);
  explode(model, {{"normal_stiffness", 1e11}, {"shear_stiffness", 1e11}}, "brittle",
          {{"tensile_strength", 1.5e6}, {"cohesion", 1e15}, {"friction", 0.7}});
  const auto season = [&](double air, double water, double ground) {
    std::vector<int> apply;
    for (auto& c :
         {condition("convection", {"up_dry", "down", "crest", "ground_d"}, Convection{{air, {}}, 15, {}, {}}, false),
          condition("fixed_temperature", {"up_wet", "ground_u"}, FixedTemperature{{water, {}}, {}, {}}, false),
          condition("fixed_temperature", {"bottom"}, FixedTemperature{{ground, {}}, {}, {}}, false)}) {
      apply.push_back(static_cast<int>(model.conditions.size()));
      model.conditions.push_back(c);
    }
    return apply;
  };
  const ThermalSolve steady{.steady = true};
  const auto hot = season(28.2, 19.5, 32.4), cold = season(-1.6, 2.8, 10.3);
  FractureSolve fracture;
  fracture.from = "summer";
  fracture.to = "winter";
  fracture.increments = 4;
  fracture.max_events = 1;
  fracture.relaxation.tolerance = 1e-6;
  model.stages = {stage("gravity", StaticSolve{{.tolerance = 1e-6}}), stage("summer", steady, hot),
                  stage("winter", steady, cold), stage("fracture", fracture)};
  Problem problem(model, {.threads = 1});
  Observer silent;
  const RunResult result = solve(problem, silent);
  ASSERT_EQ(result.stages.size(), 4u);
  ASSERT_EQ(result.stages[3].events.size(), 1u) << result.stages[3].stop_reason;
  const CrackEvent& first = result.stages[3].events[0];
  EXPECT_NEAR(first.load_factor, GetParam().onset, 0.01 * GetParam().onset);
  EXPECT_NEAR(first.place.x, GetParam().x, 1e-9);
  EXPECT_NEAR(first.place.z, 0, 1e-9);
  EXPECT_EQ(first.mode, "tension");
  RecordProperty("onset", std::to_string(first.load_factor));

  // A group that is taken wider cracks more in the same event: the contact points next in use of their strength.
  std::get<FractureSolve>(model.stages[3].solve).event_group = 0.7;
  Problem same(model, {.threads = 1});
  const RunResult wider = solve(same, silent);
  ASSERT_EQ(wider.stages[3].events.size(), 1u);
  EXPECT_EQ(wider.stages[3].events[0].load_factor, first.load_factor);
  EXPECT_GT(wider.stages[3].events[0].contact_points, first.contact_points);
}

}  // namespace
}  // namespace ashlar
