#include "programs/kerf/options.hpp"

namespace kerf::program {

std::string_view name_of(Command command) noexcept {
  switch (command) {
    case Command::run:
      return "run";
    case Command::check:
      return "check";
    case Command::explain:
      return "explain";
    case Command::report:
      return "report";
    case Command::view:
      return "view";
    case Command::dry_run:
      break;
  }
  return "dry-run";
}

bool makes_page(Command command) noexcept {
  return command == Command::report || command == Command::view;
}

}  // namespace kerf::program
