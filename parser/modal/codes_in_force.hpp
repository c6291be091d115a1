// The modal codes and words that would bring about a modal state.
#pragma once

#include <string>
#include <vector>

#include "parser/modal/modal_state.hpp"

namespace kerf::parser {

// One code of each modal group, in the order of the groups: "G1", "G17", "G90", ... "M3", "M9". Of
// G51, G51.1 and G68, which only Fanuc has, those in force; of M50 to M53 those that are not as a
// program finds them.
std::vector<std::string> codes_in_force(const ModalState& state);

// F as it was written, S, and T of the tool in the spindle: "F600 S9000 T1"; no F before the first.
std::string words_in_force(const ModalState& state);

}  // namespace kerf::parser
