#include "programs/block_watch.hpp"

namespace kerf::program {

namespace {

// Not told by the path: a slow ramp may be too short for its ends to differ.
bool stands_still(const profiles::TimeLaw& law) {
  return law.ramp().v_begin_mm_s == 0.0 && law.ramp().v_end_mm_s == 0.0;
}

}  // namespace

void BlockWatch::read(const parser::ProgramReader& reader) {
  if (!block_ && reader.watched_block()) {
    block_ = reader.watched_block();
  }
}

void BlockWatch::moves(const parser::Move& move) noexcept {
  if (block_ && !items_before_ && move.block > block_->blocks_before) {
    items_before_ = items_pushed_;
  }
}

void BlockWatch::planned(const interp::Phase& phase) {
  const bool rest = stands_still(phase.law);
  if (rest || phase.curve != curve_) {
    ++items_planned_;
    curve_ = phase.curve;
  }
  if (!items_before_ || over_ || items_planned_ <= *items_before_) {
    return;
  }
  if (!begin_s_) {
    begin_s_ = end_s_ = seconds(phase.begin);
  }
  if (phase.line == line_) {
    end_s_ = seconds(phase.begin) + phase.law.duration_s();
  } else {
    over_ = true;
  }
}

}  // namespace kerf::program
