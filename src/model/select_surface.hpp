#pragma once
#include <span>
#include <vector>

#include "model/contact/facing.hpp"
#include "model/model.hpp"

namespace ashlar {

/// The sides that `side` knows: left (-x), right (+x), front (-y), back (+y), bottom (-z), top (+z).
inline const std::vector<std::string> side_names{"left", "right", "front", "back", "bottom", "top"};

/// Facets of one choice, in the order of `outer` or of the groups. Every filter given must hold:
/// - `of`: the facet's element is in one of these regions. Without `group` only outer faces of the model are looked at,
///   or with `joint` the faces of that joint, those of both regions, and `covered` ones that were meshed apart.
/// - `side`: within 30 degrees of the side's direction, and nothing of the chosen regions in front of it: seen from
/// that
///   side, the facet's centroid is not hidden (a gallery's wall is no side; a stepped or battered face is one whole).
/// - `facing`: the angle between normal and direction is at most `within`.
/// - `box`: centroid inside; `plane`: all corners on it within a millionth of the model's size.
/// Throws DeckError: unknown region, side, group or joint; a choice that selects nothing, with what came nearest.
std::vector<Facet> select_surface(const Mesh& mesh, const FaceGraph& faces, const SurfaceChoice& choice,
                                  std::span<const Interface> interfaces, std::span<const CoveredFace> covered = {});

/// The sides that one region has, as surfaces "dam.left", "dam.top", ...; in the order of side_names.
std::vector<Surface> region_sides(const Mesh& mesh, const FaceGraph& faces, int region);

}  // namespace ashlar
