#pragma once
#include <vector>

#include "physics/laws/laws.hpp"
#include "solve/problem.hpp"

/// What laws with memory remember, as results show it.
namespace ashlar {

/// [elements] what materials count that count `wanted`: equivalent plastic strain or damage, mean over the Gauss points
/// of every mesh element; 0 in others.
std::vector<double> element_measure(const Problem& problem, Measure wanted);

/// [3 * elements] unit normal of the crack plane, of the most damaged Gauss point; 0 where nothing cracked.
std::vector<double> element_crack_normal(const Problem& problem);

/// Energy that the blocks lost so far, J.
struct BlockWork {
  double plastic = 0;   ///< by plastic flow
  double fracture = 0;  ///< by cracking and damage, with friction on their cracks
};
BlockWork block_work(const Problem& problem);

}  // namespace ashlar
