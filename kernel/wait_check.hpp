// Finds blocks that wait for an answer where nobody can give one.
#pragma once

#include <variant>

#include <kerf/kernel.hpp>

#include "parser/moves/move.hpp"

namespace kerf {

class WaitCheck {
 public:
  explicit WaitCheck(const KernelOptions& options) noexcept
      : refuses_(options.refuses_waits), optional_stop_(options.optional_stop) {}

  void set_optional_stop(bool on) noexcept { optional_stop_ = on; }

  static constexpr const char* kWhy =
      "the program waits for an answer here, and nobody is there to give it";
  [[nodiscard]] bool refuses(const parser::Move& move) const noexcept {
    const auto* event = std::get_if<parser::EventMove>(&move.shape);
    return refuses_ && event != nullptr && parser::waits_for_answer(event->kind, optional_stop_);
  }

 private:
  bool refuses_;
  bool optional_stop_;
};

}  // namespace kerf
