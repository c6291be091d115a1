// Who says what a probe touches and what inputs are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "parser/moves/move.hpp"

namespace kerf::parser {

// Of a probe, straight.
struct ProbedWay {
  Point from_mm{};  // of the machine's axes
  Point to_mm{};
  std::int32_t tool = 0;  // in the spindle
  bool until_contact = true;
};

// Stands in for a machine where there is no motion that it could answer to.
class AssumedMachine {
 public:
  AssumedMachine() = default;
  virtual ~AssumedMachine() = default;
  AssumedMachine(const AssumedMachine&) = delete;
  AssumedMachine& operator=(const AssumedMachine&) = delete;

  // There is something that a probe may touch.
  [[nodiscard]] virtual bool has_surface() const = 0;
  // Where the way begins.
  [[nodiscard]] virtual bool touches(const ProbedWay& way) const = 0;
  // Where contact begins, or ends; nothing: it does not on this way.
  [[nodiscard]] virtual std::optional<Point> change_of_contact(const ProbedWay& way) const = 0;
  [[nodiscard]] virtual bool digital(std::size_t input) const = 0;
  [[nodiscard]] virtual double analog(std::size_t input) const = 0;
  // How long the spindle takes to its speed, clockwise positive.
  [[nodiscard]] virtual double spindle_time_s(double from_per_min, double to_per_min) const = 0;
};

struct MachineSource {
  // The reader waits at G38 and M66 for the machine's answer. Else a machine is assumed.
  bool is_asked = false;
  std::uint64_t asked_from_block = 0;               // Move::block; what comes before is not run
  bool waits_for_spindle = false;                   // after M3, M4 and a new S: the same
  std::shared_ptr<const AssumedMachine> assumed{};  // null: nothing is touched, inputs are low
  // Of an assumed one: how long the tool rests for an answer that is there at the first look, how
  // long a look takes, and what a spindle that starts is given before it is asked.
  double answer_s = 0.0;
  double look_s = 0.0;
  double spindle_start_s = 0.0;

  [[nodiscard]] bool asks_in(std::uint64_t block) const noexcept {
    return is_asked && block >= asked_from_block;
  }
};

}  // namespace kerf::parser
