// What has been emitted and may not have been run yet: it can be taken back.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <variant>
#include <vector>

#include "interp/motion.hpp"
#include "interp/outputs.hpp"
#include "lookahead/path/block.hpp"
#include "lookahead/path/window.hpp"

namespace kerf::lookahead {

struct Rest {
  double duration_s = 0.0;
  std::uint32_t line = 0;       // 0: that before
  std::uint64_t run_block = 0;  // parser::Move::block; 0: of none
  bool ends_program = false;
  bool waits = false;  // until resume()
  WaitCause cause = WaitCause::none;
  bool asks_machine = false;  // it waits for the machine's answer
  bool steps = false;         // it is no item of the program: a block ends in single block
  parser::FollowedOverrides follows{};
  std::vector<interp::OutputChange>
      changes_before{};  // that were for the next item, whatever it is
  std::optional<interp::OutputChange> change{};
};

// What a program is made of after the smoothing, in its order. Blocks are whole.
using Item = std::variant<Block, Rest>;

// Where emission stands: on a block, or after an item.
struct EmitPlace {
  std::uint64_t curve = 0;
  bool on_block = false;       // a phase of the block has been emitted
  bool rests = false;          // X, Y and Z rest on the curve: it adds nothing to the path
  double s_mm = 0.0;           // on the block
  double curve_mm = 0.0;       // on the curve: farther where the block is a remainder
  double path_begin_mm = 0.0;  // of all curves before this one
  std::uint32_t line = 0;
  std::uint64_t output_changes = 0;  // so many of the program's are behind it
  std::uint64_t block_changes = 0;   // and so many of those that come with a block
  std::uint64_t segments = 0;        // ended
};

// Phases, and the items that they are of, from the last tick that was run on.
class EmittedItems {
 public:
  explicit EmittedItems(double period_s) : period_s_(period_s) {}

  // An item begins at the place, with the next phase. It comes with end().
  void begin(const EmitPlace& place);
  void end(Item item);
  void add(const interp::Phase& phase);
  // Ticks before this one have been run.
  void forget_before(std::int64_t tick);
  // Where the oldest item begins that is kept; null: none is.
  [[nodiscard]] const EmitPlace* oldest() const {
    return items_.empty() ? nullptr : &items_[0].begin;
  }

  // The motion at an instant, and the phase that it is of.
  struct Motion {
    interp::TickTime when{};
    double v_mm_s = 0.0;
    double a_mm_s2 = 0.0;
    double curve_mm = 0.0;  // on its curve
    interp::Phase phase{};
    std::uint64_t number = 0;  // of the phase

    [[nodiscard]] bool at_rest() const noexcept { return v_mm_s == 0.0; }
  };
  // Nothing: no phase has begun by then.
  [[nodiscard]] std::optional<Motion> at(std::int64_t tick) const;
  struct Ticks {
    std::int64_t begin = 0;
    std::int64_t end = 0;  // after the last
  };
  // Within a tick it may have left a rest already.
  [[nodiscard]] bool ends_at_rest() const { return phases_.empty() || phases_.back().ends_at_rest; }
  // Its last phase follows a feed hold.
  [[nodiscard]] bool ends_following_hold() const {
    return phases_.empty() || phases_.back().follows_hold;
  }
  // It rests, and nothing was emitted after it.
  [[nodiscard]] bool is_last(const Motion& motion) const {
    return motion.at_rest() && motion.number + 1 >= phase_count_ &&
           end_tick(motion.phase) <= motion.when.tick;
  }
  // That was emitted to its end; null: what was emitted ends within another, or it is not kept.
  [[nodiscard]] const Item* last_item() const {
    return items_.empty() || !items_.back().item ? nullptr : &*items_.back().item;
  }
  // Where the phases end that end within the ticks.
  [[nodiscard]] std::vector<Motion> ends_within(const Ticks& ticks) const;
  // Where the phases after the motion end, on their curves, at most so many.
  struct CurvePlace {
    std::uint64_t curve = 0;
    double s_mm = 0.0;
  };
  [[nodiscard]] std::vector<CurvePlace> places_behind(const Motion& motion, std::size_t most) const;

  // The tick, at this one or later, at which the motion comes to rest. Nothing: it does not, as far
  // as it was emitted.
  [[nodiscard]] std::optional<std::int64_t> rest_after(std::int64_t tick) const;
  // The blocks that have ended from the one on that the motion is on, up to a rest. At the end of
  // a block it is on the next.
  struct Blocks {
    const Block* before = nullptr;  // of the first; null: there was a rest, or it is not kept
    std::vector<const Block*> blocks{};
    bool is_on_next = false;    // it is at the end of `before`
    bool rest_follows = false;  // else what has not ended follows
  };
  [[nodiscard]] Blocks blocks_from(const Motion& motion) const;

  // The rest at the tick or later after which the first motion begins for which `stops` holds, of
  // the rest and the motion. Nothing: there is none.
  using Stops = std::function<bool(const interp::Phase& rest, const interp::Phase& begins)>;
  [[nodiscard]] std::optional<Motion> rest_before(std::int64_t tick, const Stops& stops) const;
  // At the tick it rests in a dwell that is not over.
  [[nodiscard]] bool dwells(const Motion& motion) const {
    return motion.at_rest() && end_tick(motion.phase) > motion.when.tick;
  }

  // Takes back what follows the motion. The items go to the front of `ahead`, which
  // begins with the item that has not ended, if there is one; present: the place after all. A
  // dwell is parted there.
  struct TakenBack {
    EmitPlace begin{};    // of the first item
    bool within = false;  // the motion has come to curve_mm on it, a block
  };
  TakenBack take_back(const Motion& motion, const EmitPlace& present, std::deque<Item>& ahead);

 private:
  struct Entry {
    std::optional<Item> item{};  // nothing: it has not ended
    EmitPlace begin{};
    std::uint64_t first_phase = 0;
    bool behind_rest = false;  // as a phase told that is no longer kept
  };

  // The motion rested before it.
  [[nodiscard]] bool is_behind_rest(const Entry& entry) const;
  // The motion is in a rest of no item after it.
  [[nodiscard]] static bool is_behind(const Entry& entry, const Motion& motion) noexcept {
    return entry.first_phase < motion.number;
  }
  // Of a rest; one of no duration has.
  [[nodiscard]] bool has_begun(const Entry& entry, const Motion& motion) const;
  // What is left of a dwell; nothing: it is over.
  [[nodiscard]] std::optional<Rest> part(Entry& entry, const Motion& motion) const;
  [[nodiscard]] interp::TickTime end_of(const interp::Phase& phase) const;
  // Of a phase that is not the last: the next, of another plan, begins before its end.
  [[nodiscard]] bool is_cut_short(std::size_t i) const;
  [[nodiscard]] std::int64_t end_tick(const interp::Phase& phase) const;
  [[nodiscard]] double since_s(const interp::TickTime& begin, std::int64_t tick) const {
    return static_cast<double>(tick - begin.tick) * period_s_ - begin.offset_s;
  }

  double period_s_;
  Window<interp::Phase> phases_;
  std::uint64_t phase_count_ = 0;  // ever added, but for those taken back
  Window<Entry> items_;
};

}  // namespace kerf::lookahead
