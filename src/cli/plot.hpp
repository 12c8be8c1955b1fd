#pragma once
#include <string>
#include <vector>

namespace ashlar {

/// Runs the plotting program (tools/plot.py, Debian's Python) with these arguments and returns its exit code.
/// The script is looked for in ../share/ashlar beside this program, then in the sources.
/// Throws ResourceError if the script or its interpreter is missing.
int plot(const std::vector<std::string>& arguments);

}  // namespace ashlar
