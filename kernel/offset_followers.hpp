// Which part of a program's motion follows which work offset.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include <kerf/check.hpp>
#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "parser/program_reader.hpp"

namespace kerf {

// Reads the program beside the check a second time, on a machine whose work offsets lie a little
// elsewhere, each by a distance of its own: the ends of moves that lie elsewhere by that distance
// follow that offset. A move that has no length in the check may have one there. So it needs to
// know nothing of G53, G28, G92 and G10, axis by axis.
class OffsetFollowers {
 public:
  // starts_at_first_places: CheckBounds.
  OffsetFollowers(const MachineSettings& settings, const KernelOptions& options,
                  bool starts_at_first_places);

  // What the check's reader is given.
  void feed(std::string_view text) {
    if (!is_over_) {
      reader_.feed(text);
    }
  }
  void finish() { reader_.finish(); }

  // Each move of the check's reader, and the box that it fills; nothing: it does not move.
  void look_at(const parser::Move& move, const std::optional<Extents>& box);

  // No more moves come: no text is kept for them.
  void end() noexcept { is_over_ = true; }

  [[nodiscard]] OffsetExtents extents() const;

 private:
  using Ranges = std::array<AxisRange, 3>;

  // Those that a place belongs to which lies so far elsewhere; null: there are none.
  Ranges* ranges_of(double shift_mm);

  // The move of that block. False: there is none, as the program runs another way.
  bool read_up_to(const parser::Move& move);
  // Of a move of the check, whose other one is shifted_.
  struct Way {
    const parser::Point& start_mm;
    const parser::Point& end_mm;
    Extents box;
    enum class Kind : std::uint8_t { line, arc, other };
    Kind kind = Kind::line;
  };
  static Way::Kind kind_of(const parser::Move& move);
  // Of one axis what its ends follow; null: nobody knows.
  struct AxisWay {
    Ranges* from = nullptr;
    Ranges* to = nullptr;
    bool moves = false;
  };
  std::array<AxisWay, 3> axes_of(const Way& way);
  // False: of an axis it is not known what it follows.
  bool include(const Way& way);

  parser::ProgramReader reader_;
  parser::Move shifted_;
  parser::Point place_mm_;  // of the tool in the check
  bool is_over_ = false;    // or the program runs another way there
  // No move has brought the axis from a start that is where the first moves lead.
  std::array<bool, 3> is_at_start_{};
  OffsetExtents extents_;
};

}  // namespace kerf
