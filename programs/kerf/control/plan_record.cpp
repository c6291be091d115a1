#include "programs/kerf/control/plan_record.hpp"

#include <utility>

namespace kerf::program {

namespace {

constexpr unsigned kBits = 7;  // of a number in each byte; the highest bit: more follow

void append(std::uint64_t number, std::string& bytes) {
  for (; number >> kBits != 0; number >>= kBits) {
    bytes.push_back(static_cast<char>((number & 0x7FU) | 0x80U));
  }
  bytes.push_back(static_cast<char>(number));
}

// Nothing: there is none; `bytes` are empty then.
std::optional<std::uint64_t> take_number(std::string_view& bytes) {
  std::uint64_t number = 0;
  for (unsigned shift = 0; shift < 64 && !bytes.empty(); shift += kBits) {
    const auto byte = static_cast<unsigned char>(bytes.front());
    bytes.remove_prefix(1);
    number |= static_cast<std::uint64_t>(byte & 0x7FU) << shift;
    if (byte < 0x80U) {
      return number;
    }
  }
  bytes = {};
  return std::nullopt;
}

// Small where the number is near 0.
std::uint64_t folded(std::int64_t number) {
  return (static_cast<std::uint64_t>(number) << 1U) ^ static_cast<std::uint64_t>(number >> 63U);
}
std::int64_t unfolded(std::uint64_t number) {
  return static_cast<std::int64_t>(number >> 1U) ^ -static_cast<std::int64_t>(number & 1U);
}

// The first number of an entry. Of looks: twice the folded way from the tick before, and how many
// follows. Of an order: this, and its length and text follow.
constexpr std::uint64_t kOrder = 1;

}  // namespace

void PlanRecord::add_look(std::int64_t tick) {
  if (tick != tick_) {
    finish();
    tick_ = tick;
  }
  ++looks_;
}

void PlanRecord::take_back_look() {
  if (looks_ > 0) {  // else an order came after it
    --looks_;
  }
}

void PlanRecord::add_order(std::string_view text) {
  finish();
  append(kOrder, entries_);
  append(text.size(), entries_);
  entries_ += text;
  has_orders_ = true;
}

void PlanRecord::finish() {
  if (looks_ > 0) {
    append(folded(tick_ - before_) << 1U, entries_);
    append(std::exchange(looks_, 0), entries_);
    before_ = tick_;
  }
}

std::string PlanRecord::bytes() const {
  PlanRecord whole = *this;
  whole.finish();
  std::string bytes;
  append((is_attended ? 1U : 0U) | (waits_for_start ? 2U : 0U) | (homes ? 4U : 0U) |
             (start_waits ? 8U : 0U),
         bytes);
  append(emergency_tick ? folded(*emergency_tick) + 1 : 0, bytes);
  return bytes + whole.entries_;
}

std::optional<PlanRecord> PlanRecord::from_bytes(std::string_view bytes) {
  const auto flags = take_number(bytes);
  const auto emergency = take_number(bytes);
  if (!flags || !emergency) {
    return std::nullopt;
  }
  PlanRecord record;
  record.is_attended = (*flags & 1U) != 0;
  record.waits_for_start = (*flags & 2U) != 0;
  record.homes = (*flags & 4U) != 0;
  record.start_waits = (*flags & 8U) != 0;
  if (*emergency != 0) {
    record.emergency_tick = unfolded(*emergency - 1);
  }
  record.entries_ = bytes;
  record.has_orders_ = true;
  return record;
}

bool PlanRecord::Reader::take_look(std::int64_t tick) {
  if (looks_ == 0 || tick != tick_) {
    return false;
  }
  if (--looks_ == 0) {
    next();
  }
  return true;
}

std::optional<std::string_view> PlanRecord::Reader::take_order() {
  const auto taken = order();
  if (taken) {
    order_.reset();
    next();
  }
  return taken;
}

void PlanRecord::Reader::next() {
  const auto first = take_number(rest_);
  const auto count = take_number(rest_);
  if (!first || !count) {
    return;
  }
  if (*first == kOrder) {
    order_ = rest_.substr(0, *count);
    rest_.remove_prefix(order_->size());
  } else {
    tick_ += unfolded(*first >> 1U);
    looks_ = *count;
  }
}

}  // namespace kerf::program
