// Finds blocks that wait for an answer where nobody can give one.
#pragma once

#include <cstdint>
#include <variant>

#include <kerf/kernel.hpp>

#include "parser/moves/move.hpp"

namespace kerf {

class WaitCheck {
 public:
  explicit WaitCheck(const KernelOptions& options) noexcept
      : refuses_(options.refuses_waits),
        optional_stop_(options.optional_stop),
        blocks_before_(options.start_in_program ? options.start_in_program->blocks_before : 0) {}

  void set_optional_stop(bool on) noexcept { optional_stop_ = on; }

  static constexpr const char* kWhy =
      "the program waits for an answer here, and nobody is there to give it";
  [[nodiscard]] bool refuses(const parser::Move& move) const noexcept {
    const auto* event = std::get_if<parser::EventMove>(&move.shape);
    return refuses_ && event != nullptr && is_run(move, *event) &&
           parser::waits_for_answer(event->kind, optional_stop_);
  }

 private:
  // What is before a start in the program is left out, but its tool is changed in.
  [[nodiscard]] bool is_run(const parser::Move& move,
                            const parser::EventMove& event) const noexcept {
    return move.block > blocks_before_ || event.kind == parser::EventKind::tool_change;
  }

  bool refuses_;
  bool optional_stop_;
  std::uint64_t blocks_before_;
};

}  // namespace kerf
