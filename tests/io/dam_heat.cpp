#include <gtest/gtest.h>

#include "io/mesh_file.hpp"
#include "solve/thermal.hpp"

/// Heat in the public dam D0 on its shared meshes, against CalculiX and an independent lumped explicit program
/// (tests/data/reference/dam_D0_thermal.json).
namespace ashlar {
namespace {

struct Season {
  double air, water, ground;  // degC, the paper's Table 2
};
constexpr Season summer{28.2, 19.5, 32.4}, winter{-1.6, 2.8, 10.3};

Material material(const char* name, double conductivity, double density, double heat_capacity) {
  Material m;
  m.name = name;
  m.regions = {name};
  m.values = {{"young", 20e9}, {"poisson", 0.2}};
  m.conductivity = conductivity;
  m.density = density;
  m.heat_capacity = heat_capacity;
  return m;
}

class DamHeat {
 public:
  DamHeat(const std::string& mesh, const Season& season, const ThermalSolve& solve) {
    model.mesh = read_mesh(std::string(ASHLAR_TEST_DATA) + "/" + mesh, {});
    model.reference_temperature = 15;
    model.materials = {material("concrete", 2.7, 2400, 960), material("rock", 3.0, 2650, 850)};
    const auto add = [&](const char* noun, std::vector<std::string> surfaces, Condition::Kind kind) {
      Condition c;
      c.noun = noun;
      c.surfaces = std::move(surfaces);
      c.kind = std::move(kind);
      model.conditions.push_back(std::move(c));
    };
    add("convection", {"up_dry", "down", "crest", "ground_d"}, Convection{{season.air, {}}, 15, {}, {}});
    add("fixed_temperature", {"up_wet", "ground_u"}, FixedTemperature{{season.water, {}}, {}, {}});
    add("fixed_temperature", {"bottom"}, FixedTemperature{{season.ground, {}}, {}, {}});
    model.stages.resize(1);
    model.stages[0].solve = solve;
    problem = std::make_unique<Problem>(model, RunOptions{Precision::double_precision, 1});
    write_temperature(*problem, *problem->backend, std::vector<double>(model.mesh.node_count(), model.reference_temperature));
    result = solve_thermal(*problem, 0);
    temperature = read_temperature(*problem);
  }
  double at(double x, double z) const {
    for (int n = 0; n < model.mesh.node_count(); ++n)
      if (norm(model.mesh.points[n] - Vec3<double>{x, 0, z}) < 1e-6) return temperature[n];
    ADD_FAILURE() << "no node at " << x << " " << z;
    return 0;
  }

  Model model;
  std::unique_ptr<Problem> problem;
  ThermalResult result;
  std::vector<double> temperature;
};

/// crest middle, crest edge, downstream face, core, base, toe, neck, far ground, foundation.
constexpr double places[9][2] = {{4, 60}, {8, 60}, {28, 25}, {14, 25}, {24, 0}, {48, 0}, {4, 50}, {108, 0}, {24, -30}};

void expect_temperatures(const DamHeat& dam, const double (&expected)[9], double tolerance) {
  EXPECT_TRUE(dam.result.converged) << dam.result.stop_reason;
  for (int i = 0; i < 9; ++i)
    EXPECT_NEAR(dam.at(places[i][0], places[i][1]), expected[i], tolerance)
        << "x " << places[i][0] << " z " << places[i][1];
}

const ThermalSolve steady{true, 0, 1e-10}, hundred_days{false, 100 * 86400.0, 0};

TEST(DamHeat, steady_summer_and_winter_agree_with_calculix) {
  expect_temperatures({"dam_D0_r1_ny1.msh", summer, steady},
                      {28.0791, 28.19296, 28.15599, 24.52747, 26.05893, 28.19908, 23.68098, 28.2134, 28.64831}, 0.005);
  expect_temperatures({"dam_D0_r2_ny1.msh", summer, steady},
                      {28.12579, 28.19608, 28.15518, 24.54143, 26.08259, 28.19881, 23.69836, 28.21338, 28.6777}, 0.005);
  expect_temperatures({"dam_D0_r1_ny1.msh", winter, steady},
                      {-1.538854, -1.596436, -1.570579, .4422764, 1.646247, -1.518099, .6852004, -1.559834, 5.710119},
                      0.005);
  expect_temperatures({"dam_D0_r2_ny1.msh", winter, steady},
                      {-1.562468, -1.598018, -1.56921, .4544432, 1.652261, -1.50623, .6771585, -1.559797, 5.722897},
                      0.005);
}

TEST(DamHeat, a_hundred_days_agree_with_the_independent_lumped_program_and_with_calculix) {
  const DamHeat hot("dam_D0_r2_ny1.msh", summer, hundred_days), cold("dam_D0_r2_ny1.msh", winter, hundred_days);
  expect_temperatures(hot, {28.038, 28.189, 27.789, 15.234, 15.004, 27.568, 20.589, 27.836, 15.000}, 0.1);
  expect_temperatures(cold, {-1.436, -1.588, -1.083, 14.680, 14.995, -.805, 5.697, -1.142, 15.000}, 0.1);
  // consistent capacity
  expect_temperatures(hot, {28.028, 28.189, 27.781, 15.134, 15.002, 27.498, 20.580, 27.783, 14.999}, 0.3);
  expect_temperatures(cold, {-1.421, -1.588, -1.074, 14.830, 14.998, -.718, 5.636, -1.075, 15.000}, 0.3);
}

}  // namespace
}  // namespace ashlar
