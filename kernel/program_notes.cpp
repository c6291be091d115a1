#include "kernel/program_notes.hpp"

#include <algorithm>
#include <iterator>
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

bool is_same(const parser::AllowedOverrides& one, const parser::AllowedOverrides& other) {
  return one.feed == other.feed && one.speed == other.speed &&
         one.adaptive_feed == other.adaptive_feed && one.feed_hold == other.feed_hold;
}

bool has_same_codes(const parser::ModalState& one, const parser::ModalState& other) {
  return one.motion == other.motion && one.plane == other.plane && one.units == other.units &&
         one.incremental == other.incremental && one.absolute_centre == other.absolute_centre &&
         one.feed_mode == other.feed_mode && one.cutter_compensation == other.cutter_compensation &&
         one.tool_length_active == other.tool_length_active &&
         one.local_active == other.local_active && one.path_mode == other.path_mode &&
         one.to_initial_level == other.to_initial_level &&
         one.surface_speed.active == other.surface_speed.active && one.spindle == other.spindle &&
         one.mist == other.mist && one.flood == other.flood;
}

// But for the place, and what lasts for a block or a cycle.
bool is_same(const parser::ModalState& one, const parser::ModalState& other) {
  return has_same_codes(one, other) && one.feed_word == other.feed_word &&
         one.feedrate_mm_s == other.feedrate_mm_s &&
         one.feed_per_revolution_mm == other.feed_per_revolution_mm &&
         one.blend_tolerance_mm == other.blend_tolerance_mm &&
         one.merge_tolerance_mm == other.merge_tolerance_mm &&
         one.spindle_speed == other.spindle_speed &&
         one.surface_speed.max_per_min == other.surface_speed.max_per_min &&
         one.tool == other.tool && one.loaded_tool == other.loaded_tool &&
         one.cutter_offset == other.cutter_offset && one.input == other.input &&
         one.stored_local_mm == other.stored_local_mm && is_same(one.overrides, other.overrides) &&
         is_same(one.coordinates, other.coordinates);
}

}  // namespace

void ProgramNotes::read(const parser::ProgramReader& reader) {
  const auto& said = reader.messages();
  std::copy_if(
      said.begin(), said.end(), std::back_inserter(messages_),
      [this](const parser::NumberedMessage& message) { return message.block > blocks_before_; });
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

bool ProgramNotes::announce(std::uint64_t block) {
  const std::size_t before = reached_messages_.size();
  while (!messages_.empty() && messages_.front().block <= block) {
    reached_messages_.push_back(std::move(messages_.front().message));
    messages_.pop_front();
  }
  return reached_messages_.size() > before;
}

void ProgramNotes::reach(std::uint64_t block) {
  announce(block);
  if (ahead_.empty() || ahead_.front().block > block) {
    return;
  }
  while (!ahead_.empty() && ahead_.front().block <= block) {
    state_ = std::move(ahead_.front().state);
    ahead_.pop_front();
  }
  tell_state();
}

// What stands after the last motion counts, too.
void ProgramNotes::reach_end(const parser::ModalState& left) {
  announce(std::numeric_limits<std::uint64_t>::max());
  ahead_.clear();
  is_at_end_ = true;
  state_ = left;
  tell_state();
}

void ProgramNotes::tell_state() {
  codes_.clear();
  for (const std::string& code : parser::codes_in_force(*state_)) {
    codes_ += (codes_.empty() ? "" : " ") + code;
  }
  words_ = parser::words_in_force(*state_);
}

std::vector<ProgramMessage> ProgramNotes::take_messages() {
  return std::exchange(reached_messages_, {});
}

}  // namespace kerf
