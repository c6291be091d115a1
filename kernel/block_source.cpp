#include "kernel/block_source.hpp"

#include <iterator>

#include "diagnostics/errors/pages.hpp"

namespace kerf {

namespace {

// The probe's motion and the question that ends it follow the first of its items at once.
bool probes_behind(const ProgramItem& item, bool probed) {
  const auto* pause = std::get_if<parser::Move>(&item);
  const auto* event = pause != nullptr ? std::get_if<parser::EventMove>(&pause->shape) : nullptr;
  return event != nullptr ? event->kind == parser::EventKind::probe_begin : probed;
}

}  // namespace

std::optional<ProgramItem> BlockSource::next() {
  if (!reads_apart_) {
    return read_item();
  }
  const std::lock_guard lock(ahead_mutex_);
  if (ahead_.empty()) {
    return std::nullopt;
  }
  ProgramItem item = std::move(ahead_.front());
  ahead_.pop_front();
  return item;
}

ReadStatus BlockSource::read() {
  if (!reads_apart_) {
    return ReadStatus::ended;  // the plan reads
  }
  const std::lock_guard lock(path_mutex_);
  if (has_ended_) {
    return ReadStatus::ended;
  }
  if (is_far_enough()) {
    return ReadStatus::far_enough;
  }
  std::vector<ProgramItem> batch = read_batch();
  if (batch.empty()) {
    return path_.reader().question() ? ReadStatus::far_enough : ReadStatus::wants_text;
  }
  has_ended_ = std::holds_alternative<ProgramEnd>(batch.back());
  const std::lock_guard ahead(ahead_mutex_);
  ahead_.insert(ahead_.end(), std::make_move_iterator(batch.begin()),
                std::make_move_iterator(batch.end()));
  return ReadStatus::read;
}

std::uint32_t BlockSource::answer(const parser::MachineAnswer& answer) {
  const std::lock_guard lock(path_mutex_);
  path_.answer(answer);
  return path_.line();
}

bool BlockSource::is_far_enough() {
  const std::lock_guard lock(ahead_mutex_);
  return ahead_.size() >= kMostAhead;
}

std::vector<ProgramItem> BlockSource::read_batch() {
  std::vector<ProgramItem> batch;
  for (bool probes = false; batch.size() < kBatch || probes;) {
    auto item = read_item();
    if (!item) {
      break;
    }
    probes = probes_behind(*item, probes);
    batch.push_back(*std::move(item));
    if (std::holds_alternative<ProgramEnd>(batch.back())) {
      break;
    }
  }
  return batch;
}

std::optional<ProgramItem> BlockSource::read_item() {
  ProgramPath::Output output;
  for (;;) {
    switch (path_.next(output)) {
      case ProgramPath::Next::wants_text:
        return std::nullopt;
      case ProgramPath::Next::ended:
        return ProgramEnd{};
      case ProgramPath::Next::output:
        break;
    }
    auto* segment = std::get_if<smoothing::PathSegment>(&output);
    if (segment == nullptr) {
      return std::get<parser::Move>(std::move(output));
    }
    if (auto item = item_of(std::move(*segment))) {
      return item;
    }
  }
}

std::optional<ProgramItem> BlockSource::item_of(smoothing::PathSegment segment) {
  const diagnostics::SourcePosition source = segment.source;
  std::vector<parser::EventMove> changes = std::move(segment.changes);
  auto block = lookahead::block_of(std::move(segment), limits_, scan_);
  if (!block) {
    path_.cut(source, block.error(), errors::kCurveRefused);
    return std::nullopt;
  }
  return BlockItem{.block = *std::move(block), .changes = std::move(changes)};
}

}  // namespace kerf
