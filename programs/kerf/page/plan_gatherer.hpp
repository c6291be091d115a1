// What the page shows of a run, gathered tick by tick in bounded memory.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <kerf/kernel.hpp>

#include "programs/kerf/page/code_runs.hpp"
#include "programs/kerf/page/motion_runs.hpp"
#include "programs/kerf/page/nominal_lines.hpp"
#include "programs/kerf/page/planned_path.hpp"
#include "programs/kerf/page/tick_columns.hpp"
#include "programs/kerf/page/timed_path.hpp"

namespace kerf::program {

class PlanGatherer {
 public:
  // extents: of the whole path, known before it runs.
  PlanGatherer(const TickColumns::Settings& columns, const curves::Extents& extents);

  void add(const TickRecord& record) {
    columns_.add(record);
    path_.add({.tick = record.tick, .position_mm = record.position_mm, .rapid = record.rapid});
    runs_.add(record);
    last_tick_ = record.tick;
    path_mm_ = record.motion.s_mm;
  }

  // What the kernel tells the operator since the tick that was added last.
  void add_notes(Kernel& kernel);

  // Is called again and again as the run goes on.
  using Watch = std::function<void(const PlanGatherer& gathered, const Kernel& kernel)>;
  void set_watch(Watch watch) { watch_ = std::move(watch); }

  [[nodiscard]] const TickColumns& columns() const noexcept { return columns_; }
  [[nodiscard]] const TimedPath& path() const noexcept { return path_; }
  [[nodiscard]] const MotionRuns& runs() const noexcept { return runs_; }
  [[nodiscard]] const CodeRuns& codes() const noexcept { return codes_; }
  // F, S and T.
  [[nodiscard]] const CodeRuns& words() const noexcept { return words_; }
  // (MSG, ...) and the like, the first kMaxMessages.
  static constexpr std::size_t kMaxMessages = 1000;
  [[nodiscard]] const std::vector<ProgramMessage>& messages() const noexcept { return messages_; }
  [[nodiscard]] std::int64_t last_tick() const noexcept { return last_tick_; }
  // Where the tool is on its path then.
  [[nodiscard]] double path_mm() const noexcept { return path_mm_; }

 private:
  TickColumns columns_;
  TimedPath path_;
  MotionRuns runs_;
  CodeRuns codes_;
  CodeRuns words_;
  std::vector<ProgramMessage> messages_;
  std::int64_t last_tick_ = 0;
  double path_mm_ = 0.0;
  Watch watch_;
  static constexpr std::int64_t kTicksOfWatch = 64;
};

struct FileReport;

// A program for the page: its text before it runs, what it did after. A comparison wants the text
// alone.
struct PageRecord {
  bool wants_motion = true;
  bool wants_source = true;
  bool quotes_text = true;  // blocks of errors, messages to the operator, headings
  std::size_t max_columns = TickColumns::kMaxColumns;  // of the motion
  TickWindow window{};                                 // of its columns; the motion ends there
  // Called with what is known of a program that is about to be planned, its path among it. Empty:
  // nobody wants it before its motion.
  std::function<void(const FileReport&)> show_path{};
  PlanGatherer::Watch watch{};               // of who waits for the motion
  std::optional<std::string> source{};       // none: not wanted, or longer than kMaxSourceBytes
  std::optional<curves::Extents> extents{};  // of the path, also of one that leaves the travel
  std::optional<PlannedPath> planned{};      // before the motion, or of what is not to move
  std::optional<NominalLines> nominal{};     // of that path, where show_path wants it
  std::optional<PlanGatherer> motion{};      // none: nothing has moved

  static constexpr std::uint64_t kMaxSourceBytes = std::uint64_t{256} << 20U;
};

}  // namespace kerf::program
