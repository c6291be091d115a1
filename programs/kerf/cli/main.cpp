// kerf: reads part programs and runs them on a simulated three-axis table.
#include "programs/kerf/cli/command.hpp"

int main(int argc, char** argv) {
  return kerf::program::run_command(argc, argv);
}
