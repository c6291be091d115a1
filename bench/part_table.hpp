// The table of the programs of short segments: a row is a run, judged.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "bench/part_run.hpp"
#include "bench/parts.hpp"

namespace kerf::bench {

// How far the chord between two ticks may leave a curve: the default machine's.
inline constexpr double kChord_mm = 0.001;

const PartMode kExactPath{"G61", 0.0};
const PartMode kExactStop{"G61.1", 0.0};
const PartMode kHundredth{"G64 P0.01 Q0.01", 0.01};

struct Row {
  std::string name;
  const PartProgram* program = nullptr;
  PartMode mode = kHundredth;
  double feed_mm_min = 6000.0;
  AxisSet axes{};
  double at_most_s = 0.0;  // 0: no target
  std::string others{};
  bool is_long = false;  // left out with --quick
};

class Table {
 public:
  explicit Table(PartsOrder order) : order_(std::move(order)) {}

  static void print_head();
  [[nodiscard]] bool wants(const std::string& name) const { return name.starts_with(order_.only); }
  // Runs and prints. Nothing where the row is left out.
  std::optional<PartRun> add(const Row& row);
  // What is asked of several rows.
  void note(const std::string& what, bool met);
  // Prints the notes. False: a target was missed.
  [[nodiscard]] bool finish() const;

 private:
  PartsOrder order_;
  std::string notes_;
  bool met_ = true;
};

}  // namespace kerf::bench
