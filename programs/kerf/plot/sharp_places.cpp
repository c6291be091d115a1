#include "programs/kerf/plot/sharp_places.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::program {

namespace {

constexpr double kMinTurn_rad = 0.5;
constexpr double kChords = 350.0;  // in the size of the picture: some two pixels

}  // namespace

SharpPlaces::SharpPlaces(View view, const PaperBox& box)
    : view_(view),
      box_(box),
      cell_mm_(std::max({box.width_mm(), box.height_mm(), 1e-9}) / static_cast<double>(kCells)),
      chord_mm_(cell_mm_ * static_cast<double>(kCells) / kChords),
      sharpest_((kCells + 1) * (kCells + 1)) {}

void SharpPlaces::add(const curves::Position& at_mm, std::uint32_t line, bool rapid) {
  if (rapid || !begin_mm_) {
    begin_mm_ = at_mm;
    line_ = line;
    chords_ = 0;
    return;
  }
  const std::array<double, 3> way{at_mm[0] - (*begin_mm_)[0], at_mm[1] - (*begin_mm_)[1],
                                  at_mm[2] - (*begin_mm_)[2]};
  const double length_mm = std::hypot(way[0], way[1], way[2]);
  if (length_mm < chord_mm_) {
    return;
  }
  take({.begin_mm = *begin_mm_,
        .direction = {way[0] / length_mm, way[1] / length_mm, way[2] / length_mm},
        .line = line_});
  begin_mm_ = at_mm;
  line_ = line;
}

// The corner may lie within the chord between: so the turn is over three of them.
void SharpPlaces::take(const Chord& chord) {
  if (chords_ == last_.size()) {
    const auto& before = last_[0].direction;
    const auto& after = chord.direction;
    const double cosine = before[0] * after[0] + before[1] * after[1] + before[2] * after[2];
    const double turn_rad = std::acos(std::clamp(cosine, -1.0, 1.0));
    if (turn_rad >= kMinTurn_rad) {
      keep({.at = project(view_, chord.begin_mm), .line = last_[1].line, .turn_rad = turn_rad});
    }
  }
  last_[0] = last_[1];
  last_[1] = chord;
  chords_ = std::min(chords_ + 1, last_.size());
}

void SharpPlaces::keep(const SharpPlace& place) {
  const auto index = [this](double distance_mm) {
    return static_cast<std::size_t>(
        std::clamp(distance_mm / cell_mm_, 0.0, static_cast<double>(kCells)));
  };
  SharpPlace& cell = sharpest_[index(place.at.v_mm - box_.min.v_mm) * (kCells + 1) +
                               index(place.at.u_mm - box_.min.u_mm)];
  if (place.turn_rad > cell.turn_rad) {
    cell = place;
  }
}

std::vector<SharpPlace> SharpPlaces::sharpest(std::size_t count) const {
  std::vector<SharpPlace> places;
  std::copy_if(sharpest_.begin(), sharpest_.end(), std::back_inserter(places),
               [](const SharpPlace& place) { return place.turn_rad > 0.0; });
  std::stable_sort(places.begin(), places.end(), [](const SharpPlace& a, const SharpPlace& b) {
    return a.turn_rad > b.turn_rad;
  });
  const double near_mm = 2.0 * cell_mm_;
  std::vector<SharpPlace> chosen;
  for (const SharpPlace& place : places) {
    const bool is_near = std::any_of(chosen.begin(), chosen.end(), [&](const SharpPlace& other) {
      return other.line == place.line ||
             std::hypot(other.at.u_mm - place.at.u_mm, other.at.v_mm - place.at.v_mm) < near_mm;
    });
    if (!is_near && chosen.size() < count) {
      chosen.push_back(place);
    }
  }
  return chosen;
}

}  // namespace kerf::program
