#include "model/doubts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/model.hpp"
#include "model/place_text.hpp"
#include "physics/laws/laws.hpp"

namespace ashlar {
namespace {

class Doubts {
 public:
  explicit Doubts(const Model& model) : model_(model) {}

  std::vector<std::string> all() {
    size();
    for (const Material& material : model_.materials) {
      const std::string who = "material '" + material.name + "'";
      quantity(material.where, who, "density", material.density, 100, 30e3, "kg/m^3", "2400*kg/m^3");
      if (material.heat_capacity)
        quantity(material.where, who, "heat_capacity", *material.heat_capacity, 50, 20e3, "J/(kg*K)", "900*J/(kg*K)");
      constants(material.where, who, material.values);
    }
    for (const Interface& i : model_.interfaces)
      constants(i.where, (i.crackable ? "crackable '" : "joint '") + i.name + "'", i.values);
    for (const InitialStress& stress : model_.initial_stresses) initial(stress);
    for (const Stage& stage : model_.stages)
      if (const auto* thermal = std::get_if<ThermalSolve>(&stage.solve); thermal && !thermal->steady)
        transient(stage, thermal->duration);
      else if (const auto* coupled = std::get_if<CoupledSolve>(&stage.solve))
        transient(stage, coupled->duration);
      else if (std::holds_alternative<FractureSolve>(stage.solve))
        fracture(stage);
    temperature(model_.where, "model", "reference_temperature", model_.reference_temperature);
    for (const Condition& condition : model_.conditions) {
      const std::string who = condition.noun + (condition.name.empty() ? "" : " '" + condition.name + "'");
      if (const auto* g = std::get_if<Gravity>(&condition.kind)) gravity(condition.where, who, g->acceleration);
      if (const auto* t = std::get_if<Traction>(&condition.kind)) pull(condition, who, t->z);
      if (const auto* w = std::get_if<WaterPressure>(&condition.kind)) level(condition, who, w->level);
      if (const auto* t = std::get_if<FixedTemperature>(&condition.kind))
        given(condition.where, who, "value", t->value);
      if (const auto* t = std::get_if<Convection>(&condition.kind)) given(condition.where, who, "ambient", t->ambient);
      if (const auto* t = std::get_if<InitialTemperature>(&condition.kind))
        given(condition.where, who, "value", t->value);
    }
    return std::move(lines_);
  }

 private:
  void add(const Where& where, const std::string& text) { lines_.push_back(where.prefix() + text); }

  /// Usual values lie between `low` and `high`; 0 stands for something that is not there.
  void quantity(const Where& where, const std::string& who, const std::string& key, double value, double low,
                double high, const std::string& unit, const std::string& example) {
    if (value == 0 || (std::abs(value) >= low && std::abs(value) <= high)) return;
    add(where, who + ": '" + key + "' is " + number_text(value) + " " + unit + ", unusually " +
                   (std::abs(value) < low ? "small" : "large") + "; bare numbers are " + unit + ", as in " + example);
  }

  void constants(const Where& where, const std::string& who, const std::map<std::string, double>& values) {
    const auto look = [&](const char* key, double low, double high, const char* unit, const char* example) {
      if (const auto found = values.find(key); found != values.end())
        quantity(where, who, key, found->second, low, high, unit, example);
    };
    look("young", 1e5, 2e12, "Pa", "30*GPa");
    look("expansion", 1e-8, 1e-3, "1/K", "1e-5/K");
    look("tensile_strength", 100, 1e10, "Pa", "2*MPa");
    look("cohesion", 100, 1e10, "Pa", "2*MPa");
    look("normal_stiffness", 1e5, 1e16, "Pa/m", "100*GPa/m");
    look("shear_stiffness", 1e5, 1e16, "Pa/m", "100*GPa/m");
  }

  void initial(const InitialStress& stress) {
    const std::string who = stress.name.empty() ? "initial_stress" : "initial_stress '" + stress.name + "'";
    constexpr const char* names[] = {"xx", "yy", "zz", "xy", "yz", "zx"};
    for (int i = 0; i < 6; ++i)
      if (!stress.in_situ && !stress.components[i].at)
        quantity(stress.where, who, names[i], stress.components[i].constant, 1000, 1e10, "Pa", "-5*MPa");
    if (!stress.in_situ && !stress.components[2].at && stress.components[2].constant > 0)
      add(stress.where, who + ": 'zz' is positive, tension; ground that is pressed has negative stress");
    if (stress.in_situ) quantity(stress.where, who, "vertical", stress.in_situ->vertical, 1000, 1e10, "Pa", "-5*MPa");
  }

  /// Heat reaches (conductivity / (density heat_capacity) time)^(1/2) deep: in concrete 1 cm in about two minutes.
  void transient(const Stage& stage, double duration) {
    constexpr double short_time = 1000, large = 1;  // s, m
    if (duration >= short_time || extent() < large) return;
    add(stage.where, "stage '" + stage.name + "': 'duration' is " + number_text(duration) +
                         " s, too short for heat to go deep; bare numbers are s, as in 100*days");
  }

  /// Something should be able to crack.
  void fracture(const Stage& stage) {
    const bool joints = std::any_of(model_.interfaces.begin(), model_.interfaces.end(),
                                    [](const Interface& i) { return i.law != "elastic" && i.law != "frictional"; });
    const bool blocks = std::any_of(model_.materials.begin(), model_.materials.end(),
                                    [](const Material& m) { return measure(m.law) != Measure::none; });
    if (!joints && !blocks)
      add(stage.where, "stage '" + stage.name + "': nothing can crack: no joint or crackable has a strength, and no "
                           "material breaks or flows");
  }

  void given(const Where& where, const std::string& who, const char* key, const Value& value) {
    if (!value.at) temperature(where, who, key, value.constant);
  }
  void temperature(const Where& where, const std::string& who, const char* key, double value) {
    if (value >= 250 && value <= 330)
      add(where, who + ": '" + key + "' is " + number_text(value) + " degC; is it in kelvin? That would be " +
                     number_text(value - 273.15) + "*degC");
  }

  void gravity(const Where& where, const std::string& who, const Vec3<double>& a) {
    if (a[2] > 0) add(where, who + ": points upwards, for z is up; weight is z = -9.81");
    if (a[2] == 0 && std::hypot(a[0], a[1]) > 5)
      add(where, who + ": acts sideways only, for z is up; weight is z = -9.81");
  }

  /// Ground that flows is pressed from above, hardly ever pulled.
  void pull(const Condition& condition, const std::string& who, const Value& z) {
    const bool flows = std::any_of(model_.materials.begin(), model_.materials.end(),
                                   [](const Material& m) { return is_plastic(m.law); });
    if (z.at || z.constant <= 0 || !flows) return;
    Vec3<double> area{};
    for (const std::string& name : condition.surfaces)
      if (const Surface* surface = model_.mesh.find_surface(name))
        for (const Facet& facet : surface->facets) area = area + model_.mesh.facet_area(facet);
    if (area.z > 0.7 * norm(area))
      add(condition.where,
          who + ": pulls a top face upwards, for z is up; what presses has z = -" + number_text(z.constant));
  }

  void level(const Condition& condition, const std::string& who, double level) {
    double lowest = std::numeric_limits<double>::infinity(), top = -lowest;
    for (const std::string& name : condition.surfaces)
      if (const Surface* surface = model_.mesh.find_surface(name))
        for (const Facet& facet : surface->facets) lowest = std::min(lowest, model_.mesh.facet_centroid(facet)[2]);
    for (const auto& point : model_.mesh.points) top = std::max(top, point[2]);
    if (level > top)
      add(condition.where, who + ": the level " + number_text(level) + " m is above the highest point of the model, " +
                               number_text(top) + " m; heights are z, in m");
    if (level <= lowest)
      add(condition.where, who + ": the level " + number_text(level) + " m is below the surface, from about " +
                               number_text(lowest) + " m up; it loads next to nothing");
  }

  /// Of the longest side of the box around the model, m.
  double extent() const {
    double longest = 0;
    for (int i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax_element(model_.mesh.points.begin(), model_.mesh.points.end(),
                                                   [i](const auto& a, const auto& b) { return a[i] < b[i]; });
      if (low != model_.mesh.points.end()) longest = std::max(longest, (*high)[i] - (*low)[i]);
    }
    return longest;
  }

  void size() {
    const double longest = extent();
    if (longest <= 20e3 && longest >= 5e-3) return;
    const Where& where = model_.imports.empty() ? model_.where : model_.imports[0].where;
    add(where, "the model is " + number_text(longest) + " m long; lengths are in m" +
                   (model_.imports.empty() ? ", as in 60*m or 60000*mm"
                                           : ": for a file in mm write unit = 1*mm in import_mesh"));
  }

  const Model& model_;
  std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> doubts(const Model& model) { return Doubts(model).all(); }

}  // namespace ashlar
