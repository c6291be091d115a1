#include "kernel/delivery.hpp"

namespace kerf {

bool Delivery::deliver(std::int64_t horizon) {
  while (pieces_sent_ < outbox_.pieces.size() && queue_->push(outbox_.pieces[pieces_sent_])) {
    ++pieces_sent_;
  }
  while (switches_sent_ < outbox_.switches.size() &&
         outbox_.switches[switches_sent_].tick <= horizon &&
         queue_->push(outbox_.switches[switches_sent_])) {
    ++switches_sent_;
  }
  while (phases_sent_ < outbox_.phases.size()) {
    const interp::Phase& phase = outbox_.phases[phases_sent_];
    if (phase.begin.tick > horizon || !may_follow(phase) || !queue_->push(phase)) {
      break;
    }
    frozen_until_tick_ = phase.begin.tick;
    ++phases_sent_;
  }
  forget_sent();
  return outbox_.phases.empty() && outbox_.switches.empty();
}

// Pieces may wait for a long time, behind a curve of more of them than the ring holds.
void Delivery::forget_sent() {
  if (phases_sent_ == outbox_.phases.size()) {
    outbox_.phases.clear();
    phases_sent_ = 0;
  }
  if (switches_sent_ == outbox_.switches.size()) {
    outbox_.switches.clear();
    switches_sent_ = 0;
  }
  if (pieces_sent_ == outbox_.pieces.size() || pieces_sent_ >= interp::MotionQueue::kPieces) {
    outbox_.pieces.erase(outbox_.pieces.begin(),
                         outbox_.pieces.begin() + static_cast<std::ptrdiff_t>(pieces_sent_));
    pieces_sent_ = 0;
  }
}

bool Delivery::may_follow(const interp::Phase& phase) const {
  if (switches_sent_ < outbox_.switches.size() &&
      outbox_.switches[switches_sent_].tick <= phase.begin.tick) {
    return false;
  }
  if (pieces_sent_ == outbox_.pieces.size()) {
    return true;
  }
  const interp::PathPiece& waiting = outbox_.pieces[pieces_sent_];
  return phase.curve < waiting.curve ||
         (phase.curve == waiting.curve && phase.s_begin_mm < curves::s_begin_mm(waiting.geometry));
}

}  // namespace kerf
