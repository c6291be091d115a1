#include "programs/kerf/run/feeder.hpp"

namespace kerf::program {

void Feeder::pump() {
  while (kernel_->plan() && !stopped_) {
    if (!feed_piece()) {
      if (kernel_->runs_low()) {
        kernel_->plan_to_rest();
      }
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
    kernel_->finish();
  } else {
    kernel_->feed(piece->bytes);
  }
  progress_->set_planned(kernel_->totals().path_length_mm);
  progress_->set_read(text_->share_read());
  return true;
}

void Feeder::stop() {
  if (!stopped_) {
    stopped_ = true;
    kernel_->stop();
    kernel_->plan();
  }
}

}  // namespace kerf::program
