#pragma once
/// The single commands. Private to this module.

#include "solver/app/arguments.hpp"
#include "solver/app/program.hpp"

namespace sunder::app {

int run_command(const Arguments& arguments, const Console& console, const Solver& solver);
int check_command(const Arguments& arguments, const Console& console, const Solver& solver);
int ablate_command(const Arguments& arguments, const Console& console, const Solver& solver);
int keys_command(const Arguments& arguments, const Console& console);

}  // namespace sunder::app
