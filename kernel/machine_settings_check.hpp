// Checks the settings of a machine, by the rules of a machine file's keys.
#pragma once

#include <string>

#include <kerf/machine.hpp>
#include <tl/expected.hpp>

#include "diagnostics/diagnostic.hpp"
#include "diagnostics/errors/pages.hpp"

namespace kerf {

struct SettingsFault {
  std::string message;
  const diagnostics::ErrorPage* page = nullptr;

  static tl::unexpected<SettingsFault> of(
      const std::string& field, const std::string& problem,
      const diagnostics::ErrorPage& page = errors::kImpossibleSetting) {
    return tl::unexpected(SettingsFault{field + ": " + problem, &page});
  }
};

// By value: the rules say where a number stands by a reference to it.
tl::expected<void, SettingsFault> check_machine(MachineSettings settings);

}  // namespace kerf
