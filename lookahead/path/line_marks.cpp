#include "lookahead/path/line_marks.hpp"

#include <algorithm>

namespace kerf::lookahead {

LineMark mark_at(const Block& block, double s_mm) {
  const auto after = std::upper_bound(block.marks.begin(), block.marks.end(), s_mm,
                                      [](double s, const LineMark& mark) { return s < mark.s_mm; });
  return after == block.marks.begin() ? LineMark{.line = block.line, .run_block = block.run_block}
                                      : *std::prev(after);
}

}  // namespace kerf::lookahead
