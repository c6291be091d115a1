#include "programs/kerf/io/machine_lock.hpp"

#include <cerrno>
#include <sys/file.h>

namespace kerf::program {

tl::expected<Descriptor, std::string> lock_machine(const std::string& machine_file) {
  auto file = open_regular(machine_file);
  if (!file) {
    return tl::unexpected(machine_file + ": " + file.error());
  }
  if (::flock(file->number(), LOCK_EX | LOCK_NB) != 0) {
    return tl::unexpected(machine_file + ": " +
                          (errno == EWOULDBLOCK ? "another kerf run has this machine"
                                                : "cannot be locked: " + error_text(errno)));
  }
  return file;
}

}  // namespace kerf::program
