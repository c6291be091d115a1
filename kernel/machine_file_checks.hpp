// Checks between the keys of one axis, once each is valid by itself.
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

// A plan must not ask more than the motor can do: a drive that the file does not describe can do
// twice what the limits of the axis ask, or without any those of the path, or the default if that
// is more.
void raise_silent_drive(MachineSettings& settings, std::size_t axis,
                        const std::function<bool(std::string_view)>& has_key);

// What is wrong with the upper end of travel (rules[0] and rules[1] are the two ends); nothing: it
// is above the lower one.
std::optional<std::string> travel_problem(std::span<const NumberRule> rules,
                                          MachineSettings& settings, std::size_t axis);

// The drive must be at least as strong as the limits of the plan, the position loop no faster than
// the velocity loop, and where the axis goes once it is homed within its travel.
std::vector<KeyProblem> check_axis(const MachineSettings& settings, std::size_t axis,
                                   const std::function<bool(std::string_view)>& has_key);

}  // namespace kerf
