#include "programs/kerf/run/first_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>

#include "kernel/reader_options.hpp"
#include "parser/moves/short_moves.hpp"
#include "parser/program_reader.hpp"
#include "programs/kerf/io/interrupt.hpp"

namespace kerf::program {

namespace {

constexpr double kRounding_mm = 1e-9;

// Where a block brings an axis.
struct FirstPlace {
  std::uint64_t block = 0;  // as Move::block
  double mm = 0.0;
};

enum class LookAt : std::uint8_t { rapids, cuts };

class FirstPlaces {
 public:
  // False: what follows does not matter.
  bool look_at(const parser::Move& move, LookAt what) {
    const parser::Point* const end = parser::end_mm(move);
    if (end == nullptr) {
      return true;
    }
    if (!move.rapid && what == LookAt::rapids) {
      return false;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (!places_[k] && (*end)[k] != move.start_mm[k]) {
        places_[k] = FirstPlace{.block = move.block, .mm = (*end)[k]};
        of_curve_ = of_curve_ || !std::holds_alternative<parser::LineMove>(move.shape);
      }
    }
    return move.rapid && !(places_[0] && places_[1] && places_[2]);
  }
  // One of them is where an arc or a curve ends, whose way there depends on where it begins.
  [[nodiscard]] bool of_curve() const { return of_curve_; }
  [[nodiscard]] bool is_empty() const { return !places_[0] && !places_[1] && !places_[2]; }

  [[nodiscard]] Position from(const Position& start_mm) const {
    Position position = start_mm;
    for (std::size_t k = 0; k < 3; ++k) {
      position[k] = places_[k] ? places_[k]->mm : start_mm[k];
    }
    return position;
  }

  // The last block that counts.
  [[nodiscard]] std::uint64_t last_block() const {
    std::uint64_t last = 0;
    for (const auto& place : places_) {
      last = place ? std::max(last, place->block) : last;
    }
    return last;
  }

  // As read from another start: they depend on none.
  [[nodiscard]] bool lead_as(const FirstPlaces& other) const {
    const auto is_same = [](const auto& one, const auto& two) {
      return one.has_value() == two.has_value() &&
             (!one || (one->block == two->block && std::abs(one->mm - two->mm) <= kRounding_mm));
    };
    return std::equal(places_.begin(), places_.end(), other.places_.begin(), is_same);
  }
  // The same blocks, if they move it, bring the tool to the same places. False: they do not.
  [[nodiscard]] bool agrees(const parser::Move& move) const {
    const parser::Point* const end = parser::end_mm(move);
    for (std::size_t k = 0; end != nullptr && k < 3; ++k) {
      if (places_[k] && places_[k]->block == move.block &&
          std::abs(places_[k]->mm - (*end)[k]) > kRounding_mm) {
        return false;
      }
    }
    return true;
  }

 private:
  std::array<std::optional<FirstPlace>, 3> places_{};
  bool of_curve_ = false;
};

// A rapid to where the tool is already is no move, so rapids are read from where no program leads.
Position away_from(Position start_mm, double times) {
  for (double& mm : start_mm) {
    mm += times * 0.123456789;
  }
  return start_mm;
}

// A program that goes on for longer before its first cut may be a loop that never cuts.
constexpr int kMaxMoves = 1'000'000;

// Shows the moves from the file's begin on, until it is told that the next does not matter. Error:
// the file cannot be read.
tl::expected<void, std::string> read_moves(
    ProgramFile& file, const parser::ReaderOptions& options,
    const std::function<bool(const parser::Move&)>& look_at) {
  parser::ProgramReader reader(options);
  file.rewind();
  int moves = 0;
  bool goes_on = true;
  while (goes_on) {
    const auto piece = file.read();
    if (!piece) {
      return tl::unexpected(piece.error());
    }
    goes_on = !piece->empty();
    goes_on ? reader.feed(*piece) : reader.finish();
    for (parser::Move move; reader.next(move);) {
      if (stop_requested() || ++moves == kMaxMoves || reader.has_errors() || !look_at(move)) {
        goes_on = false;
        break;
      }
    }
    goes_on = goes_on && !reader.at_end() && !stop_requested();
  }
  file.rewind();
  return {};
}

}  // namespace

tl::expected<Position, std::string> first_places(ProgramFile& file, const MachineSettings& settings,
                                                 const KernelOptions& options) {
  parser::ReaderOptions from = reader_options(settings, options);
  const auto read_from = [&](const Position& start_mm, const auto& look_at) {
    from.start_mm = start_mm;
    return read_moves(file, from, look_at);
  };
  FirstPlaces places;
  FirstPlaces again;
  auto read = read_from(away_from(options.start_mm, 1.0), [&](const parser::Move& move) {
    return places.look_at(move, LookAt::rapids);
  });
  bool agrees = true;
  if (read && !places.is_empty()) {
    read = read_from(away_from(options.start_mm, 2.0),
                     [&](const parser::Move& move) { return again.look_at(move, LookAt::rapids); });
    agrees = places.lead_as(again);
  } else if (read) {
    // A cut may be an arc, which there is from its own start alone. A line must lead to the same
    // places from where it leads.
    read = read_from(options.start_mm,
                     [&](const parser::Move& move) { return places.look_at(move, LookAt::cuts); });
    if (read && !places.of_curve()) {
      read = read_from(places.from(options.start_mm), [&](const parser::Move& move) {
        agrees = agrees && places.agrees(move);
        return agrees && move.block <= places.last_block();
      });
    }
  }
  if (!read) {
    return tl::unexpected(read.error());
  }
  if (!agrees || places.of_curve()) {
    return tl::unexpected(
        file.name() + ": its first " +
        (agrees ? "move is a curve, whose way depends on" : "moves are relative to") +
        " the start" + (agrees ? "" : " (G91 or G92)") +
        ", so --start first-move has no place; take --start X,Y,Z");
  }
  return places.from(options.start_mm);
}

}  // namespace kerf::program
