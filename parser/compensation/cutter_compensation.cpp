#include "parser/compensation/cutter_compensation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "diagnostics/errors/pages.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

// Less motion in the plane than this has no direction.
constexpr double kMinMotion_mm = 1e-7;

// From the centre of the tip to the controlled point, in radii along Z and X.
constexpr std::array<planar::Vec, 10> kTips = {
    {{0, 0}, {1, -1}, {-1, -1}, {-1, 1}, {1, 1}, {1, 0}, {0, -1}, {-1, 0}, {0, 1}, {0, 0}}};

const Point* end_of(const Move& move) {
  if (const auto* line = std::get_if<LineMove>(&move.shape)) {
    return &line->end_mm;
  }
  const auto* arc = std::get_if<ArcMove>(&move.shape);
  return arc != nullptr ? &arc->end_mm : nullptr;
}

}  // namespace

void CutterCompensation::start(const CompensationStart& start) {
  displaced_ = placed_ = leaving_;
  send_all();
  leaving_ = false;
  on_ = true;
  entered_ = false;
  start_ = start;
  const planar::Vec tip = kTips.at(static_cast<std::size_t>(start.orientation));
  sender_.set_frame(start.plane, start.plane == Plane::zx ? start.radius_mm * tip : planar::Vec{});
}

void CutterCompensation::stop() {
  settle_last();
  leads_left_ = 0;
  leaving_ = entered_ || displaced_;
  on_ = false;
}

void CutterCompensation::finish(const diagnostics::DiagnosticPlace& place) {
  if (on_) {
    faults_.push_back({place, &errors::kCompensationLeftOn,
                       "cutter compensation is still on at the program's end (G40 is missing)"});
  }
  settle_last();
  send_all();
  on_ = leaving_ = false;
}

void CutterCompensation::take(const Move& move, diagnostics::DiagnosticPlace place) {
  place_ = std::move(place);
  if (!busy() || (start_.radius_mm == 0.0 && !displaced_)) {
    ready().push() = move;
    leaving_ = false;
    return;
  }
  if (!placed_) {
    sender_.set_place(move.start_mm);
    placed_ = true;
  }
  if (const auto* arc = std::get_if<ArcMove>(&move.shape);
      arc != nullptr && !moves_in_plane(move)) {
    Move rise = move;  // no contour has a turn so small
    rise.shape = LineMove{arc->end_mm};
    take_compensated(rise);
  } else {
    take_compensated(move);
  }
}

void CutterCompensation::take_compensated(const Move& move) {
  if (leaving_) {
    take_exit(move);
  } else if (!moves_in_plane(move)) {
    hold_idle(move);
  } else if (!entered_) {
    take_entry(move);
  } else {
    take_contour(move);
  }
}

bool CutterCompensation::moves_in_plane(const Move& move) const {
  if (const auto* line = std::get_if<LineMove>(&move.shape)) {
    return length(sender_.in_plane(line->end_mm) - sender_.in_plane(move.start_mm)) > kMinMotion_mm;
  }
  return std::holds_alternative<ArcMove>(move.shape) && length_mm(curve_of(move)) > kMinMotion_mm;
}

planar::ContourElement CutterCompensation::curve_of(const Move& move) const {
  planar::ContourElement curve{
      sender_.in_plane(move.start_mm), sender_.in_plane(*end_of(move)), {}};
  if (const auto* arc = std::get_if<ArcMove>(&move.shape)) {
    curve.centre_mm = sender_.in_plane(arc->centre_mm);
    curve.sweep_rad =
        turn_rad(curve.start_mm - curve.centre_mm, curve.end_mm - curve.centre_mm, arc->clockwise);
    const bool closed = curve.start_mm == curve.end_mm || curve.sweep_rad == 0.0;
    const double whole = planar::kTurn_rad * (arc->turns - (closed ? 0 : 1));
    curve.sweep_rad = (closed ? 0.0 : curve.sweep_rad) + (arc->clockwise ? -whole : whole);
  }
  return curve;
}

HeldMove& CutterCompensation::hold(const Move& move, HeldRole role) {
  HeldMove& held = held_.emplace_back();
  held.move = move;
  held.role = role;
  if (role == HeldRole::idle) {
    return held;
  }
  ++curves_;
  held.place = place_;
  held.curve.programmed = held.wall = curve_of(move);
  const std::size_t normal = axes_of(start_.plane).normal;
  const double from = move.start_mm[normal];
  const double to = (*end_of(move))[normal];
  held.low_mm = std::min(from, to);
  held.high_mm = std::max(from, to);
  held.run = run_;
  held.number = ++number_;
  return held;
}

void CutterCompensation::hold_idle(const Move& move) {
  hold(move, HeldRole::idle);
  if (!entered_) {
    send_all();
  } else if (held_.size() >= kMaxHeld) {
    faults_.push_back({place_, &errors::kCompensationHoldsTooMuch,
                       joined({"cutter compensation: ", std::to_string(kMaxHeld),
                               " blocks without motion in the plane, the corner after them "
                               "cannot be looked up"})});
    settle_last();
    send_all();
  }
}

void CutterCompensation::take_entry(const Move& move) {
  entered_ = true;
  if (std::holds_alternative<ArcMove>(move.shape)) {
    const std::string_view name = start_.side == CutterSide::left ? "G41" : "G42";
    faults_.push_back({place_, &errors::kCompensationStartedOnArc,
                       joined({name, " must start on a G0 or G1 move, not on an arc"})});
    sender_.set_place(*end_of(move));
    return;
  }
  HeldMove& held = hold(move, HeldRole::entry);
  const double size = length_mm(held.curve.programmed);
  held.curve.path = held.way = *offset(held.curve.programmed, left_mm());
  held.way.start_mm = sender_.centre_mm();
  if (size <= start_.radius_mm) {
    blame(held, errors::kCompensationEntryTooShort,
          joined({"the entry move into cutter compensation is ", in_mm(size),
                  " mm long, it must be longer than the tool radius of ", in_mm(start_.radius_mm),
                  " mm"}));
  }
  if (start_.radius_mm == 0.0) {  // it leads from beside a contour to the path; the rest is that
    settle_last();
    send_all();
    displaced_ = false;
  }
}

void CutterCompensation::take_contour(const Move& move) {
  HeldMove* const first = goes_on_at(move.start_mm) ? last_curve() : nullptr;
  HeldMove& second = hold(move, HeldRole::contour);
  if (move.rapid) {
    second.run = 0;
    ++run_;
  }
  const std::optional<planar::ContourElement> path = offset(second.curve.programmed, left_mm());
  if (!path) {
    const planar::ContourElement& arc = second.curve.programmed;
    blame(second, errors::kCompensationArcTooSmall,
          joined({"the tool does not fit inside the arc: radius ",
                  in_mm(std::min(arc.start_radius_mm(), arc.end_radius_mm())),
                  " mm, the tool's is ", in_mm(start_.radius_mm), " mm"}));
    if (first != nullptr) {
      settle(*first);
    }
    second.left_out = true;
    send_all();
    return;
  }
  second.curve.path = second.way = *path;
  find_leads(second);
  if (first != nullptr) {
    join(*first, second);
    settle(*first);
  }
  send_surplus();
}

void CutterCompensation::take_exit(const Move& move) {
  const bool is_arc = std::holds_alternative<ArcMove>(move.shape);
  const bool is_curve = std::holds_alternative<NurbsMove>(move.shape);
  if (end_of(move) == nullptr && !is_curve) {
    hold(move, HeldRole::idle);
    return;
  }
  if (is_arc || is_curve) {
    faults_.push_back({place_, &errors::kCompensationExitOnArc,
                       joined({"the first move after G40 must be a straight line, not ",
                               is_arc ? "an arc" : "a curve"})});
    send_all();
    ready().push() = move;
  } else {
    HeldMove& held = hold(move, HeldRole::exit);
    const HeldMove* const before = last_curve();
    held.way = {before != nullptr ? before->way.end_mm : sender_.centre_mm(),
                sender_.centre_for(*end_of(move)),
                {}};
    report(cuts_of(held));
    send_all();
  }
  leaving_ = false;
}

}  // namespace kerf::parser
