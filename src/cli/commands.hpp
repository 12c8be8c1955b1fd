#pragma once
#include "cli/arguments.hpp"

/// The verbs of the program. Each returns an exit code, or throws DeckError, UsageError, ResourceError.
namespace ashlar {

int new_command(const Arguments& arguments);
int run_command(const Arguments& arguments);
int resume_command(const Arguments& arguments);
int check_command(const Arguments& arguments);
int export_command(const Arguments& arguments);
int info_command(const Arguments& arguments);
int help_command(const Arguments& arguments);
int version_command(const Arguments& arguments);
int material_command(const Arguments& arguments);
int plot_command(const Arguments& arguments);
int compare_command(const Arguments& arguments);
int bench_command(const Arguments& arguments);

}  // namespace ashlar
