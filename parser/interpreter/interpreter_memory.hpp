// What the interpreter knows between blocks and of the block that is running.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "diagnostics/diagnostic_list.hpp"
#include "diagnostics/fault.hpp"
#include "parser/block/block.hpp"
#include "parser/compensation/cutter_compensation.hpp"
#include "parser/curves/nurbs_collector.hpp"
#include "parser/curves/uniform_collector.hpp"
#include "parser/cycles/drill_cycle.hpp"
#include "parser/dialects/dialect.hpp"
#include "parser/interpreter/saved_modes.hpp"
#include "parser/modal/codes.hpp"
#include "parser/modal/machine_data.hpp"
#include "parser/modal/modal_state.hpp"
#include "parser/moves/move_queue.hpp"
#include "parser/offsets/machine_values.hpp"

namespace kerf::parser {

// The members of Interpreter, whose functions are all that touch them.
class InterpreterMemory {
 public:
  InterpreterMemory(const InterpreterMemory&) = delete;
  InterpreterMemory& operator=(const InterpreterMemory&) = delete;

 protected:
  InterpreterMemory(diagnostics::DiagnosticList& diagnostics, MachineData machine, Dialect dialect)
      : machine_(std::move(machine)),
        dialect_(dialect),
        diagnostics_(&diagnostics),
        compensation_(diagnostics),
        nurbs_(diagnostics) {}
  ~InterpreterMemory() = default;

  ModalState state_;
  MachineData machine_;
  Dialect dialect_;
  // One place for the main program and for each call that is open.
  std::vector<std::optional<SavedModes>> saved_modes_{1};
  MoveQueue moves_;
  diagnostics::DiagnosticList* diagnostics_;
  CutterCompensation compensation_;
  NurbsCollector nurbs_;
  UniformCollector uniform_;
  std::vector<CycleStep> cycle_steps_;  // of the running block
  diagnostics::SourcePosition curve_source_;
  double curve_feedrate_mm_s_ = 0.0;
  Tenths skipped_curve_ = kNoCode;  // the code of a curve with an error whose blocks still come
  const Block* block_ = nullptr;    // of the running block
  Block counted_block_;             // with numbers that count in least increments
  BlockCodes codes_;
  Group axis_taker_ = Group::count;  // the code that takes the block's axis words from the motion
  diagnostics::Fault fault_;
  std::uint64_t blocks_run_ = 0;
  std::uint32_t line_ = 0;
  std::uint16_t file_ = 0;
  MachineValues values_{{&state_, &machine_, &dialect_, &line_, &saved_modes_}};
  std::uint32_t reported_line_ = 0;  // one error per block
  SurfaceFollowing surface_sent_{};
  bool no_feed_reported_ = false;
  bool stopped_spindle_reported_ = false;
  bool program_ended_ = false;
};

}  // namespace kerf::parser
