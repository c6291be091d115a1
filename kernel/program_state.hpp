// What Kernel::state_left() gives.
#pragma once

#include <utility>

#include <kerf/kernel.hpp>

#include "parser/flow/reader_options.hpp"

namespace kerf {
inline namespace v0 {

class ProgramState {
 public:
  explicit ProgramState(parser::ReaderState of_reader) : of_reader_(std::move(of_reader)) {}
  [[nodiscard]] const parser::ReaderState& of_reader() const noexcept { return of_reader_; }

 private:
  parser::ReaderState of_reader_;
};

}  // namespace v0
}  // namespace kerf
