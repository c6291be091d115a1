// The sharpest places of a path, for their line numbers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "curves/position.hpp"
#include "programs/kerf/plot/projection.hpp"

namespace kerf::program {

struct SharpPlace {
  PaperPoint at{};
  std::uint32_t line = 0;
  double turn_rad = 0.0;  // within some pixels
};

// Follows what is cut in chords of a length that can be seen, so that a corner counts alike whether
// it is exact or rounded a little. Memory is bounded: of each part of the paper the sharpest place.
class SharpPlaces {
 public:
  SharpPlaces(View view, const PaperBox& box);

  // Points of the path, one after the other.
  void add(const curves::Position& at_mm, std::uint32_t line, bool rapid);

  // At most so many, the sharpest first, one of each line, none near another one.
  [[nodiscard]] std::vector<SharpPlace> sharpest(std::size_t count) const;

 private:
  struct Chord {
    curves::Position begin_mm{};
    std::array<double, 3> direction{};
    std::uint32_t line = 0;  // where it begins
  };
  static constexpr std::size_t kCells = 24;  // in a row

  void take(const Chord& chord);
  void keep(const SharpPlace& place);

  View view_;
  PaperBox box_;
  double cell_mm_;
  double chord_mm_;
  std::optional<curves::Position> begin_mm_;  // of the present chord
  std::uint32_t line_ = 0;                    // there
  std::array<Chord, 2> last_{};               // chords, the older one first
  std::size_t chords_ = 0;                    // of them
  std::vector<SharpPlace> sharpest_;          // of each cell; turn_rad 0: none
};

}  // namespace kerf::program
