#include "parser/curves/nurbs_collector.hpp"

#include <cmath>

#include "diagnostics/errors/pages.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr double kFirstPointTolerance_mm = 0.0005;  // half of Fanuc's least increment
constexpr std::size_t kHighestPlainOrder = 4;       // what is above is an extension
constexpr Tenths kG62 = 62;
constexpr CurveCode kCurve{"G6.2"};
constexpr WeightRule kWeight{'R', &errors::kNurbsWeight};

}  // namespace

Done NurbsCollector::read_order(const RunningBlock& at) {
  order_ = 4;
  extension_.reset();
  if (!at.block.has('P')) {
    return {};
  }
  const Word& word = at.block.word('P');
  if (word.value != std::floor(word.value)) {
    return kCurve.fail(word.offset, errors::kNurbsOrder,
                       {"P (order) must be a whole number, found ", shortest(word.value)});
  }
  if (word.value < kLowestOrder || word.value > kHighestOrder) {
    return kCurve.fail(word.offset, errors::kNurbsOrder,
                       {"P (order) must be ", std::to_string(kLowestOrder), " to ",
                        std::to_string(kHighestOrder), ", found ", shortest(word.value)});
  }
  order_ = static_cast<std::size_t>(word.value);
  if (order_ > kHighestPlainOrder) {
    extension_ = at.diagnostics.place({at.source.line, word.offset + 1});
  }
  return {};
}

Done NurbsCollector::read_form(const RunningBlock& at) {
  in_plane_ = at.block.has('Q');
  if (!in_plane_) {
    return {};
  }
  const Word& word = at.block.word('Q');
  if (word.value != 1.0 && word.value != 2.0 && word.value != 3.0) {
    return kCurve.fail(word.offset, errors::kNurbsForm,
                       {"Q must be 1, 2 or 3, found ", shortest(word.value)});
  }
  return {};
}

Done NurbsCollector::begin(const RunningBlock& at, const ModalState& state) {
  curve_ = {};
  last_point_mm_ = state.position_mm;
  tail_ = run_ = 0;
  axes_ = 0;
  active_ = false;
  Done head = check_foreign(at).and_then([&] { return read_order(at); }).and_then([&] {
    return read_form(at);
  });
  if (!head) {
    return head;
  }
  const BlockWords& block = at.block;
  const bool implicit = at.codes[Group::motion] != kG62;
  const bool has_axes = block.has_any(kAxisLetters);
  if (!has_axes && implicit) {
    return kCurve.fail(block.first_word, errors::kPointMissing,
                       {"the curve is complete, a control point is expected with K"});
  }
  if (!has_axes && !block.has('P')) {
    return kCurve.fail(block.first_word, errors::kPointMissing,
                       {"P and a control point are expected in the first block"});
  }
  if (implicit && !block.has('K')) {
    return kCurve.fail(leftmost(block, kAxisLetters)->offset, errors::kKnotMissing,
                       {"K is missing (G6.2 is still active)"});
  }
  if (Done fine = check_axes(at, state); !fine) {
    return fine;
  }
  if (Done fine = first_point(at, state); !fine) {
    return fine;
  }
  if (implicit) {
    at.warn(block.first_word, errors::kImplicitNurbs,
            "G6.2: a new curve without G6.2, order 4 is assumed");
  }
  curve_.degree = static_cast<int>(order_) - 1;
  active_ = true;
  return {};
}

Done NurbsCollector::first_point(const RunningBlock& at, const ModalState& state) {
  const Point& here = state.position_mm;
  Expected<Point> point = resolve_point(at, state, here);
  if (!point) {
    return fault_of(point);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(std::fabs((*point)[axis] - here[axis]) <= kFirstPointTolerance_mm)) {
      return kCurve.fail(leftmost(at.block, kAxisLetters)->offset, errors::kFirstPoint,
                         {"the first control point ", in_mm(*point),
                          " is not the current position ", in_mm(here)});
    }
  }
  Expected<double> weight = kCurve.read_weight(at.block, kWeight);
  if (!weight) {
    return fault_of(weight);
  }
  append_point(curve_, {here, *weight}, at.source.line);
  knot_pending_ = !at.block.has('K');
  if (!knot_pending_) {
    push_knot({at.block.value('K'), at.source.line});
  }
  return {};
}

void NurbsCollector::push_knot(const KnotOfLine& given) {
  run_ = !curve_.knots.empty() && given.knot == curve_.knots.back() ? run_ + 1 : 1;
  curve_.knots.push_back(given.knot);
  curve_.knot_lines.push_back(given.line);
}

Done NurbsCollector::add_point(const RunningBlock& at, const ModalState& state) {
  const BlockWords& block = at.block;
  const Word* const first_axis = leftmost(block, kAxisLetters);
  if (!block.has('K')) {
    return kCurve.fail(first_axis->offset, errors::kKnotMissing, {"K is missing"});
  }
  if (tail_ > 0) {
    return kCurve.fail(first_axis->offset, errors::kPointAfterTail,
                       {"a control point after the knot-only blocks (",
                        std::to_string(order_ - tail_), " more of them are expected)"});
  }
  if (Done fine = check_axes(at, state); !fine) {
    return fine;
  }
  Expected<Point> point = resolve_point(at, state, last_point_mm_);
  if (!point) {
    return fault_of(point);
  }
  last_point_mm_ = *point;
  Expected<double> weight = kCurve.read_weight(block, kWeight);
  if (!weight) {
    return fault_of(weight);
  }
  const double knot = block.value('K');
  if (knot_pending_) {
    push_knot({knot, curve_.point_lines.front()});
    knot_pending_ = false;
  }
  if (Done fine = check_knot(at, knot); !fine) {
    return fine;
  }
  if (curve_.points.size() == kMaxControlPoints) {
    return kCurve.fail(first_axis->offset, errors::kNurbsTooManyPoints,
                       {"more than ", std::to_string(kMaxControlPoints), " control points"});
  }
  push_knot({knot, at.source.line});
  append_point(curve_, {*point, *weight}, at.source.line);
  return {};
}

Done NurbsCollector::add_knot(const RunningBlock& at) {
  if (Done fine = check_tail(at); !fine) {
    return fine;
  }
  ++tail_;
  push_knot({at.block.value('K'), at.source.line});
  return tail_ < order_ ? Done() : check_whole(at);
}

diagnostics::Fault NurbsCollector::unfinished(std::uint32_t offset, std::string_view where) const {
  if (tail_ == 0) {
    return kCurve.fault(offset, errors::kNurbsUnfinished,
                        {"the curve is not finished ", where, " (", std::to_string(order_),
                         " knot-only blocks are missing)"});
  }
  return kCurve.fault(offset, errors::kNurbsUnfinished,
                      {"the curve is not finished ", where, ": ", std::to_string(order_),
                       " knot-only blocks are needed at its end, found ", std::to_string(tail_)});
}

Expected<CurveProgress> NurbsCollector::add(const RunningBlock& at, const ModalState& state) {
  Done taken = take_block(at, state);
  if (!taken) {
    active_ = false;
    return fault_of(taken);
  }
  active_ = tail_ < order_;
  return active_ ? CurveProgress::more : CurveProgress::complete;
}

Done NurbsCollector::take_block(const RunningBlock& at, const ModalState& state) {
  const BlockWords& block = at.block;
  if (Done fine = check_foreign(at); !fine) {
    return fine;
  }
  if (block.has('F')) {
    at.warn(block.word('F').offset, errors::kFeedInNurbs,
            "G6.2: F inside a curve takes effect at the next curve");
  }
  if (block.has_any(kAxisLetters)) {
    return add_point(at, state);
  }
  if (!block.has_any(letters('K', 'R'))) {
    return {};
  }
  if (!block.has('K')) {
    return kCurve.fail(block.word('R').offset, errors::kNurbsWeightAlone,
                       {"R without a control point"});
  }
  return add_knot(at);
}

}  // namespace kerf::parser
