#include <algorithm>
#include <map>

#include "base/nearest_name.hpp"
#include "script/schema.hpp"

namespace ashlar {
namespace {

/// Symbols and words of books and of other programs, in lower case.
const std::map<std::string, std::vector<std::string>>& other_names() {
  static const std::map<std::string, std::vector<std::string>> all = {
      {"e", {"young"}},
      {"modulus", {"young"}},
      {"elastic_modulus", {"young"}},
      {"elasticity", {"young"}},
      {"nu", {"poisson"}},
      {"v", {"poisson"}},
      {"rho", {"density"}},
      {"alpha", {"expansion"}},
      {"cte", {"expansion"}},
      {"k", {"conductivity"}},
      {"lambda", {"conductivity"}},
      {"c", {"cohesion", "heat_capacity"}},
      {"cp", {"heat_capacity"}},
      {"specific_heat", {"heat_capacity"}},
      {"phi", {"friction"}},
      {"psi", {"dilation"}},
      {"dilatancy", {"dilation"}},
      {"ft", {"tensile_strength"}},
      {"tension", {"tensile_strength"}},
      {"tensile", {"tensile_strength"}},
      {"strength", {"tensile_strength", "yield_stress"}},
      {"kn", {"normal_stiffness"}},
      {"ks", {"shear_stiffness"}},
      {"h", {"film"}},
      {"hc", {"film"}},
      {"coefficient", {"film"}},
      {"t", {"ambient", "value"}},
      {"temp", {"ambient", "value"}},
      {"temperature", {"ambient", "value"}},
      {"t_ref", {"reference_temperature"}},
      {"p", {"value"}},
      {"q", {"value"}},
      {"head", {"level"}},
      {"height", {"level"}},
      {"time", {"duration"}},
      {"dt", {"time_step"}},
      {"step", {"time_step"}},
      {"g", {"z"}},
      {"on", {"surface"}},
      {"face", {"surface"}},
      {"faces", {"surface"}},
      {"body", {"region", "of"}},
      {"bodies", {"region", "of"}},
      {"thickness", {"length"}},
      {"width", {"length"}},
      {"points", {"section"}},
      {"outline", {"section"}},
      {"min", {"from"}},
      {"max", {"to"}},
      {"divisions", {"cells"}},
      {"point", {"at"}},
      {"position", {"at"}},
      {"fields", {"record"}},
      {"path", {"file"}},
  };
  return all;
}

/// Whether `part` is one or several whole words of `name`, whose words are joined by underscores.
bool holds_words(const std::string& name, const std::string& part) {
  return ("_" + name + "_").find("_" + part + "_") != std::string::npos;
}

}  // namespace

std::string key_meant(const std::string& name, const std::vector<std::string>& valid) {
  const std::string near = nearest_name(name, valid);
  if (!near.empty()) return near;
  std::string lower = name;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  const auto found = other_names().find(lower);
  if (found != other_names().end())
    for (const std::string& key : found->second)
      if (std::find(valid.begin(), valid.end(), key) != valid.end()) return key;
  constexpr std::size_t shortest = 4;  // of words that say enough
  std::vector<std::string> alike;
  for (const std::string& key : valid)
    if (std::min(key.size(), lower.size()) >= shortest && (holds_words(lower, key) || holds_words(key, lower)))
      alike.push_back(key);
  return alike.size() == 1 ? alike[0] : "";
}

}  // namespace ashlar
