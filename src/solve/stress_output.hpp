#pragma once
#include <span>
#include <vector>

#include "solve/problem.hpp"

/// Stress as results show it, from the Gauss points (numerics 2).
namespace ashlar {

/// Stress at the Gauss points at the present displacement, initial stress included, Pa: [6 * Gauss points].
std::vector<double> gauss_stress(const Problem& problem);

/// Mean over the Gauss points of every mesh element, Pa: [6 * elements] xx yy zz xy yz zx.
/// @param gauss [6 * Gauss points], the machine's order
std::vector<double> element_stress(const Problem& problem, std::span<const double> gauss);

/// Extrapolated from the Gauss points to the corners and averaged by element volume, Pa: [6 * block nodes]; of elastic
/// laws without what incompatible modes would relax. A node shared by regions shows the region that comes first in the
/// mesh; nothing is averaged across regions or interfaces.
/// @param gauss from gauss_stress
std::vector<double> nodal_stress(const Problem& problem, std::span<const double> gauss);

/// Principal values, largest first: [3 * n] from [6 * n].
std::vector<double> principal_stress(std::span<const double> stress);

}  // namespace ashlar
