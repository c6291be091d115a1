#include "programs/feeder.hpp"

#include <algorithm>

namespace kerf::program {

void Feeder::pump() {
  while (kernel_->plan() && !stopped_) {
    feed_piece();
  }
}

void Feeder::feed_piece() {
  const auto piece = file_->read();
  if (!piece) {
    error_ = piece.error();
    stop();
  } else if (piece->empty()) {
    kernel_->finish();
  } else {
    kernel_->feed(*piece);
  }
  const auto size = static_cast<double>(std::max<std::uint64_t>(file_->size_bytes(), 1));
  progress_->set_planned(kernel_->totals().path_length_mm);
  progress_->set_read(static_cast<double>(file_->bytes_read()) / size);
}

void Feeder::stop() {
  if (!stopped_) {
    stopped_ = true;
    kernel_->stop();
    kernel_->plan();
  }
}

}  // namespace kerf::program
