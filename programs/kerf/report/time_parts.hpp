// Where the time of a run goes by tool and by operation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "programs/kerf/report/time_split.hpp"

namespace kerf::program {

// An operation as CAM systems mark it: a line that is nothing but a comment.
struct Heading {
  std::uint32_t line = 0;
  std::string text;
};

// The words of a line that is a heading, in the program's own bytes; empty: it is none. Words to
// the operator and those that machines act on, (MSG, ...) and the like, are none.
[[nodiscard]] std::string heading_of(std::string_view line);

struct TimePart {
  std::string name;
  std::uint32_t line = 0;  // of the heading; 0: it has none
  TimeSplit time{};        // its approach is not counted

  [[nodiscard]] std::int64_t ticks() const noexcept {
    return time.cutting + time.rapid + time.rest + time.tool_change;
  }
};

struct TimeParts {
  std::vector<TimePart> tools;       // in the order of their numbers
  std::vector<TimePart> operations;  // in the program's order; empty without headings
};

// A rest belongs to a tool change as in TimeAccount, and to the tool and the operation that it
// begins with.
class PartsAccount {
 public:
  // headings: in ascending order of their lines.
  PartsAccount(std::vector<Heading> headings, ToolChange tool_change)
      : headings_(std::move(headings)), tool_change_(tool_change) {}

  // Ticks come in ascending order.
  void add(const TickRecord& record);
  // Those that took time, up to the tick that was added last.
  [[nodiscard]] TimeParts parts() const;

 private:
  // A tool, and how many headings are at or before the line.
  struct Place {
    std::int32_t tool = 0;
    std::size_t heading = 0;

    friend bool operator==(const Place&, const Place&) = default;
  };
  struct Order {
    bool operator()(const Place& a, const Place& b) const {
      return a.tool != b.tool ? a.tool < b.tool : a.heading < b.heading;
    }
  };
  struct Rest {
    Place place{};
    std::int64_t ticks = 0;
  };

  void count(const Place& place, std::int64_t TimeSplit::*kind, std::int64_t ticks);
  void end_rest();
  [[nodiscard]] Place place_of(const TickRecord& record);

  std::vector<Heading> headings_;
  ToolChange tool_change_;
  std::map<Place, TimeSplit, Order> places_;
  Place counted_{};  // the last one, which most ticks have
  TimeSplit* of_counted_ = nullptr;
  std::vector<Rest> rests_;  // of the present rest
  TickRecord last_{};
  bool has_last_ = false;
  std::int32_t tool_before_ = 0;  // the rest
  std::uint32_t line_ = 0;        // that was looked for last
  std::size_t heading_ = 0;
};

}  // namespace kerf::program
