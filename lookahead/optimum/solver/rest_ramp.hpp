// The grid of the time optimum beside a rest.
#pragma once

#include <vector>

#include "lookahead/optimum/solver/limit_check.hpp"

namespace kerf::lookahead {

enum class RestAt { begin, end };

// Divides the cells towards a rest at their beginning or end so that a launch or landing and the
// ramp after it find room; the outermost cell is then that launch or landing.
void refine_to_rest(std::vector<Cell>& cells, RestAt where, const PathAt& path,
                    const PlanLimits& limits);

}  // namespace kerf::lookahead
