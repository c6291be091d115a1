// A file with all that a machine was told in a run, and what it answered.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <thread>

#include <boost/lockfree/spsc_queue.hpp>
#include <tl/expected.hpp>

#include "programs/kerf/driver/frames.hpp"
#include "programs/kerf/io/output_file.hpp"

namespace kerf::program {

// One call and its answer.
struct RecordedCall {
  ToldBytes told{};
  AnswerBytes answer{};
};
static_assert(sizeof(RecordedCall) == kToldBytes + kAnswerBytes);

// A file of the format that docs/machine-interface.md describes, with a thread that writes it.
class RecordWriter {
 public:
  enum class WhenFull : std::uint8_t {
    drop,  // by the clock: the tick waits for nothing
    wait   // without a clock
  };

  // Error: what the system says, with the path.
  static tl::expected<std::unique_ptr<RecordWriter>, std::string> create(const std::string& path,
                                                                         double period_s,
                                                                         WhenFull when_full);
  ~RecordWriter();
  RecordWriter(const RecordWriter&) = delete;
  RecordWriter& operator=(const RecordWriter&) = delete;

  // For the tick: allocates nothing, takes no lock, and waits only where it was asked for. What is
  // dropped is counted.
  void push(const RecordedCall& call) noexcept;
  // Writes what is left, and what the planning side did (PlanRecord); empty: that is not kept. No
  // push() may follow. A record that was not finished has no end, and not its name. Error: why it
  // is not whole.
  [[nodiscard]] std::optional<std::string> finish(std::string_view plan_record);

  [[nodiscard]] bool follows_incomplete() const noexcept { return file_.follows_incomplete(); }

 private:
  static constexpr std::size_t kRingCalls = 8192;
  using Ring = boost::lockfree::spsc_queue<RecordedCall, boost::lockfree::capacity<kRingCalls>>;

  RecordWriter(OutputFile file, double period_s, WhenFull when_full);
  void work() noexcept;
  void write_head() noexcept;
  void write(std::span<const std::byte> bytes) noexcept;
  void join() noexcept;

  OutputFile file_;
  double period_s_;
  bool has_head_ = false;  // the file
  WhenFull when_full_;
  std::unique_ptr<Ring> ring_ = std::make_unique<Ring>();
  std::atomic<bool> over_{false};
  std::uint64_t dropped_ = 0;  // of the thread that pushes
  std::uint64_t written_ = 0;  // of the other
  int error_ = 0;
  std::thread thread_;
};

// A whole record, mapped into memory and checked from end to end.
class RecordReader {
 public:
  // Error: why it cannot be read, is torn, or is no record of this kind, with the path.
  static tl::expected<RecordReader, std::string> open(const std::string& path, double period_s);
  // plan_record() of such a file, without a look at the rest. Empty: there is none, or it is no
  // whole record.
  static std::string plan_record_in(const std::string& path);
  ~RecordReader();
  RecordReader(RecordReader&& other) noexcept;
  RecordReader& operator=(RecordReader&&) = delete;

  [[nodiscard]] std::span<const RecordedCall> calls() const noexcept { return calls_; }
  // What the planning side did; empty: it was not kept.
  [[nodiscard]] std::string_view plan_record() const noexcept { return plan_record_; }

 private:
  RecordReader(void* map, std::size_t bytes) noexcept : map_(map), bytes_(bytes) {}
  // Why it is not what it should be; nothing: it is.
  [[nodiscard]] std::optional<std::string> look(double period_s);

  void* map_ = nullptr;
  std::size_t bytes_ = 0;
  std::span<const RecordedCall> calls_;
  std::string_view plan_record_;
};

}  // namespace kerf::program
