#include "programs/kerf/driver/frames.hpp"

#include <bit>
#include <concepts>
#include <cstring>
#include <type_traits>

#include <boost/crc.hpp>

namespace kerf::program {

namespace {

static_assert(std::endian::native == std::endian::little, "frames are little-endian");

constexpr std::uint32_t kToldMark = 0x4454'464B;    // "KFTD"
constexpr std::uint32_t kAnswerMark = 0x4E41'464B;  // "KFAN"
constexpr std::size_t kChecksumBytes = 4;

// Writing and reading are one walk over the fields (walk), with one of these.
class FrameWriter {
 public:
  explicit FrameWriter(std::span<std::byte> bytes) noexcept : bytes_(bytes) {}

  template <typename Value>
  requires std::is_arithmetic_v<Value>
  void operator()(const Value& value) noexcept {
    std::memcpy(bytes_.data() + at_, &value, sizeof value);
    at_ += sizeof value;
  }
  template <typename Value, std::size_t kCount>
  void operator()(const std::array<Value, kCount>& values) noexcept {
    for (const Value& value : values) {
      (*this)(value);
    }
  }
  template <typename Enum>
  requires std::is_enum_v<Enum>
  void operator()(const Enum& value, Enum /*last*/) noexcept {
    (*this)(static_cast<std::uint8_t>(value));
  }

 private:
  std::span<std::byte> bytes_;
  std::size_t at_ = 0;
};

class FrameReader {
 public:
  explicit FrameReader(std::span<const std::byte> bytes) noexcept : bytes_(bytes) {}

  template <typename Value>
  requires std::is_arithmetic_v<Value>
  void operator()(Value& value) noexcept {
    if constexpr (std::same_as<Value, bool>) {
      const std::byte byte = bytes_[at_++];
      possible_ = possible_ && byte <= std::byte{1};
      value = byte == std::byte{1};
    } else {
      std::memcpy(&value, bytes_.data() + at_, sizeof value);
      at_ += sizeof value;
    }
  }
  template <typename Value, std::size_t kCount>
  void operator()(std::array<Value, kCount>& values) noexcept {
    for (Value& value : values) {
      (*this)(value);
    }
  }
  template <typename Enum>
  requires std::is_enum_v<Enum>
  void operator()(Enum& value, Enum last) noexcept {
    std::uint8_t number = 0;
    (*this)(number);
    possible_ = possible_ && number <= static_cast<std::uint8_t>(last);
    value = static_cast<Enum>(number);
  }
  [[nodiscard]] bool is_possible() const noexcept { return possible_; }

 private:
  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
  bool possible_ = true;
};

template <typename Fields>
void walk_outputs(Fields& fields, auto& outputs) {
  fields(outputs.spindle_rad_s);
  fields(outputs.surface.mm_s);
  fields(outputs.surface.max_rad_s);
  fields(outputs.surface.per_x);
  fields(outputs.surface.per_y);
  fields(outputs.surface.at_origin_mm);
  fields(outputs.spindle_angle_rad);
  fields(outputs.digital);
  fields(outputs.analog);
  fields(outputs.tool);
  fields(outputs.follows_speed_override);
  fields(outputs.follows_adaptive_feed);
  fields(outputs.heeds_feed_stop);
  fields(outputs.spindle_held);
  fields(outputs.mist);
  fields(outputs.flood);
}

template <typename Fields>
void walk_inputs(Fields& fields, auto& inputs) {
  fields(inputs.digital);
  fields(inputs.analog);
  fields(inputs.home);
  fields(inputs.lower_limit);
  fields(inputs.upper_limit);
  fields(inputs.probe);
  fields(inputs.door_open);
  fields(inputs.emergency_loop_open);
  fields(inputs.tool_changed);
  fields(inputs.spindle_at_speed);
}

template <typename Fields>
void walk(Fields& fields, auto& setpoint) {
  fields(setpoint.tick);
  fields(setpoint.position_mm);
  fields(setpoint.extra_rad_mm);
  fields(setpoint.velocity_mm_s);
  fields(setpoint.acceleration_mm_s2);
  fields(setpoint.s_mm);
  fields(setpoint.v_mm_s);
  fields(setpoint.a_mm_s2);
  fields(setpoint.j_mm_s3);
  walk_outputs(fields, setpoint.outputs);
  fields(setpoint.line);
  fields(setpoint.limit, static_cast<Constraint>(34));  // the jerk of the last axis
  fields(setpoint.rapid);
}

template <typename Fields>
void walk_state(Fields& fields, auto& state) {
  fields(state.actual_mm);
  fields(state.extra_rad_mm);
  fields(state.following_error_mm);
  fields(state.contour_error_mm);
  walk_outputs(fields, state.outputs);
  walk_inputs(fields, state.inputs);
  for (auto& axis : state.axes) {
    fields(axis, machine::AxisState::stopping);
  }
  fields(state.fault, machine::kLastDriveFault);
  fields(state.fault_axis);
  fields(state.has_latched);
  fields(state.latched_mm);
}

std::uint32_t checksum(std::span<const std::byte> bytes) noexcept {
  boost::crc_32_type sum;
  sum.process_bytes(bytes.data(), bytes.size());
  return sum.checksum();
}

// The bytes after the last field stay 0.
template <std::size_t kBytes>
void seal(std::array<std::byte, kBytes>& bytes) noexcept {
  const std::uint32_t sum = checksum(std::span(bytes).first(kBytes - kChecksumBytes));
  std::memcpy(bytes.data() + kBytes - kChecksumBytes, &sum, sizeof sum);
}

bool is_sealed(std::span<const std::byte> bytes, std::uint32_t mark, std::size_t size) noexcept {
  if (bytes.size() != size) {
    return false;
  }
  std::array<std::uint32_t, 2> head{};
  std::uint32_t sum = 0;
  std::memcpy(head.data(), bytes.data(), sizeof head);
  std::memcpy(&sum, bytes.data() + size - kChecksumBytes, sizeof sum);
  return head[0] == mark && head[1] == kFrameVersion &&
         sum == checksum(bytes.first(size - kChecksumBytes));
}

}  // namespace

ToldBytes to_bytes(const ToldFrame& frame) noexcept {
  ToldBytes bytes{};
  FrameWriter fields(bytes);
  fields(kToldMark);
  fields(kFrameVersion);
  walk(fields, frame.setpoint);
  fields(frame.call, MachineCall::disable);
  seal(bytes);
  return bytes;
}

AnswerBytes to_bytes(const AnswerFrame& frame) noexcept {
  AnswerBytes bytes{};
  FrameWriter fields(bytes);
  fields(kAnswerMark);
  fields(kFrameVersion);
  fields(frame.tick);
  walk_state(fields, frame.state);
  seal(bytes);
  return bytes;
}

std::optional<ToldFrame> told_from(std::span<const std::byte> bytes) noexcept {
  if (!is_sealed(bytes, kToldMark, kToldBytes)) {
    return std::nullopt;
  }
  FrameReader fields(bytes.subspan(8));
  ToldFrame frame;
  walk(fields, frame.setpoint);
  fields(frame.call, MachineCall::disable);
  return fields.is_possible() && frame.call >= MachineCall::enable ? std::optional(frame)
                                                                   : std::nullopt;
}

std::optional<AnswerFrame> answer_from(std::span<const std::byte> bytes) noexcept {
  if (!is_sealed(bytes, kAnswerMark, kAnswerBytes)) {
    return std::nullopt;
  }
  FrameReader fields(bytes.subspan(8));
  AnswerFrame frame;
  fields(frame.tick);
  walk_state(fields, frame.state);
  const bool names_axis = frame.state.fault_axis >= -1 &&
                          frame.state.fault_axis < static_cast<std::int8_t>(machine::kAllAxes);
  return fields.is_possible() && names_axis ? std::optional(frame) : std::nullopt;
}

}  // namespace kerf::program
