// The real-time line: planned motion waits here until the tick reaches it.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include <boost/lockfree/spsc_queue.hpp>

#include "interp/motion.hpp"
#include "interp/outputs.hpp"

namespace kerf::interp {

// Wait-free rings of fixed size, for one producing and one consuming thread. Push a phase after the
// piece that it begins on and after the line changes up to there; it counts once it is committed.
// Phases of a plan that takes over stand after those that they replace.
//
// The queued motion need not end at rest. A way to rest may be committed with it, and the consumer
// takes it at its tick if no other has come by then. One word decides: the producer's commit and
// the consumer's take exchange it, and whichever comes second fails: a commit after a take, and a
// take after a commit that replaced the stop. What was pushed by a producer that lost is passed
// over.
class MotionQueue {
 public:
  static constexpr std::size_t kPieces = 4096;
  static constexpr std::size_t kPhases = 8192;
  // So many stay free of what is planned ahead: room for a plan that takes over, and for what was
  // planned last and waits.
  static constexpr std::size_t kPhasesKeptFree = 3072;
  static constexpr std::size_t kPhasesOfTakeover = 2048;  // before it is planned, at the least
  static constexpr std::size_t kOutputChanges = 4096;
  static constexpr std::size_t kLineChanges = 16'384;
  static constexpr std::size_t kTakeovers = 4;

  bool push(const CurvePiece& piece) { return pieces_.push(piece); }
  bool push(const Phase& phase) {
    const bool pushed = phases_.push(phase);
    phases_pushed_ += pushed ? 1 : 0;
    return pushed;
  }
  // In program order, each before the first phase that counts it.
  bool push(const OutputChange& change) { return output_changes_.push(change); }
  // In the order of their places.
  bool push(const LineChange& change) { return line_changes_.push(change); }
  // After all phases of its plan that lead to a rest, and before they are committed.
  bool push(const Takeover& takeover) { return takeovers_.push(takeover); }

  // Where a stop ahead that is to be committed is written.
  [[nodiscard]] StopAhead& spare_stop() { return stops_[1 - slot_]; }
  // All phases that were pushed, with the stop ahead as it is, with the one that was written, or
  // without. Beside it: the one that was written is for a plan that takes over, until settle().
  // False: the consumer has taken a stop ahead.
  enum class Ahead : std::uint8_t { same, written, beside, none };
  bool commit(Ahead ahead = Ahead::same);
  // Of the two, that of the plan in force stays. Call it after a commit beside, and no other but
  // those with the stop ahead as it is between them.
  void settle(bool took_over);
  [[nodiscard]] bool stop_taken() const {
    return (word_.load(std::memory_order_relaxed) & kTaken) != 0;
  }
  // The stop ahead that was taken has been read: commits are possible again.
  void release_stop() {
    word_.store(word_.load(std::memory_order_relaxed) & ~(kTaken | has_bit(0) | has_bit(1)));
  }
  // How many, ever.
  [[nodiscard]] std::uint32_t phases_pushed() const { return phases_pushed_; }

  // The consumer's: whether so many phases are committed.
  [[nodiscard]] bool is_committed(std::uint32_t phases) const noexcept {
    const auto committed = static_cast<std::uint32_t>(word_.load(std::memory_order_acquire));
    return static_cast<std::int32_t>(committed - phases) >= 0;
  }
  [[nodiscard]] bool has_stop() const noexcept {
    const std::uint64_t word = word_.load(std::memory_order_relaxed);
    return (word & kTaken) == 0 && (word & (has_bit(0) | has_bit(1))) != 0;
  }
  // The stop ahead of that plan at that tick, taken; null: there is none. It is good until
  // release_stop().
  [[nodiscard]] const StopAhead* take_stop(std::uint32_t from, std::int64_t tick) noexcept;

  // The next value without taking it; null where there is none.
  [[nodiscard]] const CurvePiece* next_piece() noexcept {
    return pieces_.read_available() > 0 ? &pieces_.front() : nullptr;
  }
  [[nodiscard]] const Phase* next_phase() noexcept {
    const auto committed = static_cast<std::uint32_t>(word_.load(std::memory_order_acquire));
    return committed != phases_popped_ ? &phases_.front() : nullptr;
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
  void pop_phase() noexcept {
    phases_.pop();
    ++phases_popped_;
  }
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

  // The word: how many phases are committed, which stops are ahead, and a number of its own for
  // each commit, so that no two are the same.
  static constexpr std::uint64_t kTaken = 1ULL << 32U;
  static constexpr unsigned kNumberBit = 35;
  // A commit that keeps the stop ahead may come between. So many in a row do not: each takes the
  // producer longer than a take.
  static constexpr int kTakes = 64;
  static constexpr std::uint64_t has_bit(unsigned slot) { return 1ULL << (33U + slot); }
  std::atomic<std::uint64_t> word_ = 0;
  std::uint32_t phases_pushed_ = 0;
  std::uint32_t phases_popped_ = 0;
  // Of the stops: written one by one before the commit, read before the take.
  struct StopKey {
    std::atomic<std::uint32_t> from = 0;
    std::atomic<std::int64_t> tick = 0;
  };
  std::array<StopKey, 2> keys_{};
  std::array<StopAhead, 2> stops_{};
  unsigned slot_ = 0;  // of the latest that was committed, but beside it
};

}  // namespace kerf::interp
