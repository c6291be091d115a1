// Where two held curves meet, whether the tool can reach them, and what it would cut into.
#include <cmath>

#include "parser/compensation/cutter_compensation.hpp"
#include "parser/compensation/gouge.hpp"
#include "parser/errors/compensation.hpp"
#include "parser/text.hpp"

namespace kerf::parser {

namespace {

std::string line_of(const Move& move) {
  return joined({"line ", std::to_string(move.source.line)});
}

}  // namespace

void CutterCompensation::join(HeldMove& first, HeldMove& second) {
  const Corner corner = corner_between(first.curve, second.curve, left_mm());
  if (corner.kind == CornerKind::too_tight) {
    blame(second, errors::kCompensationCornerTooTight,
          joined({"the tool (radius ", in_mm(start_.radius_mm),
                  " mm) does not fit into the inside corner between ", line_of(first.move),
                  " and this move"}));
    second.run = run_;
    return;
  }
  if (corner.kind == CornerKind::inside) {
    join_inside(first, second, corner);
    return;
  }
  first.way.end_mm = corner.first_end_mm;
  second.way.start_mm = corner.second_start_mm;
  if (corner.kind == CornerKind::outside) {
    second.has_corner = true;
    second.corner = {corner.first_end_mm, corner.second_start_mm, second.curve.programmed.start_mm};
    second.corner.sweep_rad =
        turn_rad(second.corner.start_mm - second.corner.centre_mm,
                 second.corner.end_mm - second.corner.centre_mm, left_mm() > 0.0);
    if (first.role == HeldRole::entry) {
      first.has_corner = second.corner_is_of_entry = true;
      first.corner = second.corner;
    }
  }
}

void CutterCompensation::join_inside(HeldMove& first, HeldMove& second, const Corner& corner) {
  first.lost_at_end_mm = corner.first_loses_mm;
  second.lost_at_start_mm = corner.second_loses_mm;
  if (!has_room(first) || !has_room(second)) {
    first.lost_at_end_mm = second.lost_at_start_mm = 0.0;
    second.run = run_;
    return;
  }
  const auto lose = [](planar::Curve& way, double lost_mm, double radius_mm) {
    if (way.is_arc()) {
      way.sweep_rad -= std::copysign(lost_mm / radius_mm, way.sweep_rad);
    }
  };
  lose(first.way, corner.first_loses_mm, first.curve.path.end_radius_mm());
  lose(second.way, corner.second_loses_mm, second.curve.path.start_radius_mm());
  first.way.end_mm = second.way.start_mm = corner.first_end_mm;
}

// An entry has no start on the contour that a corner could reach.
bool CutterCompensation::has_room(HeldMove& held) {
  constexpr double kNoise_mm = 1e-7;
  const double lost = held.lost_at_start_mm + held.lost_at_end_mm;
  const double whole = length_mm(held.curve.path);
  if (held.role == HeldRole::entry || lost <= whole + kNoise_mm) {
    return true;
  }
  blame(held, errors::kCompensationMoveTooShort,
        joined({"the tool (radius ", in_mm(start_.radius_mm), " mm) cannot reach ",
                line_of(held.move), " without gouging: its path beside this move is ", in_mm(whole),
                " mm long, the inside corners at its ends take ", in_mm(lost), " mm"}));
  return false;
}

// The way past `mover` is known now: what does it cut most?
void CutterCompensation::settle(HeldMove& mover) {
  double deepest = 0.0;
  HeldMove* cut = nullptr;
  for (HeldMove& contour : held_) {
    const double depth = depth_of_cut_mm(mover, contour, start_.radius_mm);
    if (depth > deepest && !is_lead(held_, mover, contour)) {
      deepest = depth;
      cut = &contour;
    }
  }
  if (cut != nullptr) {
    report_cut(mover, *cut, deepest);
  }
}

// The contour of the newest move is known now: which way before it cuts it most?
void CutterCompensation::settle_behind(HeldMove& contour) {
  double deepest = 0.0;
  HeldMove* cutter = nullptr;
  for (HeldMove& mover : held_) {
    const double depth =
        &mover != &contour ? depth_of_cut_mm(mover, contour, start_.radius_mm) : 0.0;
    if (depth > deepest && !is_lead(held_, mover, contour)) {
      deepest = depth;
      cutter = &mover;
    }
  }
  if (cutter != nullptr) {
    report_cut(*cutter, contour, deepest);
  }
}

void CutterCompensation::settle_last() {
  if (HeldMove* const last = last_curve(); last != nullptr) {
    settle(*last);
  }
}

void CutterCompensation::report_cut(HeldMove& mover, HeldMove& contour, double depth_mm) {
  const std::string cut =
      joined({"the tool (radius ", in_mm(start_.radius_mm), " mm) would cut ", in_mm(depth_mm),
              " mm into the contour of ", line_of(contour.move)});
  const bool seam = mover.role == HeldRole::contour && meet_at_seam(mover, contour);
  if (mover.role == HeldRole::contour && !seam) {
    blame(mover, errors::kCompensationGouge, joined({"on this move ", cut}));
    contour.faulty = true;
    return;
  }
  if (seam) {
    blame(mover, errors::kCompensationSeam,
          joined({"the contour begins and ends in an inside corner: ", cut}));
  } else if (mover.role == HeldRole::entry) {
    blame(mover, errors::kCompensationEntryGouges, joined({"on the entry move ", cut}));
  } else {
    blame(mover, errors::kCompensationExitGouges, joined({"on the exit move ", cut}));
  }
}

void CutterCompensation::blame(HeldMove& held, const ErrorPage& page, std::string message) {
  if (!held.faulty) {
    held.fault = HeldFault{std::move(message), &page};
  }
  held.faulty = true;
  if (page.severity == Severity::error) {
    ++run_;  // what comes behind is not measured against a contour that is wrong already
  }
}

}  // namespace kerf::parser
