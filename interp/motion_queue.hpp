// The real-time line: planned motion waits here until the tick reaches it.
#pragma once

#include <cstddef>

#include <boost/lockfree/spsc_queue.hpp>

#include "interp/motion.hpp"

namespace kerf::interp {

// Two wait-free rings of fixed size, for one producing and one consuming thread. A phase is pushed
// after the piece that it begins on. What lies here need not end at rest: the planner holds the
// rest of the way to a stop, and must push it before the tick has used up what is here.
class MotionQueue {
 public:
  static constexpr std::size_t kPieces = 1024;
  static constexpr std::size_t kPhases = 4096;

  bool push(const PathPiece& piece) { return pieces_.push(piece); }
  bool push(const Phase& phase) { return phases_.push(phase); }

  // The next value without taking it; null where there is none.
  [[nodiscard]] const PathPiece* next_piece() noexcept {
    return pieces_.read_available() > 0 ? &pieces_.front() : nullptr;
  }
  [[nodiscard]] const Phase* next_phase() noexcept {
    return phases_.read_available() > 0 ? &phases_.front() : nullptr;
  }
  void pop_piece() noexcept { pieces_.pop(); }
  void pop_phase() noexcept { phases_.pop(); }

  [[nodiscard]] std::size_t phases_free() const { return phases_.write_available(); }
  [[nodiscard]] std::size_t pieces_free() const { return pieces_.write_available(); }

 private:
  boost::lockfree::spsc_queue<PathPiece, boost::lockfree::capacity<kPieces>> pieces_;
  boost::lockfree::spsc_queue<Phase, boost::lockfree::capacity<kPhases>> phases_;
};

}  // namespace kerf::interp
