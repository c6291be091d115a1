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
  if (pieces_sent_ < outbox_.pieces.size() || phases_sent_ < outbox_.phases.size() ||
      switches_sent_ < outbox_.switches.size()) {
    return false;
  }
  outbox_.pieces.clear();
  outbox_.phases.clear();
  outbox_.switches.clear();
  pieces_sent_ = phases_sent_ = switches_sent_ = 0;
  return true;
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
