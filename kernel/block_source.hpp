// The blocks of a program, in order, and the rests between them: what the planner takes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include <kerf/kernel.hpp>

#include "kernel/program_path.hpp"
#include "lookahead/path/block_builder.hpp"

namespace kerf {

struct BlockItem {
  lookahead::Block block;
  std::vector<parser::EventMove> changes;  // that come with it
};
struct ProgramEnd {};
// A move is a dwell or an event.
using ProgramItem = std::variant<BlockItem, parser::Move, ProgramEnd>;

// Reads the next item when it is asked for it. With `reads_apart` another thread reads ahead, and
// next() gives what it has read; path() is for that thread then, until next() has given the end.
// The motion of a probe comes together with the question after it, for it is planned with that.
class BlockSource {
 public:
  struct Order {
    ProgramPath::Order path{};
    lookahead::ScanFor scan{};
    bool reads_apart = false;
  };

  BlockSource(const MachineSettings& settings, const KernelOptions& options, const Order& order)
      : limits_(settings.limits),
        scan_(order.scan),
        reads_apart_(order.reads_apart),
        path_(settings, options, order.path) {}

  // Nothing: there is no more text, or nothing is read.
  std::optional<ProgramItem> next();

  // Of the thread that reads (Kernel::read).
  ReadStatus read();

  // Of the machine (ProgramPath::answer). Returns the line that asked it.
  std::uint32_t answer(const parser::MachineAnswer& answer);

  [[nodiscard]] ProgramPath& path() noexcept { return path_; }
  [[nodiscard]] const ProgramPath& path() const noexcept { return path_; }

 private:
  static constexpr std::size_t kBatch = 16;
  static constexpr std::size_t kMostAhead = 256;

  std::vector<ProgramItem> read_batch();
  std::optional<ProgramItem> read_item();
  // Nothing: it cannot be run, and the path ends before it.
  std::optional<ProgramItem> item_of(smoothing::PathSegment segment);
  [[nodiscard]] bool is_far_enough();

  lookahead::PlanLimits limits_;
  lookahead::ScanFor scan_;
  bool reads_apart_;
  std::mutex path_mutex_;  // of path_ and has_ended_, where another thread reads
  ProgramPath path_;
  bool has_ended_ = false;
  std::mutex ahead_mutex_;
  std::deque<ProgramItem> ahead_;
};

}  // namespace kerf
