// An observer of what passes from a program's text to its plan.
#pragma once

#include "lookahead/emit/emitter.hpp"
#include "lookahead/event_time.hpp"
#include "parser/program_reader.hpp"

namespace kerf {

// Called in program order, in the planning thread. Planned motion lags behind reading by up to one
// window.
class PipelineObserver {
 public:
  PipelineObserver() = default;
  PipelineObserver(const PipelineObserver&) = delete;
  PipelineObserver& operator=(const PipelineObserver&) = delete;
  virtual ~PipelineObserver() = default;

  // After each attempt to read a move.
  virtual void read(const parser::ProgramReader& /*reader*/) {}
  // The move was read.
  virtual void move(const parser::Move& /*move*/) {}
  // A dwell or event became a rest in the plan.
  virtual void rest(const lookahead::RestTime& /*time*/) {}
  // Goes to the plan.
  virtual void pushed(const lookahead::Block& /*block*/) {}
  // All of the program went there.
  virtual void ended() {}
  // All that was planned at once.
  virtual void planned(const lookahead::Outbox& /*outbox*/) {}
};

}  // namespace kerf
