// The rows: programs, machines, targets, and what others do on the same.
#include "bench/parts.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "bench/part_bound.hpp"
#include "bench/part_table.hpp"

namespace kerf::bench {

namespace {

std::string seconds(double time_s) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3f s", time_s);
  return text.data();
}

void add_raster(Table& table) {
  if (!table.wants("raster")) {
    return;
  }
  const PartProgram program = raster(10'000);
  const Row slow{.name = "raster", .program = &program, .feed_mm_min = 3000.0};
  Row row = slow;
  row.axes = {1000.0, 1e4};
  row.at_most_s = 46.0;
  row.others = "optimum 44.7; LinuxCNC 408, naive CAM 184, J0 44.1";
  table.add(row);
  row.axes.jerk_mm_s3 = 5e4;
  row.at_most_s = 45.0;
  row.others = "optimum 43.7; LinuxCNC 241, naive CAM 97, J0 44.1";
  table.add(row);
  row.feed_mm_min = 6000.0;
  row.axes.jerk_mm_s3 = 1e4;
  row.at_most_s = 38.5;
  row.others = "optimum 37.4; LinuxCNC 408, J0 25.7";
  table.add(row);
  row.axes.jerk_mm_s3 = 5e4;
  row.at_most_s = 25.0;
  row.others = "optimum 24.1; LinuxCNC 241, J0 25.7";
  table.add(row);
  row = slow;
  row.mode = kExactStop;
  row.is_long = true;
  table.add(row);
}

void add_flower(Table& table) {
  if (!table.wants("flower")) {
    return;
  }
  struct Flower {
    int decimals;
    const char* others;
  };
  const std::array<Flower, 2> flowers{{{3,
                                        "optimum 336 (without jerk limit 287); grblHAL 202.3 (9.8 "
                                        "times a), Klipper 425.6, g2core 2395"},
                                       {6,
                                        "optimum 336 (without jerk limit 287); grblHAL 201.7 (9.8 "
                                        "times a), Klipper 339.6, g2core 2395"}}};
  std::vector<std::optional<PartRun>> runs;
  for (const Flower& each : flowers) {
    const PartProgram program = flower(each.decimals);
    Row row{.name = "flower, " + std::to_string(each.decimals) + " decimals",
            .program = &program,
            .axes = {500.0, 5e4},
            .at_most_s = 343.0,
            .others = each.others};
    runs.push_back(table.add(row));
    row = {.name = row.name,
           .program = &program,
           .mode = kExactStop,
           .axes = row.axes,
           .is_long = true};
    table.add(row);
  }
  if (runs[0] && runs[1]) {
    const double ratio = runs[0]->time_s / runs[1]->time_s;
    table.note("flower: 3 decimals take " + std::to_string(ratio) + " of the time of 6",
               std::abs(ratio - 1.0) <= 0.01);
  }
}

void add_straight(Table& table) {
  if (!table.wants("straight")) {
    return;
  }
  struct Line {
    double length_mm;
    int lines;
    double feed_mm_min;
    double jerk_mm_s3;
    const char* others;
  };
  for (const Line& line : {Line{200.0, 1000, 16'000.0, 1e4, "LinuxCNC 39.2, as one G1 1.118"},
                           Line{100.0, 10'000, 6000.0, 5e4, "LinuxCNC: at 980 lines a second"}}) {
    const PartProgram one = straight(line.length_mm, 1);
    const PartProgram many = straight(line.length_mm, line.lines);
    Row row{.name = "straight, 1 line",
            .program = &one,
            .feed_mm_min = line.feed_mm_min,
            .axes = {1000.0, line.jerk_mm_s3}};
    const auto as_one = table.add(row);
    row.name = "straight, " + std::to_string(line.lines) + " lines";
    row.program = &many;
    row.others = line.others;
    const auto as_many = table.add(row);
    if (as_one && as_many) {
      table.note(row.name + ": " + seconds(as_many->time_s) + ", as one line " +
                     seconds(as_one->time_s) + ", to be the same to the tick",
                 std::abs(as_many->time_s - as_one->time_s) < 0.5e-3);
    }
    row.mode = kExactStop;
    row.others.clear();
    table.add(row);
  }
}

void add_square(Table& table) {
  if (!table.wants("square")) {
    return;
  }
  const PartProgram program = square(100.0);
  for (const bool soft : {true, false}) {
    Row row{.name = "square",
            .program = &program,
            .mode = kExactPath,
            .axes = {1000.0, soft ? 1e4 : 5e4},
            .at_most_s = soft ? 4.801 : 4.481};
    table.add(row);
    row.mode = kExactStop;
    row.others = soft ? "LinuxCNC 4.801, J0 4.401" : "LinuxCNC 4.481, J0 4.401";
    table.add(row);
    row.mode = {"G64 P0.01", 0.01};
    row.at_most_s = soft ? 4.732 : 4.619;
    row.others = soft ? "LinuxCNC 4.732, J0 4.398" : "LinuxCNC 4.619, J0 4.398";
    table.add(row);
    row.mode = {"G64 P0.05", 0.05};
    row.others.clear();
    table.add(row);
  }
}

void add_spiral(Table& table) {
  if (!table.wants("spiral")) {
    return;
  }
  const SpiralShape shape;
  const PartProgram program = spiral(shape);
  Row row{.name = "spiral", .program = &program, .axes = {1000.0, 5e4}};
  const double bound = spiral_bound_s(shape, row.feed_mm_min / 60.0, row.axes);
  row.at_most_s = 1.03 * bound;
  row.others = "bound (F and a alone) " + seconds(bound);
  table.add(row);
  table.add({.name = row.name,
             .program = &program,
             .mode = kExactStop,
             .axes = row.axes,
             .is_long = true});
}

// Never slower than exactly on the path.
void add_beside_exact(Table& table, const std::string& name, const PartProgram& program,
                      double feed_mm_min) {
  Row row{.name = name, .program = &program, .feed_mm_min = feed_mm_min, .axes = {1000.0, 5e4}};
  row.mode = kExactStop;
  table.add(row);
  row.mode = kExactPath;
  if (const auto exact = table.add(row)) {
    row.at_most_s = exact->time_s;
  }
  row.mode = kHundredth;
  table.add(row);
}

void add_loops(Table& table) {
  if (!table.wants("loops")) {
    return;
  }
  const PartProgram program = small_loops(100);
  Row row{.name = "loops", .program = &program, .mode = kExactStop, .axes = {1750.0, 5e4}};
  table.add(row);
  row.mode = kExactPath;
  if (const auto exact = table.add(row)) {
    row.at_most_s = exact->time_s;
  }
  for (const PartMode& mode : {PartMode{"G64 P0.01", 0.01}, PartMode{"G64 P0.1", 0.1}}) {
    row.mode = mode;
    row.others = mode.allowed_mm > 0.05 ? "LinuxCNC J0 puts 13,842 mm/s2 on an axis there" : "";
    if (const auto run = table.add(row)) {
      row.at_most_s = run->time_s;
    }
  }
}

}  // namespace

int parts(const PartsOrder& order) {
  const bool smoothing_met = parts_smoothing(order);
  const bool cost_met = parts_cost(order) && smoothing_met;
  if (order.only == "cost") {
    return cost_met ? 0 : 1;
  }
  std::printf(
      "Limits of each axis in mm/s2 and mm/s3, F in mm/min; rest to rest. A figure over its limit "
      "and the deviations are found from positions of ticks alone. Allowed is P (exact modes: a "
      "nanometre) for ticks off the path; P and the chord tolerance, %g mm, by which a tick cuts a "
      "corner, for the path off the ticks; 2 P for ticks off their line, which ends somewhere "
      "within P of its end. Others: the optimum on the exact curve; measured for LinuxCNC "
      "2.10~pre, its planner driven headless, jerk-limited and (J0) trapezoid; grblHAL, Klipper "
      "and g2core their own planners on the same lines.\n\n",
      kChord_mm);
  Table table(order);
  Table::print_head();
  add_raster(table);
  add_flower(table);
  add_straight(table);
  add_square(table);
  add_spiral(table);
  if (table.wants("engraving")) {
    add_beside_exact(table, "engraving", engraving(), 1500.0);
  }
  if (table.wants("pocket")) {
    add_beside_exact(table, "pocket", pocket(), 3000.0);
  }
  add_loops(table);
  return table.finish() && cost_met ? 0 : 1;
}

}  // namespace kerf::bench
