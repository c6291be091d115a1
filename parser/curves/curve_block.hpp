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
inline constexpr std::size_t kMaxControlPoints = 20'000;

// What a further block means to a curve.
enum class CurveProgress : std::uint8_t { more, complete };

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

  // Puts a fault together from parts of its message.
  [[nodiscard]] diagnostics::Fault fault(std::uint32_t offset, const diagnostics::ErrorPage& page,
                                         std::initializer_list<std::string_view> parts) const;
  [[nodiscard]] diagnostics::Failure fail(std::uint32_t offset, const diagnostics::ErrorPage& page,
                                          std::initializer_list<std::string_view> parts) const {
    return diagnostics::failure(fault(offset, page, parts));
  }
  // 1 where the block has no such word; greater than 0.
  [[nodiscard]] Expected<double> read_weight(const BlockWords& block, const WeightRule& rule) const;
};

// For curves of two axes: either both or none of the plane's axes. `name` begins the message.
Done check_plane_axes(const BlockWords& block, Plane plane, std::string_view name);

struct ReadyCurve {
  NurbsMove curve;
  std::string_view name;  // of its code, for messages
  diagnostics::SourcePosition source;
  double feedrate_mm_s = 0.0;
};
// Hands the curve on, as far as it has any extent; the tool is then at its last control point.
void push_curve(const RunningBlock& at, ModalState& state, ReadyCurve ready);

}  // namespace kerf::parser
