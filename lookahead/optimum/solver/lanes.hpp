// Two cells side by side: arithmetic that a processor does for both at once.
#pragma once

#include <cstddef>

#include <Eigen/Core>

namespace kerf::lookahead {

// Two, since that is what every 64-bit processor has: the results are the same on all of them.
using Lanes = Eigen::Array2d;
inline constexpr std::size_t kLanes = 2;

}  // namespace kerf::lookahead
