// What the collectors of curves share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

#include "diagnostics/fault.hpp"
#include "parser/block/block.hpp"
#include "parser/modal/codes.hpp"
#include "parser/modal/end_point.hpp"
#include "parser/modal/modal_state.hpp"
#include "parser/moves/move.hpp"

namespace kerf::parser {

// Orders (degree + 1) that the curves can have, and how long a curve may become in memory.
inline constexpr int kLowestOrder = 2;
inline constexpr int kHighestOrder = 10;
inline constexpr std::size_t kMostControlPoints = 20'000;

// Adds a control point and the line that it comes from.
void append_point(NurbsMove& curve, const NurbsPoint& point, std::uint32_t line);

// The word that gives a control point its weight, and the page of a wrong one.
struct WeightRule {
  char letter;
  const diagnostics::ErrorPage* page;
};

// The code of a curve, with which each of its messages begins.
struct CurveCode {
  std::string_view name;

  // Puts a fault together from parts of its message. Returns false for the caller to return.
  bool fail(diagnostics::Fault& fault, std::uint32_t offset, const diagnostics::ErrorPage& page,
            std::initializer_list<std::string_view> parts) const;
  // 1 where the block has no such word. False, with the fault: not greater than 0.
  bool read_weight(const Block& block, const WeightRule& rule, double& weight,
                   diagnostics::Fault& fault) const;
};

// For curves of two axes: either both or none of the plane's axes. `name` begins the message.
bool check_plane_axes(const CurveBlock& at, std::string_view name, diagnostics::Fault& fault);

// True where the curve has no extent.
bool is_a_point(const NurbsMove& curve);

}  // namespace kerf::parser
