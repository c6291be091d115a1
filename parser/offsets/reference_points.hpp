// G28, G30 and the rapids beside the motion in force.
#pragma once

#include "parser/modal/end_point.hpp"
#include "parser/modal/machine_data.hpp"

namespace kerf::parser {

void push_rapid(const RunningBlock& at, ModalState& state, const Point& end_mm,
                const AuxiliaryWords& auxiliary_deg_mm);
// Goes home by way of the point that the axis words name. Only axes with a word go home, or all if
// none has one.
Done go_home(const RunningBlock& at, ModalState& state, const HomePosition& home,
             ContourPhase phase);

}  // namespace kerf::parser
