// Where two held curves meet, whether the tool can reach them, and what it would cut into.
#include <algorithm>
#include <cmath>
#include <utility>

#include "diagnostics/errors/pages.hpp"
#include "parser/compensation/cutter_compensation.hpp"
#include "parser/compensation/gouge.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

// Cuts that are no deeper come of coordinates written with two decimals where the tool fits
// exactly.
constexpr double kCoordinateRounding_mm = 0.01;

std::string line_of(const Move& move) {
  return joined({"line ", std::to_string(move.source.line)});
}

}  // namespace

void CutterCompensation::join(HeldMove& first, HeldMove& second) {
  const OffsetCorner corner = corner_between(first.curve, second.curve, left_mm());
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

void CutterCompensation::join_inside(HeldMove& first, HeldMove& second,
                                     const OffsetCorner& corner) {
  first.lost_at_end_mm = corner.first_loses_mm;
  second.lost_at_start_mm = corner.second_loses_mm;
  if (!has_room(first) || !has_room(second)) {
    first.lost_at_end_mm = second.lost_at_start_mm = 0.0;
    second.run = run_;
    return;
  }
  const auto lose = [](planar::ContourElement& way, double lost_mm, double radius_mm) {
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

bool CutterCompensation::is_first(const HeldMove& move) const {
  return !held_.empty() && held_.front().role == HeldRole::entry &&
         held_.front().number + 1 == move.number;
}

// Where a contour runs on beyond its beginning, what is beyond is no wall.
void CutterCompensation::cut_off_overrun(const HeldMove& first, HeldMove& newest) {
  if (newest.number > first.number + 1 && starts_on(first, newest)) {
    newest.wall = up_to(newest.curve.programmed, first.curve.programmed.start_mm);
  }
}

// Where the newest move meets the contour before it.
CutterCompensation::Meeting CutterCompensation::meeting_of(HeldMove& newest) {
  const bool closed = is_closed(newest);
  Meeting meeting;
  for (const HeldMove& held : held_) {
    if (held.role != HeldRole::contour || held.number == newest.number) {
      continue;
    }
    if (is_first(held)) {
      cut_off_overrun(held, newest);
    }
    const bool neighbour = held.number + 1 == newest.number;
    meeting.returns = meeting.returns || (neighbour ? is_closed(held) : starts_on(newest, held));
    if (neighbour ? closed : ends_on(held, newest)) {
      meeting.leads_up_to = held.number;
    }
  }
  return meeting;
}

// Which moves are no walls; told as soon as a move is known, before anything is compared with it.
void CutterCompensation::find_leads(HeldMove& newest) {
  constexpr int kLeadOut = 2;
  const auto [returns, leads_up_to] = meeting_of(newest);
  leads_left_ = returns ? kLeadOut : leads_left_;
  newest.lead = leads_left_ > 0 || is_first(newest);
  leads_left_ -= leads_left_ > 0 ? 1 : 0;
  for (HeldMove& held : held_) {
    const bool part_of_contour = !newest.lead && meet_at_seam(held, newest);
    held.lead = (held.lead && !part_of_contour) || held.number <= leads_up_to;
  }
}

// Both ends of the move are settled and what it is: how its way and the contours up to it go
// together, and the ways before it and its contour.
void CutterCompensation::settle(HeldMove& move) {
  std::vector<Cut> cuts = cuts_of(move);
  for (HeldMove& mover : held_) {
    if (const double depth = depth_of_cut_mm(mover, move, start_.radius_mm);
        mover.number < move.number && depth > 0.0) {
      cuts.push_back({&mover, &move, depth});
    }
  }
  report(std::move(cuts));
}

std::vector<CutterCompensation::Cut> CutterCompensation::cuts_of(HeldMove& mover) {
  std::vector<Cut> cuts;
  for (HeldMove& contour : held_) {
    if (const double depth = depth_of_cut_mm(mover, contour, start_.radius_mm);
        contour.number <= mover.number && depth > 0.0) {
      cuts.push_back({&mover, &contour, depth});
    }
  }
  return cuts;
}

// One move is told of once, so the errors come first and the deepest cuts before the others.
void CutterCompensation::report(std::vector<Cut> cuts) {
  const auto order = [](const Cut& cut) { return std::pair(!cut.is_error(), -cut.depth_mm); };
  std::stable_sort(cuts.begin(), cuts.end(),
                   [&](const Cut& a, const Cut& b) { return order(a) < order(b); });
  for (const Cut& cut : cuts) {
    if (!cut.mover->faulty && !cut.contour->faulty) {
      report_cut(cut);
    }
  }
}

void CutterCompensation::settle_last() {
  if (HeldMove* const last = last_curve(); last != nullptr) {
    settle(*last);
  }
}

bool CutterCompensation::Cut::is_error() const {
  return mover->role == HeldRole::contour && depth_mm > kCoordinateRounding_mm &&
         !meet_at_seam(*mover, *contour);
}

void CutterCompensation::report_cut(const Cut& cut) {
  const std::string what =
      joined({"the tool (radius ", in_mm(start_.radius_mm), " mm) would cut ", in_mm(cut.depth_mm),
              " mm into the contour of ", line_of(cut.contour->move)});
  if (cut.is_error()) {
    blame(*cut.mover, errors::kCompensationGouge, joined({"on this move ", what}));
    cut.contour->faulty = true;
  } else if (cut.mover->role == HeldRole::entry) {
    blame(*cut.mover, errors::kCompensationEntryGouges, joined({"on the entry move ", what}));
  } else if (cut.mover->role == HeldRole::exit) {
    blame(*cut.mover, errors::kCompensationExitGouges, joined({"on the exit move ", what}));
  } else if (cut.depth_mm <= kCoordinateRounding_mm) {
    blame(*cut.mover, errors::kCompensationScratch, joined({"on this move ", what}));
  } else {
    blame(*cut.mover, errors::kCompensationSeam,
          joined({"the contour begins and ends in an inside corner: ", what}));
  }
}

void CutterCompensation::blame(HeldMove& held, const diagnostics::ErrorPage& page,
                               std::string message) {
  if (!held.faulty) {
    held.fault = ContourFault{held.place, &page, std::move(message)};
  }
  held.faulty = true;
  if (page.severity == diagnostics::Severity::error) {
    ++run_;  // what comes after is not measured against a contour that is wrong already
  }
}

}  // namespace kerf::parser
