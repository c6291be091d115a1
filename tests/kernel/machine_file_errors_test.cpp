// What is wrong with the form of a machine file, with its place.
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/machine.hpp>

#include "kernel/machine_file_schema.hpp"
#include "kernel/machine_file_text.hpp"
#include "machine/simulated_table.hpp"
#include "tests/kernel/machine_file_helpers.hpp"

namespace {

using kerf::kUnbounded;
using kerf::MachineSettings;
using kerf::NumberRule;
using kerf::parse_machine_file;
using kerf::test::errors_of;
using kerf::test::kBounded;
using kerf::test::kBoundedLines;
using kerf::test::Lines;

TEST(MachineFileErrors, NamesAnUnknownKeyInEverySection) {
  for (const char* section : {"tick", "path", "axes", "axes.x", "axes.y", "axes.z"}) {
    const std::string name(section);
    std::string toml = kBounded;
    std::string place = ":6:2: ";
    if (name == "path") {
      toml += " wobble = 1\n";
      place = ":5:2: ";
    } else {
      toml += "[" + name + "]\n wobble = 1\n";
    }
    EXPECT_EQ(errors_of(toml),
              Lines{"m.toml" + place + "error: unknown key 'wobble' in [" + name + "]"});
  }
  EXPECT_EQ(errors_of("wobble = 1\n" + kBounded), Lines{"m.toml:1:1: error: unknown key 'wobble'"});
  EXPECT_EQ(errors_of(kBounded + "[wobble.x]\nfoo = 1\n"),
            Lines{"m.toml:5:2: error: unknown key 'wobble'"});
}

TEST(MachineFileErrors, AsksWhetherANearKeyWasMeant) {
  EXPECT_EQ(errors_of(kBounded + "max_velocty_mm_s = 3\n"),
            Lines{"m.toml:5:1: error: unknown key 'max_velocty_mm_s' in [path], did you mean "
                  "'max_velocity_mm_s'?"});
  EXPECT_EQ(errors_of(kBounded + "[axes.X]\n"),
            Lines{"m.toml:5:7: error: unknown key 'X' in [axes], did you mean 'x'?"});
  EXPECT_EQ(errors_of(kBounded + "[axis.x]\n"),
            Lines{"m.toml:5:2: error: unknown key 'axis', did you mean 'axes'?"});
  EXPECT_EQ(errors_of(kBounded + "[axes.q]\n"),
            Lines{"m.toml:5:7: error: unknown key 'q' in [axes]"});
}

// The section of the rule, its key with the value, under kBounded where the key is not there yet.
struct Written {
  std::string toml;
  std::string path;
  std::string place;
};
Written write(const std::string& section, const NumberRule& rule, const std::string& value) {
  const std::string key(rule.key);
  const std::string column = std::to_string(key.size() + 4);
  if (section != "path") {
    return {kBounded + "[" + section + "]\n" + key + " = " + value + "\n", section + "." + key,
            "m.toml:" + std::to_string(kBoundedLines + 2) + ":" + column + ": error: "};
  }
  std::string toml = "[path]\n" + key + " = " + value + "\n";
  for (const NumberRule& other : kerf::path_rules()) {
    toml += other.key != rule.key ? std::string(other.key) + " = 1\n" : "";
  }
  return {toml, "path." + key, "m.toml:2:" + column + ": error: "};
}

void for_every_key(const std::function<void(const std::string&, const NumberRule&)>& test) {
  for (const NumberRule& rule : kerf::tick_rules()) {
    test("tick", rule);
  }
  for (const NumberRule& rule : kerf::path_rules()) {
    test("path", rule);
  }
  for (const char* axis : {"axes.x", "axes.y", "axes.z"}) {
    for (const NumberRule& rule : kerf::axis_rules()) {
      test(axis, rule);
    }
  }
}

TEST(MachineFileErrors, RefusesAWrongTypeOfEveryKey) {
  const std::vector<std::array<std::string, 2>> values{
      {"\"1\"", "a string"},
      {"true", "a boolean"},
      {"[1]", "an array"},
      {"{a = 1}", "a table"},
      {"1979-05-27", "a date or time"},
      {"07:32:00", "a date or time"},
  };
  for_every_key([&](const std::string& section, const NumberRule& rule) {
    for (const auto& [value, found] : values) {
      const Written written = write(section, rule, value);
      EXPECT_EQ(errors_of(written.toml),
                Lines{written.place + written.path + ": found " + found + ", expected a number"});
    }
  });
}

TEST(MachineFileErrors, RefusesAnImpossibleValueOfEveryKey) {
  for_every_key([](const std::string& section, const NumberRule& rule) {
    const std::string range =
        ", expected a number from " + kerf::text_of(rule.min) + " to " + kerf::text_of(rule.max);
    std::vector<double> values{std::nextafter(rule.min, -kUnbounded),
                               std::nextafter(rule.max, kUnbounded), -1e300, 1e300};
    if (rule.min > 0.0) {
      values.push_back(0.0);
      values.push_back(-1.0);
    }
    for (const double value : values) {
      std::string text = kerf::text_of(value);
      text += text.find_first_of(".e") == std::string::npos ? ".0" : "";
      const Written written = write(section, rule, text);
      EXPECT_EQ(errors_of(written.toml),
                Lines{written.place + written.path + ": found " + kerf::text_of(value) + range});
    }
    for (const char* value : {"inf", "-inf", "nan"}) {
      const Written written = write(section, rule, value);
      EXPECT_EQ(errors_of(written.toml),
                Lines{written.place + written.path + ": found " + value + range});
    }
  });
}

TEST(MachineFileErrors, TakesEveryKeyAtBothEndsOfItsRange) {
  for_every_key([](const std::string& section, const NumberRule& rule) {
    for (const double value : {rule.min, rule.max}) {
      // What the ends of the range would contradict in the same table.
      std::string partner;
      if (rule.key == "position_gain_per_s") {
        partner = "velocity_gain_per_s = 1e5\n";
      } else if (rule.key == "velocity_gain_per_s") {
        partner = "position_gain_per_s = 1e-3\n";
      }
      const Written written = write(section, rule, kerf::text_of(value));
      const auto read = parse_machine_file(written.toml + partner);
      ASSERT_TRUE(read) << written.toml << to_string(read.error()[0], "m.toml");
      MachineSettings settings = *read;
      const std::size_t axis = section.size() == 6 ? static_cast<std::size_t>(section[5] - 'x') : 0;
      EXPECT_EQ(rule.field(settings, axis), value) << written.path;
      EXPECT_TRUE(kerf::machine::is_valid(settings.table)) << written.path;
    }
  });
}

TEST(MachineFileErrors, ReportsAllErrorsInTheOrderOfTheText) {
  const Lines errors = errors_of(
      "[axes.z]\nfeed_forward = 1.5\nfoo = 1\n[path]\nmax_velocity_mm_s = 'a'\n"
      "max_acceleration_mm_s2 = -1\nmax_jerk_mm_s3 = 5\n[tick]\nperiod_s = 1\n[more]\n");
  ASSERT_EQ(errors.size(), 6U);
  const std::vector<std::string> places{"2:16", "3:1", "5:21", "6:26", "9:12", "10:2"};
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_EQ(errors[i].find("m.toml:" + places[i] + ": error: "), 0U) << errors[i];
  }
}

TEST(MachineFileErrors, WantsSectionsToBeTables) {
  EXPECT_EQ(errors_of("tick = 3\n" + kBounded),
            Lines{"m.toml:1:8: error: tick: found a number, expected a table"});
  EXPECT_EQ(errors_of(kBounded + "[axes]\n  y = [1]\n"),
            Lines{"m.toml:6:7: error: axes.y: found an array, expected a table"});
  const Lines errors = errors_of("[[path]]\nmax_velocity_mm_s = 1\n");
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_NE(errors[0].find("path: found an array, expected a table"), std::string::npos);
}

TEST(MachineFileErrors, PlacesWhatIsNotToml) {
  const Lines broken = errors_of("[path]\nmax_velocity_mm_s = \n");
  ASSERT_EQ(broken.size(), 1U);
  EXPECT_EQ(broken[0].find("m.toml:2:21: error: "), 0U) << broken[0];
  const Lines twice = errors_of(kBounded + "max_velocity_mm_s = 1\n");
  ASSERT_EQ(twice.size(), 1U);
  EXPECT_EQ(twice[0].find("m.toml:5:"), 0U) << twice[0];
  const Lines control = errors_of("\x01");
  ASSERT_EQ(control.size(), 1U);
  EXPECT_EQ(control[0].find("m.toml:1:1: error: "), 0U) << control[0];
  EXPECT_EQ(errors_of("\xff\xfe").size(), 1U);
}

TEST(MachineFileErrors, SurvivesDeepNestingAndOddKeys) {
  EXPECT_EQ(errors_of(kBounded + "a = " + std::string(100'000, '[')).size(), 1U);
  EXPECT_EQ(errors_of("\"a\\u0001b\\n\" = 1\n" + kBounded),
            Lines{"m.toml:1:1: error: unknown key 'a?b?'"});
  const Lines lengthy = errors_of(std::string(5000, 'k') + " = 1\n" + kBounded);
  ASSERT_EQ(lengthy.size(), 1U);
  EXPECT_LT(lengthy[0].size(), 120U);
}

TEST(MachineFileErrors, RefusesMoreThanAMebibyte) {
  const std::string comment = "#" + std::string((1U << 20) - kBounded.size() - 2, 'x') + "\n";
  EXPECT_TRUE(parse_machine_file(kBounded + comment));
  EXPECT_EQ(errors_of(kBounded + comment + "\n"),
            Lines{"m.toml: error: found 1048577 bytes, expected at most 1 MiB"});
}

TEST(MachineFileErrors, NamesWhatIsWrongWithOffsets) {
  EXPECT_EQ(errors_of(kBounded + "[offsets.g54]\nx_mm = 1\nrotation = 2\n"),
            (Lines{"m.toml:7:1: error: unknown key 'rotation' in [offsets.g54], did you mean "
                   "'rotation_deg'?"}));
  EXPECT_EQ(errors_of(kBounded + "[offsets.g28]\nrotation_deg = 2\n").size(), 1U);
  EXPECT_EQ(errors_of(kBounded + "[offsets.g60]\nx_mm = 1\n").size(), 1U);
}

TEST(MachineFileErrors, NamesWhatIsWrongWithInputs) {
  EXPECT_EQ(
      errors_of(kBounded + "[inputs]\nadaptive_feed = 8\nfeed_stop = 1.5\n"),
      (Lines{"m.toml:6:17: error: inputs.adaptive_feed: found 8, expected a number from 0 to 7",
             "m.toml:7:13: error: inputs.feed_stop: found 1.5, expected a whole number"}));
  EXPECT_EQ(errors_of(kBounded + "[inputs]\nfeed_stop = true\nfeed_step = 1\n").size(), 2U);
}

TEST(MachineFileErrors, NamesWhatIsWrongWithADriver) {
  EXPECT_EQ(errors_of(kBounded + "[driver]\nmax_late_periods = 1.5\n"),
            Lines{"m.toml:6:20: error: driver.max_late_periods: expected a whole number"});
  EXPECT_EQ(errors_of(kBounded + "[driver]\nfault = []\n"), Lines{});
  EXPECT_EQ(errors_of(kBounded + "[[driver.fault]]\nkind = \"drive_trip\"\naxis = 3\n").size(), 1U);
}

TEST(MachineFileErrors, NamesTheDriversThereAre) {
  EXPECT_EQ(errors_of(kBounded + "[driver]\nname = 'ethercat'\n"),
            (Lines{"m.toml:6:8: error: driver.name: found 'ethercat', expected 'simulated' or "
                   "'loopback'"}));
  EXPECT_EQ(errors_of(kBounded + "[driver]\nname = 3\n").size(), 1U);
  EXPECT_EQ(errors_of(kBounded + "[driver]\nname = 'loopback'\n"),
            (Lines{"m.toml:6:8: error: driver.name: the driver loopback needs a socket"}));
  EXPECT_EQ(errors_of(kBounded + "[driver]\nsocket = 7\ntimeout_s = 0\n").size(), 2U);
}

TEST(MachineFileErrors, NamesWhatIsWrongWithTools) {
  EXPECT_EQ(errors_of(kBounded + "[[tools.tool]]\nnumber = 1\nnumbr = 2\n").size(), 1U);
  EXPECT_EQ(errors_of(kBounded + "[tools]\nfile = 3\n"),
            (Lines{"m.toml:6:8: error: tools.file: found a number, expected the name of a file"}));
  EXPECT_EQ(errors_of(kBounded + "[tools]\nfile = \"a\"\ntool = []\n"),
            (Lines{"m.toml:6:8: error: tools: found a file and tools, expected one of them"}));
  EXPECT_EQ(errors_of(kBounded + "[tools]\ntool = 3\n"),
            (Lines{"m.toml:6:8: error: tools.tool: found a number, expected an array of tables "
                   "([[tools.tool]])"}));
  EXPECT_EQ(errors_of(kBounded + "[tools]\ntool = [{ number = 1.5 }]\n"),
            (Lines{"m.toml:6:20: error: tools.tool.number: expected the tool's number, a whole "
                   "one"}));
  EXPECT_EQ(errors_of(kBounded + "[tools]\ntool = [{ number = 1 }, { number = 1 }]\n"),
            (Lines{"m.toml:6:36: error: tools.tool: T1 is listed twice"}));
  EXPECT_EQ(errors_of(kBounded + "[tools]\ntool = [{ number = 1, pocket = 1.5 }]\n"),
            (Lines{"m.toml:6:32: error: tools.tool.pocket: expected the pocket's number, a whole "
                   "one"}));
}

}  // namespace
