// The connection to a machine in another process: frames, each whole or not at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include <tl/expected.hpp>

#include "programs/kerf/driver/frames.hpp"
#include "programs/kerf/io/descriptor.hpp"

namespace kerf::program {

class FrameSocket {
 public:
  // Connects to who listens at the path, tells the machine to be off, and waits for its answer.
  // Error: why there is none, with the path.
  static tl::expected<FrameSocket, std::string> open(const std::string& path, double timeout_s);
  // Closes it so that the other end hears all that it was told.
  ~FrameSocket();
  FrameSocket(FrameSocket&&) noexcept = default;
  FrameSocket& operator=(FrameSocket&&) = delete;

  // The rest is for the tick: nothing waits, allocates or throws.

  // False: errno says why.
  bool send(const ToldFrame& told) noexcept;
  struct Received {
    enum class What : std::uint8_t {
      nothing,  // none has come
      frame,    // of whatever kind: an answer, or what is none
      hung_up
    };
    What what = What::nothing;
    std::size_t bytes = 0;
    std::optional<AnswerFrame> answer{};
  };
  Received receive() noexcept;
  void hang_up() noexcept;

  // What the machine answered first.
  [[nodiscard]] const AnswerFrame& greeting() const noexcept { return greeting_; }

 private:
  explicit FrameSocket(Descriptor socket) noexcept : socket_(std::move(socket)) {}
  // Empty: it answers.
  [[nodiscard]] std::string greet(double timeout_s);

  Descriptor socket_;
  AnswerFrame greeting_{};
};

}  // namespace kerf::program
