// What an operator and the machine make of the feedrates of a program.
#pragma once

#include "parser/moves/move.hpp"

namespace kerf::lookahead {

struct FeedOverride {
  double feed = 1.0;      // of programmed feedrates, > 0
  double rapid = 1.0;     // of rapids, > 0 and at most 1
  double spindle = 1.0;   // of feedrates per revolution, > 0
  double adaptive = 1.0;  // of both where the program says so, > 0 and at most 1

  friend bool operator==(const FeedOverride&, const FeedOverride&) = default;
};

// What is at 0, or asks the tool to stop: nothing that follows it begins to move.
struct StoppedFeed {
  bool by_override = false;
  bool by_adaptive = false;
  bool by_machine = false;

  [[nodiscard]] bool any() const noexcept { return by_override || by_adaptive || by_machine; }
  [[nodiscard]] bool stops(const parser::FollowedOverrides& follows) const noexcept {
    return (by_override && follows.feed) || (by_adaptive && follows.adaptive) ||
           (by_machine && follows.feed_stop);
  }
};

// Of a programmed feedrate.
inline double share_of(const FeedOverride& by, const parser::FollowedOverrides& follows) {
  return (follows.feed ? by.feed : 1.0) * (follows.spindle ? by.spindle : 1.0) *
         (follows.adaptive ? by.adaptive : 1.0);
}

inline double share_of_rapid(const FeedOverride& by, const parser::FollowedOverrides& follows) {
  return by.rapid * (follows.adaptive ? by.adaptive : 1.0);
}

}  // namespace kerf::lookahead
