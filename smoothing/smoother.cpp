#include "smoothing/smoother.hpp"

#include <utility>

#include "smoothing/segment_builder.hpp"

namespace kerf::smoothing {

tl::expected<void, PathError> Smoother::push(const parser::Move& move) {
  if (const auto* event = std::get_if<parser::EventMove>(&move.shape);
      event != nullptr && parser::is_at_motion(event->kind)) {
    changes_.push_back(*event);
    return {};
  }
  made_.clear();
  if (Compressor::takes(move) && changes_.empty()) {
    if (!compressor_.continues(move)) {
      compressor_.flush(made_);
    }
    compressor_.push(move, made_);
    blend_made();
    return {};
  }
  compressor_.flush(made_);
  blend_made();
  if (auto built = append_segments(move, made_); !built) {
    return built;
  }
  if (std::holds_alternative<parser::DwellMove>(move.shape) ||
      std::holds_alternative<parser::EventMove>(move.shape)) {
    flush();
    outputs_.emplace_back(move);
    return {};
  }
  made_.front().changes = std::exchange(changes_, {});
  blend_made();
  return {};
}

void Smoother::blend_made() {
  for (PathSegment& segment : made_) {
    blender_.push(std::move(segment), blended_);
  }
  made_.clear();
  queue_segments();
}

void Smoother::flush() {
  compressor_.flush(made_);
  blend_made();
  blender_.flush(blended_);
  queue_segments();
}

void Smoother::queue_segments() {
  for (PathSegment& segment : blended_) {
    outputs_.emplace_back(std::move(segment));
  }
  blended_.clear();
}

PathDeviations Smoother::deviations() const noexcept {
  PathDeviations all = compressor_.deviations();
  all.add(blender_.deviations());
  return all;
}

bool Smoother::next(Output& output) {
  if (taken_ == outputs_.size()) {
    outputs_.clear();
    taken_ = 0;
    return false;
  }
  output = std::move(outputs_[taken_++]);
  return true;
}

}  // namespace kerf::smoothing
