#include "kernel/start_in_middle.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "curves/curve.hpp"
#include "parser/moves/auxiliary_axes.hpp"
#include "parser/moves/short_moves.hpp"
#include "parser/spindle_io/spindle.hpp"
#include "smoothing/segment_builder.hpp"

namespace kerf {

namespace {

using parser::EventKind;
using parser::EventMove;

constexpr double kFeedrateOfNone_mm_s = 5.0;  // down to a place before the program has any

bool turns(const EventMove& spindle) {
  return spindle.kind == EventKind::spindle_cw || spindle.kind == EventKind::spindle_ccw;
}

// M62 and M64 switch the same output.
EventKind at_rest(EventKind kind) {
  return kind == EventKind::digital_at_motion  ? EventKind::digital_output
         : kind == EventKind::analog_at_motion ? EventKind::analog_output
                                               : kind;
}

PlaceOfTool begin_of(const StartInMiddle::Output& output) {
  if (const auto* segment = std::get_if<smoothing::PathSegment>(&output)) {
    return {.position_mm = curves::position_at(segment->curve, 0.0),
            .extra_rad_mm = segment->extra.begin_rad_mm};
  }
  const auto& pause = std::get<parser::Move>(output);
  return {.position_mm = pause.start_mm, .extra_rad_mm = pause.auxiliary.begin_rad_mm};
}

// A, B and C alone move at a feedrate in rad/s.
bool goes_through_mm(const smoothing::PathSegment& segment) {
  const curves::AuxiliaryAxisMotion& extra = segment.extra;
  for (std::size_t axis = 0; extra.alone && axis < curves::kAuxiliaryAxes; ++axis) {
    if (!parser::is_rotary(axis) && extra.begin_rad_mm[axis] != extra.end_rad_mm[axis]) {
      return true;
    }
  }
  return !extra.alone;
}

diagnostics::SourcePosition source_of(const StartInMiddle::Output& output) {
  const auto* segment = std::get_if<smoothing::PathSegment>(&output);
  return segment != nullptr ? segment->source : std::get<parser::Move>(output).source;
}

// Takes the tool from place to place.
class Way {
 public:
  Way(const diagnostics::SourcePosition& source, std::uint64_t block, const PlaceOfTool& tool)
      : source_(source), block_(block), at_(tool) {}

  template <typename Shape>
  void stay(const Shape& shape) {
    out_.emplace_back(from_here(shape));
  }
  void go(const PlaceOfTool& to, std::optional<double> feedrate_mm_s) {
    parser::Move move = from_here(parser::LineMove{to.position_mm});
    move.auxiliary.end_rad_mm = to.extra_rad_mm;
    move.rapid = !feedrate_mm_s;
    move.feedrate_mm_s = feedrate_mm_s.value_or(0.0);
    at_ = to;
    std::vector<smoothing::PathSegment> segments;
    if ((parser::way_mm(move) >= parser::kShortestWay_mm || move.auxiliary.moves()) &&
        smoothing::append_segments(move, segments)) {
      out_.insert(out_.end(), std::make_move_iterator(segments.begin()),
                  std::make_move_iterator(segments.end()));
    }
  }
  [[nodiscard]] std::vector<StartInMiddle::Output> take() && { return std::move(out_); }

 private:
  template <typename Shape>
  [[nodiscard]] parser::Move from_here(const Shape& shape) const {
    return {.shape = shape,
            .source = source_,
            .start_mm = at_.position_mm,
            .auxiliary = {.begin_rad_mm = at_.extra_rad_mm, .end_rad_mm = at_.extra_rad_mm},
            .mode = parser::PathMode::exact_stop,
            .block = block_};
  }

  diagnostics::SourcePosition source_;
  std::uint64_t block_;
  PlaceOfTool at_;
  std::vector<StartInMiddle::Output> out_;
};

}  // namespace

void SwitchedState::add(const EventMove& event) {
  switch (event.kind) {
    case EventKind::program_stop:
    case EventKind::optional_stop:
    case EventKind::pallet_change:
    case EventKind::program_end:
    case EventKind::start:
      break;
    case EventKind::tool_change:
      tool_ = event;
      spindle_.reset();
      break;
    case EventKind::tool_number:
      if (tool_) {
        tool_->value = event.value;
      } else {
        tool_ = event;
      }
      break;
    case EventKind::spindle_cw:
    case EventKind::spindle_ccw:
    case EventKind::spindle_off:
    case EventKind::spindle_orient:
      spindle_ = event;
      spindle_->taps = false;  // it starts, in the air
      break;
    case EventKind::mist_on:
      mist_ = event;
      break;
    case EventKind::flood_on:
      flood_ = event;
      break;
    case EventKind::coolant_off:
      mist_.reset();
      flood_.reset();
      break;
    default: {
      EventMove now = event;
      now.kind = at_rest(event.kind);
      others_[{now.kind, now.index}] = now;
    }
  }
}

std::vector<EventMove> SwitchedState::outputs() const {
  std::vector<EventMove> events;
  for (const auto& [key, event] : others_) {
    events.push_back(event);
  }
  return events;
}

std::vector<EventMove> SwitchedState::coolant() const {
  std::vector<EventMove> events;
  for (const auto& event : {mist_, flood_}) {
    if (event) {
      events.push_back(*event);
    }
  }
  return events;
}

std::uint64_t first_block(const smoothing::Smoother::Output& output) {
  const auto* segment = std::get_if<smoothing::PathSegment>(&output);
  return segment != nullptr ? segment->first_block() : std::get<parser::Move>(output).block;
}

StartInMiddle::StartInMiddle(const StartInProgram& start, const MachineSettings& settings,
                             parser::MachineSource answers, const PlaceOfTool& tool)
    : start_(start),
      answers_(std::move(answers)),
      tool_(tool),
      safe_z_mm_(std::min(settings.program.safe_z_mm, settings.table.axes[2].travel.max_mm)),
      highest_mm_(tool.position_mm[2]),
      feedrate_mm_s_(kFeedrateOfNone_mm_s) {}

bool StartInMiddle::leaves_out(const Output& output) {
  if (!leaves_out(first_block(output))) {
    return false;
  }
  if (const auto* segment = std::get_if<smoothing::PathSegment>(&output)) {
    for (const EventMove& change : segment->changes) {
      switched_.add(change);
    }
    if (!segment->rapid && goes_through_mm(*segment)) {
      feedrate_mm_s_ = segment->feedrate_mm_s;
    }
    highest_mm_ = std::max(highest_mm_, curves::extents(segment->curve).max_mm[2]);
  } else if (const auto* event = std::get_if<EventMove>(&std::get<parser::Move>(output).shape)) {
    switched_.add(*event);
  }
  return true;
}

std::vector<StartInMiddle::Output> StartInMiddle::way_to(const Output& first) const {
  const PlaceOfTool target = begin_of(first);
  const double safe_mm = std::max({std::isfinite(safe_z_mm_) ? safe_z_mm_ : highest_mm_,
                                   tool_.position_mm[2], target.position_mm[2]});
  Way way(source_of(first), start_.blocks_before + 1, tool_);
  if (start_.waits) {
    way.stay(EventMove{.kind = EventKind::start});
  }
  PlaceOfTool up = tool_;
  up.position_mm[2] = safe_mm;
  way.go(up, std::nullopt);
  if (switched_.tool()) {
    way.stay(*switched_.tool());
  }
  for (const EventMove& output : switched_.outputs()) {
    way.stay(output);
  }
  if (const auto& spindle = switched_.spindle()) {
    way.stay(*spindle);
    const auto wait = turns(*spindle)
                          ? parser::wait_for_speed(answers_, start_.blocks_before + 1,
                                                   {.to_per_min = turns_per_min(*spindle)})
                          : std::nullopt;
    if (wait) {
      std::visit([&way](const auto& shape) { way.stay(shape); }, *wait);
    }
  }
  PlaceOfTool above = target;
  above.position_mm[2] = safe_mm;
  way.go(above, std::nullopt);
  for (const EventMove& event : switched_.coolant()) {
    way.stay(event);
  }
  const auto* segment = std::get_if<smoothing::PathSegment>(&first);
  const bool has_feedrate = segment != nullptr && !segment->rapid && goes_through_mm(*segment);
  way.go(target, has_feedrate ? segment->feedrate_mm_s : feedrate_mm_s_);
  return std::move(way).take();
}

}  // namespace kerf
