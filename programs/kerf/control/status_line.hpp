// What a run does, and what it waits for, in words for the person at its terminal.
#pragma once

#include <string>

#include <kerf/controller.hpp>

namespace kerf::program {

// The state, the line, the feedrate or why the tool stands, the feed override and single block.
[[nodiscard]] std::string status_line(const ControllerStatus& status);

// "waiting at line 3 for tool 3 (M6): Enter goes on". Precondition: it waits for an answer.
[[nodiscard]] std::string call_for_answer(const ControllerStatus& status);

// Its inputs hold the tool, where the program lets them.
bool is_held_by_machine(const ControllerStatus& status) noexcept;

}  // namespace kerf::program
