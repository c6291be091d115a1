// Which part of a program's motion follows which work offset.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include <kerf/check.hpp>
#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "parser/program_reader.hpp"

namespace kerf {

// Reads the program beside the check a second time, on a machine whose work offsets lie a little
// elsewhere, each by a distance of its own: the ends of moves that lie elsewhere by that distance
// follow that offset. So it needs to know nothing of G53, G28, G92 and G10, axis by axis.
class OffsetFollowers {
 public:
  OffsetFollowers(const MachineSettings& settings, const KernelOptions& options);

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

  [[nodiscard]] const OffsetExtents& extents() const noexcept { return extents_; }

 private:
  using Ranges = std::array<AxisRange, 3>;

  // Those that a place belongs to which lies so far elsewhere; null: there are none.
  Ranges* ranges_of(double shift_mm);

  parser::ProgramReader reader_;
  parser::Move shifted_;
  bool is_over_ = false;  // or the program runs another way there
  OffsetExtents extents_;
};

}  // namespace kerf
