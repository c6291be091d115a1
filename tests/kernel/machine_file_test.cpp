// What a machine file says, where it goes, and the files that are shipped.
#include <cmath>
#include <cstddef>
#include <string>

#include <gtest/gtest.h>
#include <kerf/machine.hpp>

#include "kernel/driver_settings.hpp"
#include "kernel/machine_file_schema.hpp"
#include "lookahead/path/limits.hpp"
#include "machine/simulated_table.hpp"
#include "parser/dialects/dialect.hpp"
#include "parser/modal/machine_data.hpp"
#include "tests/kernel/machine_file_helpers.hpp"

namespace {

using kerf::kUnbounded;
using kerf::MachineSettings;
using kerf::NumberRule;
using kerf::parse_machine_file;
using kerf::test::kBounded;
using kerf::test::read_text;

TEST(MachineFile, SaysWhichDialectProgramsAreIn) {
  EXPECT_EQ(parse_machine_file(kBounded)->dialect, kerf::parser::Dialect::rs274);
  const std::string section = std::string(kBounded) + "[program]\n";
  EXPECT_EQ(parse_machine_file(section + "dialect = 'fanuc'\n")->dialect,
            kerf::parser::Dialect::fanuc);
  EXPECT_FALSE(parse_machine_file(section + "dialect = 'heidenhain'\n"));
  EXPECT_FALSE(parse_machine_file(section + "dialect = 3\n"));
  EXPECT_FALSE(parse_machine_file(section + "dialekt = 'fanuc'\n"));
}

TEST(MachineFile, SaysInWhichPathModeProgramsBegin) {
  const std::string file = kBounded;
  const auto mode_of = [&](const std::string& words) {
    const auto read = parse_machine_file(file + "[program]\npath_mode = '" + words + "'\n");
    return read ? std::optional(read->program.path_control) : std::nullopt;
  };
  const auto blend = [](double corner_mm, double merge_mm) {
    return kerf::PathControl{.mode = kerf::PathMode::blend,
                             .corner_tolerance_mm = corner_mm,
                             .merge_tolerance_mm = merge_mm};
  };
  EXPECT_EQ(parse_machine_file(file)->program.path_control, blend(0.01, 0.01));
  EXPECT_EQ(mode_of("G61"), (kerf::PathControl{.mode = kerf::PathMode::exact_path}));
  EXPECT_EQ(mode_of("G61.1"), (kerf::PathControl{.mode = kerf::PathMode::exact_stop}));
  EXPECT_EQ(mode_of("G64"), blend(0.01, 0.01));
  EXPECT_EQ(mode_of("G64 P0.05"), blend(0.05, 0.05));
  EXPECT_EQ(mode_of(" G64  Q0.002"), blend(0.01, 0.002));
  EXPECT_EQ(mode_of("G64 P0.05 Q0"), blend(0.05, 0.0));
  for (const char* wrong : {"", "G62", "g64", "G61 P1", "G64 P", "G64 P-1", "G64 P0.1 P0.2",
                            "G64 R1", "G64 Pnan", "G64 P2000", "G64P0.1"}) {
    EXPECT_EQ(mode_of(wrong), std::nullopt) << wrong;
  }
  EXPECT_EQ(parse_machine_file("[path]\ncorner_tolerance_mm = 0.03\nmerge_tolerance_mm = 0\n" +
                               file.substr(file.find('\n') + 1))
                ->program.path_control,
            blend(0.03, 0.0));
}

TEST(MachineFile, ReadsEveryKeyIntoItsPlace) {
  const auto read = parse_machine_file(
      "[tick]\nperiod_s = 0.002\n"
      "[path]\nmax_velocity_mm_s = 101\nmax_acceleration_mm_s2 = 102.5\nmax_jerk_mm_s3 = 1_03e3\n"
      "chord_tolerance_mm = 5e-4\ncorner_tolerance_mm = 0.03\nmerge_tolerance_mm = 0\n"
      "[axes.y]\nmin_mm = -11\nmax_mm = 12\nmax_velocity_mm_s = 13\nmax_acceleration_mm_s2 = 14\n"
      "max_jerk_mm_s3 = 15\nscrew_lead_mm = 16\ncounts_per_rev = 17\ndrive_velocity_mm_s = 18\n"
      "drive_acceleration_mm_s2 = 19\nposition_gain_per_s = 20\nvelocity_gain_per_s = 21\n"
      "velocity_integral_per_s2 = 22\nfeed_forward = 0.23\ncoulomb_friction_mm_s2 = 24\n"
      "viscous_friction_per_s = 25\nmax_following_error_mm = 26\n"
      "[axes.z]\nmin_mm = -31\n");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->limits.period_s, 0.002);
  EXPECT_EQ(read->table.period_s, 0.002);
  EXPECT_EQ(read->limits.path.velocity_mm_s, 101.0);
  EXPECT_EQ(read->limits.path.acceleration_mm_s2, 102.5);
  EXPECT_EQ(read->limits.path.jerk_mm_s3, 103e3);
  EXPECT_EQ(read->limits.chord_tolerance_mm, 5e-4);
  EXPECT_EQ(read->program.corner_tolerance_mm, 0.03);
  EXPECT_EQ(read->program.merge_tolerance_mm, 0.0);
  const kerf::lookahead::MotionLimits& y = read->limits.axes[1];
  EXPECT_EQ(y.velocity_mm_s, 13.0);
  EXPECT_EQ(y.acceleration_mm_s2, 14.0);
  EXPECT_EQ(y.jerk_mm_s3, 15.0);
  const kerf::AxisDrive& drive = read->table.axes[1];
  EXPECT_EQ(drive.travel.min_mm, -11.0);
  EXPECT_EQ(drive.travel.max_mm, 12.0);
  EXPECT_EQ(drive.screw_lead_mm, 16.0);
  EXPECT_EQ(drive.counts_per_rev, 17.0);
  EXPECT_EQ(drive.drive_velocity_mm_s, 18.0);
  EXPECT_EQ(drive.drive_acceleration_mm_s2, 19.0);
  EXPECT_EQ(drive.position_gain_per_s, 20.0);
  EXPECT_EQ(drive.velocity_gain_per_s, 21.0);
  EXPECT_EQ(drive.velocity_integral_per_s2, 22.0);
  EXPECT_EQ(drive.feed_forward, 0.23);
  EXPECT_EQ(drive.coulomb_friction_mm_s2, 24.0);
  EXPECT_EQ(drive.viscous_friction_per_s, 25.0);
  EXPECT_EQ(drive.max_following_error_mm, 26.0);
  EXPECT_EQ(read->table.axes[2].travel.min_mm, -31.0);
  EXPECT_EQ(read->table.axes[2].travel.max_mm, kUnbounded);
}

TEST(MachineFile, WhatIsLeftOutDoesNotBindOrKeepsItsDefault) {
  const auto read = parse_machine_file(kBounded);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->limits.period_s, 0.001);
  EXPECT_EQ(read->limits.chord_tolerance_mm, kUnbounded);
  EXPECT_EQ(read->program.corner_tolerance_mm, 0.01);
  EXPECT_EQ(read->program.merge_tolerance_mm, 0.01);
  const kerf::AxisDrive defaults{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(read->limits.axes[axis].velocity_mm_s, kUnbounded);
    EXPECT_EQ(read->limits.axes[axis].acceleration_mm_s2, kUnbounded);
    EXPECT_EQ(read->limits.axes[axis].jerk_mm_s3, kUnbounded);
    EXPECT_EQ(read->table.axes[axis].travel.min_mm, -kUnbounded);
    EXPECT_EQ(read->table.axes[axis].drive_velocity_mm_s, defaults.drive_velocity_mm_s);
    EXPECT_EQ(read->table.axes[axis].position_gain_per_s, defaults.position_gain_per_s);
  }
}

TEST(MachineFile, ADriveThatTheFileIsSilentAboutIsTwiceAsStrongAsThePlan) {
  const auto read = parse_machine_file(
      kBounded + "[axes.x]\nmax_velocity_mm_s = 1000\nmax_acceleration_mm_s2 = 30e3\n");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->table.axes[0].drive_velocity_mm_s, 2000.0);
  EXPECT_EQ(read->table.axes[0].drive_acceleration_mm_s2, 60e3);
  EXPECT_EQ(read->table.axes[1].drive_velocity_mm_s, 500.0);
}

TEST(MachineFile, TheDefaultMachineIsTheTableThatIsShipped) {
  const auto read = parse_machine_file(read_text("programs/machines/table.toml"));
  ASSERT_TRUE(read);
  MachineSettings shipped = *read;
  MachineSettings built_in = kerf::default_machine();
  EXPECT_EQ(shipped.table.period_s, built_in.table.period_s);
  for (const auto& rules : {kerf::tick_rules(), kerf::path_rules(), kerf::axis_rules()}) {
    for (const NumberRule& rule : rules) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(rule.field(shipped, axis), rule.field(built_in, axis)) << rule.key << axis;
        // All that a machine needs is bound; across the path the limits of the axes bind.
        const bool across = rule.key.find("normal") != std::string_view::npos;
        const bool switches =
            rule.key == "home_switch_mm" || rule.key == "home_mm" || rule.key == "home_travel_mm";
        EXPECT_EQ(std::isfinite(rule.field(shipped, axis)), !across && !switches)
            << rule.key << axis;
      }
    }
  }
  const auto& tools = shipped.program.tools.listed();
  const auto& built_in_tools = built_in.program.tools.listed();
  EXPECT_EQ(shipped.program.path_control, built_in.program.path_control);
  EXPECT_TRUE(shipped.program.tools.given());
  ASSERT_EQ(tools.size(), built_in_tools.size());
  for (std::size_t i = 0; i < tools.size(); ++i) {
    EXPECT_EQ(tools[i].number, built_in_tools[i].number);
    EXPECT_EQ(tools[i].pocket, built_in_tools[i].pocket);
    EXPECT_EQ(tools[i].offset_mm, built_in_tools[i].offset_mm);
    EXPECT_EQ(tools[i].diameter_mm, built_in_tools[i].diameter_mm);
  }
}

TEST(MachineFile, HoldsOffsetsAndTools) {
  const auto read =
      parse_machine_file(kBounded +
                         "[offsets.g54]\nx_mm = 1\nrotation_deg = 30\n[offsets.g59_3]\nz_mm = -5\n"
                         "[offsets.g28]\ny_mm = 7\n[offsets.g30]\nz_mm = 8\n"
                         "[[tools.tool]]\nnumber = 7\npocket = 3\ndiameter_mm = 6\nz_mm = 40\n");
  ASSERT_TRUE(read);
  const kerf::ProgramData& data = read->program;
  EXPECT_EQ(data.work[0].origin_mm, (kerf::Position{1.0, 0.0, 0.0}));
  EXPECT_EQ(data.work[0].rotation_deg, 30.0);
  EXPECT_EQ(data.work[8].origin_mm[2], -5.0);
  EXPECT_EQ(data.first_home_mm[1], 7.0);
  EXPECT_EQ(data.second_home_mm[2], 8.0);
  ASSERT_NE(data.tools.find(7), nullptr);
  EXPECT_EQ(data.tools.find(7)->pocket, 3);
  EXPECT_EQ(data.tools.find(7)->diameter_mm, 6.0);
  EXPECT_EQ(data.tools.find(7)->offset_mm[2], 40.0);
  EXPECT_EQ(data.tools.find(8), nullptr);
}

TEST(MachineFile, NamesTheInputsThatTheFeedrateFollows) {
  const auto read = parse_machine_file(kBounded + "[inputs]\nadaptive_feed = 7\nfeed_stop = 63\n");
  ASSERT_TRUE(read);
  const auto inputs = read->program.feed_inputs;
  EXPECT_EQ(inputs.adaptive_feed, 7);
  EXPECT_EQ(inputs.feed_stop, 63);
  EXPECT_FALSE(kerf::default_machine().program.feed_inputs.feed_stop);
}

TEST(MachineFile, NamesTheDriver) {
  EXPECT_EQ(kerf::driver_of_machine_file(kBounded).name, "simulated");
  EXPECT_EQ(kerf::driver_of_machine_file(kBounded + "[driver]\nname = 'simulated'\n").name,
            "simulated");
  const auto loopback = kerf::driver_of_machine_file(
      kBounded + "[driver]\nname = 'loopback'\nsocket = '/run/m.sock'\ntimeout_s = 0.05\n");
  EXPECT_EQ(loopback.name, "loopback");
  EXPECT_EQ(loopback.socket, "/run/m.sock");
  EXPECT_EQ(loopback.timeout_s, 0.05);
  EXPECT_FALSE(parse_machine_file(kBounded + "[driver]\nnames = 'simulated'\n"));
}

TEST(MachineFile, WithoutToolsKnowsEveryTool) {
  const auto read = parse_machine_file(kBounded);
  ASSERT_TRUE(read);
  EXPECT_NE(read->program.tools.find(99), nullptr);
}

TEST(MachineFile, MayNameAFileOfTools) {
  const auto read = parse_machine_file(kBounded + "[tools]\nfile = \"t.tbl\"\n");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->tool_file, "t.tbl");
}

TEST(MachineFile, EveryShippedMachineLoadsAndCanBeSimulated) {
  for (const char* name : {"table", "sigmoid-butterfly", "sigmoid-wm", "sine-series", "quintic"}) {
    const auto read =
        parse_machine_file(read_text(std::string("programs/machines/") + name + ".toml"));
    ASSERT_TRUE(read) << name;
    EXPECT_TRUE(kerf::machine::is_valid(read->table)) << name;
  }
}

TEST(MachineFile, ThePapersLimitsAreTheirOwn) {
  const auto butterfly = parse_machine_file(read_text("programs/machines/sigmoid-butterfly.toml"));
  ASSERT_TRUE(butterfly);
  EXPECT_EQ(butterfly->limits.path.velocity_mm_s, 100.0);
  EXPECT_EQ(butterfly->limits.path.acceleration_mm_s2, 3000.0);
  EXPECT_EQ(butterfly->limits.path.jerk_mm_s3, 55e3);
  EXPECT_EQ(butterfly->limits.chord_tolerance_mm, 5e-4);
  EXPECT_EQ(butterfly->limits.axes[0].jerk_mm_s3, kUnbounded);
  const auto quintic = parse_machine_file(read_text("programs/machines/quintic.toml"));
  ASSERT_TRUE(quintic);
  // 0 to 800 mm/min in 0.2 s: T = max(1.875 v / A, sqrt(10 / sqrt(3) v / J)), and the quintic
  // paper's corner D, 12.5 mm/s / sqrt(2) = 530 mm/min.
  const kerf::lookahead::MotionLimits& path = quintic->limits.path;
  EXPECT_NEAR(path.velocity_mm_s * 60.0, 800.0, 1e-12);
  EXPECT_NEAR(1.875 * path.velocity_mm_s / path.acceleration_mm_s2, 0.2, 1e-15);
  const double by_jerk_s = std::sqrt(10.0 / std::sqrt(3.0) * path.velocity_mm_s / path.jerk_mm_s3);
  EXPECT_LE(by_jerk_s, 0.2);
  EXPECT_NEAR(by_jerk_s, 0.2, 1e-7);
  const double corner_mm_s =
      quintic->limits.axes[1].acceleration_mm_s2 * quintic->limits.period_s / std::sqrt(2.0);
  EXPECT_NEAR(corner_mm_s * 60.0, 530.3, 0.05);
}

TEST(MachineFile, TakesAByteOrderMarkCrlfAndInlineTables) {
  std::string crlf;
  for (const char c : kBounded) {
    crlf += c == '\n' ? "\r\n" : std::string(1, c);
  }
  EXPECT_TRUE(parse_machine_file("\xef\xbb\xbf" + crlf));
  EXPECT_TRUE(
      parse_machine_file(kBounded + "[axes]\nx = { min_mm = 0, max_mm = 1 }\ny.min_mm = 3"));
}

TEST(MachineFile, SaysHowAxesFindTheirHomeAndWhatAnOperatorMayDo) {
  const auto read = parse_machine_file(
      kBounded +
      "[axes]\nz = { home_switch_mm = 205, home_mm = 190, home_search_mm_s = 15, "
      "home_latch_mm_s = 0.5, home_back_off_mm = 4, home_travel_mm = 450, home_time_s = 60, "
      "home_order = 2 }\n[manual]\njog_mm_s = 50\nunhomed_jog_mm_s = 5\njog_timeout_s = 0.2\n"
      "runs_unhomed = true\n");
  ASSERT_TRUE(read);
  const kerf::AxisHoming& z = read->manual.homing[2];
  EXPECT_EQ(z.switch_mm, 205.0);
  EXPECT_EQ(z.home_mm, 190.0);
  EXPECT_EQ(z.search_mm_s, 15.0);
  EXPECT_EQ(z.latch_mm_s, 0.5);
  EXPECT_EQ(z.back_off_mm, 4.0);
  EXPECT_EQ(z.travel_mm, 450.0);
  EXPECT_EQ(z.time_s, 60.0);
  EXPECT_EQ(z.order, 2.0);
  EXPECT_FALSE(std::isfinite(read->manual.homing[0].switch_mm));
  EXPECT_EQ(read->manual.jog_mm_s, 50.0);
  EXPECT_EQ(read->manual.unhomed_jog_mm_s, 5.0);
  EXPECT_EQ(read->manual.jog_timeout_s, 0.2);
  EXPECT_TRUE(read->manual.runs_unhomed);
  for (const char* wrong :
       {"[axes]\nx.home_search_mm_s = 0", "[axes]\nx.home_latch_mm_s = -1", "[manual]\njog = 1",
        "[manual]\nruns_unhomed = 1", "[manual]\njog_timeout_s = 0"}) {
    EXPECT_FALSE(parse_machine_file(kBounded + wrong)) << wrong;
  }
}

TEST(MachineFile, DocumentsEveryKeyWithItsDefaultAndEveryShippedMachine) {
  const std::string page = read_text("docs/machine-file.md");
  for (const auto& rules :
       {kerf::tick_rules(), kerf::path_rules(), kerf::axis_rules(), kerf::manual_rules()}) {
    for (const NumberRule& rule : rules) {
      const std::size_t row = page.find("\n| `" + std::string(rule.key) + "` | ");
      ASSERT_NE(row, std::string::npos) << rule.key;
      const std::string line = page.substr(row + 1, page.find('\n', row + 1) - row - 1);
      // | key | range | default | meaning |
      const std::size_t range = line.find("| ", 2) + 2;
      const std::string default_column = line.substr(line.find("| ", range) + 2);
      MachineSettings defaults{};
      const double value = rule.field(defaults, 0);
      if (std::isfinite(value)) {
        EXPECT_EQ(std::stod(default_column), value) << line;
      } else {
        EXPECT_TRUE(default_column.starts_with("does not bind |") ||
                    default_column.starts_with("none |"))
            << line;
      }
    }
  }
  for (const char* name : {"table", "sigmoid-butterfly", "sigmoid-wm", "sine-series", "quintic"}) {
    EXPECT_NE(page.find("`" + std::string(name) + ".toml`"), std::string::npos);
  }
}

}  // namespace
