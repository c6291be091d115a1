// What the keys of one axis must be to each other, each being right for itself.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <kerf/machine.hpp>

#include "kernel/machine_file_schema.hpp"

namespace kerf {

struct KeyProblem {
  std::string_view key;  // the key to blame, which the file has
  std::string message;   // "found ..., expected ..."
};

// The plan must stay within what the motor can do: a drive that the file is silent about can do
// twice what is asked of it, where that is more than the default.
void raise_silent_drive(MachineSettings& settings, std::size_t axis,
                        const std::function<bool(std::string_view)>& has_key);

// What is wrong with the upper of two ends of travel, the first two of the rules; nothing: there is
// some way between them.
std::optional<std::string> travel_problem(std::span<const NumberRule> rules,
                                          MachineSettings& settings, std::size_t axis);

// The drive at least as strong as the plan, the position loop no faster than the velocity loop.
std::vector<KeyProblem> check_axis(const MachineSettings& settings, std::size_t axis,
                                   const std::function<bool(std::string_view)>& has_key);

}  // namespace kerf
