#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "model/model.hpp"

/// Which conditions act in a stage, and where.
namespace ashlar {

/// Whether the condition is one of the boundary of heat, or a source of it: what mechanical stages do not feel.
bool gives_heat(const Condition& condition);

/// One condition with the surfaces on which it still holds.
struct ActingCondition {
  const Condition* condition = nullptr;
  std::vector<const Surface*> surfaces;  ///< in the deck's order; empty for nouns without surfaces
  std::vector<int> regions{};            ///< where a heat source acts, ascending; empty for other nouns
  std::shared_ptr<const Condition> held{};  ///< what `condition` points to where its numbers are those of a moment
};

/// Conditions that act in stage `stage` (0-based), oldest first. Those declared outside `apply` are older than the
/// first stage. A condition of the same noun on the same surface given by a later stage replaces the earlier one there
/// (point loads: at the same place; heat sources: in the same region; other nouns without surfaces: altogether);
/// conditions given together add up. `remove` acts before `apply` of the same stage. Throws DeckError for a surface or
/// region that does not exist.
std::vector<ActingCondition> acting_conditions(const Model& model, int stage);
/// Whether a condition of stage `stage` (0-based) acts in no stage before it.
bool first_acts(const Model& model, int stage, const Condition& condition);
/// Conditions with their numbers in time as `choose` says.
std::vector<ActingCondition> at_moment(std::vector<ActingCondition> acting,
                                       const std::function<double(const InTime&)>& choose);
/// Those of a stage, likewise.
std::vector<ActingCondition> acting_conditions(const Model& model, int stage,
                                               const std::function<double(const InTime&)>& choose);
/// The same at `time`, s since the start of the run.
std::vector<ActingCondition> acting_conditions(const Model& model, int stage, double time);

/// Whether a held or moved node at `p` is meant: all of a surface, or those on the condition's line within a millionth
/// of its length.
bool holds_at(const Condition& condition, const Vec3<double>& p);

/// Material of every mesh region. Throws DeckError naming regions without one.
std::vector<const Material*> materials_by_region(const Model& model);

}  // namespace ashlar
