#include "parser/curves/curve_reader.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr Tenths kG52 = 52;
constexpr Tenths kG53 = 53;
constexpr Tenths kG62 = 62;
constexpr Tenths kG63 = 63;

bool ends_program(const BlockCodes& codes) {
  return codes[Group::stop] == 20 || codes[Group::stop] == 300;
}

}  // namespace

Done CurveReader::begin(const RunningBlock& at, const ModalState& state, double feedrate_mm_s) {
  source_ = at.source;
  feedrate_mm_s_ = feedrate_mm_s;
  return state.motion == Motion::nurbs ? nurbs_.begin(at, state) : uniform_.begin(at, state);
}

// The block that proves a curve wrong may stand far behind the one that began it.
diagnostics::Fault CurveReader::of_curve(std::uint32_t line, diagnostics::Fault fault) const {
  if (line != source_.line && !fault.elsewhere) {
    fault.message += joined({"; the curve begins in line ", std::to_string(source_.line)});
  }
  return fault;
}

std::optional<diagnostics::Fault> CurveReader::missing_end(const RunningBlock& at) const {
  const Tenths code = at.codes[Group::motion];
  const bool ends = ends_program(at.codes);
  if (!ends && !(nurbs_.active() && code != kNoCode && code != kG62)) {
    return std::nullopt;
  }
  const Group shown_by = ends ? Group::stop : Group::motion;
  const std::uint32_t offset = at.code_word(shown_by).offset;
  const std::string where = joined({"at ", at.name_of(shown_by)});
  return of_curve(at.source.line, nurbs_.active() ? nurbs_.unfinished(offset, where)
                                                  : uniform_.unfinished(offset, where));
}

diagnostics::Fault CurveReader::unfinished(const TextEnd& end) const {
  return of_curve(end.line, nurbs_.active() ? nurbs_.unfinished(0, end.where)
                                            : uniform_.unfinished(0, end.where));
}

Done CurveReader::add(const RunningBlock& at, ModalState& state) {
  if (!nurbs_.active()) {
    return add_uniform(at, state);
  }
  Expected<CurveProgress> progress = nurbs_.add(at, state);
  if (!progress) {
    state.position_mm = nurbs_.last_point_mm();
    skipped_ = kG62;
    return diagnostics::failure(of_curve(at.source.line, std::move(*progress.error())));
  }
  if (*progress == CurveProgress::complete) {
    push_curve(at, state, {nurbs_.take(), "G6.2", source_, feedrate_mm_s_});
  }
  return {};
}

Done CurveReader::add_uniform(const RunningBlock& at, ModalState& state) {
  Expected<CurveProgress> progress = uniform_.add(at, state);
  if (!progress) {
    state.position_mm = uniform_.last_point_mm();
    skipped_ = at.codes[Group::motion] == kG53 ? kNoCode : kG52;
    return diagnostics::failure(of_curve(at.source.line, std::move(*progress.error())));
  }
  if (*progress == CurveProgress::complete) {
    set_motion(at, state, kG53);
    push_curve(at, state, {uniform_.take(), "G5.2", source_, feedrate_mm_s_});
  }
  return {};
}

void CurveReader::abandon(ModalState& state) {
  const bool nurbs = nurbs_.active();
  state.position_mm = nurbs ? nurbs_.last_point_mm() : uniform_.last_point_mm();
  skip(nurbs ? Motion::nurbs : Motion::uniform_nurbs);
  nurbs_.abort();
  uniform_.abort();
}

void CurveReader::skip_from(const BlockWords& block) {
  for (std::size_t i = 0; i < block.g_count; ++i) {
    for (const Tenths code : kBegins) {
      if (std::fabs(block.g[i].value * 10.0 - code) < 1e-8) {
        skipped_ = code;
      }
    }
  }
}

void CurveReader::skip(Motion motion) {
  skipped_ = motion == Motion::nurbs ? kG62 : kG52;
}

bool CurveReader::leave_skipped(const RunningBlock& at, ModalState& state) {
  const Tenths code = at.codes[Group::motion];
  const bool new_curve = code == skipped_ && code == kG62 && at.block.has('P');
  const bool other = code != kNoCode && code != skipped_;
  if (!new_curve && !other && !ends_program(at.codes)) {
    return false;
  }
  skipped_ = kNoCode;
  state.motion = Motion::none;
  return code != kG53 && code != kG63;
}

}  // namespace kerf::parser
