// Where and how a plan that was emitted comes to rest before its end.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "lookahead/emit/emitter.hpp"
#include "lookahead/optimum/braking.hpp"
#include "lookahead/path/block.hpp"
#include "lookahead/path/limits.hpp"

namespace kerf::lookahead {

struct PlanStop {
  EmittedItems::Motion from{};
  std::vector<BrakingPart> parts{};  // none: the tool is at rest then
};

// shortest: what find_braking() finds; any: find_any_braking().
enum class StopEffort : std::uint8_t { shortest, any };
struct StopOrder {
  std::int64_t tick = 0;
  StopEffort effort = StopEffort::shortest;
  IsLate is_late = never_late;  // of the shortest
};
// From the tick on or some ticks later; or at the rest of the plan itself, if that is as near.
// ahead: the blocks, whole, after those that were emitted, up to a rest. Nothing: no way was
// found, and the plan was emitted to no rest. Precondition: the emitter keeps what it emits, and
// has emitted to the tick or to a rest.
std::optional<PlanStop> find_stop(const Emitter& emitter, const std::vector<const Block*>& ahead,
                                  const StopOrder& order, const PlanLimits& limits);

// ahead: the items after those that are emitted; those that end on the way go. No parts: it is at
// rest already. Keeps all phases but the last, which may change yet. The outbox is empty before.
void emit_stop(const std::vector<BrakingPart>& parts, std::deque<Item>& ahead, Emitter& emitter,
               Outbox& outbox);

}  // namespace kerf::lookahead
