// The exit status of `kerf`.
#pragma once

#include <exception>

namespace kerf::program {

enum class ExitStatus : int {
  done = 0,
  program_error = 1,   // the part program has errors; nothing moved
  wrong_use = 2,       // of the command line
  settings_error = 3,  // the machine file has errors
  machine_fault = 4,   // a soft limit, before motion or in it, or another fault of the machine
  io_error = 5,        // a file cannot be read or written, or the system gives no memory, no thread
  internal_error = 6,  // a defect of kerf
  stopped = 7,         // on the path: by key, control channel or door, or no start was confirmed
  emergency_stop = 8,  // of an operator or of the machine
  hung_up = 129,       // SIGHUP, SIGINT, SIGTERM: 128 + signal number, after a stop on the path
  interrupted = 130,   // SIGQUIT, too
  terminated = 143,
};

constexpr int to_int(ExitStatus status) noexcept {
  return static_cast<int>(status);
}

// The status for an exception that ends the program.
ExitStatus status_of(const std::exception& exception) noexcept;

}  // namespace kerf::program
