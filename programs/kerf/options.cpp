#include "programs/kerf/options.hpp"

namespace kerf::program {

std::string_view name_of(Subcommand command) noexcept {
  switch (command) {
    case Subcommand::run:
      return "run";
    case Subcommand::check:
      return "check";
    case Subcommand::explain:
      return "explain";
    case Subcommand::report:
      return "report";
    case Subcommand::view:
      return "view";
    case Subcommand::compare:
      return "compare";
    case Subcommand::tick_cost:
      return "tick-cost";
    case Subcommand::dry_run:
      break;
  }
  return "dry-run";
}

bool makes_page(Subcommand command) noexcept {
  return command == Subcommand::report || command == Subcommand::view;
}

}  // namespace kerf::program
