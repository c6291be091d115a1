#include "tests/kernel/chord_checker.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace kerf::test {

namespace {

constexpr int kPartsOfStretch = 8;  // of a stretch between two ticks
constexpr int kMaxSteps = 40;
constexpr double kSameParameter = 1e-14;
// What the scan's straight lines between its samples may miss of a curve's bound.
constexpr double kRelativeToChord = 1e-3;
// The kernel looks at the quarters of a tick, this checker closer: where the path bends unevenly
// the kernel sees less of it.
constexpr double kMinAccount = 0.3;

Vec minus(const Vec& a, const Vec& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double dot(const Vec& a, const Vec& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double norm(const Vec& a) {
  return std::sqrt(dot(a, a));
}

struct Chord {
  Vec from_mm{};
  Vec to_mm{};
};

double distance_mm(const Vec& point, const Chord& chord) {
  const Vec along = minus(chord.to_mm, chord.from_mm);
  const Vec offset = minus(point, chord.from_mm);
  const double squared = dot(along, along);
  const double share = squared > 0.0 ? std::clamp(dot(offset, along) / squared, 0.0, 1.0) : 0.0;
  return norm(
      {offset[0] - share * along[0], offset[1] - share * along[1], offset[2] - share * along[2]});
}

struct Range {
  double begin = 0.0;
  double end = 0.0;
};

// Of the points that part the range of a stretch evenly, then of those a half and a quarter of
// their distance beside the farthest.
double farthest_mm(const Stretch& stretch, const Range& u, const Chord& chord) {
  const double apart = (u.end - u.begin) / kPartsOfStretch;
  double worst_mm = 0.0;
  double worst_u = u.begin;
  const auto look = [&](double at) {
    const double found_mm = distance_mm(stretch.at_mm(at), chord);
    worst_u = found_mm > worst_mm ? at : worst_u;
    worst_mm = std::max(worst_mm, found_mm);
  };
  for (int k = 0; k <= kPartsOfStretch; ++k) {
    look(u.begin + apart * k);
  }
  for (const double beside : {0.5 * apart, 0.25 * apart}) {
    const double middle = worst_u;
    look(std::max(middle - beside, u.begin));
    look(std::min(middle + beside, u.end));
  }
  return worst_mm;
}

Vec slope(const Stretch& stretch, double u) {
  constexpr double kStep = 1e-5;
  const double from = std::min(u, 1.0 - kStep);
  const Vec difference = minus(stretch.at_mm(from + kStep), stretch.at_mm(from));
  return {difference[0] / kStep, difference[1] / kStep, difference[2] / kStep};
}

// The step from a parameter to where the stretch, straight on, comes closest to a point.
double step_to(const Stretch& stretch, const Vec& point_mm, double u) {
  const Vec d = slope(stretch, u);
  return dot(minus(point_mm, stretch.at_mm(u)), d) / dot(d, d);
}

// Where the stretch's speed over its parameter changes so much that whole steps lead to and fro:
// no step farther away is taken, half of it instead.
double closest_in_halves(const Stretch& stretch, const Vec& point_mm, double u_from) {
  const auto away_mm = [&](double u) { return norm(minus(stretch.at_mm(u), point_mm)); };
  double u = u_from;
  for (int i = 0; i < kMaxSteps; ++i) {
    double step = step_to(stretch, point_mm, u);
    while (std::abs(step) > kSameParameter &&
           away_mm(std::clamp(u + step, u_from, 1.0)) > away_mm(u)) {
      step *= 0.5;
    }
    if (std::abs(step) <= kSameParameter) {
      break;
    }
    u = std::clamp(u + step, u_from, 1.0);
  }
  return u;
}

// The parameter from u_from on where the stretch comes closest to a point not far from there
// (Newton's method).
double closest(const Stretch& stretch, const Vec& point_mm, double u_from) {
  double u = u_from;
  for (int i = 0; i < kMaxSteps; ++i) {
    const double before = u;
    u = std::clamp(u + step_to(stretch, point_mm, u), u_from, 1.0);
    if (std::abs(u - before) < kSameParameter) {
      return u;
    }
  }
  return closest_in_halves(stretch, point_mm, u_from);
}

}  // namespace

ChordChecker::Place ChordChecker::find(const Vec& point_mm, const Place& from) const {
  for (Place place = from; place.stretch < path_->size(); ++place.stretch, place.u = 0.0) {
    const Stretch& stretch = (*path_)[place.stretch];
    place.u = closest(stretch, point_mm, place.u);
    if (norm(minus(stretch.at_mm(place.u), point_mm)) <= stretch.freedom_mm) {
      return place;
    }
  }
  return {.stretch = path_->size()};
}

double ChordChecker::chord_error_mm(const Place& from, const Place& to) const {
  const Chord chord{.from_mm = (*path_)[from.stretch].at_mm(from.u),
                    .to_mm = (*path_)[to.stretch].at_mm(to.u)};
  double worst = 0.0;
  for (std::size_t i = from.stretch; i <= to.stretch; ++i) {
    const double begin = i == from.stretch ? from.u : 0.0;
    const double end = i == to.stretch ? to.u : 1.0;
    worst = std::max(worst, farthest_mm((*path_)[i], {.begin = begin, .end = end}, chord));
  }
  return worst;
}

// After a corner that turns back the path runs so close to itself that only the block tells where
// a tick is.
ChordChecker::Place ChordChecker::first_of_line(std::size_t line, const Place& from) const {
  Place place = from;
  while (place.stretch < path_->size() && (*path_)[place.stretch].line < line) {
    place = {.stretch = place.stretch + 1};
  }
  return place.stretch < path_->size() ? place : from;
}

void ChordChecker::add(const interp::Setpoint& setpoint, double kernel_says_mm) {
  if (!complaint_.empty() || setpoint.position_mm == position_mm_) {
    return;
  }
  position_mm_ = setpoint.position_mm;
  const Place before = here_;
  here_ = find(position_mm_, first_of_line(setpoint.line, before));
  if (here_.stretch == path_->size()) {
    complain("distance from the path", 0.0, 0.0, setpoint);
    return;
  }
  const double found_mm = chord_error_mm(before, here_);
  largest_mm_ = std::max(largest_mm_, found_mm);
  const double freedom_mm =
      4.0 * std::max((*path_)[before.stretch].freedom_mm, (*path_)[here_.stretch].freedom_mm);
  const double limit_mm = tolerance_mm_ * (1.0 + kRelativeToChord) + freedom_mm;
  if (!(found_mm <= limit_mm)) {
    complain("chord error", found_mm, limit_mm, setpoint);
  }
  if (!(kernel_says_mm <= limit_mm)) {
    complain("chord error by the kernel's account", kernel_says_mm, limit_mm, setpoint);
  }
  if (!(kernel_says_mm >= kMinAccount * found_mm - freedom_mm)) {
    complain("too little of the chord error seen by the kernel", kernel_says_mm, found_mm,
             setpoint);
  }
}

void ChordChecker::complain(const std::string& what, double found_mm, double limit_mm,
                            const interp::Setpoint& setpoint) {
  if (!complaint_.empty()) {
    return;
  }
  std::ostringstream text;
  text.precision(12);
  text << what << " " << found_mm << " against " << limit_mm << " mm at tick " << setpoint.tick
       << ", line " << setpoint.line << ", s " << setpoint.s_mm;
  complaint_ = text.str();
}

}  // namespace kerf::test
