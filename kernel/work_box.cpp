#include "kernel/work_box.hpp"

#include <algorithm>

namespace kerf {

void unite(Extents& all, const Extents& box, bool is_first) {
  for (std::size_t k = 0; k < 3; ++k) {
    all.min_mm[k] = is_first ? box.min_mm[k] : std::min(all.min_mm[k], box.min_mm[k]);
    all.max_mm[k] = is_first ? box.max_mm[k] : std::max(all.max_mm[k], box.max_mm[k]);
  }
}

WorkBox::Frame WorkBox::frame_of(const parser::Coordinates& coordinates) {
  return {.system = coordinates.system(),
          .to_program_mm = coordinates.to_program({}),
          .is_shaped = coordinates.turned() || coordinates.shaped()};
}

void WorkBox::look_at(const parser::ProgramReader& reader, const parser::Move& move,
                      const std::optional<Extents>& box, CheckReport& report) {
  // Cutter compensation gives moves after the blocks that they come from.
  if (const Frame frame = frame_of(reader.modal_state().coordinates); frame != now_ || read_ == 0) {
    before_ = read_ == 0 ? frame : now_;
    now_ = frame;
    begin_ = read_;
  }
  read_ = reader.blocks_read();
  if (!box) {
    return;
  }
  const Frame& frame = move.block > begin_ ? now_ : before_;
  WorkExtents& work = report.work_extents;
  const bool is_first = work.systems.empty();
  if (std::find(work.systems.begin(), work.systems.end(), frame.system) == work.systems.end()) {
    work.systems.push_back(frame.system);
  }
  work.is_known = work.is_known && !frame.is_shaped;
  Extents in_program = *box;
  for (std::size_t k = 0; k < 3; ++k) {
    in_program.min_mm[k] += frame.to_program_mm[k];
    in_program.max_mm[k] += frame.to_program_mm[k];
  }
  unite(work.all, in_program, is_first);
  if (!move.rapid) {
    unite(work.cutting, in_program, !report.cuts);
    unite(report.cutting_extents, *box, !report.cuts);
    report.cuts = true;
  }
}

}  // namespace kerf
