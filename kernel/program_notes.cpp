#include "kernel/program_notes.hpp"

#include <limits>
#include <utility>

#include "parser/modal/codes_in_force.hpp"

namespace kerf {

namespace {

bool is_same(const parser::Coordinates& one, const parser::Coordinates& other) {
  const auto same_work = [&](std::size_t system) {
    const WorkOffset& a = one.work(system);
    const WorkOffset& b = other.work(system);
    return a.origin_mm == b.origin_mm && a.rotation_deg == b.rotation_deg &&
           a.extra_deg_mm == b.extra_deg_mm;
  };
  for (std::size_t system = 0; system < parser::Coordinates::kSystems; ++system) {
    if (!same_work(system)) {
      return false;
    }
  }
  return one.system() == other.system() && same_work(one.system()) &&
         one.local_mm() == other.local_mm() &&
         one.local_auxiliary_deg_mm() == other.local_auxiliary_deg_mm() &&
         one.tool_mm() == other.tool_mm() && one.scaling() == other.scaling() &&
         one.program_turn() == other.program_turn() && one.mirror() == other.mirror();
}

// But for the place and what lasts for a block or a cycle. G54.1 is seen where it is in force.
bool is_same(const parser::ModalState& one, const parser::ModalState& other) {
  return one.motion == other.motion && one.feed_word == other.feed_word &&
         one.feedrate_mm_s == other.feedrate_mm_s && one.spindle_speed == other.spindle_speed &&
         one.tool == other.tool && one.loaded_tool == other.loaded_tool &&
         one.input == other.input && one.cutter_offset == other.cutter_offset &&
         one.blend_tolerance_mm == other.blend_tolerance_mm &&
         one.merge_tolerance_mm == other.merge_tolerance_mm &&
         one.overrides.feed == other.overrides.feed &&
         one.overrides.speed == other.overrides.speed &&
         one.overrides.adaptive_feed == other.overrides.adaptive_feed &&
         one.overrides.feed_hold == other.overrides.feed_hold &&
         is_same(one.coordinates, other.coordinates) &&
         parser::codes_in_force(one) == parser::codes_in_force(other);
}

}  // namespace

void ProgramNotes::read(const parser::ProgramReader& reader) {
  messages_.insert(messages_.end(), reader.messages().begin(), reader.messages().end());
  read_state_ = reader.modal_state();
}

void ProgramNotes::move(const parser::Move& move) {
  const parser::ModalState* const latest = !ahead_.empty() ? &ahead_.back().state
                                           : state_        ? &*state_
                                                           : nullptr;
  if (latest == nullptr || !is_same(*latest, read_state_)) {
    ahead_.push_back({.block = move.block, .state = read_state_});
  }
}

void ProgramNotes::reach(std::uint64_t block) {
  while (!messages_.empty() && messages_.front().block <= block) {
    reached_messages_.push_back(std::move(messages_.front().message));
    messages_.pop_front();
  }
  if (ahead_.empty() || ahead_.front().block > block) {
    return;
  }
  while (!ahead_.empty() && ahead_.front().block <= block) {
    state_ = std::move(ahead_.front().state);
    ahead_.pop_front();
  }
  codes_.clear();
  for (const std::string& code : parser::codes_in_force(*state_)) {
    codes_ += (codes_.empty() ? "" : " ") + code;
  }
}

void ProgramNotes::reach_end() {
  reach(std::numeric_limits<std::uint64_t>::max());
}

std::vector<ProgramMessage> ProgramNotes::take_messages() {
  return std::exchange(reached_messages_, {});
}

}  // namespace kerf
