#include "parser/curves/uniform_collector.hpp"

#include <algorithm>
#include <cmath>

#include "diagnostics/errors/bsplines.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr Tenths kG52 = 52;
constexpr Tenths kG53 = 53;
constexpr int kLowest = 3;
constexpr CurveCode kCurve{"G5.2"};
constexpr WeightRule kWeight{'P', &errors::kSplineWeight};

}  // namespace

bool UniformCollector::read_order(const CurveBlock& at, diagnostics::Fault& fault) {
  order_ = kLowest;
  if (!at.block.has('L')) {
    return true;
  }
  const Word& word = at.block.word('L');
  if (word.value != std::floor(word.value) || word.value < kLowest || word.value > kHighestOrder) {
    return kCurve.fail(fault, word.offset, errors::kSplineOrder,
                       {"L (order) must be a whole number from ", std::to_string(kLowest), " to ",
                        std::to_string(kHighestOrder), ", found ", shortest(word.value)});
  }
  order_ = static_cast<std::size_t>(word.value);
  return true;
}

bool UniformCollector::check_foreign(const CurveBlock& at, diagnostics::Fault& fault) const {
  if (at.block.m_count > 0) {
    return kCurve.fail(fault, at.block.m[0].offset, errors::kForeignInSpline,
                       {upper(at.block.text(at.block.m[0])), " is not allowed before G5.3"});
  }
  for (std::size_t i = 0; active_ && i < at.block.g_count; ++i) {
    const Word& word = at.block.g[i];
    if (at.codes[Group::motion] == kNoCode || at.block.g_count > 1) {
      return kCurve.fail(fault, word.offset, errors::kForeignInSpline,
                         {upper(at.block.text(word)), " is not allowed before G5.3"});
    }
  }
  const Letters usable =
      letters('N', 'P', 'F') | kAxisLetters | (active_ ? Letters{0} : letters('L'));
  if (const Word* const word = leftmost(at.block, ~usable)) {
    const char letter = letter_of(at.block, *word);
    return kCurve.fail(fault, word->offset,
                       letter == 'L' ? errors::kOrderNotFirst : errors::kForeignInSpline,
                       {named(letter), letter == 'L' ? " can be given only in the first block"
                                                     : " is not allowed before G5.3"});
  }
  return true;
}

bool UniformCollector::begin(const CurveBlock& at, diagnostics::Fault& fault) {
  curve_ = {};
  active_ = false;
  last_point_mm_ = at.state.position_mm;
  double weight = 1.0;
  if (!check_foreign(at, fault) || !read_order(at, fault) ||
      !kCurve.read_weight(at.block, kWeight, weight, fault)) {
    return false;
  }
  const bool has_point = at.block.has_any(kAxisLetters);
  append_point(curve_, {at.state.position_mm, has_point ? 1.0 : weight}, at.line);
  if (has_point && !add_point(at, fault)) {
    return false;
  }
  active_ = true;
  return true;
}

bool UniformCollector::add_point(const CurveBlock& at, diagnostics::Fault& fault) {
  if (!check_plane_axes(at, kCurve.name, fault)) {
    return false;
  }
  Point point;
  if (!resolve_point(at, last_point_mm_, point, fault)) {
    return false;
  }
  last_point_mm_ = point;
  double weight = 1.0;
  if (!kCurve.read_weight(at.block, kWeight, weight, fault)) {
    return false;
  }
  if (curve_.points.size() == kMostControlPoints) {
    return kCurve.fail(fault, at.block.first_word, errors::kSplineTooManyPoints,
                       {"more than ", std::to_string(kMostControlPoints), " control points"});
  }
  append_point(curve_, {point, weight}, at.line);
  return true;
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

bool UniformCollector::close(const CurveBlock& at, diagnostics::Fault& fault) {
  if (const Word* const word = leftmost(at.block, ~letters('N'))) {
    return kCurve.fail(fault, word->offset, errors::kForeignInSplineEnd,
                       {named(letter_of(at.block, *word)), " is not used by G5.3"});
  }
  if (curve_.points.size() < order_) {
    return kCurve.fail(
        fault, at.block.g[0].offset, errors::kSplineFewPoints,
        {"order ", std::to_string(order_), " needs at least ", std::to_string(order_),
         " control points, found ", std::to_string(curve_.points.size())});
  }
  make_knots(curve_.point_lines.front());
  return true;
}

diagnostics::Fault UniformCollector::unfinished(std::uint32_t offset,
                                                std::string_view where) const {
  diagnostics::Fault fault;
  kCurve.fail(fault, offset, errors::kSplineUnfinished,
              {"the curve is not finished ", where, " (G5.3 is missing)"});
  return fault;
}

UniformCollector::Result UniformCollector::add(const CurveBlock& at, diagnostics::Fault& fault) {
  const Block& block = at.block;
  const Tenths code = at.codes[Group::motion];
  bool fine = check_foreign(at, fault);
  if (fine && code == kG53) {
    active_ = false;
    return close(at, fault) ? Result::complete : Result::failed;
  }
  if (fine && code != kNoCode && code != kG52) {
    const Word& word = code_word(block, at.codes, Group::motion);
    fine = kCurve.fail(fault, word.offset, errors::kForeignInSpline,
                       {upper(block.text(word)), " is not allowed before G5.3"});
  }
  if (fine && block.has_any(kAxisLetters)) {
    fine = add_point(at, fault);
  } else if (fine && block.has('P')) {
    fine = kCurve.fail(fault, block.word('P').offset, errors::kSplineWeightAlone,
                       {"weight P without a control point"});
  }
  active_ = fine;
  return fine ? Result::more : Result::failed;
}

}  // namespace kerf::parser
