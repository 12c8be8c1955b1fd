#pragma once

namespace ashlar {

/// From now on Ctrl-C (and SIGTERM) asks for a stop; a second one ends the process at once with code 130.
void catch_interrupts();

/// Whether a stop was asked for.
bool interrupt_requested();

}  // namespace ashlar
