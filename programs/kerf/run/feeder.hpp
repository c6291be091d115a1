// Feeds text to the planning side as it needs it.
#pragma once

#include <optional>
#include <string>

#include "programs/kerf/io/progress.hpp"
#include "programs/kerf/io/text_feed.hpp"
#include "programs/kerf/run/planning_side.hpp"

namespace kerf::program {

// Belongs to the thread that plans. Text that cannot be read any more, and a request to stop, let
// the tool come to rest on the path; so does text that is late, until it comes.
class Feeder {
 public:
  Feeder(PlanningSide& planning, TextFeed& text, Progress& progress) noexcept
      : planning_(&planning), text_(&text), progress_(&progress) {}

  // Plans as far ahead as there is room.
  void pump();
  void stop();

  [[nodiscard]] const std::optional<std::string>& error() const noexcept { return error_; }

 private:
  // False: none is there yet.
  bool feed_piece();

  PlanningSide* planning_;
  TextFeed* text_;
  Progress* progress_;
  bool stopped_ = false;
  std::optional<std::string> error_;
};

}  // namespace kerf::program
