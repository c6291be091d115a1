// Judges how far the path of a program leaves the straight lines between its ticks.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "interp/setpoint.hpp"
#include "tests/kernel/program_path.hpp"

namespace kerf::test {

// Follows the ticks along the path: finds the parameter of each by its position, on the block that
// it belongs to or later, and looks at the path between two of them.
class ChordChecker {
 public:
  ChordChecker(const std::vector<Stretch>& path, double tolerance_mm)
      : path_(&path), tolerance_mm_(tolerance_mm) {}

  // kernel_says_mm: the chord error since the tick before, by the kernel's own account.
  void add(const interp::Setpoint& setpoint, double kernel_says_mm);
  // What was exceeded, where and by how much; empty if nothing was.
  [[nodiscard]] const std::string& complaint() const { return complaint_; }
  [[nodiscard]] double largest_mm() const { return largest_mm_; }

 private:
  struct Place {
    std::size_t stretch = 0;
    double u = 0.0;
  };

  // The first place from `from` on where the path passes through point; nowhere: past the end.
  [[nodiscard]] Place find(const Vec& point_mm, const Place& from) const;
  [[nodiscard]] Place first_of_line(std::size_t line, const Place& from) const;
  [[nodiscard]] double chord_error_mm(const Place& from, const Place& to) const;
  void complain(const std::string& what, double found_mm, double limit_mm,
                const interp::Setpoint& setpoint);

  const std::vector<Stretch>* path_;
  double tolerance_mm_;
  Place here_;
  Vec position_mm_{};
  double largest_mm_ = 0.0;
  std::string complaint_;
};

}  // namespace kerf::test
