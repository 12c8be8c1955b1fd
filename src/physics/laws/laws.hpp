#pragma once
#include <map>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "physics/laws/breakage.hpp"
#include "physics/laws/damage.hpp"
#include "physics/laws/discrete_spring.hpp"
#include "physics/laws/drucker_prager.hpp"
#include "physics/laws/elastic.hpp"
#include "physics/laws/jointed.hpp"
#include "physics/laws/mohr_coulomb.hpp"
#include "physics/laws/von_mises.hpp"

/// The register of block laws. Adding one: its header, its name in this list, its test.
namespace ashlar {

using BlockLaws = std::tuple<Elastic, Breakage, Damage, DiscreteSpring, DruckerPrager, Jointed, MohrCoulomb, VonMises>;

template <class>
struct VariantOf;
template <class... Law>
struct VariantOf<std::tuple<Law...>> {
  using type = std::variant<Law...>;
};
/// The law of one material.
using BlockLaw = VariantOf<BlockLaws>::type;

std::vector<LawDoc> material_law_docs();

/// A law with its members set from the deck's values; keys that are missing take their fallback (the schema has refused
/// missing required keys before).
template <class Law>
Law make_law(const std::map<std::string, double>& values) {
  Law law;
  for (const auto& key : Law::keys) {
    const auto found = values.find(key.name);
    if (found != values.end())
      law.*key.member = found->second;
    else if (key.fallback)
      law.*key.member = *key.fallback;
  }
  return law;
}

/// The law called `name`. Throws std::invalid_argument for a name that is not registered.
BlockLaw make_block_law(const std::string& name, const std::map<std::string, double>& values);

/// What is wrong with the values together.
std::vector<LawComplaint> law_complaints(const std::string& name, const std::map<std::string, double>& values);

/// Numbers that a Gauss point of the law remembers.
int history_size(const BlockLaw& law);
/// What the law called `name` counts.
Measure measure(const std::string& name);
/// Whether it has plastic flow, which keeps its volume, nearly.
inline bool is_plastic(const std::string& name) { return measure(name) == Measure::plastic_strain; }
/// Whether tet4 of the law called `name` share their change of volume unless the deck says otherwise: where strength does
/// not depend on pressure. With friction a uniform triaxial state of them is not stable.
inline bool averages_tet4(const std::string& name) { return name == VonMises::name; }
/// Whether its points remember a crack plane.
bool has_crack_plane(const std::string& name);
/// Of an element across a crack, m: larger ones would snap back. Infinity for laws that do not crack.
double largest_length(const BlockLaw& law);
/// The law with its strength divided by `factor`; an angle by its tangent.
BlockLaw weakened(const BlockLaw& law, double factor);

/// Where histories keep what all laws with memory have, and the normal of a crack plane.
inline constexpr int measure_number = 6, dissipation_number = 7, normal_number = 8;

}  // namespace ashlar
