// A program that is run from one of its blocks on.
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "kernel/tick_judge.hpp"
#include "parser/modal/machine_source.hpp"
#include "smoothing/smoother.hpp"

namespace kerf {

// The events that would switch spindle, coolant, tool and outputs to what a part of a program has
// left them at.
class SwitchedState {
 public:
  void add(const parser::EventMove& event);

  [[nodiscard]] const std::optional<parser::EventMove>& tool() const noexcept { return tool_; }
  // And what the overrides are for.
  [[nodiscard]] std::vector<parser::EventMove> outputs() const;
  [[nodiscard]] const std::optional<parser::EventMove>& spindle() const noexcept {
    return spindle_;
  }
  [[nodiscard]] std::vector<parser::EventMove> coolant() const;

 private:
  using Key = std::pair<parser::EventKind, std::int32_t>;

  std::optional<parser::EventMove> tool_;
  std::optional<parser::EventMove> spindle_;
  std::optional<parser::EventMove> mist_;
  std::optional<parser::EventMove> flood_;
  std::map<Key, parser::EventMove> others_;
};

// The path of the whole program comes in; what lies before the start is left out, and in its place
// comes the way of the tool to where the rest begins: up to the safe height, there the tool change,
// outputs and spindle, over the place in X, Y and all further axes, coolant, down at feedrate. So
// the rest is the same path to the last bit, corners that are rounded and lines that are merged
// included.
class StartInMiddle {
 public:
  using Output = smoothing::Smoother::Output;

  // answers: as of the run, which waits for the spindle after a start of its own, too.
  StartInMiddle(const StartInProgram& start, const MachineSettings& settings,
                parser::MachineSource answers, const PlaceOfTool& tool);

  // The reader's moves that belong to the part.
  [[nodiscard]] bool leaves_out(std::uint64_t block) const noexcept {
    return block <= start_.blocks_before;
  }
  // True: the output belongs to the part, and is noted.
  bool leaves_out(const Output& output);
  // To the first output that does not.
  [[nodiscard]] std::vector<Output> way_to(const Output& first) const;

 private:
  StartInProgram start_;
  parser::MachineSource answers_;
  PlaceOfTool tool_;
  double safe_z_mm_;  // infinite: the highest place of the part
  double highest_mm_;
  double feedrate_mm_s_;  // of the latest move that goes through mm
  SwitchedState switched_;
};

// The block that an output of the path begins with (parser::Move::block).
[[nodiscard]] std::uint64_t first_block(const smoothing::Smoother::Output& output);

}  // namespace kerf
