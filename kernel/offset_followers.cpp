#include "kernel/offset_followers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>

#include "kernel/reader_options.hpp"
#include "parser/moves/short_moves.hpp"

namespace kerf {

namespace {

// How far each offset lies elsewhere: 1/64 mm times roots of primes, so that no whole multiple, sum
// or difference of some is another one's.
constexpr std::array<double, kWorkSystems> kShifts_mm{0.015625,     0.0220970869, 0.0270632939,
                                                      0.0349385621, 0.0413398642, 0.0518222623,
                                                      0.0563367387, 0.0644235254, 0.0681077960};
constexpr double kRounding_mm = 1e-6;

parser::ReaderOptions elsewhere(parser::ReaderOptions options) {
  for (std::size_t system = 0; system < kWorkSystems; ++system) {
    for (double& origin_mm : options.machine.work[system].origin_mm) {
      origin_mm += kShifts_mm[system];
    }
  }
  options.keeps_messages = false;
  return options;
}

void extend(AxisRange& range, const AxisRange& also) {
  range.min_mm = std::min(range.min_mm, also.min_mm);
  range.max_mm = std::max(range.max_mm, also.max_mm);
}

}  // namespace

OffsetFollowers::OffsetFollowers(const MachineSettings& settings, const KernelOptions& options,
                                 bool starts_at_first_places)
    : reader_(elsewhere(reader_options(settings, options))), place_mm_(options.start_mm) {
  is_at_start_.fill(starts_at_first_places);
}

// An axis that no move brings anywhere starts where it is on the machine.
OffsetExtents OffsetFollowers::extents() const {
  OffsetExtents extents = extents_;
  for (std::size_t k = 0; k < 3; ++k) {
    if (is_at_start_[k]) {
      extend(extents.fixed[k], {place_mm_[k], place_mm_[k]});
    }
  }
  return extents;
}

OffsetFollowers::Ranges* OffsetFollowers::ranges_of(double shift_mm) {
  if (std::abs(shift_mm) < kRounding_mm) {
    return &extents_.fixed;
  }
  for (std::size_t system = 0; system < kWorkSystems; ++system) {
    if (std::abs(shift_mm - kShifts_mm[system]) < kRounding_mm) {
      return &extents_.following[system];
    }
  }
  return nullptr;
}

OffsetFollowers::Way::Kind OffsetFollowers::kind_of(const parser::Move& move) {
  if (std::holds_alternative<parser::LineMove>(move.shape)) {
    return Way::Kind::line;
  }
  return std::holds_alternative<parser::ArcMove>(move.shape) ? Way::Kind::arc : Way::Kind::other;
}

bool OffsetFollowers::read_up_to(const parser::Move& move) {
  while (reader_.next(shifted_)) {
    if (shifted_.block >= move.block) {
      return shifted_.block == move.block && shifted_.source.line == move.source.line &&
             shifted_.shape.index() == move.shape.index();
    }
    // The check has no move of that block: the tool is there already.
    if (parser::end_mm(shifted_) == nullptr ||
        !include({.start_mm = place_mm_, .end_mm = place_mm_, .box = {place_mm_, place_mm_}})) {
      return false;
    }
  }
  return false;
}

void OffsetFollowers::look_at(const parser::Move& move, const std::optional<Extents>& box) {
  if (is_over_) {
    return;
  }
  if (!read_up_to(move)) {
    is_over_ = true;
    extents_.is_known.fill(false);
    return;
  }
  if (const parser::Point* end = parser::end_mm(move); end != nullptr && box) {
    include({.start_mm = move.start_mm, .end_mm = *end, .box = *box, .kind = kind_of(move)});
    place_mm_ = *end;
  }
}

std::array<OffsetFollowers::AxisWay, 3> OffsetFollowers::axes_of(const Way& way) {
  std::array<AxisWay, 3> axes;
  const parser::Point& shifted_end = *parser::end_mm(shifted_);
  for (std::size_t k = 0; k < 3; ++k) {
    AxisWay& axis = axes[k];
    axis.moves = !is_at_start_[k] || shifted_end[k] != shifted_.start_mm[k] ||
                 way.end_mm[k] != way.start_mm[k];
    if (!axis.moves) {
      continue;
    }
    const bool begins = std::exchange(is_at_start_[k], false);
    axis.from = ranges_of(shifted_.start_mm[k] - way.start_mm[k]);
    axis.to = ranges_of(shifted_end[k] - way.end_mm[k]);
    // The check starts where this move leads, so it has no way to there.
    if (begins && way.end_mm[k] == way.start_mm[k]) {
      axis.from = axis.to;
    }
  }
  return axes;
}

// Between two places that follow different offsets a line reaches no farther than they. What a
// curve does there changes with the offsets, an arc along the other axis, too.
bool OffsetFollowers::include(const Way& way) {
  const std::array<AxisWay, 3> axes = axes_of(way);
  const bool is_other_arc =
      way.kind == Way::Kind::arc &&
      std::ranges::any_of(axes, [](const AxisWay& axis) { return axis.from != axis.to; });
  bool all_known = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const AxisRange filled{way.box.min_mm[k], way.box.max_mm[k]};
    const bool spans = filled.max_mm - filled.min_mm > kRounding_mm;
    const auto [from, to, moves] = axes[k];
    if (!moves) {
      continue;
    }
    if (from == nullptr || to == nullptr || (from != to && way.kind != Way::Kind::line) ||
        (is_other_arc && spans)) {
      extents_.is_known[k] = false;
    } else if (from == to) {
      extend((*to)[k], filled);
    } else {
      extend((*from)[k], {way.start_mm[k], way.start_mm[k]});
      extend((*to)[k], {way.end_mm[k], way.end_mm[k]});
    }
    all_known = all_known && extents_.is_known[k];
  }
  return all_known;
}

}  // namespace kerf
