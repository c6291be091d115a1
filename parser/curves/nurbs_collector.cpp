#include "parser/curves/nurbs_collector.hpp"

#include <cmath>

#include "diagnostics/errors/nurbs.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr double kFirstPointTolerance_mm = 0.0005;  // half of Fanuc's least increment
constexpr std::size_t kHighestPlainOrder = 4;       // what is above is an extension
constexpr Tenths kG62 = 62;
constexpr CurveCode kCurve{"G6.2"};
constexpr WeightRule kWeight{'R', &errors::kNurbsWeight};

}  // namespace

bool NurbsCollector::read_order(const CurveBlock& at, diagnostics::Fault& fault) {
  order_ = 4;
  extension_.reset();
  if (!at.block.has('P')) {
    return true;
  }
  const Word& word = at.block.word('P');
  if (word.value != std::floor(word.value)) {
    return kCurve.fail(fault, word.offset, errors::kNurbsOrder,
                       {"P (order) must be a whole number, found ", shortest(word.value)});
  }
  if (word.value < kLowestOrder || word.value > kHighestOrder) {
    return kCurve.fail(fault, word.offset, errors::kNurbsOrder,
                       {"P (order) must be ", std::to_string(kLowestOrder), " to ",
                        std::to_string(kHighestOrder), ", found ", shortest(word.value)});
  }
  order_ = static_cast<std::size_t>(word.value);
  if (order_ > kHighestPlainOrder) {
    extension_ = diagnostics_->place({at.line, word.offset + 1});
  }
  return true;
}

bool NurbsCollector::read_form(const CurveBlock& at, diagnostics::Fault& fault) {
  in_plane_ = at.block.has('Q');
  if (!in_plane_) {
    return true;
  }
  const Word& word = at.block.word('Q');
  if (word.value != 1.0 && word.value != 2.0 && word.value != 3.0) {
    return kCurve.fail(fault, word.offset, errors::kNurbsForm,
                       {"Q must be 1, 2 or 3, found ", shortest(word.value)});
  }
  return true;
}

bool NurbsCollector::begin(const CurveBlock& at, diagnostics::Fault& fault) {
  curve_ = {};
  last_point_mm_ = at.state.position_mm;
  tail_ = run_ = 0;
  axes_ = 0;
  active_ = false;
  if (!check_foreign(at, fault) || !read_order(at, fault) || !read_form(at, fault)) {
    return false;
  }
  const Block& block = at.block;
  const bool implicit = at.codes[Group::motion] != kG62;
  const bool has_axes = block.has_any(kAxisLetters);
  if (!has_axes && implicit) {
    return kCurve.fail(fault, block.first_word, errors::kPointMissing,
                       {"the curve is complete, a control point is expected with K"});
  }
  if (!has_axes && !block.has('P')) {
    return kCurve.fail(fault, block.first_word, errors::kPointMissing,
                       {"P and a control point are expected in the first block"});
  }
  if (implicit && !block.has('K')) {
    return kCurve.fail(fault, leftmost(block, kAxisLetters)->offset, errors::kKnotMissing,
                       {"K is missing (G6.2 is still active)"});
  }
  if (!check_axes(at, fault) || !first_point(at, fault)) {
    return false;
  }
  if (implicit) {
    diagnostics_->add({at.line, block.first_word + 1}, errors::kImplicitNurbs,
                      "G6.2: a new curve without G6.2, order 4 is assumed");
  }
  curve_.degree = static_cast<int>(order_) - 1;
  active_ = true;
  return true;
}

bool NurbsCollector::first_point(const CurveBlock& at, diagnostics::Fault& fault) {
  Point point;
  const Point& here = at.state.position_mm;
  if (!resolve_point(at, here, point, fault)) {
    return false;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(std::fabs(point[axis] - here[axis]) <= kFirstPointTolerance_mm)) {
      return kCurve.fail(
          fault, leftmost(at.block, kAxisLetters)->offset, errors::kFirstPoint,
          {"the first control point ", in_mm(point), " is not the current position ", in_mm(here)});
    }
  }
  double weight = 1.0;
  if (!kCurve.read_weight(at.block, kWeight, weight, fault)) {
    return false;
  }
  append_point(curve_, {here, weight}, at.line);
  knot_pending_ = !at.block.has('K');
  if (!knot_pending_) {
    push_knot({at.block.value('K'), at.line});
  }
  return true;
}

void NurbsCollector::push_knot(const KnotOfLine& given) {
  run_ = !curve_.knots.empty() && given.knot == curve_.knots.back() ? run_ + 1 : 1;
  curve_.knots.push_back(given.knot);
  curve_.knot_lines.push_back(given.line);
}

bool NurbsCollector::add_point(const CurveBlock& at, diagnostics::Fault& fault) {
  const Block& block = at.block;
  const Word* const first_axis = leftmost(block, kAxisLetters);
  if (!block.has('K')) {
    return kCurve.fail(fault, first_axis->offset, errors::kKnotMissing, {"K is missing"});
  }
  if (tail_ > 0) {
    return kCurve.fail(fault, first_axis->offset, errors::kPointAfterTail,
                       {"a control point after the knot-only blocks (",
                        std::to_string(order_ - tail_), " more of them are expected)"});
  }
  if (!check_axes(at, fault)) {
    return false;
  }
  Point point;
  if (!resolve_point(at, last_point_mm_, point, fault)) {
    return false;
  }
  last_point_mm_ = point;
  double weight = 1.0;
  if (!kCurve.read_weight(block, kWeight, weight, fault)) {
    return false;
  }
  const double knot = block.value('K');
  if (knot_pending_) {
    push_knot({knot, curve_.point_lines.front()});
    knot_pending_ = false;
  }
  if (!check_knot(at, knot, fault)) {
    return false;
  }
  if (curve_.points.size() == kMostControlPoints) {
    return kCurve.fail(fault, first_axis->offset, errors::kNurbsTooManyPoints,
                       {"more than ", std::to_string(kMostControlPoints), " control points"});
  }
  push_knot({knot, at.line});
  append_point(curve_, {point, weight}, at.line);
  return true;
}

bool NurbsCollector::add_knot(const CurveBlock& at, diagnostics::Fault& fault) {
  if (!check_tail(at, fault)) {
    return false;
  }
  ++tail_;
  push_knot({at.block.value('K'), at.line});
  return tail_ < order_ || check_whole(at, fault);
}

diagnostics::Fault NurbsCollector::unfinished(std::uint32_t offset, std::string_view where) const {
  diagnostics::Fault fault;
  if (tail_ == 0) {
    kCurve.fail(fault, offset, errors::kNurbsUnfinished,
                {"the curve is not finished ", where, " (", std::to_string(order_),
                 " knot-only blocks are missing)"});
  } else {
    kCurve.fail(fault, offset, errors::kNurbsUnfinished,
                {"the curve is not finished ", where, ": ", std::to_string(order_),
                 " knot-only blocks are needed at its end, found ", std::to_string(tail_)});
  }
  return fault;
}

NurbsCollector::Result NurbsCollector::add(const CurveBlock& at, diagnostics::Fault& fault) {
  const Block& block = at.block;
  if (!check_foreign(at, fault)) {
    return failed();
  }
  if (block.has('F')) {
    diagnostics_->add({at.line, block.word('F').offset + 1}, errors::kFeedInNurbs,
                      "G6.2: F inside a curve takes effect at the next curve");
  }
  if (block.has_any(kAxisLetters)) {
    return add_point(at, fault) ? Result::more : failed();
  }
  if (!block.has_any(letters('K', 'R'))) {
    return Result::more;
  }
  if (!block.has('K')) {
    kCurve.fail(fault, block.word('R').offset, errors::kNurbsWeightAlone,
                {"R without a control point"});
    return failed();
  }
  if (!add_knot(at, fault)) {
    return failed();
  }
  active_ = tail_ < order_;
  return active_ ? Result::more : Result::complete;
}

}  // namespace kerf::parser
