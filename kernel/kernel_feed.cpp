// What an operator and the machine make of the feedrates, and where they let the tool hold.
#include <utility>

#include "kernel/kernel_impl.hpp"

namespace kerf {

namespace {

// What is next to nothing would be a cruise of years.
double heeded_share(double feed) {
  return feed < Overrides::kLeastFeed ? 0.0 : feed;
}

}  // namespace

bool Kernel::Impl::set_overrides(const Overrides& overrides) {
  if (!is_possible(overrides)) {
    return false;
  }
  const bool was_at_feed_0 = is_at_feed_0();
  interpolator_.override_spindle_by(overrides.spindle);
  const double feed = heeded_share(overrides.feed);
  const double feed_before = std::exchange(feed_, feed > 0.0 ? feed : feed_);
  wants_change_ |= feed_ != feed_before || overrides.rapid != overrides_.rapid ||
                   overrides.spindle != overrides_.spindle;
  overrides_ = overrides;
  overrides_.feed = feed;
  stop_feed();
  follow_feed_0(was_at_feed_0);
  plan();
  return true;
}

bool Kernel::Impl::set_feed_inputs(const FeedInputs& inputs) {
  if (!is_possible(inputs)) {
    return false;
  }
  inputs_ = {.adaptive = heeded_share(inputs.adaptive), .stop = inputs.stop};
  stop_feed();
  if (inputs_.adaptive > 0.0 && inputs_.adaptive != adaptive_) {
    adaptive_ = inputs_.adaptive;
    wants_change_ = true;
    follow_feed_0(is_at_feed_0());
  }
  plan();
  return true;
}

void Kernel::Impl::stop_feed() {
  pipeline_.stop_feed({.by_override = overrides_.feed == 0.0,
                       .by_adaptive = inputs_.adaptive == 0.0,
                       .by_machine = inputs_.stop});
}

bool Kernel::Impl::inputs_stop() const noexcept {
  const interp::Interpolator::Heeded heeded = interpolator_.heeded();
  return (heeded.feed_stop && inputs_.stop) || (heeded.adaptive_feed && inputs_.adaptive == 0.0);
}

void Kernel::Impl::follow_place() {
  const bool was_at_feed_0 = is_at_feed_0();
  is_stopped_ = inputs_stop();
  keeps_feed_ = feed_is_kept();
  if (is_at_feed_0() != was_at_feed_0) {
    follow_feed_0(was_at_feed_0);
  }
}

void Kernel::Impl::follow_feed_0(bool was_at_feed_0) {
  // A wait is not answered by it.
  const bool releases =
      was_at_feed_0 && !is_at_feed_0() && (pipeline_.is_held() || takeover_.has_value());
  next_try_tick_ = 0;
  wants_hold_ = holds_ || stops_ || is_at_feed_0();
  wants_resume_ = !wants_hold_ && (wants_resume_ || releases);
}

}  // namespace kerf
