#include "programs/kerf/run/block_watch.hpp"

namespace kerf::program {

namespace {

// When the law has come s_mm far. s(t) never falls: halved until no double lies between.
double time_at_s(const profiles::TimeLaw& law, double s_mm) {
  double before = 0.0;
  double after = law.duration_s();
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (before + after);
    (law.at(middle).s_mm < s_mm ? before : after) = middle;
  }
  return after;
}

}  // namespace

void BlockWatch::about_to_run(const parser::UpcomingBlock& block) {
  if (block.source.line != line_ || block.source.file != 0) {
    return;
  }
  if (!block_) {
    block_.emplace(block);
  } else if (!again_) {
    again_ = Again{.blocks_before = block.blocks_before, .rests_before = rests_pushed_};
  }
}

void BlockWatch::move(const parser::Move& move) {
  if (block_ && !first_ && move.block > block_->blocks_before) {
    first_ = First{.run_block = move.block, .rests_before = rests_pushed_};
  }
}

void BlockWatch::planned(const lookahead::Outbox& outbox) {
  changes_.insert(changes_.end(), outbox.line_changes.begin(), outbox.line_changes.end());
  for (const interp::Phase& phase : outbox.phases) {
    planned(phase);
  }
}

void BlockWatch::planned(const interp::Phase& phase) {
  const double begin_s = seconds(phase.begin);
  Part part{.line = phase.line, .run_block = phase.run_block, .begin_s = begin_s};
  while (phase.has_changes && !changes_.empty() && changes_.front().curve <= phase.curve) {
    const interp::LineChange& change = changes_.front();
    if (change.curve == phase.curve && change.s_mm >= phase.s_end_mm) {
      break;
    }
    if (change.curve == phase.curve && change.s_mm > phase.s_begin_mm) {
      part.end_s = begin_s + time_at_s(phase.law, change.s_mm - phase.s_begin_mm);
      add(part);
      part = {.line = change.line, .run_block = change.run_block, .begin_s = part.end_s};
    }
    changes_.pop_front();
  }
  part.end_s = begin_s + phase.law.duration_s();
  add(part);
}

void BlockWatch::add(const Part& part) {
  const bool rest = part.run_block == 0;
  rests_planned_ += rest ? 1 : 0;
  if (!first_ || over_) {
    return;
  }
  if (!begin_s_) {
    if (rest ? rests_planned_ <= first_->rests_before : part.run_block < first_->run_block) {
      return;
    }
    begin_s_ = end_s_ = part.begin_s;
  }
  const bool is_again = again_ && (rest ? rests_planned_ > again_->rests_before
                                        : part.run_block > again_->blocks_before);
  if (part.line == line_ && !is_again) {
    end_s_ = part.end_s;
  } else {
    over_ = true;
  }
}

}  // namespace kerf::program
