#include "programs/kerf/run/feeder.hpp"

namespace kerf::program {

void Feeder::pump() {
  while (planning_->plan() && !stopped_) {
    if (!feed_piece()) {
      planning_->text_is_late();
      return;
    }
  }
}

bool Feeder::feed_piece() {
  const auto piece = text_->read();
  if (!piece) {
    error_ = piece.error();
    stop();
  } else if (piece->state == TextPiece::State::not_yet) {
    return false;
  } else if (piece->state == TextPiece::State::end) {
    planning_->finish();
  } else {
    planning_->feed(piece->bytes);
  }
  progress_->set_planned(planning_->kernel().totals().path_length_mm);
  progress_->set_read(text_->share_read());
  return true;
}

void Feeder::stop() {
  if (!stopped_) {
    stopped_ = true;
    planning_->stop();
    planning_->plan();
  }
}

}  // namespace kerf::program
