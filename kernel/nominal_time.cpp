#include "kernel/nominal_time.hpp"

namespace kerf {

void add_motion(NominalTime& nominal, double duration_s, bool rapid,
                const parser::FollowedOverrides& follows) {
  nominal.motion_s += duration_s;
  if (rapid) {
    nominal.rapid_s += duration_s;
  } else if (follows.spindle) {
    (follows.feed ? nominal.spindle_s : nominal.spindle_alone_s) += duration_s;
  } else if (!follows.feed) {
    nominal.steady_s += duration_s;
  }
}

NominalTime sum_of(const NominalTime& first, const NominalTime& second, double share) {
  return {.motion_s = first.motion_s + share * second.motion_s,
          .rest_s = first.rest_s + share * second.rest_s,
          .rapid_s = first.rapid_s + share * second.rapid_s,
          .steady_s = first.steady_s + share * second.steady_s,
          .spindle_s = first.spindle_s + share * second.spindle_s,
          .spindle_alone_s = first.spindle_alone_s + share * second.spindle_alone_s};
}

double held_by_feed_s(const NominalTime& nominal) {
  return nominal.motion_s - nominal.steady_s - nominal.spindle_alone_s;
}

double motion_at_s(const NominalTime& nominal, const Overrides& overrides) {
  const double fed_s = nominal.motion_s - nominal.rapid_s - nominal.steady_s - nominal.spindle_s -
                       nominal.spindle_alone_s;
  return (fed_s + nominal.spindle_s / overrides.spindle) / overrides.feed +
         nominal.spindle_alone_s / overrides.spindle + nominal.rapid_s / overrides.rapid +
         nominal.steady_s;
}

}  // namespace kerf
