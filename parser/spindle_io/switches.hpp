// Tool change, coolant, outputs and inputs, overrides and stops.
#pragma once

#include "parser/modal/machine_source.hpp"
#include "parser/modal/running_block.hpp"

namespace kerf::parser {

Done select_tool(const RunningBlock& at, ModalState& state, const ToolTable& tools);  // T
// M6, which stops the spindle, and M61 Q, which only says which tool is in it.
Done change_tool(const RunningBlock& at, ModalState& state, const ToolTable& tools);
void switch_coolant(const RunningBlock& at, ModalState& state);
// Tells the machine what has changed since `before`.
void bring_back_coolant(const MoveSink& at, const ModalState& before, const ModalState& state);
// in_out.cpp. M62 to M68: digital and analog outputs, waiting for an input.
Done switch_in_out(const RunningBlock& at, ModalState& state, const MachineSource& machine);
// What counts from the next motion on.
void follow_overrides(const MoveSink& at, ModalState& state, const AllowedOverrides& overrides);
// M48 and M49 switch both overrides; M50 to M53 one thing each, off with P0.
Done switch_overrides(const RunningBlock& at, ModalState& state);
// M0, M1, M2, M30, M60. True: the program ends here.
bool stop_program(const RunningBlock& at, const ModalState& state);

}  // namespace kerf::parser
