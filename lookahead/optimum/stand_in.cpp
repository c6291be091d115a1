#include "lookahead/optimum/stand_in.hpp"

namespace kerf::lookahead {

double classical_s(const Window<Block>& blocks, std::size_t count,
                   const SpanSchedule::Settings& settings) {
  SpanSchedule schedule(settings);
  Window<Block> copies;
  for (std::size_t i = 0; i < count; ++i) {
    copies.push_back(Block(blocks[i]));
    schedule.push(copies);
  }
  Emitter emitter(settings.limits.period_s);
  Outbox outbox;
  double sum_s = 0.0;
  while (!schedule.empty()) {
    schedule.emit(copies, Supply::draining, emitter, outbox);
    for (const interp::Phase& phase : outbox.phases) {
      sum_s += phase.law.duration_s();
    }
    outbox = {};
  }
  return sum_s;
}

}  // namespace kerf::lookahead
