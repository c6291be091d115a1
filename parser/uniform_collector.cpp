#include "parser/uniform_collector.hpp"

#include <algorithm>
#include <cmath>

#include "parser/errors/bsplines.hpp"
#include "parser/text.hpp"

namespace kerf::parser {

namespace {

constexpr Tenths kG52 = 52;
constexpr Tenths kG53 = 53;
constexpr int kLowest = 3;
constexpr std::string_view kName = "G5.2";

bool fail(Fault& fault, std::uint32_t offset, const ErrorPage& page,
          std::initializer_list<std::string_view> parts) {
  fault = {offset, joined({kName, ": ", joined(parts)}), &page};
  return false;
}

bool check_weight(const Block& block, Fault& fault) {
  if (block.value_or('P', 1.0) > 0.0) {
    return true;
  }
  return fail(fault, block.word('P').offset, errors::kSplineWeight,
              {"weight P must be greater than 0, found ", shortest(block.value('P'))});
}

}  // namespace

bool UniformCollector::read_order(const CurveBlock& at, Fault& fault) {
  order_ = kLowest;
  if (!at.block.has('L')) {
    return true;
  }
  const Word& word = at.block.word('L');
  if (word.value != std::floor(word.value) || word.value < kLowest || word.value > kHighestOrder) {
    return fail(fault, word.offset, errors::kSplineOrder,
                {"L (order) must be a whole number from ", std::to_string(kLowest), " to ",
                 std::to_string(kHighestOrder), ", found ", shortest(word.value)});
  }
  order_ = static_cast<std::size_t>(word.value);
  return true;
}

bool UniformCollector::check_foreign(const CurveBlock& at, Fault& fault) const {
  if (at.block.m_count > 0) {
    return fail(fault, at.block.m[0].offset, errors::kForeignInSpline,
                {upper(at.block.text(at.block.m[0])), " is not allowed before G5.3"});
  }
  for (std::size_t i = 0; active_ && i < at.block.g_count; ++i) {
    const Word& word = at.block.g[i];
    if (at.codes[Group::motion] == kNoCode || at.block.g_count > 1) {
      return fail(fault, word.offset, errors::kForeignInSpline,
                  {upper(at.block.text(word)), " is not allowed before G5.3"});
    }
  }
  const Letters usable =
      letters('N', 'P', 'F') | kAxisLetters | (active_ ? Letters{0} : letters('L'));
  if (const Word* const word = leftmost(at.block, ~usable)) {
    const char letter = letter_of(at.block, *word);
    return fail(fault, word->offset,
                letter == 'L' ? errors::kOrderNotFirst : errors::kForeignInSpline,
                {named(letter), letter == 'L' ? " can be given only in the first block"
                                              : " is not allowed before G5.3"});
  }
  return true;
}

bool UniformCollector::begin(const CurveBlock& at, Fault& fault) {
  curve_ = {};
  active_ = false;
  last_point_mm_ = at.state.position_mm;
  if (!check_foreign(at, fault) || !read_order(at, fault) || !check_weight(at.block, fault)) {
    return false;
  }
  const bool has_point = at.block.has_any(kAxisLetters);
  const double weight = has_point ? 1.0 : at.block.value_or('P', 1.0);
  curve_.points.push_back({at.state.position_mm, weight});
  curve_.point_lines.push_back(at.line);
  if (has_point && !add_point(at, fault)) {
    return false;
  }
  active_ = true;
  return true;
}

bool UniformCollector::add_point(const CurveBlock& at, Fault& fault) {
  if (!check_plane_axes(at, kName, fault)) {
    return false;
  }
  Point point;
  if (!resolve_point(at, last_point_mm_, point, fault)) {
    return false;
  }
  last_point_mm_ = point;
  if (!check_weight(at.block, fault)) {
    return false;
  }
  if (curve_.points.size() == kMostControlPoints) {
    return fail(fault, at.block.first_word, errors::kSplineTooManyPoints,
                {"more than ", std::to_string(kMostControlPoints), " control points"});
  }
  curve_.points.push_back({point, at.block.value_or('P', 1.0)});
  curve_.point_lines.push_back(at.line);
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

bool UniformCollector::close(const CurveBlock& at, Fault& fault) {
  if (const Word* const word = leftmost(at.block, ~letters('N'))) {
    return fail(fault, word->offset, errors::kForeignInSplineEnd,
                {named(letter_of(at.block, *word)), " is not used by G5.3"});
  }
  if (curve_.points.size() < order_) {
    return fail(fault, at.block.g[0].offset, errors::kSplineFewPoints,
                {"order ", std::to_string(order_), " needs at least ", std::to_string(order_),
                 " control points, found ", std::to_string(curve_.points.size())});
  }
  make_knots(curve_.point_lines.front());
  return true;
}

Fault UniformCollector::unfinished(std::uint32_t offset, std::string_view where) const {
  Fault fault;
  fail(fault, offset, errors::kSplineUnfinished,
       {"the curve is not finished ", where, " (G5.3 is missing)"});
  return fault;
}

UniformCollector::Result UniformCollector::add(const CurveBlock& at, Fault& fault) {
  const Block& block = at.block;
  const Tenths code = at.codes[Group::motion];
  bool fine = check_foreign(at, fault);
  if (fine && code == kG53) {
    active_ = false;
    return close(at, fault) ? Result::complete : Result::failed;
  }
  if (fine && code != kNoCode && code != kG52) {
    const Word& word = code_word(block, at.codes, Group::motion);
    fine = fail(fault, word.offset, errors::kForeignInSpline,
                {upper(block.text(word)), " is not allowed before G5.3"});
  }
  if (fine && block.has_any(kAxisLetters)) {
    fine = add_point(at, fault);
  } else if (fine && block.has('P')) {
    fine = fail(fault, block.word('P').offset, errors::kSplineWeightAlone,
                {"weight P without a control point"});
  }
  active_ = fine;
  return fine ? Result::more : Result::failed;
}

}  // namespace kerf::parser
