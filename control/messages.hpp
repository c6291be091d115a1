// The latest messages of programs, for any number of readers, without a lock.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include <kerf/program_data.hpp>

#include "control/snapshot.hpp"

namespace kerf::control {

class Messages {
 public:
  // The number that it has from now on. One thread.
  std::uint32_t add(const ProgramMessage& message) noexcept {
    Kept kept{.number = ++latest_, .kind = message.kind, .line = message.line};
    kept.size = std::min(message.text.size(), kept.text.size());
    std::copy_n(message.text.begin(), kept.size, kept.text.begin());
    kept_[kept.number % kKept].write(kept);
    return kept.number;
  }
  // Nothing: it is forgotten.
  [[nodiscard]] std::optional<ProgramMessage> find(std::uint32_t number) const {
    const Kept kept = kept_[number % kKept].read();
    if (number == 0 || kept.number != number) {
      return std::nullopt;
    }
    return ProgramMessage{
        .kind = kept.kind, .line = kept.line, .text = std::string(kept.text.data(), kept.size)};
  }

 private:
  static constexpr std::size_t kKept = 1024;
  static constexpr std::size_t kLongest = 500;  // bytes

  struct Kept {
    std::uint32_t number = 0;
    ProgramMessage::Kind kind = ProgramMessage::Kind::message;
    std::uint32_t line = 0;
    std::size_t size = 0;
    std::array<char, kLongest> text{};
  };

  std::uint32_t latest_ = 0;
  std::array<Snapshot<Kept>, kKept> kept_{};
};

}  // namespace kerf::control
