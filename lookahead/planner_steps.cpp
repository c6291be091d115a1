// Single block: where a block of the program ends.
#include <algorithm>
#include <utility>

#include "lookahead/planner.hpp"

namespace kerf::lookahead {

Planner::ProgramPlace Planner::place_of(const Item& item) {
  if (const auto* rest = std::get_if<Rest>(&item)) {
    return {.line = rest->line,
            .run_block = rest->run_block,
            .end_line = rest->line,
            .end_run_block = rest->run_block};
  }
  const auto& block = std::get<Block>(item);
  const LineMark end = block.mark_at(block.length_mm);
  return {.line = block.line,
          .run_block = block.run_block,
          .end_line = end.line,
          .end_run_block = end.run_block};
}

Rest Planner::step_at_end_of(const ProgramPlace& place) {
  return {.line = place.end_line,
          .run_block = place.end_run_block,
          .waits = true,
          .cause = WaitCause::block_end,
          .steps = true};
}

std::optional<Planner::ProgramPlace> Planner::place_behind(const Item& item) {
  const auto* rest = std::get_if<Rest>(&item);
  const bool has_waited = rest != nullptr && rest->waits && !rest->asks_machine;
  return has_waited ? std::nullopt : std::optional(place_of(item));
}

std::optional<Planner::ProgramPlace> Planner::place_emitted() const {
  const Item* item = emitter_.kept().last_item();
  return item != nullptr ? place_behind(*item) : std::nullopt;
}

bool Planner::is_same_block(const ProgramPlace& before, const ProgramPlace& after) {
  return before.line == after.line &&
         (before.run_block == after.run_block || before.run_block == 0 || after.run_block == 0);
}

bool Planner::is_step(const Item& item) {
  const auto* rest = std::get_if<Rest>(&item);
  return rest != nullptr && rest->steps;
}

bool Planner::steps_before(const Item& next) const {
  return single_block_ && !is_step(next) && last_ && !is_same_block(*last_, place_of(next));
}

void Planner::end_with_step() {
  end_with(step_at_end_of(*last_));
}

void Planner::step_behind(std::size_t item) {
  for (; single_block_ && item + 1 < waiting_.size(); ++item) {
    const ProgramPlace place = place_of(waiting_[item]);
    if (!is_same_block(place, place_of(waiting_[item + 1]))) {
      waiting_.insert(waiting_.begin() + static_cast<std::ptrdiff_t>(item) + 1,
                      step_at_end_of(place));
      return;
    }
  }
}

// They are put where they belong again as the blocks are taken; but where the tool has come to the
// end of one, its step is all that is left to say so.
void Planner::forget_steps() {
  const bool is_at_step =
      single_block_ && !emitter_.is_on_block() && !waiting_.empty() && is_step(waiting_.front());
  waiting_.erase(std::remove_if(waiting_.begin() + (is_at_step ? 1 : 0), waiting_.end(), is_step),
                 waiting_.end());
}

}  // namespace kerf::lookahead
