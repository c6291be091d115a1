#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "programs/kerf/cli/option_parser.hpp"

namespace kerf::program {
namespace {

std::variant<Options, Leave> parse(std::vector<const char*> words) {
  words.insert(words.begin(), "kerf");
  return parse_options(static_cast<int>(words.size()), words.data());
}

std::string refusal(const std::vector<const char*>& words) {
  const auto parsed = parse(words);
  const auto* leave = std::get_if<Leave>(&parsed);
  if (leave == nullptr) {
    return "accepted";
  }
  EXPECT_EQ(leave->status, ExitStatus::wrong_use);
  return leave->text;
}

TEST(CommandLine, HasDefaults) {
  const auto parsed = parse({"dry-run", "a.ngc"});
  const auto& options = std::get<Options>(parsed);
  EXPECT_EQ(options.command, Subcommand::dry_run);
  EXPECT_EQ(options.files, std::vector<std::string>{"a.ngc"});
  EXPECT_EQ(options.profile, profiles::ProfileKind::time_optimal);
  EXPECT_EQ(options.window_blocks, 1000U);
  EXPECT_FALSE(options.machine_file || options.trace_file || options.plot_file);
  EXPECT_FALSE(options.json || options.quiet);
  EXPECT_EQ(options.block_delete, parser::BlockDelete());
}

TEST(CommandLine, TakesADialect) {
  EXPECT_FALSE(std::get<Options>(parse({"check", "a.nc"})).dialect);
  EXPECT_EQ(std::get<Options>(parse({"check", "--dialect", "fanuc", "a.nc"})).dialect,
            parser::Dialect::fanuc);
  EXPECT_EQ(std::get<Options>(parse({"run", "--dialect", "rs274", "a.nc"})).dialect,
            parser::Dialect::rs274);
  EXPECT_NE(refusal({"run", "--dialect", "heidenhain", "a.nc"}), "accepted");
}

TEST(CommandLine, BoundsTheTimeOfAProgramAndTheSizeOfATrace) {
  const auto of = [](std::vector<const char*> words) {
    words.insert(words.begin(), {"dry-run", "a.ngc"});
    return std::get<Options>(parse(words));
  };
  EXPECT_EQ(of({}).max_time_s, 2'592'000.0);
  EXPECT_EQ(of({}).max_trace_bytes, 4'294'967'296U);
  EXPECT_EQ(of({"--max-time", "90"}).max_time_s, 90.0);
  EXPECT_EQ(of({"--max-time", "1.5s"}).max_time_s, 1.5);
  EXPECT_EQ(of({"--max-time", "5min"}).max_time_s, 300.0);
  EXPECT_EQ(of({"--max-time", "2h"}).max_time_s, 7200.0);
  EXPECT_EQ(of({"--max-time", "0.5d"}).max_time_s, 43'200.0);
  EXPECT_EQ(of({"--trace", "t.csv", "--trace-from", "0"}).trace_from_s, 0.0);
  EXPECT_EQ(of({"--trace", "t.csv", "--max-trace", "1000"}).max_trace_bytes, 1000U);
  EXPECT_EQ(of({"--trace", "t.csv", "--max-trace", "1.5kB"}).max_trace_bytes, 1500U);
  EXPECT_EQ(of({"--trace", "t.csv", "--max-trace", "2GB"}).max_trace_bytes, 2'000'000'000U);
  EXPECT_EQ(of({"--trace", "t.csv", "--max-trace", "3MiB"}).max_trace_bytes, 3U << 20U);
  for (const char* const time :
       {"0", "-1", "h", "2 h", "2hours", "nan", "inf", "1e3", "20000000000"}) {
    EXPECT_NE(refusal({"check", "a.ngc", "--max-time", time}), "accepted") << time;
  }
  for (const char* const size : {"0", "-1", "GiB", "4gib", "0.5", "nan", "2000000TiB"}) {
    EXPECT_NE(refusal({"run", "a.ngc", "--max-trace", size}), "accepted") << size;
  }
  EXPECT_NE(refusal({"check", "a.ngc", "--max-trace", "1"}), "accepted");
}

TEST(CommandLine, CountsNothingBelowZero) {
  EXPECT_NE(refusal({"check", "a.ngc", "--max-moves", "-1"}), "accepted");
  EXPECT_NE(refusal({"check", "a.ngc", "--max-moves", "0"}), "accepted");
  EXPECT_NE(refusal({"compare", "a.ngc", "b.ngc", "--lines", "-1"}), "accepted");
  EXPECT_EQ(refusal({"compare", "a.ngc", "b.ngc", "--lines", "0"}), "accepted");
}

TEST(CommandLine, NamesTheWordsThatAnOptionTakes) {
  EXPECT_EQ(std::get<Options>(parse({"check", "a.ngc", "--units", "inch/min"})).feed_unit,
            FeedUnit::inch_min);
  EXPECT_EQ(std::get<Options>(parse({"check", "a.ngc", "--log-level", "debug"})).log_level,
            LogLevel::debug);
  EXPECT_EQ(std::get<Options>(parse({"check", "a.ngc", "--format", "sarif"})).format,
            DiagnosticFormat::sarif);
  for (const auto& [option, words] :
       {std::pair{"--units", "{inch/min,mm/min,mm/s}"},
        std::pair{"--log-level", "{debug,error,info}"}, std::pair{"--format", "{json,sarif,text}"},
        std::pair{"--dialect", "{fanuc,rs274}"}}) {
    EXPECT_NE(refusal({"check", "a.ngc", option, "foo"}).find(words), std::string::npos) << option;
  }
}

TEST(CommandLine, WritesOverNothingThatItReads) {
  const std::vector<const char*> run{"run", "a.ngc", "--machine", "m.toml", "--tools", "t.tbl"};
  for (const char* const option :
       {"--trace", "--plot", "--record", "--log", "--journal", "--flight-recorder"}) {
    for (const char* const file : {"a.ngc", "m.toml", "t.tbl"}) {
      std::vector<const char*> words = run;
      words.insert(words.end(), {option, file});
      EXPECT_NE(refusal(words).find(std::string(file) + " is read"), std::string::npos) << option;
    }
    std::vector<const char*> words = run;
    words.insert(words.end(), {option, "new"});
    EXPECT_EQ(refusal(words), "accepted") << option;
  }
  EXPECT_NE(refusal({"report", "a.ngc", "-o", "a.ngc"}), "accepted");
  EXPECT_NE(refusal({"dry-run", "a.ngc", "--replay", "r", "--record", "r"}), "accepted");
  EXPECT_EQ(refusal({"dry-run", "-", "--trace", "-"}), "accepted");
}

TEST(CommandLine, TakesEveryOption) {
  const auto parsed = parse({"run", "--machine", "m.toml", "--profile", "sigmoid",
                             "--sigmoid-shape", "2.5", "--trace", "t.csv", "--plot", "p.svg",
                             "--window", "50", "--block-delete", "--json", "--quiet", "-"});
  const auto& options = std::get<Options>(parsed);
  EXPECT_EQ(options.command, Subcommand::run);
  EXPECT_EQ(options.files, std::vector<std::string>{"-"});
  EXPECT_EQ(options.machine_file, "m.toml");
  EXPECT_EQ(options.profile, profiles::ProfileKind::sigmoid);
  EXPECT_EQ(options.sigmoid_shape, 2.5);
  EXPECT_EQ(options.trace_file, "t.csv");
  EXPECT_EQ(options.plot_file, "p.svg");
  EXPECT_EQ(options.window_blocks, 50U);
  EXPECT_TRUE(options.json && options.quiet);
  EXPECT_EQ(options.block_delete, parser::BlockDelete::all());
}

TEST(CommandLine, TakesTheBlockDeleteSwitchesThatAreOn) {
  parser::BlockDelete second_and_ninth;
  second_and_ninth.switch_on(2);
  second_and_ninth.switch_on(9);
  EXPECT_EQ(std::get<Options>(parse({"check", "--block-delete=2,9", "a.nc"})).block_delete,
            second_and_ninth);
  EXPECT_EQ(
      std::get<Options>(parse({"check", "--block-delete=1,2,3,4,5,6,7,8,9", "a.nc"})).block_delete,
      parser::BlockDelete::all());
  const auto without_list = parse({"check", "--block-delete", "a.nc"});
  EXPECT_EQ(std::get<Options>(without_list).files, std::vector<std::string>{"a.nc"});
  for (const char* const wrong : {"0", "10", "1,", ",1", "1 2", "x", "1,,2"}) {
    EXPECT_NE(refusal({"check", "a.nc", (std::string("--block-delete=") + wrong).c_str()}),
              "accepted")
        << wrong;
  }
}

TEST(CommandLine, TakesWhatIsToBeSaidOfTheSpeed) {
  EXPECT_FALSE(std::get<Options>(parse({"dry-run", "a.ngc"})).explained_speed);
  const auto all = parse({"dry-run", "--explain-speed", "a.ngc"});
  EXPECT_TRUE(std::get<Options>(all).explained_speed.has_value());
  EXPECT_FALSE(std::get<Options>(all).explained_speed->line);
  EXPECT_EQ(std::get<Options>(parse({"run", "--explain-speed=14", "a.ngc"})).explained_speed->line,
            14U);
  EXPECT_TRUE(std::holds_alternative<Leave>(parse({"run", "--explain-speed=x", "a.ngc"})));
}

TEST(CommandLine, TakesSeveralFilesWhereThatMakesSense) {
  for (const char* command : {"dry-run", "check"}) {
    const auto parsed = parse({command, "a.ngc", "b.ngc", "--json"});
    EXPECT_EQ(std::get<Options>(parsed).files.size(), 2U);
  }
  EXPECT_NE(refusal({"run", "a.ngc", "b.ngc"}), "accepted");
  EXPECT_NE(refusal({"dry-run", "a.ngc", "b.ngc", "--trace", "t.csv"}), "accepted");
}

TEST(CommandLine, SaysWhatIsWrong) {
  EXPECT_NE(refusal({}), "accepted");
  EXPECT_NE(refusal({"dry-run"}), "accepted");
  EXPECT_NE(refusal({"mill", "a.ngc"}), "accepted");
  EXPECT_NE(refusal({"dry-run", "a.ngc", "--speed", "3"}).find("--speed"), std::string::npos);
  EXPECT_NE(refusal({"dry-run", "a.ngc", "--profile", "cubic"}).find("quintic"), std::string::npos);
  EXPECT_NE(refusal({"dry-run", "a.ngc", "--window", "1"}).find("--window"), std::string::npos);
  EXPECT_NE(refusal({"dry-run", "a.ngc", "--window", "many"}), "accepted");
  EXPECT_NE(refusal({"dry-run", "a.ngc", "--sigmoid-shape", "3"}), "accepted");
  EXPECT_NE(refusal({"dry-run", "a.ngc", "--profile", "sigmoid", "--sigmoid-shape", "60"}),
            "accepted");
  EXPECT_NE(refusal({"dry-run", "a.ngc", "--profile", "sigmoid", "--sigmoid-shape", "nan"}),
            "accepted");
  EXPECT_NE(refusal({"check", "a.ngc", "--trace", "t.csv"}), "accepted");
  EXPECT_NE(refusal({"dry-run", "a.ngc", "--json", "--trace", "-"}), "accepted");
  EXPECT_NE(refusal({"check", "-", "-"}), "accepted");
  for (const char* const option : {"--start", "--g54", "--max-time", "--from-line"}) {
    EXPECT_NE(refusal({"dry-run", "a.ngc", option, ""}).find(option), std::string::npos);
  }
}

TEST(CommandLine, GivesHelpAndVersionWithoutAFile) {
  for (const char* flag : {"--help", "--version"}) {
    const auto parsed = parse({flag});
    const auto& leave = std::get<Leave>(parsed);
    EXPECT_EQ(leave.status, ExitStatus::done);
    EXPECT_NE(leave.text.find("kerf"), std::string::npos);
  }
}

}  // namespace
}  // namespace kerf::program
