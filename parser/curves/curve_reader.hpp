// G6.2 and G5.2 ... G5.3: which blocks belong to a curve, and what follows an error in one.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "parser/curves/nurbs_collector.hpp"
#include "parser/curves/uniform_collector.hpp"

namespace kerf::parser {

class CurveReader {
 public:
  // A curve has begun and is not complete.
  [[nodiscard]] bool open() const { return nurbs_.active() || uniform_.active(); }
  // The block is the first of a curve.
  [[nodiscard]] static bool begins(const RunningBlock& at, const ModalState& state) {
    const Tenths code = at.codes[Group::motion];
    return code != kNoCode ? code == kBegins[0] || code == kBegins[1]
                           : state.motion == Motion::nurbs &&
                                 at.block.has_any(at.axis_letters() | letters('K', 'R'));
  }

  Done begin(const RunningBlock& at, const ModalState& state, double feedrate_mm_s);
  // A further block; the last one makes the move. Precondition of these three: open().
  Done add(const RunningBlock& at, ModalState& state);
  // A block that is no part of the curve but shows that its end is missing.
  [[nodiscard]] std::optional<diagnostics::Fault> missing_end(const RunningBlock& at) const;
  // The text ends here.
  struct TextEnd {
    std::uint32_t line = 0;
    std::string_view where;
  };
  [[nodiscard]] diagnostics::Fault unfinished(const TextEnd& end) const;

  // Drops the curve after an error. Its remaining blocks are skipped.
  void abandon(ModalState& state);
  // Skips the blocks of a curve whose first block has an error.
  void skip_from(const BlockWords& block);
  void skip(Motion motion);
  [[nodiscard]] bool skipping() const { return skipped_ != kNoCode; }
  void skip_no_more() { skipped_ = kNoCode; }
  // Blocks are passed over up to the next other code of group 1, the start of a new curve, or the
  // end of the program. True: the block is to be run. Precondition: skipping().
  bool leave_skipped(const RunningBlock& at, ModalState& state);

 private:
  static constexpr std::array<Tenths, 2> kBegins{52, 62};  // G5.2 and G6.2
  Done add_uniform(const RunningBlock& at, ModalState& state);
  [[nodiscard]] diagnostics::Fault of_curve(std::uint32_t line, diagnostics::Fault fault) const;

  NurbsCollector nurbs_;
  UniformCollector uniform_;
  diagnostics::SourcePosition source_;
  double feedrate_mm_s_ = 0.0;
  Tenths skipped_ = kNoCode;  // the code of a curve with an error whose blocks still come
};

}  // namespace kerf::parser
