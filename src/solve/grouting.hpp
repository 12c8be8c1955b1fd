#pragma once
#include "solve/problem.hpp"

namespace ashlar {

/// Fills what is open of joints whose grouting first acts in stage `stage` (0-based): their present gap is closed from
/// now on, without traction, and what has slid stays where it is.
void fill_with_grout(Problem& problem, int stage);

/// Sends Problem::contacts' openings to the machine.
void write_openings(Problem& problem);

}  // namespace ashlar
