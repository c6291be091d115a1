// What an operator makes of the feedrates of a program.
#pragma once

namespace kerf::lookahead {

struct FeedOverride {
  double feed = 1.0;   // of programmed feedrates, > 0
  double rapid = 1.0;  // of rapids, > 0 and at most 1

  friend bool operator==(const FeedOverride&, const FeedOverride&) = default;
};

}  // namespace kerf::lookahead
