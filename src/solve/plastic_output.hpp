#pragma once
#include <vector>

#include "solve/problem.hpp"

/// What plastic laws remember, as results show it.
namespace ashlar {

/// Equivalent plastic strain, mean over the Gauss points of every mesh element; 0 where the law has none.
std::vector<double> element_plastic_strain(const Problem& problem);

/// Work of plastic flow so far, J.
double plastic_work(const Problem& problem);

}  // namespace ashlar
