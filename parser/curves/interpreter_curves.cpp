// G6.2 and G5.2 ... G5.3: which blocks belong to a curve, and what follows an error in one.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "diagnostics/errors/curves.hpp"
#include "parser/interpreter/interpreter.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr Tenths kG52 = 52;
constexpr Tenths kG53 = 53;
constexpr Tenths kG62 = 62;
constexpr Tenths kG63 = 63;

constexpr double kLargestWeightRatio = 1e6;

double weight_ratio(const NurbsMove& curve) {
  const auto [least, most] = std::minmax_element(
      curve.points.begin(), curve.points.end(),
      [](const NurbsPoint& a, const NurbsPoint& b) { return a.weight < b.weight; });
  return most->weight / least->weight;
}

bool ends_program(const BlockCodes& codes) {
  return codes[Group::stop] == 20 || codes[Group::stop] == 300;
}

}  // namespace

bool Interpreter::begins_curve() const {
  const Tenths code = codes_[Group::motion];
  if (code != kNoCode) {
    return code == kG62 || code == kG52;
  }
  return state_.motion == Motion::nurbs && block_->has_any(axis_letters() | letters('K', 'R'));
}

bool Interpreter::curve_feed() {
  const bool nurbs = state_.motion == Motion::nurbs;
  if (state_.feed_mode == FeedMode::inverse_time ||
      (nurbs && state_.feed_mode == FeedMode::per_revolution)) {
    return fail(motion_offset(), errors::kCurveInverseTime,
                nurbs ? "G6.2 cannot be used with G93 or G95" : "G5.2 cannot be used with G93");
  }
  return cutting_feedrate(0.0, curve_feedrate_mm_s_);
}

bool Interpreter::begin_curve() {
  set_units_and_feed_mode();
  if (!set_modes()) {
    return false;
  }
  curve_source_ = {line_, block_->first_word + 1, file_};
  const bool nurbs = state_.motion == Motion::nurbs;
  const bool fine =
      set_feed() && curve_feed() &&
      (nurbs ? nurbs_.begin(curve_block(), fault_) : uniform_.begin(curve_block(), fault_));
  if (!fine) {
    skipped_curve_ = nurbs ? kG62 : kG52;
  } else if (nurbs && dialect_ == Dialect::fanuc) {
    warn_of_order();
  }
  return fine;
}

// The block that proves a curve wrong may stand far behind the one that began it.
diagnostics::Fault Interpreter::of_curve(diagnostics::Fault fault) const {
  if (line_ != curve_source_.line && !fault.elsewhere) {
    fault.message += joined({"; the curve begins in line ", std::to_string(curve_source_.line)});
  }
  return fault;
}

// A block that is no part of the open curve but shows that its end is missing.
bool Interpreter::reports_open_curve() {
  const Tenths code = codes_[Group::motion];
  std::string_view where;
  if (nurbs_.active() && code != kNoCode && code != kG62) {
    where = "before this block";
  } else if (ends_program(codes_)) {
    where = "at the end of the program";
  } else {
    return false;
  }
  const Word& word = code_word(*block_, codes_, ends_program(codes_) ? Group::stop : Group::motion);
  const std::string name = joined({"at ", upper(block_->text(word))});
  report(of_curve(nurbs_.active() ? nurbs_.unfinished(word.offset, name)
                                  : uniform_.unfinished(word.offset, name)));
  return true;
}

bool Interpreter::continue_curve() {
  const CurveBlock here = curve_block();
  if (nurbs_.active()) {
    const auto result = nurbs_.add(here, fault_);
    if (result == NurbsCollector::Result::complete) {
      return deliver_curve(nurbs_.take(), "G6.2") && set_feed();
    }
    if (result == NurbsCollector::Result::failed) {
      state_.position_mm = nurbs_.last_point_mm();
      skipped_curve_ = kG62;
      fault_ = of_curve(std::move(fault_));
      return false;
    }
    return set_feed();
  }
  const auto result = uniform_.add(here, fault_);
  if (result == UniformCollector::Result::complete) {
    set_motion(kG53);
    return deliver_curve(uniform_.take(), "G5.2");
  }
  if (result == UniformCollector::Result::failed) {
    state_.position_mm = uniform_.last_point_mm();
    skipped_curve_ = codes_[Group::motion] == kG53 ? kNoCode : kG52;
    fault_ = of_curve(std::move(fault_));
    return false;
  }
  return set_feed();
}

// Hands the curve on, as far as it has any extent; the tool is then at its last control point.
bool Interpreter::deliver_curve(NurbsMove curve, std::string_view name) {
  if (is_a_point(curve)) {
    diagnostics_->add({curve.point_lines.back(), 1}, errors::kCurveIsAPoint,
                      joined({name, ": the curve has zero length and is left out"}));
    return true;
  }
  if (weight_ratio(curve) > kLargestWeightRatio) {
    diagnostics_->add({curve.point_lines.back(), 1}, errors::kWeightsFarApart,
                      joined({name, ": the weights differ by more than a factor of 1e6"}));
  }
  const Point end = curve.points.back().position_mm;
  Move& move = push_move();
  move.shape = std::move(curve);
  move.source = curve_source_;
  move.feedrate_mm_s = curve_feedrate_mm_s_;
  state_.position_mm = end;
  return true;
}

void Interpreter::abandon_curve() {
  const bool nurbs = nurbs_.active();
  state_.position_mm = nurbs ? nurbs_.last_point_mm() : uniform_.last_point_mm();
  skipped_curve_ = nurbs ? kG62 : kG52;
  nurbs_.abort();
  uniform_.abort();
}

// The block that should have begun a curve has an error: the curve's blocks mean nothing.
void Interpreter::skip_curve_of_wrong_block() {
  for (std::size_t i = 0; i < block_->g_count; ++i) {
    for (const Tenths code : {kG52, kG62}) {
      if (std::fabs(block_->g[i].value * 10.0 - code) < 1e-8) {
        skipped_curve_ = code;
      }
    }
  }
}

// After an error in a curve its blocks are passed over up to the next other code of group 1, the
// start of a new curve, or the end of the program. True: the block is to be run.
bool Interpreter::leave_skipped_curve() {
  const Tenths code = codes_[Group::motion];
  const bool new_curve = code == skipped_curve_ && code == kG62 && block_->has('P');
  const bool other = code != kNoCode && code != skipped_curve_;
  if (!new_curve && !other && !ends_program(codes_)) {
    return false;
  }
  skipped_curve_ = kNoCode;
  state_.motion = Motion::none;
  return code != kG53 && code != kG63;
}

}  // namespace kerf::parser
