// The real-time line: planned motion waits here until the tick reaches it.
#pragma once

#include <cstddef>

#include <boost/lockfree/spsc_queue.hpp>

#include "interp/motion.hpp"
#include "interp/outputs.hpp"

namespace kerf::interp {

// Wait-free rings of fixed size, for one producing and one consuming thread. Push a phase after the
// piece that it begins on and after the line changes up to there. The queued motion need not end at
// rest: the planner holds the rest of the path to a stop, and must push it before the tick has used
// up the queue. Phases of a plan that takes over stand behind those that they replace.
class MotionQueue {
 public:
  static constexpr std::size_t kPieces = 1024;
  static constexpr std::size_t kPhases = 4096;
  static constexpr std::size_t kOutputChanges = 1024;
  static constexpr std::size_t kLineChanges = 16'384;
  static constexpr std::size_t kTakeovers = 4;

  bool push(const CurvePiece& piece) { return pieces_.push(piece); }
  bool push(const Phase& phase) { return phases_.push(phase); }
  // In program order, each before the first phase that counts it.
  bool push(const OutputChange& change) { return output_changes_.push(change); }
  // In the order of their places.
  bool push(const LineChange& change) { return line_changes_.push(change); }
  // After all phases of its plan that lead to a rest.
  bool push(const Takeover& takeover) { return takeovers_.push(takeover); }

  // The next value without taking it; null where there is none.
  [[nodiscard]] const CurvePiece* next_piece() noexcept {
    return pieces_.read_available() > 0 ? &pieces_.front() : nullptr;
  }
  [[nodiscard]] const Phase* next_phase() noexcept {
    return phases_.read_available() > 0 ? &phases_.front() : nullptr;
  }
  [[nodiscard]] const OutputChange* next_output_change() noexcept {
    return output_changes_.read_available() > 0 ? &output_changes_.front() : nullptr;
  }
  [[nodiscard]] const LineChange* next_line_change() noexcept {
    return line_changes_.read_available() > 0 ? &line_changes_.front() : nullptr;
  }
  [[nodiscard]] const Takeover* next_takeover() noexcept {
    return takeovers_.read_available() > 0 ? &takeovers_.front() : nullptr;
  }
  void pop_piece() noexcept { pieces_.pop(); }
  void pop_phase() noexcept { phases_.pop(); }
  void pop_output_change() noexcept { output_changes_.pop(); }
  void pop_line_change() noexcept { line_changes_.pop(); }
  void pop_takeover() noexcept { takeovers_.pop(); }

  [[nodiscard]] std::size_t phases_free() const { return phases_.write_available(); }

 private:
  boost::lockfree::spsc_queue<CurvePiece, boost::lockfree::capacity<kPieces>> pieces_;
  boost::lockfree::spsc_queue<Phase, boost::lockfree::capacity<kPhases>> phases_;
  boost::lockfree::spsc_queue<OutputChange, boost::lockfree::capacity<kOutputChanges>>
      output_changes_;
  boost::lockfree::spsc_queue<LineChange, boost::lockfree::capacity<kLineChanges>> line_changes_;
  boost::lockfree::spsc_queue<Takeover, boost::lockfree::capacity<kTakeovers>> takeovers_;
};

}  // namespace kerf::interp
