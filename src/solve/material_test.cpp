#include "solve/material_test.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace ashlar {

namespace {

constexpr int steps = 400;
constexpr double largest_strain = 0.2, elastic_strain = 1e-3;

/// Memory of laws that have none.
struct NoHistory {
  double operator[](int) const { return 0; }
};
template <class Law>
auto history_of(const Law&) {
  if constexpr (Law::history_size == 0)
    return NoHistory{};
  else
    return typename Law::template History<double>{};
}

/// A point of one law, moved by strain; lateral stress may be kept.
template <class Law>
class Specimen {
 public:
  Specimen(const Law& law, double size) : law_(law), size_(size), history_(history_of(law)) {}

  void go_to(const Sym3<double>& strain) {
    strain_ = strain;
    stress_ = answer(strain, history_);
  }
  /// Axial strain given, lateral strains so that lateral stress is `lateral`.
  void stretch_to(double axial, double lateral) {
    const auto off = [&](double side) {
      auto history = history_;
      return answer({side, side, axial, 0, 0, 0}, history).xx - lateral;
    };
    const double stiffness = 2 * (law_.elastic().lambda + law_.elastic().shear);
    double low = strain_.xx, high = low, reach = 1e-9 + std::abs(off(low)) / stiffness;
    while (off(low) > 0 && reach < 1) low -= reach, reach *= 2;
    while (off(high) < 0 && reach < 1) high += reach, reach *= 2;
    for (int i = 0; i < 100 && high - low > 1e-15; ++i) {
      const double middle = (low + high) / 2;
      (off(middle) < 0 ? low : high) = middle;
    }
    const double side = (low + high) / 2;
    go_to({side, side, axial, 0, 0, 0});
  }

  MaterialState state(bool shear, double from) const {
    return {shear ? strain_.zx : strain_.zz - from, shear ? stress_.zx : stress_.zz, stress_.xx,
            strain_.xx + strain_.yy + strain_.zz - (shear ? 0 : from_volume_), history_[measure_number]};
  }
  double axial() const { return strain_.zz; }
  void count_volume_from_here() { from_volume_ = strain_.xx + strain_.yy + strain_.zz; }
  /// All-round strain that brings all-round stress `pressure` in the elastic range.
  double all_round(double pressure) const { return pressure / (3 * law_.elastic().lambda + 2 * law_.elastic().shear); }

 private:
  template <class History>
  Sym3<double> answer(const Sym3<double>& strain, History& history) const {
    if constexpr (Law::history_size == 0)
      return law_.stress(strain);
    else if constexpr (Law::sized)
      return law_.stress(strain, history, [this](int, const Vec3<double>&) { return size_; });
    else
      return law_.stress(strain, history);
  }
  Law law_;
  double size_;
  decltype(history_of(std::declval<Law>())) history_;
  Sym3<double> strain_, stress_;
  double from_volume_ = 0;
};

enum class Path { axial, oedometer, shear, cycle };

template <class Law>
MaterialCurve run(const Law& law, const std::string& name, Path path, double pressure, double reach,
                  double size) {
  MaterialCurve curve{name, {}};
  Specimen<Law> specimen(law, size);
  const double side = specimen.all_round(-pressure);
  specimen.go_to({side, side, side, 0, 0, 0});
  specimen.count_volume_from_here();
  curve.states.push_back(specimen.state(path == Path::shear, side));
  const int legs = path == Path::cycle ? 4 : 1;
  for (int i = 1; i <= legs * steps; ++i) {
    double e = reach * i / steps;
    if (path == Path::cycle) e = i <= steps ? e : i <= 3 * steps ? 2 * reach - e : e - 4 * reach;
    if (path == Path::shear)
      specimen.go_to({0, 0, 0, 0, 0, e});
    else if (path == Path::oedometer)
      specimen.go_to({0, 0, e, 0, 0, 0});
    else
      specimen.stretch_to(side + e, -pressure);
    curve.states.push_back(specimen.state(path == Path::shear, side));
  }
  return curve;
}

/// As far as `strain`, or until flow has gone on for three quarters of the way.
template <class Law>
MaterialCurve run_far(const Law& law, const std::string& name, Path path, double pressure, double sign, double strain,
                      double size) {
  if (strain > 0) return run(law, name, path, pressure, sign * strain, size);
  if (Law::history_size == 0) return run(law, name, path, pressure, sign * elastic_strain, size);
  for (double reach = 1e-5;; reach *= 2) {
    MaterialCurve curve = run(law, name, path, pressure, sign * reach, size);
    const auto flows = [&](const MaterialState& s) { return s.plastic_strain > curve.states[0].plastic_strain; };
    const auto first = std::find_if(curve.states.begin(), curve.states.end(), flows);
    if (first - curve.states.begin() <= steps / 4 || reach >= largest_strain) return curve;
  }
}

}  // namespace

std::vector<MaterialCurve> test_material(const BlockLaw& law, const std::vector<double>& confining, double strain,
                                         double size) {
  return std::visit(
      [&](const auto& l) {
        const auto point = l.template prepare<double>();
        std::vector<MaterialCurve> curves;
        curves.push_back(run_far(point, "uniaxial compression", Path::axial, 0, -1, strain, size));
        for (const double pressure : confining) {
          char name[80];
          std::snprintf(name, sizeof name, "triaxial compression at %.6g MPa", pressure / 1e6);
          curves.push_back(run_far(point, name, Path::axial, pressure, -1, strain, size));
        }
        curves.push_back(run_far(point, "uniaxial tension", Path::axial, 0, 1, strain, size));
        curves.push_back(run_far(point, "oedometer", Path::oedometer, 0, -1, strain, size));
        curves.push_back(run_far(point, "simple shear", Path::shear, 0, 1, strain, size));
        curves.push_back(run_far(point, "cycle", Path::cycle, 0, -1, strain, size));
        return curves;
      },
      law);
}

}  // namespace ashlar
