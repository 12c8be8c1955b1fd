#pragma once
#include <array>

#include "model/mesher/section_graph.hpp"

namespace ashlar {

/// Throws DeckError with every complaint: numbers that are not finite or not positive, too few or repeated points, an
/// outline that crosses or touches itself, divisions of sides that do not exist.
void check_outline(const Extrude& extrude, double tolerance);

/// Indices into the section, 0-based, in its order: those given, else the four sharpest corners.
/// Throws DeckError where four corners cannot be told: the section is no logical quad.
std::array<int, 4> choose_corners(const Extrude& extrude);

/// Throws DeckError if two sections share area over a range of y.
void check_overlaps(const SectionGraph& graph, double tolerance);

}  // namespace ashlar
