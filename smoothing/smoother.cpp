#include "smoothing/smoother.hpp"

#include <utility>

#include "smoothing/part_builder.hpp"

namespace kerf::smoothing {

namespace {

bool comes_with_motion(const parser::EventMove& event) {
  return event.kind == parser::EventKind::digital_at_motion ||
         event.kind == parser::EventKind::analog_at_motion;
}

}  // namespace

tl::expected<void, PathError> Smoother::push(const parser::Move& move) {
  if (const auto* event = std::get_if<parser::EventMove>(&move.shape);
      event != nullptr && comes_with_motion(*event)) {
    changes_.push_back(*event);
    return {};
  }
  made_.clear();
  if (auto built = append_parts(move, made_); !built) {
    return built;
  }
  if (std::holds_alternative<parser::DwellMove>(move.shape) ||
      std::holds_alternative<parser::EventMove>(move.shape)) {
    flush();
    outputs_.emplace_back(move);
    return {};
  }
  for (PathPart& part : made_) {
    part.changes = std::exchange(changes_, {});
    blender_.push(std::move(part), blended_);
  }
  queue_parts();
  return {};
}

void Smoother::flush() {
  blender_.flush(blended_);
  queue_parts();
}

void Smoother::queue_parts() {
  for (PathPart& part : blended_) {
    outputs_.emplace_back(std::move(part));
  }
  blended_.clear();
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
