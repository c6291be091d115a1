// The rules that a curve of G6.2 must keep.
#include <cmath>

#include "diagnostics/errors/pages.hpp"
#include "parser/curves/nurbs_collector.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr CurveCode kCurve{"G6.2"};

}  // namespace

// Words and codes that no block of a curve may hold.
Done NurbsCollector::check_foreign(const RunningBlock& at) const {
  if (at.block.m_count > 0) {
    return kCurve.fail(at.block.m[0].offset, errors::kForeignInNurbs,
                       {upper(at.block.text(at.block.m[0])), " is not allowed inside a curve"});
  }
  for (std::size_t i = 0; active_ && i < at.block.g_count; ++i) {
    const Word& word = at.block.g[i];
    if (std::fabs(word.value - 6.2) > 1e-9) {
      return kCurve.fail(word.offset, errors::kForeignInNurbs,
                         {upper(at.block.text(word)), " is not allowed inside a curve"});
    }
  }
  const Letters usable =
      letters('N', 'F', 'K', 'R') | kAxisLetters | (active_ ? Letters{0} : letters('P', 'Q'));
  if (const Word* const word = leftmost(at.block, ~usable)) {
    const char letter = letter_of(at.block, *word);
    const bool first_block_only = letter == 'P' || letter == 'Q';
    return kCurve.fail(word->offset,
                       first_block_only ? errors::kFirstBlockOnly : errors::kForeignInNurbs,
                       {named(letter), first_block_only ? " can be given only in the first block"
                                                        : " is not allowed inside a curve"});
  }
  return {};
}

Done NurbsCollector::check_axes(const RunningBlock& at, const ModalState& state) {
  if (in_plane_) {
    if (Done fine = check_plane_axes(at.block, state.plane, kCurve.name); !fine) {
      return fine;
    }
  }
  if (axes_ == 0) {
    axes_ = at.block.present & kAxisLetters;
  }
  if (const Word* const word = leftmost(at.block, kAxisLetters & ~axes_)) {
    return kCurve.fail(word->offset, errors::kNurbsNewAxis,
                       {named(letter_of(at.block, *word)),
                        " was not given in the block of the first control point"});
  }
  return {};
}

// Of an order that only few controls know the mistake is more likely in P than in the knots.
Done NurbsCollector::wrong_head(const RunningBlock& at, double knot) const {
  const std::string first = shortest(curve_.knots.front());
  const std::string order = std::to_string(order_);
  if (!extension_) {
    return kCurve.fail(
        at.block.word('K').offset, errors::kHeadKnots,
        {"the first ", order, " knots must be equal, found ", shortest(knot), " after ", first});
  }
  auto fault = kCurve.fault(
      0, errors::kHeadKnots,
      {"P (order) ", order, " needs the first ", order, " knots equal, found ", shortest(knot),
       " in line ", std::to_string(at.source.line), " after ", std::to_string(curve_.knots.size()),
       curve_.knots.size() == 1 ? " knot of " : " knots of ", first, " (Fanuc takes P 2 to 4)"});
  fault.elsewhere = extension_;
  return diagnostics::failure(std::move(fault));
}

Done NurbsCollector::check_knot(const RunningBlock& at, double knot) const {
  const auto& knots = curve_.knots;
  const std::uint32_t offset = at.block.word('K').offset;
  if (knots.empty()) {
    return {};
  }
  if (knot < knots.back()) {
    return kCurve.fail(offset, errors::kKnotDecreases,
                       {"knot ", shortest(knot), " is smaller than the knot before it (",
                        shortest(knots.back()), ")"});
  }
  if (knots.size() < order_ && knot != knots.front()) {
    return wrong_head(at, knot);
  }
  const bool in_tail = !at.block.has_any(kAxisLetters);  // judged when the row is complete
  if (!in_tail && knot == knots.back() && run_ == order_) {
    const bool at_start = knot == knots.front();
    return kCurve.fail(offset, errors::kKnotTooOften,
                       {"knot ", shortest(knot), " is repeated ", std::to_string(run_ + 1),
                        " times, at most ", std::to_string(at_start ? order_ : order_ - 1),
                        at_start ? " are allowed at the start (P is the order: degree + 1)"
                                 : " are allowed inside the curve"});
  }
  return {};
}

Done NurbsCollector::check_tail(const RunningBlock& at) const {
  const BlockWords& block = at.block;
  if (block.has('R')) {
    return kCurve.fail(block.word('R').offset, errors::kNurbsWeightAlone,
                       {"R without a control point"});
  }
  if (curve_.points.size() < order_) {
    return kCurve.fail(
        block.word('K').offset, errors::kNurbsFewPoints,
        {"order ", std::to_string(order_), " needs at least ", std::to_string(order_),
         " control points, found ", std::to_string(curve_.points.size())});
  }
  const double knot = block.value('K');
  if (tail_ > 0 && knot > curve_.knots.back()) {
    return kCurve.fail(block.word('K').offset, errors::kTailKnots,
                       {"the last ", std::to_string(order_), " knots must be equal, found ",
                        shortest(knot), " after ", shortest(curve_.knots.back())});
  }
  return check_knot(at, knot);
}

// What only the complete row of knots shows.
Done NurbsCollector::check_whole(const RunningBlock& at) const {
  const auto& knots = curve_.knots;
  const std::uint32_t offset = at.block.word('K').offset;
  if (knots.front() == knots.back()) {
    return kCurve.fail(offset, errors::kNoParameterRange,
                       {"the first and the last knot are equal (", shortest(knots.back()),
                        "): the curve has no parameter range"});
  }
  if (run_ > order_) {
    return kCurve.fail(offset, errors::kKnotTooOften,
                       {"knot ", shortest(knots.back()), " is repeated ", std::to_string(run_),
                        " times at the end, ", std::to_string(order_), " are allowed"});
  }
  // P equal knots inside: the curve jumps from control point i - 1 to control point i.
  for (std::size_t i = order_; i + order_ < knots.size(); ++i) {
    if (i + order_ <= curve_.points.size() && knots[i] == knots[i + order_ - 1] &&
        curve_.points[i].position_mm != curve_.points[i - 1].position_mm) {
      return kCurve.fail(
          offset, errors::kKnotTooOften,
          {"knot ", shortest(knots[i]), " (line ", std::to_string(curve_.knot_lines[i]),
           ") is repeated ", std::to_string(order_), " times, at most ", std::to_string(order_ - 1),
           " are allowed inside the curve"});
    }
  }
  return {};
}

}  // namespace kerf::parser
