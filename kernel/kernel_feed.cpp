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
  if (overrides.spindle != overrides_.spindle) {
    override_spindle_by(overrides.spindle);
  }
  const double feed = heeded_share(overrides.feed);
  const double feed_before = std::exchange(feed_, feed > 0.0 ? feed : feed_);
  wants_change_ |= feed_ != feed_before || overrides.rapid != overrides_.rapid ||
                   overrides.spindle != overrides_.spindle;
  overrides_ = overrides;
  overrides_.feed = feed;
  stopped_feed_.by_override = feed == 0.0;
  stop_feed();
  plan();
  return true;
}

// A tick has it once it was told, so which one that is the plan's clock knows.
void Kernel::Impl::override_spindle_by(double share) {
  const auto at_once = [](std::int64_t /*ticks*/) { return true; };
  interpolator_.override_spindle_by(share);
  plan_clock_ ? calls_.tell(plan_clock_) : calls_.tell(at_once);
}

bool Kernel::Impl::set_feed_inputs(const FeedInputs& inputs) {
  if (!is_possible(inputs)) {
    return false;
  }
  const double adaptive = heeded_share(inputs.adaptive);
  stopped_feed_.by_adaptive = adaptive == 0.0;
  stopped_feed_.by_machine = inputs.stop;
  stop_feed();
  if (adaptive > 0.0 && adaptive != adaptive_) {
    adaptive_ = adaptive;
    wants_change_ = true;
  }
  plan();
  return true;
}

void Kernel::Impl::stop_feed() {
  pipeline_.stop_feed(stopped_feed_);
  next_hold_tick_ = next_try_tick_ = 0;
}

bool Kernel::Impl::is_at_feed_0() const noexcept {
  const interp::Interpolator::Heeded heeded = interpolator_.heeded();
  return stopped_feed_.stops({.feed = heeded.feed_override,
                              .adaptive = heeded.adaptive_feed,
                              .feed_stop = heeded.feed_stop});
}

void Kernel::Impl::try_hold_feed() {
  if (pipeline_.is_held() && (is_at_hold() || !pipeline_.is_held_by_feed())) {
    return;
  }
  if (!has_room_to_hold()) {
    return;
  }
  lookahead::Outbox plan;
  const std::uint32_t from = pipeline_.plan();
  if (!pipeline_.hold_feed(stop_order(), plan)) {
    next_hold_tick_ = now() + margin_ticks_ / 2;
    return;
  }
  if (!plan.phases.empty()) {
    static_cast<void>(hand_over_hold(std::move(plan), from));
  }
}

}  // namespace kerf
