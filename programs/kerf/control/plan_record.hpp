// What the planning side of a run did, in its order: all that a run under commands has beside its
// program and its machine, and so what lets it be repeated.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace kerf::program {

// Two kinds of entry: it looked how far the ticks are (KernelOptions::plan_clock), and it was given
// an order. Some 2 KB a second of a program, 7 KB of a search for the home switches.
class PlanRecord {
 public:
  // Of the run: somebody could answer a wait, it began with none, with a search for the home
  // switches, and its start in the middle waited to be confirmed.
  bool is_attended = false;
  bool waits_for_start = false;
  bool homes = false;
  bool start_waits = false;
  // Before this tick came an emergency stop that no machine asked for.
  std::optional<std::int64_t> emergency_tick{};

  void add_look(std::int64_t tick);
  // The latest one came to nothing.
  void take_back_look();
  void add_order(std::string_view text);
  [[nodiscard]] bool has_orders() const noexcept { return has_orders_ || emergency_tick; }

  // So far it is whole, and can be read. More may follow.
  void finish();

  [[nodiscard]] std::string bytes() const;
  // Nothing: these are none.
  static std::optional<PlanRecord> from_bytes(std::string_view bytes);

  // Reads the entries, one after the other.
  class Reader {
   public:
    // Refers to the record. Precondition: finish().
    explicit Reader(const PlanRecord& record) : rest_(record.entries_) { next(); }
    // The next entry is a look at that tick: it is taken.
    bool take_look(std::int64_t tick);
    // The next one is an order: the same. Nothing: it is none.
    std::optional<std::string_view> take_order();
    // The same, which stays.
    [[nodiscard]] std::optional<std::string_view> order() const noexcept {
      return looks_ == 0 ? order_ : std::nullopt;
    }

   private:
    void next();

    std::string_view rest_;
    std::int64_t tick_ = 0;
    std::uint64_t looks_ = 0;  // at that tick, still to come
    std::optional<std::string_view> order_{};
  };

 private:
  std::string entries_;
  std::int64_t tick_ = 0;    // of the looks that are not in the entries yet
  std::int64_t before_ = 0;  // of those that are
  std::uint64_t looks_ = 0;
  bool has_orders_ = false;
};

}  // namespace kerf::program
