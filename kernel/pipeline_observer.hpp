// What passes on the way from a program's text to its plan.
#pragma once

#include "lookahead/emit/emitter.hpp"
#include "parser/program_reader.hpp"

namespace kerf {

// Told in the order of the program: what is planned comes later than what is read, by up to a
// window. The planning side's thread.
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
  // A move is a rest in the plan.
  virtual void rest() {}
  // All that was planned at once.
  virtual void planned(const lookahead::Outbox& /*outbox*/) {}
};

}  // namespace kerf
