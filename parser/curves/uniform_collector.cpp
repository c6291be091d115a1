#include "parser/curves/uniform_collector.hpp"

#include <algorithm>
#include <cmath>

#include "diagnostics/errors/pages.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr Tenths kG52 = 52;
constexpr Tenths kG53 = 53;
constexpr int kLowest = 3;
constexpr CurveCode kCurve{"G5.2"};
constexpr WeightRule kWeight{'P', &errors::kSplineWeight};

}  // namespace

Done UniformCollector::read_order(const RunningBlock& at) {
  order_ = kLowest;
  if (!at.block.has('L')) {
    return {};
  }
  const Word& word = at.block.word('L');
  if (word.value != std::floor(word.value) || word.value < kLowest || word.value > kHighestOrder) {
    return kCurve.fail(word.offset, errors::kSplineOrder,
                       {"L (order) must be a whole number from ", std::to_string(kLowest), " to ",
                        std::to_string(kHighestOrder), ", found ", shortest(word.value)});
  }
  order_ = static_cast<std::size_t>(word.value);
  return {};
}

Done UniformCollector::check_foreign(const RunningBlock& at) const {
  if (at.block.m_count > 0) {
    return kCurve.fail(at.block.m[0].offset, errors::kForeignInSpline,
                       {upper(at.block.text(at.block.m[0])), " is not allowed before G5.3"});
  }
  for (std::size_t i = 0; active_ && i < at.block.g_count; ++i) {
    const Word& word = at.block.g[i];
    if (at.codes[Group::motion] == kNoCode || at.block.g_count > 1) {
      return kCurve.fail(word.offset, errors::kForeignInSpline,
                         {upper(at.block.text(word)), " is not allowed before G5.3"});
    }
  }
  const Letters usable =
      letters('N', 'P', 'F') | kAxisLetters | (active_ ? Letters{0} : letters('L'));
  if (const Word* const word = leftmost(at.block, ~usable)) {
    const char letter = letter_of(at.block, *word);
    return kCurve.fail(word->offset,
                       letter == 'L' ? errors::kOrderNotFirst : errors::kForeignInSpline,
                       {named(letter), letter == 'L' ? " can be given only in the first block"
                                                     : " is not allowed before G5.3"});
  }
  return {};
}

Done UniformCollector::begin(const RunningBlock& at, const ModalState& state) {
  curve_ = {};
  active_ = false;
  last_point_mm_ = state.position_mm;
  Expected<double> weight =
      check_foreign(at).and_then([&] { return read_order(at); }).and_then([&] {
        return kCurve.read_weight(at.block, kWeight);
      });
  if (!weight) {
    return fault_of(weight);
  }
  const bool has_point = at.block.has_any(kAxisLetters);
  append_point(curve_, {state.position_mm, has_point ? 1.0 : *weight}, at.source.line);
  if (has_point) {
    if (Done fine = add_point(at, state); !fine) {
      return fine;
    }
  }
  active_ = true;
  return {};
}

Done UniformCollector::add_point(const RunningBlock& at, const ModalState& state) {
  if (Done fine = check_plane_axes(at.block, state.plane, kCurve.name); !fine) {
    return fine;
  }
  Expected<Point> point = resolve_point(at, state, last_point_mm_);
  if (!point) {
    return fault_of(point);
  }
  last_point_mm_ = *point;
  Expected<double> weight = kCurve.read_weight(at.block, kWeight);
  if (!weight) {
    return fault_of(weight);
  }
  if (curve_.points.size() == kMaxControlPoints) {
    return kCurve.fail(at.block.first_word, errors::kSplineTooManyPoints,
                       {"more than ", std::to_string(kMaxControlPoints), " control points"});
  }
  append_point(curve_, {*point, *weight}, at.source.line);
  return {};
}

void UniformCollector::make_knots(std::uint32_t line) {
  const std::size_t points = curve_.points.size();
  const std::size_t spans = points - order_ + 1;
  curve_.degree = static_cast<int>(order_) - 1;
  for (std::size_t i = 0; i < points + order_; ++i) {
    const std::size_t knot = i < order_ ? 0 : std::min(i - order_ + 1, spans);
    curve_.knots.push_back(static_cast<double>(knot));
  }
  curve_.knot_lines.assign(curve_.knots.size(), line);
}

Done UniformCollector::close(const RunningBlock& at) {
  if (const Word* const word = leftmost(at.block, ~letters('N'))) {
    return kCurve.fail(word->offset, errors::kForeignInSplineEnd,
                       {named(letter_of(at.block, *word)), " is not used by G5.3"});
  }
  if (curve_.points.size() < order_) {
    return kCurve.fail(
        at.block.g[0].offset, errors::kSplineFewPoints,
        {"order ", std::to_string(order_), " needs at least ", std::to_string(order_),
         " control points, found ", std::to_string(curve_.points.size())});
  }
  make_knots(curve_.point_lines.front());
  return {};
}

diagnostics::Fault UniformCollector::unfinished(std::uint32_t offset,
                                                std::string_view where) const {
  return kCurve.fault(offset, errors::kSplineUnfinished,
                      {"the curve is not finished ", where, " (G5.3 is missing)"});
}

Expected<CurveProgress> UniformCollector::add(const RunningBlock& at, const ModalState& state) {
  Done taken = take_block(at, state);
  const bool closed = at.codes[Group::motion] == kG53;
  active_ = taken && !closed;
  if (!taken) {
    return fault_of(taken);
  }
  return closed ? CurveProgress::complete : CurveProgress::more;
}

Done UniformCollector::take_block(const RunningBlock& at, const ModalState& state) {
  const BlockWords& block = at.block;
  const Tenths code = at.codes[Group::motion];
  if (Done fine = check_foreign(at); !fine) {
    return fine;
  }
  if (code == kG53) {
    return close(at);
  }
  if (code != kNoCode && code != kG52) {
    return kCurve.fail(at.code_word(Group::motion).offset, errors::kForeignInSpline,
                       {at.name_of(Group::motion), " is not allowed before G5.3"});
  }
  if (block.has_any(kAxisLetters)) {
    return add_point(at, state);
  }
  if (block.has('P')) {
    return kCurve.fail(block.word('P').offset, errors::kSplineWeightAlone,
                       {"weight P without a control point"});
  }
  return {};
}

}  // namespace kerf::parser
