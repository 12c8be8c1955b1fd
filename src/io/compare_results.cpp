#include "io/compare_results.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <optional>

#include "base/error.hpp"
#include "base/nearest_name.hpp"
#include "model/locate.hpp"

namespace ashlar {

namespace {

constexpr double same_place = 1e-9;  // of the size of the model
constexpr int line_samples = 11;

[[noreturn]] void differ(const ResultReader& a, const ResultReader& b, const std::string& how) {
  throw DeckError({}, "the meshes differ, so that values cannot be compared node by node: " + how + " (" + a.path() +
                          ", " + b.path() + ")");
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

void check_meshes(const ResultReader& a, const ResultReader& b) {
  const Grid &ga = a.grid(), &gb = b.grid();
  const auto counts = [&](const char* what, std::size_t na, std::size_t nb) {
    if (na != nb) differ(a, b, std::to_string(na) + " and " + std::to_string(nb) + " " + what);
  };
  counts("elements", ga.cell_count(), gb.cell_count());
  counts("nodes of blocks", ga.point_count(), gb.point_count());
  double size = 0;
  for (const double x : gb.points) size = std::max(size, std::abs(x));
  for (std::size_t i = 0; i < ga.points.size(); ++i)
    if (!(std::abs(ga.points[i] - gb.points[i]) <= same_place * size))
      differ(a, b, "node " + std::to_string(i / 3) + " has " + "xyz"[i % 3] + " = " + number(ga.points[i]) + " and " +
                       number(gb.points[i]) + " m");
  for (std::size_t c = 0; c < ga.cell_count(); ++c)
    if (ga.types[c] != gb.types[c] ||
        !std::equal(ga.connectivity.begin() + ga.offsets[c], ga.connectivity.begin() + ga.offsets[c + 1],
                    gb.connectivity.begin() + gb.offsets[c], gb.connectivity.begin() + gb.offsets[c + 1]))
      differ(a, b, "element " + std::to_string(c) + " has other corners");
}

/// Size of one entry, `apart`: of the difference. Two values that are not numbers are the same.
double magnitude(const double* a, const double* b, int components) {
  double sum = 0;
  for (int k = 0; k < components; ++k) {
    const double d = b == nullptr ? a[k] : std::isnan(a[k]) && std::isnan(b[k]) ? 0 : a[k] - b[k];
    sum += d * d;
  }
  return std::isnan(sum) ? std::numeric_limits<double>::infinity() : std::sqrt(sum);
}

double share(double difference, double scale) {
  if (difference == 0) return 0;
  return scale > 0 ? difference / scale : std::numeric_limits<double>::infinity();
}

Vec3<double> place_of(const Grid& grid, bool point, std::size_t index) {
  const auto at = [&](std::size_t n) { return Vec3<double>{grid.points[3 * n], grid.points[3 * n + 1], grid.points[3 * n + 2]}; };
  if (point) return at(index);
  Vec3<double> sum;
  for (auto i = grid.offsets[index]; i < grid.offsets[index + 1]; ++i) sum = sum + at(grid.connectivity[i]);
  return (1.0 / double(grid.offsets[index + 1] - grid.offsets[index])) * sum;
}

/// Steps of `a` and `b` that belong together: same stage, same time.
std::vector<std::pair<std::size_t, std::size_t>> pairs(const ResultReader& a, const ResultReader& b,
                                                       std::vector<std::string>& missing) {
  const auto find = [](const ResultReader& in, const GridStep& step) {
    const auto& all = in.steps();
    return std::find_if(all.begin(), all.end(),
                        [&](const GridStep& s) { return s.stage == step.stage && s.time == step.time; }) -
           all.begin();
  };
  const auto lacks = [&](const ResultReader& in, const GridStep& step) {
    if (std::size_t(find(in, step)) == in.steps().size())
      missing.push_back(in.path() + ": no output of stage " + step.stage + " at time " + number(step.time));
  };
  for (const GridStep& step : b.steps()) lacks(a, step);
  for (const GridStep& step : a.steps()) lacks(b, step);
  std::vector<std::pair<std::size_t, std::size_t>> both;
  for (std::size_t s = 0; s < a.steps().size(); ++s)
    if (const std::size_t t = find(b, a.steps()[s]); t < b.steps().size()) both.emplace_back(s, t);
  return both;
}

std::optional<ResultField> field_of(const ResultReader& reader, const ResultField& like) {
  for (const ResultField& f : reader.fields())
    if (f.name == like.name && f.components == like.components && f.on_points == like.on_points) return f;
  return {};
}

Mesh mesh_of(const Grid& grid) {
  Mesh mesh;
  for (std::size_t n = 0; n < grid.point_count(); ++n) mesh.points.push_back(place_of(grid, true, n));
  for (std::size_t c = 0; c < grid.cell_count(); ++c) {
    const std::vector<int> corners(grid.connectivity.begin() + grid.offsets[c],
                                   grid.connectivity.begin() + grid.offsets[c + 1]);
    const auto type = grid.types[c];
    mesh.add_element(type == vtk_cell_type(Shape::hex8)     ? Shape::hex8
                     : type == vtk_cell_type(Shape::wedge6) ? Shape::wedge6
                                                            : Shape::tet4,
                     corners, 0, static_cast<long>(c));
  }
  return mesh;
}

/// The last output of the stage.
std::size_t step_of(const ResultReader& reader, const std::string& stage) {
  std::vector<std::string> names;
  for (std::size_t s = reader.steps().size(); s-- > 0;) {
    if (reader.steps()[s].stage == stage) return s;
    names.push_back(reader.steps()[s].stage);
  }
  throw DeckError({}, reader.path() + ": no output of stage '" + stage + "'" + suggest_name(stage, names));
}

}  // namespace

double Comparison::largest_relative() const {
  double largest = 0;
  for (const StageDifference& s : stages)
    for (const FieldDifference& f : s.fields) largest = std::max(largest, f.largest_relative);
  return largest;
}

Comparison compare_results(ResultReader& a, ResultReader& b) {
  check_meshes(a, b);
  Comparison comparison;
  const auto both = pairs(a, b, comparison.missing);
  for (const ResultField& f : b.fields())
    if (!a.steps().empty() && !field_of(a, f)) comparison.missing.push_back(a.path() + ": no field " + f.name);
  for (const ResultField& f : a.fields()) {
    if (!field_of(b, f)) {
      if (!b.steps().empty()) comparison.missing.push_back(b.path() + ": no field " + f.name);
      continue;
    }
    double scale = 0;
    std::map<std::size_t, FieldDifference> of_stage;  // by place in comparison.stages
    std::map<std::size_t, std::pair<double, std::size_t>> sums;
    for (std::size_t t = 0; t < b.steps().size(); ++t) {
      const std::vector<double> values = b.values(t, f);
      for (std::size_t i = 0; i < values.size(); i += f.components)
        if (const double m = magnitude(&values[i], nullptr, f.components); std::isfinite(m)) scale = std::max(scale, m);
    }
    for (const auto& [s, t] : both) {
      const std::string& stage = a.steps()[s].stage;
      auto at = std::find_if(comparison.stages.begin(), comparison.stages.end(),
                             [&](const StageDifference& d) { return d.stage == stage; });
      if (at == comparison.stages.end()) at = comparison.stages.insert(at, {stage, {}});
      const std::size_t number = at - comparison.stages.begin();
      FieldDifference& d =
          of_stage.try_emplace(number, FieldDifference{f.name, f.unit, -1, 0, 0, f.on_points, 0, {}}).first->second;
      const std::vector<double> va = a.values(s, f), vb = b.values(t, f);
      for (std::size_t i = 0; i < va.size(); i += f.components) {
        const double apart = magnitude(&va[i], &vb[i], f.components);
        sums[number].first += apart;
        ++sums[number].second;
        if (apart > d.largest) d.largest = apart, d.index = i / f.components;
      }
    }
    for (auto& [number, d] : of_stage) {
      d.largest = std::max(d.largest, 0.0);
      d.largest_relative = share(d.largest, scale);
      if (sums[number].second > 0) d.mean_relative = share(sums[number].first / double(sums[number].second), scale);
      d.place = place_of(b.grid(), f.on_points, d.index);
      comparison.stages[number].fields.push_back(d);
    }
  }
  return comparison;
}

std::vector<LineComparison> compare_along(ResultReader& a, ResultReader& b, const std::string& stage,
                                          const Vec3<double>& from, const Vec3<double>& to, const std::string& of) {
  check_meshes(a, b);
  const std::size_t s = step_of(a, stage), t = step_of(b, stage);
  const Mesh mesh = mesh_of(b.grid());
  std::vector<LineSample> points(line_samples);
  std::vector<Location> where(line_samples);
  bool any = false;
  for (int i = 0; i < line_samples; ++i) {
    const double share = double(i) / (line_samples - 1);
    points[i].place = from + share * (to - from);
    points[i].along = share * norm(to - from);
    if (const auto found = locate(mesh, points[i].place)) {
      where[i] = *found;
      any = points[i].inside = true;
    }
  }
  if (!any) {
    const Vec3<double> near = mesh.points[nearest_node(mesh, from)];
    throw DeckError({}, "no point of the line lies in the body; the node nearest to its start is at (" +
                            number(near.x) + ", " + number(near.y) + ", " + number(near.z) + ")");
  }
  std::vector<LineComparison> tables;
  std::vector<std::string> names;
  for (const ResultField& f : b.fields()) {
    names.push_back(f.name);
    if (!field_of(a, f)) continue;
    const std::vector<double> va = a.values(s, f), vb = b.values(t, f);
    for (int k = 0; k < f.components; ++k) {
      const std::string label = k < int(f.labels.size()) ? f.labels[k] : std::to_string(k);
      const std::string name = f.name + (f.components > 1 ? "." + label : "");
      names.push_back(name);
      if (!of.empty() && of != f.name && of != name) continue;
      LineComparison table{name, f.unit, points};
      double scale = 0;
      for (int i = 0; i < line_samples; ++i) {
        LineSample& sample = table.samples[i];
        if (!sample.inside) continue;
        const auto at = [&](const std::vector<double>& v) {
          if (!f.on_points) return v[std::size_t(f.components) * where[i].element + k];
          double value = 0;
          const auto corners = mesh.element(where[i].element);
          for (std::size_t c = 0; c < corners.size(); ++c)
            value += where[i].weights[c] * v[std::size_t(f.components) * corners[c] + k];
          return value;
        };
        sample.a = at(va);
        sample.b = at(vb);
        scale = std::max(scale, std::abs(sample.b));
      }
      for (LineSample& sample : table.samples) sample.relative = share(magnitude(&sample.a, &sample.b, 1), scale);
      tables.push_back(std::move(table));
    }
  }
  if (tables.empty()) throw DeckError({}, "no field is called '" + of + "'" + suggest_name(of, names));
  return tables;
}

}  // namespace ashlar
