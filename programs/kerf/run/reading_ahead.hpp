// Reads a program ahead of its plan, in a thread of its own.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include <kerf/kernel.hpp>

#include "programs/kerf/io/progress.hpp"
#include "programs/kerf/io/text_feed.hpp"
#include "programs/kerf/run/planning_side.hpp"

namespace kerf::program {

// For the thread that plans it is the side that plans, and never wants text but where that cannot
// be read: read() says why then. Of a text that is there as a whole. An error of the other thread
// is thrown by plan().
class ReadingAhead final : public PlanningSide, public TextFeed {
 public:
  // The kernel reads apart (KernelOptions).
  ReadingAhead(Kernel& kernel, TextFeed& text, Progress& progress);
  ~ReadingAhead() override;

  void feed(std::string_view /*text*/) override {}
  void finish() override {}
  bool plan() override;
  void text_is_late() override {}
  void stop() override { kernel_->stop(); }
  [[nodiscard]] const Kernel& kernel() const override { return *kernel_; }

  // Precondition: plan() wants text.
  tl::expected<TextPiece, std::string> read() override;
  [[nodiscard]] double share_read() const noexcept override { return text_->share_read(); }

 private:
  void work() noexcept;
  // True: it goes on.
  bool read_on();
  bool feed_piece();
  // Until there may be room, or the plan wants it.
  void pause();
  // Waits for what is read next. False: nothing comes any more.
  bool wait();

  Kernel* kernel_;
  TextFeed* text_;
  Progress* progress_;
  std::mutex mutex_;
  std::condition_variable wanted_change_;
  std::condition_variable read_change_;
  bool is_wanted_ = false;
  bool is_read_ = false;  // something, since the plan asked last
  bool over_ = false;     // nothing more is wanted
  bool has_ended_ = false;
  std::optional<std::string> error_;  // not written any more once it has ended
  std::exception_ptr exception_;
  std::thread thread_;  // the last: it uses all of the above
};

}  // namespace kerf::program
