#include "smoothing/smoother.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "smoothing/curvature_jumps.hpp"
#include "smoothing/segment_builder.hpp"

namespace kerf::smoothing {

tl::expected<void, PathError> Smoother::push(const parser::Move& move) {
  if (const auto* event = std::get_if<parser::EventMove>(&move.shape);
      event != nullptr && parser::is_at_motion(event->kind)) {
    changes_.push_back(*event);
    last_change_ = move;
    return {};
  }
  made_.clear();
  if (merges(move)) {
    if (!compressor_.continues(move)) {
      compressor_.flush(made_);
    }
    compressor_.push(move, made_, {.has_changes = !changes_.empty()});
    come_with(move);
    queue_made();
    return {};
  }
  compressor_.flush(made_);
  queue_made();
  if (auto built = append_segments(move, made_); !built) {
    return built;
  }
  if (std::holds_alternative<parser::DwellMove>(move.shape) ||
      std::holds_alternative<parser::EventMove>(move.shape)) {
    queue_changes_before(move);
    queue_.emplace_back(move);
    return {};
  }
  if (std::holds_alternative<parser::NurbsMove>(move.shape) && may_bend(made_.front())) {
    smooth_jumps(move);
  }
  come_with(move);
  queue_made();
  return {};
}

bool Smoother::merges(const parser::Move& move) const {
  const bool is_kept = keeps_exact_lines_apart_ && move.mode == parser::PathMode::exact_path;
  return !keeps_blocks_apart_ && !is_kept && Compressor::takes(move);
}

void Smoother::queue_changes_before(const parser::Move& rest) {
  for (const parser::EventMove& change : changes_) {
    if (parser::is_of_override(change.kind)) {
      parser::Move before = rest;
      before.shape = change;
      queue_.emplace_back(std::move(before));
    }
  }
  std::erase_if(changes_, [](const auto& change) { return parser::is_of_override(change.kind); });
}

void Smoother::come_with(const parser::Move& move) {
  output_changes_.come_with(move.block, std::exchange(changes_, {}));
}

void Smoother::smooth_jumps(const parser::Move& move) {
  std::vector<PathSegment> segments = std::exchange(made_, {});
  for (PathSegment& segment : segments) {
    const auto* curve = std::get_if<curves::NurbsCurve>(&segment.curve);
    const std::vector<double> jumps_mm =
        curve != nullptr ? curvature_jumps(*curve) : std::vector<double>{};
    if (jumps_mm.empty()) {
      made_.push_back(std::move(segment));
      continue;
    }
    const std::size_t count = made_.size();
    const SampledCurve lines = blends_meet(*curve, jumps_mm, segment.feedrate_mm_s, settings_)
                                   ? sampled(*curve, segment.corner_tolerance_mm)
                                   : SampledCurve{};
    if (lines.points_mm.empty()) {
      append_cut(segment, jumps_mm, made_);
    } else {
      fit_lines(lines, move, curve->at(0.0));
    }
    if (made_.size() == count) {  // all its points coincide
      made_.push_back(std::move(segment));
    }
  }
}

// The curve's points as a run of its own.
void Smoother::fit_lines(const SampledCurve& lines, const parser::Move& move,
                         const curves::Position& begin_mm) {
  parser::Move line{.shape = parser::LineMove{},
                    .source = move.source,
                    .start_mm = begin_mm,
                    .feedrate_mm_s = move.feedrate_mm_s,
                    .follows = move.follows,
                    .auxiliary = move.auxiliary,
                    .mode = move.mode,
                    .blend_tolerance_mm = move.blend_tolerance_mm,
                    .merge_tolerance_mm = move.blend_tolerance_mm,
                    .block = move.block};
  for (const curves::Position& end_mm : lines.points_mm) {
    line.shape = parser::LineMove{end_mm};
    compressor_.push(line, made_, {.beside_mm = lines.beside_mm});
    line.start_mm = end_mm;
  }
  compressor_.flush(made_);
}

void Smoother::queue_made() {
  std::move(made_.begin(), made_.end(), std::back_inserter(queue_));
  made_.clear();
}

void Smoother::flush() {
  made_.clear();
  compressor_.flush(made_);
  queue_made();
  queue_changes_at_end();
  queue_.emplace_back(EndOfPath{});
}

// A tick has them: they come with a rest of no time.
void Smoother::queue_changes_at_end() {
  const std::size_t count = changes_.size();
  queue_changes_before(last_change_);
  if (changes_.size() < count) {
    parser::Move rest = last_change_;
    rest.shape = parser::DwellMove{};
    queue_.emplace_back(std::move(rest));
  }
}

void Smoother::blend_next() {
  auto item = std::move(queue_.front());
  queue_.pop_front();
  if (auto* segment = std::get_if<PathSegment>(&item)) {
    blender_.push(std::move(*segment), blended_);
  } else {
    blender_.flush(blended_);
  }
  for (PathSegment& segment : blended_) {
    output_changes_.cut(std::move(segment), cut_);
  }
  blended_.clear();
  std::move(cut_.begin(), cut_.end(), std::back_inserter(outputs_));
  cut_.clear();
  if (auto* move = std::get_if<parser::Move>(&item)) {
    outputs_.emplace_back(std::move(*move));
  }
}

PathDeviations Smoother::deviations() const noexcept {
  PathDeviations all = compressor_.deviations();
  all.add(blender_.deviations());
  return all;
}

bool Smoother::next(Output& output) {
  while (taken_ == outputs_.size()) {
    outputs_.clear();
    taken_ = 0;
    if (queue_.empty()) {
      return false;
    }
    blend_next();
  }
  output = std::move(outputs_[taken_++]);
  return true;
}

}  // namespace kerf::smoothing
