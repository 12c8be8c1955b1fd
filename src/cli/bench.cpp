#include <omp.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/wording.hpp"
#include "solve/problem.hpp"
#include "solve/relaxation.hpp"
#include "solve/virtual_mass.hpp"

namespace ashlar {

namespace {

using Json = nlohmann::ordered_json;

/// One line of the benchmark.
struct Work {
  const char* name;
  Shape shape;
  bool crackable, thermal;
};

constexpr double seconds_each = 1.0;  // measured per row, after a warm-up of a tenth

/// A cube of about `elements` elements whose inner nodes are moved by up to a fifth of a cell, so that no element is a
/// brick and nothing can be saved by symmetry.
Model perturbed_cube(const Work& work, int elements) {
  const int per_cell = work.shape == Shape::hex8 ? 1 : work.shape == Shape::wedge6 ? 2 : 6;
  const int n = static_cast<int>(std::lround(std::cbrt(double(elements) / per_cell)));
  Model model;
  Box box;
  box.name = "body";
  box.to = {double(n), double(n), double(n)};
  box.cells = {n, n, n};
  box.shape = work.shape;
  model.boxes = {box};
  build_mesh(model);
  for (auto& p : model.mesh.points) {
    const Vec3<double> q = p;
    for (int i = 0; i < 3; ++i)
      if (q.x > 0 && q.x < n && q.y > 0 && q.y < n && q.z > 0 && q.z < n)
        p[i] += 0.2 * std::sin(12.9898 * q.x + 78.233 * q.y + 37.719 * q.z + 2.1 * i);
  }
  Material material;
  material.name = "concrete";
  material.regions = {"body"};
  material.density = 2400;
  material.conductivity = 2.7;
  material.values = {{"young", 30e9}, {"poisson", 0.2}, {"expansion", 1e-5}};
  model.materials = {material};
  if (work.crackable) {
    Interface faces;
    faces.name = "faces";
    faces.crackable = true;
    faces.regions = {"body"};
    faces.law = "brittle";
    faces.values = {{"tensile_strength", 1e12}, {"cohesion", 2e12}, {"friction", 0.7}};
    model.interfaces = {faces};
  }
  return model;
}

void step(Backend& backend, bool thermal) {
  Controls controls;
  controls.viscous_damping = 0.1;
  controls.time_step = 0.1;
  if (thermal) {
    backend.run(Phase::heat_flow);
    backend.run(Phase::step_heat, controls);
  } else {
    evaluate_force(backend);
    backend.run(Phase::move_nodes, controls);
  }
}

double total_seconds(const Backend& backend) {
  double sum = 0;
  for (int p = 0; p < static_cast<int>(Phase::count); ++p) sum += backend.seconds(static_cast<Phase>(p));
  return sum;
}

Json measure(const Work& work, int elements, int threads) {
  const Model model = perturbed_cube(work, elements);
  Problem problem(model, {Precision::double_precision, threads});
  Backend& backend = *problem.backend;
  std::vector<double> velocity(backend.size(Field::velocity));
  for (std::size_t i = 0; i < velocity.size(); ++i) velocity[i] = 1e-6 * std::sin(0.1 * double(i));
  backend.write(Field::velocity, velocity);
  backend.write(Field::inverse_capacity, std::vector<double>(backend.size(Field::inverse_capacity), 1e-3));
  set_virtual_mass(problem, backend, {});

  const double start = total_seconds(backend);
  while (total_seconds(backend) - start < 0.1 * seconds_each) step(backend, work.thermal);
  std::vector<double> before;
  for (int p = 0; p < static_cast<int>(Phase::count); ++p) before.push_back(backend.seconds(static_cast<Phase>(p)));
  const double warm = total_seconds(backend);
  long steps = 0;
  for (; total_seconds(backend) - warm < seconds_each; ++steps) step(backend, work.thermal);
  const double seconds = total_seconds(backend) - warm;

  Json row;
  row["work"] = work.name;
  row["shape"] = shape_name(work.shape);
  row["elements"] = model.mesh.element_count();
  row["contact_points"] = problem.contacts.count();
  row["precision"] = "double";
  row["device"] = backend.name();
  row["steps"] = steps;
  row["seconds"] = seconds;
  row["element_steps_per_second"] = double(model.mesh.element_count()) * double(steps) / seconds;
  for (int p = 0; p < static_cast<int>(Phase::count); ++p) {
    const double share = (backend.seconds(static_cast<Phase>(p)) - before[p]) / seconds;
    if (share > 0) row["share"][phase_name(static_cast<Phase>(p))] = share;
  }
  return row;
}

std::string line_of(const Json& row) {
  std::string shares;
  for (const auto& [phase, share] : row["share"].items())
    if (share.get<double>() >= 0.005) shares += text(" %s %.0f %%", phase.c_str(), 100 * share.get<double>());
  return text("%-10s %-6s %9s  %-15s %8.2f M/s %s\n", row["work"].get<std::string>().c_str(),
              row["shape"].get<std::string>().c_str(), count_text(row["elements"]).c_str(),
              row["device"].get<std::string>().c_str(), row["element_steps_per_second"].get<double>() * 1e-6,
              shares.c_str());
}

}  // namespace

int bench_command(const Arguments& arguments) {
  const int all = arguments.threads > 0 ? arguments.threads : omp_get_num_procs();
  const Work elastic{"elastic", Shape::hex8, false, false};
  struct Row {
    Work work;
    int elements, threads;
  };
  std::vector<Row> rows = {{elastic, 3000, 1}, {elastic, 30000, 1}, {elastic, 300000, 1}};
  if (all > 1)
    for (const int elements : {3000, 30000, 300000}) rows.push_back({elastic, elements, all});
  rows.push_back({{"elastic", Shape::wedge6, false, false}, 30000, all});
  rows.push_back({{"elastic", Shape::tet4, false, false}, 30000, all});
  rows.push_back({{"crackable", Shape::hex8, true, false}, 30000, all});
  rows.push_back({{"heat", Shape::hex8, false, true}, 30000, all});

  std::printf("%-10s %-6s %9s  %-15s %12s  %s\n", "work", "shape", "elements", "device", "element-steps",
              "share of time by phase");
  Json report;
  report["program"] = "ashlar " ASHLAR_VERSION;
  for (const Row& row : rows) {
    report["rows"].push_back(measure(row.work, row.elements, row.threads));
    std::fputs(line_of(report["rows"].back()).c_str(), stdout);
    std::fflush(stdout);
  }
  const std::string path = arguments.out.empty() ? "bench.json" : arguments.out;
  std::ofstream file(path);
  file << report.dump(2) << '\n';
  if (!file) throw ResourceError("cannot write '" + path + "'");
  std::printf("written   %s\n", path.c_str());
  return 0;
}

}  // namespace ashlar
