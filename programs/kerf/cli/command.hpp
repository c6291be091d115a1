// The whole program, from the command line to the exit status.
#pragma once

namespace kerf::program {

int run_command(int argc, char** argv);

}  // namespace kerf::program
