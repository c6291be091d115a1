// Records ticks: the trace, the plot, the accounts of the active constraints and of tools and
// operations, the page; any of them or none.
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <thread>

#include <boost/lockfree/spsc_queue.hpp>

#include "programs/kerf/page/plan_gatherer.hpp"
#include "programs/kerf/plot/plot_data.hpp"
#include "programs/kerf/report/speed_account.hpp"
#include "programs/kerf/report/time_parts.hpp"
#include "programs/kerf/run/trace_writer.hpp"

namespace kerf::program {

struct Recorder {
  std::optional<TraceWriter> trace;
  std::optional<PlotData> plot;
  std::optional<SpeedAccount> speed;
  std::optional<PartsAccount> parts;
  PlanGatherer* page = nullptr;  // of whom asks for the page

  [[nodiscard]] bool wants_ticks() const noexcept {
    return trace || plot || speed || parts || page != nullptr;
  }

  // Somebody who records a part of the motion has all of it.
  [[nodiscard]] bool has_enough() const noexcept {
    return (trace && trace->ended()) || (page != nullptr && page->columns().has_all());
  }

  void add(const TickRecord& record) {
    if (trace) {
      trace->add(record);
    }
    if (plot) {
      plot->add(record);
    }
    if (speed) {
      speed->add(record);
    }
    if (parts) {
      parts->add(record);
    }
    if (page != nullptr) {
      page->add(record);
    }
  }
};

// A recorder behind a ring, with a thread of its own. push() is for the tick: by the clock it waits
// for nothing and never sees the disk. Records that do not fit into the ring are dropped and
// counted then.
class RecorderThread {
 public:
  RecorderThread(Recorder& recorder, bool has_clock);
  ~RecorderThread();
  RecorderThread(const RecorderThread&) = delete;
  RecorderThread& operator=(const RecorderThread&) = delete;

  void push(const TickRecord& record) noexcept;
  // Waits until everything pushed is recorded. No push() may follow. Throws what the recorder
  // threw.
  void finish();

  [[nodiscard]] std::uint64_t dropped() const noexcept { return dropped_; }

 private:
  static constexpr std::size_t kRingRecords = 16'384;
  using Ring = boost::lockfree::spsc_queue<TickRecord, boost::lockfree::capacity<kRingRecords>>;

  void work() noexcept;
  void join() noexcept;

  Recorder* recorder_;
  bool has_clock_;
  std::unique_ptr<Ring> ring_ = std::make_unique<Ring>();
  std::atomic<bool> over_{false};
  std::atomic<bool> has_failed_{false};
  std::exception_ptr error_;
  std::uint64_t dropped_ = 0;
  std::thread thread_;
};

}  // namespace kerf::program
