#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "backend/machine_memory.hpp"
#include "base/nearest_name.hpp"
#include "cli/commands.hpp"
#include "cli/textbook_hex8.hpp"
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
  const char* law = "elastic";
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
  material.law = work.law;
  material.bbar = false;
  if (material.law != "elastic") {
    // Far from failure, but for the work called yielding: all of it flows.
    const bool yields = std::string(work.name) == "yielding";
    material.values.merge(std::map<std::string, double>{{"cohesion", yields ? 1e-9 : 1e12}, {"friction", yields ? 0 : 0.5},
                                                        {"tensile_strength", 1e11}, {"fracture_energy", 1e20},
                                                        {"dip", 0.5}, {"dip_direction", 0.5}});
  }
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

using Clock = std::chrono::steady_clock;
double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Something that computes.
struct Machine {
  std::string name;
  DeviceChoice device;
  Precision precision = Precision::double_precision;
  int threads = 0;
};
const char* word(Precision p) { return p == Precision::double_precision ? "double" : "single"; }

Controls step_controls() {
  Controls controls;
  controls.viscous_damping = 0.1;
  controls.time_step = 0.1;
  return controls;
}
void steps(Backend& backend, bool thermal, int count) {
  thermal ? backend.march_heat(step_controls(), count) : backend.relax(step_controls(), count);
}

/// Seconds of one step: as many as fit into `seconds_each`, in rows, after a warm-up.
double seconds_per_step(Backend& backend, bool thermal) {
  constexpr int row = 8;
  steps(backend, thermal, row);
  backend.finish();
  const auto start = Clock::now();
  long done = 0;
  while (since(start) < seconds_each) {
    for (int i = 0; i < 4; ++i, done += row) steps(backend, thermal, row);
    backend.finish();
  }
  return since(start) / static_cast<double>(done);
}

/// Share of each phase in a step whose phases run one by one.
Json shares(Backend& backend, bool thermal) {
  using Phases = std::vector<Phase>;
  const Phases phases =
      thermal ? Phases{Phase::heat_flow, Phase::step_heat}
              : Phases{Phase::block_force, Phase::gather_force, Phase::spring_force, Phase::move_nodes};
  std::vector<double> seconds(phases.size());
  double all = 0;
  for (bool warm = false; all < 0.2 * seconds_each; warm = true)
    for (std::size_t i = 0; i < phases.size(); ++i) {
      const auto start = Clock::now();
      backend.run(phases[i], step_controls());
      backend.finish();
      if (!warm) continue;
      seconds[i] += since(start);
      all += since(start);
    }
  Json share;
  for (std::size_t i = 0; i < phases.size(); ++i)
    if (seconds[i] > 0.005 * all) share[phase_name(phases[i])] = seconds[i] / all;
  return share;
}

/// Bytes that a step must move at least: every node and element number read once, what changes written once, nodes on
/// patch boundaries once a patch.
double bytes_per_step(const Problem& problem, bool thermal, Precision precision) {
  const Discretisation& d = problem.discretisation;
  const Topology& t = thermal ? d.heat : d.blocks;
  const double real = precision == Precision::double_precision ? 8 : 4, entries = t.entry_count();
  double on_boundaries = entries;
  for (const int interior : t.patch_interior) on_boundaries -= interior;
  const double width = thermal ? 1 : 3;
  const double staged = real * entries * (3 + width), partial = 2 * real * width * on_boundaries;
  const double node = thermal ? 4 * real + 1 : real * (4 * width + 1) + 1;  // v twice, u, load, 1/m; T, Q, 1/C, flow
  const double springs = problem.contacts.count() * (real * (3 + 1 + 2 + 3 + 3 + 6) + 13);
  return staged + partial + node * t.node_count + 4.0 * d.slot_count + (thermal ? 0 : springs);
}

/// One row: a model on a machine.
Json measure(const Work& work, const Model& model, const Machine& machine) {
  const auto start = Clock::now();
  Problem problem(model, {machine.precision, machine.threads, machine.device});
  Backend& backend = *problem.backend;
  std::vector<double> velocity(backend.size(Field::velocity));
  for (std::size_t i = 0; i < velocity.size(); ++i) velocity[i] = 1e-6 * std::sin(0.1 * double(i));
  backend.write(Field::velocity, velocity);
  backend.write(Field::inverse_capacity, std::vector<double>(backend.size(Field::inverse_capacity), 1e-3));
  set_virtual_mass(problem, backend, {});
  if (!work.thermal) {  // what flows has flowed before
    steps(backend, false, 1);
    backend.run(Phase::advance_history);
  }
  backend.finish();
  const double set_up = since(start);
  const double seconds = seconds_per_step(backend, work.thermal), elements = model.mesh.element_count();
  const double bandwidth = backend.copy_bandwidth(), bytes = bytes_per_step(problem, work.thermal, machine.precision);

  Json row;
  row["work"] = work.name;
  row["shape"] = shape_name(work.shape);
  row["elements"] = model.mesh.element_count();
  row["contact_points"] = problem.contacts.count();
  row["machine"] = machine.name;
  row["device"] = backend.name();
  row["precision"] = word(machine.precision);
  row["element_steps_per_second"] = elements / seconds;
  row["microseconds_per_step"] = 1e6 * seconds;
  row["bytes_per_element_step"] = bytes / elements;
  row["share_of_copy_bandwidth"] = bytes / seconds / bandwidth;
  row["copy_bytes_per_second"] = bandwidth;
  row["memory_bytes_per_element"] = double(MachineMemory::bytes) / elements;
  row["set_up_seconds"] = set_up;
  row["share"] = shares(backend, work.thermal);
  return row;
}

/// The same elastic steps as a textbook would have them, serial (see textbook_hex8.hpp): force, then motion.
Json measure_textbook(const Model& model) {
  const Mesh& mesh = model.mesh;
  const auto& values = model.materials[0].values;
  const double young = values.at("young"), poisson = values.at("poisson");
  const double shear = young / (2 * (1 + poisson)), lambda = young * poisson / ((1 + poisson) * (1 - 2 * poisson));
  std::vector<double> u(3 * mesh.points.size()), v(u.size()), force(u.size());
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = 1e-6 * std::sin(0.1 * double(i));
  const double mass = 100 * young;
  const auto start = Clock::now();
  long done = 0;
  for (; since(start) < seconds_each; ++done) {
    std::fill(force.begin(), force.end(), 0.0);
    for (int e = 0; e < mesh.element_count(); ++e) {
      double x[8][3], moved[8][3], f[8][3];
      const auto corners = mesh.element(e);
      for (int k = 0; k < 8; ++k)
        for (int c = 0; c < 3; ++c) {
          x[k][c] = mesh.points[corners[k]][c];
          moved[k][c] = u[3 * corners[k] + c];
        }
      textbook_hex8_force(x, moved, lambda, shear, f);
      for (int k = 0; k < 8; ++k)
        for (int c = 0; c < 3; ++c) force[3 * corners[k] + c] += f[k][c];
    }
    for (std::size_t i = 0; i < u.size(); ++i) {
      v[i] = 0.9 * v[i] - force[i] / mass;
      u[i] += v[i];
    }
  }
  const double seconds = since(start) / static_cast<double>(done), elements = mesh.element_count();
  Json row;
  row["work"] = "textbook";
  row["shape"] = "hex8";
  row["elements"] = mesh.element_count();
  row["machine"] = "serial";
  row["device"] = "cpu, 1 thread";
  row["precision"] = "double";
  row["element_steps_per_second"] = elements / seconds;
  row["microseconds_per_step"] = 1e6 * seconds;
  return row;
}

/// Ratios to the other rows of the same work, shape and size.
void add_ratios(Json& rows) {
  const auto speed = [](const Json& row) { return row["element_steps_per_second"].get<double>(); };
  for (Json& row : rows)
    for (const Json& other : rows) {
      if (other["shape"] != row["shape"] || other["elements"] != row["elements"]) continue;
      if (other["work"] == "elastic" && other["machine"] == row["machine"] && other["precision"] == row["precision"])
        row["over_elastic"] = speed(row) / speed(other);
      if (other["work"] == "textbook" && row["work"] == "elastic") row["over_textbook"] = speed(row) / speed(other);
      if (other["work"] != row["work"]) continue;
      if (other["machine"] == "serial") row["over_serial"] = speed(row) / speed(other);
      if (other["machine"] == "cores") row["over_all_cores"] = speed(row) / speed(other);
    }
}

std::string ratio_text(const Json& row, const char* key) {
  return row.contains(key) ? text("%8.3g", row[key].get<double>()) : std::string(8, ' ');
}

std::string line_of(const Json& row) {
  std::string shares;
  if (row.contains("share"))
    for (const auto& [phase, share] : row["share"].items())
      if (share.get<double>() >= 0.005) shares += text(" %s %.0f %%", phase.c_str(), 100 * share.get<double>());
  std::string line = text("%-14s %-6s %11s  %-22.22s %-6s %10.2f %10.1f", row["work"].get<std::string>().c_str(),
                          row["shape"].get<std::string>().c_str(), count_text(row["elements"]).c_str(),
                          row["device"].get<std::string>().c_str(), row["precision"].get<std::string>().c_str(),
                          row["element_steps_per_second"].get<double>() * 1e-6,
                          row["microseconds_per_step"].get<double>());
  if (row.contains("share_of_copy_bandwidth"))
    line += text(" %5.0f %4.0f %% %6.0f", row["bytes_per_element_step"].get<double>(),
                 100 * row["share_of_copy_bandwidth"].get<double>(), row["memory_bytes_per_element"].get<double>());
  return line + shares + "\n";
}

}  // namespace

int bench_command(const Arguments& arguments) {
  const int all = arguments.threads > 0 ? arguments.threads : omp_get_num_procs();
  const CudaSupport cuda = cuda_support();
  const DeviceChoice& wanted = arguments.device;
  const bool on_device = wanted.kind == DeviceChoice::cuda || (wanted.kind == DeviceChoice::automatic && !cuda.devices.empty());
  const bool on_cpu = wanted.kind != DeviceChoice::cuda;
  if (!on_cpu && cuda.devices.empty()) throw ResourceError("--device cuda: " + cuda.missing);
  const Machine serial{"serial", {DeviceChoice::cpu}, Precision::double_precision, 1};
  const Machine cores{"cores", {DeviceChoice::cpu}, Precision::double_precision, all};
  const Machine device_double{"device", {DeviceChoice::cuda, wanted.index}, Precision::double_precision, all};
  const Machine device_single{"device", {DeviceChoice::cuda, wanted.index}, Precision::single_precision, all};

  std::vector<Work> works = {{"elastic", Shape::hex8, false, false},  {"elastic", Shape::wedge6, false, false},
                             {"elastic", Shape::tet4, false, false},  {"crackable", Shape::hex8, true, false},
                             {"heat", Shape::hex8, false, true}};
  for (const char* law : {"drucker_prager", "mohr_coulomb", "jointed", "breakage", "damage"})
    works.push_back({law, Shape::hex8, false, false, law});
  works.push_back({"yielding", Shape::hex8, false, false, "drucker_prager"});
  if (!arguments.operands.empty()) {
    std::vector<std::string> names;
    for (const Work& work : works) names.push_back(work.name);
    std::erase_if(works, [&](const Work& work) { return work.name != arguments.operands[0]; });
    if (works.empty())
      throw UsageError("bench has no work '" + arguments.operands[0] + "'" + suggest_name(arguments.operands[0], names));
  }
  std::vector<int> sizes = {30000, 300000};
  if (on_device) sizes = {30000, 300000, 2400000, 20000000};
  std::printf("%-14s %-6s %11s  %-22s %-6s %10s %10s %5s %6s %6s  share of time by phase, run one by one\n", "work", "shape",
              "elements", "device", "number", "M el.st./s", "us a step", "B/el.", "copy", "memory");
  Json report;
  report["program"] = "ashlar " ASHLAR_VERSION;
  report["copy"] = "share of the machine's copy bandwidth; memory: bytes an element";
  const auto add = [&](Json row) {
    std::fputs(line_of(row).c_str(), stdout);
    std::fflush(stdout);
    report["rows"].push_back(std::move(row));
  };
  for (const int size : sizes)
    for (const Work& work : works) {
      if (arguments.elements > 0 ? size != sizes[0] : size == sizes.back() && size > 300000 && work.shape != Shape::hex8) continue;
      if ((work.crackable || std::string(work.law) != "elastic") && size > 2400000) continue;
      const Model model = perturbed_cube(work, arguments.elements > 0 ? arguments.elements : size);
      const bool small = model.mesh.element_count() < 400000;
      if (on_cpu && small && work.shape == Shape::hex8 && std::string(work.name) == "elastic") add(measure_textbook(model));
      if (on_cpu && small) add(measure(work, model, serial));
      if (on_cpu && all > 1) add(measure(work, model, cores));
      if (on_device) add(measure(work, model, device_double));
      if (on_device) add(measure(work, model, device_single));
    }
  add_ratios(report["rows"]);
  std::printf("\n%-14s %-6s %11s  %-22s %-6s %10s %10s %10s %10s\n", "work", "shape", "elements", "device", "number",
              "x textbook", "x serial", "x all cores", "x elastic");
  for (const Json& row : report["rows"])
    if (row["machine"] != "serial")
      std::printf("%-14s %-6s %11s  %-22.22s %-6s   %s   %s   %s   %s\n", row["work"].get<std::string>().c_str(),
                  row["shape"].get<std::string>().c_str(), count_text(row["elements"]).c_str(),
                  row["device"].get<std::string>().c_str(), row["precision"].get<std::string>().c_str(),
                  ratio_text(row, "over_textbook").c_str(), ratio_text(row, "over_serial").c_str(),
                  ratio_text(row, "over_all_cores").c_str(), ratio_text(row, "over_elastic").c_str());
  const std::string path = arguments.out.empty() ? "bench.json" : arguments.out;
  std::ofstream file(path);
  file << report.dump(2) << '\n';
  if (!file) throw ResourceError("cannot write '" + path + "'");
  std::printf("written   %s\n", path.c_str());
  return 0;
}

}  // namespace ashlar
