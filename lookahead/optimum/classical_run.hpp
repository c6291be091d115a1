// The classical schedule where it runs in place of the time optimum: from a rest on.
#pragma once

#include <cstddef>

#include "lookahead/classical/classical_schedule.hpp"

namespace kerf::lookahead {

class ClassicalRun {
 public:
  explicit ClassicalRun(const ClassicalSchedule::Settings& settings)
      : settings_(settings), schedule_(settings) {}

  [[nodiscard]] const ClassicalSchedule::Settings& settings() const { return settings_; }
  [[nodiscard]] bool empty() const { return schedule_.empty(); }

  // For what is taken next. Precondition: empty.
  void use(profiles::ProfileKind profile) { schedule_.use(profiles::Profile(profile)); }
  // The window's first blocks, from rest to rest.
  void take(const Window<Block>& blocks, std::size_t count);
  // How many of the window's first blocks stand before the next rest.
  [[nodiscard]] std::size_t run_length(const Window<Block>& blocks) const;
  // Takes them, and says how many they are. expects_more: where the window ends before that rest,
  // the blocks to come are among them.
  std::size_t follow(const Window<Block>& blocks, bool expects_more);
  [[nodiscard]] bool goes_on() const { return goes_on_; }
  // Takes the window's last block where the run goes on with it; if not, the run has ended.
  bool push(const Window<Block>& blocks);

  // Precondition: not empty.
  bool emit(Window<Block>& blocks, Supply supply, Emitter& emitter, Outbox& outbox);

 private:
  [[nodiscard]] Supply supply_of(Supply supply, std::size_t blocks) const;
  [[nodiscard]] bool stops_between(const Block& before, const Block& after) const;

  ClassicalSchedule::Settings settings_;
  ClassicalSchedule schedule_;
  bool goes_on_ = false;  // the next block joins the last one taken
};

}  // namespace kerf::lookahead
