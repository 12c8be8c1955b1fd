#pragma once
#include <array>
#include <optional>

#include "model/mesher/section_graph.hpp"

namespace ashlar {

/// Throws DeckError with every complaint: numbers that are not finite or not positive, too few or repeated points, an
/// outline that crosses or touches itself, holes that do so or are not inside, divisions of sides that do not exist.
void check_outline(const Extrude& extrude, double tolerance);

/// Indices into the section, 0-based, in its order: those given, else the four sharpest corners; nothing if the section
/// is to be meshed free: it has holes, says structured = false, or its angles do not tell four corners.
/// Throws DeckError if it is and yet has corners or divisions; if `corners` are none.
std::optional<std::array<int, 4>> choose_corners(const Extrude& extrude);

/// Throws DeckError if two sections share area over a range of y.
void check_overlaps(const SectionGraph& graph, double tolerance);

}  // namespace ashlar
