// The journal of a run: what was written is what is read, and nothing else is.
#include "programs/kerf/run/journal.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "programs/kerf/io/checksum.hpp"
#include "tests/program/temporary_folder.hpp"

namespace kerf::program {
namespace {

const JournalledRun kRun{
    .file = "part.ngc", .program = 0xFEDCBA9876543210U, .machine = 7, .blocks_before = 3};

JournalledPlace place(std::uint64_t block) {
  return {.block = block,
          .line = 12,
          .run_s = 0.1 * static_cast<double>(block),
          .position_mm = {1.0 / 3.0, -2.5, 1e-9},
          .state = "running"};
}

class JournalOfARun : public testing::Test {
 protected:
  std::string written() {
    auto writer = JournalWriter::open(path_, kRun, 0);
    EXPECT_TRUE(writer);
    for (const std::uint64_t block : {4U, 9U, 12U}) {
      EXPECT_EQ(writer->place(place(block)), 0);
    }
    EXPECT_EQ(writer->end(ExitStatus::stopped), 0);
    return text();
  }
  std::string text() const {
    std::ostringstream text;
    text << std::ifstream(path_).rdbuf();
    return text.str();
  }

  TemporaryFolder folder_;
  std::string path_ = (folder_ / "part.journal").string();
};

TEST(Checksum, IsCrc64Xz) {
  Checksum checksum;
  checksum.add("1234");
  checksum.add("56789");
  EXPECT_EQ(checksum.value(), 0x995DC9BBDF1939FAU);  // the check value of CRC-64/XZ
}

TEST_F(JournalOfARun, SaysWhatAnOperatorChangedUntilTheNextRunBegins) {
  {
    auto writer = JournalWriter::open(path_, kRun, 0);
    ASSERT_TRUE(writer);
    EXPECT_EQ(writer->change("a line was run"), 0);
    EXPECT_EQ(writer->place(place(4)), 0);
  }
  const auto journal = read_journal_file(path_);
  ASSERT_TRUE(journal);
  EXPECT_EQ(journal->change, "a line was run");
  EXPECT_EQ(journal->block(), 4U);
  ASSERT_TRUE(JournalWriter::open(path_, kRun, journal->valid_bytes));
  EXPECT_EQ(read_journal_file(path_)->change, "");
}

TEST_F(JournalOfARun, IsReadAsItWasWritten) {
  written();
  const auto journal = read_journal_file(path_);
  ASSERT_TRUE(journal) << journal.error();
  EXPECT_EQ(journal->run, kRun);
  EXPECT_EQ(journal->place, place(12));
  EXPECT_EQ(journal->exit_status, 7);
  EXPECT_EQ(journal->valid_bytes, text().size());
}

TEST_F(JournalOfARun, Row79TornAtAnyByteIsAsItWasBeforeTheRecord) {
  const std::string whole = written();
  const auto records_in = [&](std::size_t bytes) {
    return std::count(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(bytes), '\n');
  };
  for (std::size_t bytes = 0; bytes <= whole.size(); ++bytes) {
    const auto journal = read_journal(whole.substr(0, bytes));
    const auto records = records_in(bytes);
    ASSERT_EQ(journal.has_value(), records > 0) << bytes;
    if (!journal) {
      continue;
    }
    EXPECT_EQ(journal->run, kRun);
    constexpr std::array<std::uint64_t, 5> kBlocks{4, 4, 9, 12, 12};  // at first that of the start
    EXPECT_EQ(journal->block(), kBlocks[static_cast<std::size_t>(records - 1)]) << bytes;
    EXPECT_EQ(journal->exit_status.has_value(), records == 5) << bytes;
    EXPECT_EQ(std::count(whole.begin(),
                         whole.begin() + static_cast<std::ptrdiff_t>(journal->valid_bytes), '\n'),
              records);
  }
}

TEST_F(JournalOfARun, WithAnyByteChangedIsAsItWasBeforeTheRecord) {
  const std::string whole = written();
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 0x04);
    const auto records =
        std::count(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    const auto journal = read_journal(changed);
    ASSERT_EQ(journal.has_value(), records > 0) << at;
    if (journal) {
      EXPECT_EQ(journal->valid_bytes, whole.rfind('\n', at - 1) + 1) << at;
    }
  }
}

TEST_F(JournalOfARun, GoesOnBehindItsValidBytes) {
  const std::string whole = written();
  const std::size_t torn = whole.size() - 5;
  std::ofstream(path_) << whole.substr(0, torn);
  const auto before = read_journal_file(path_);
  ASSERT_TRUE(before);
  JournalledRun next = kRun;
  next.blocks_before = 11;
  auto writer = JournalWriter::open(path_, next, before->valid_bytes);
  ASSERT_TRUE(writer);
  auto journal = read_journal_file(path_);
  ASSERT_TRUE(journal);
  EXPECT_EQ(journal->run, next);
  EXPECT_FALSE(journal->exit_status);
  EXPECT_EQ(journal->block(), 12U);  // where it started
  EXPECT_EQ(writer->place(place(20)), 0);
  EXPECT_EQ(read_journal_file(path_)->block(), 20U);
  EXPECT_TRUE(text().starts_with(whole.substr(0, before->valid_bytes)));
}

TEST_F(JournalOfARun, IsNoneWhereThereIsNoRun) {
  EXPECT_FALSE(read_journal(""));
  EXPECT_FALSE(read_journal("hello\n"));
  EXPECT_FALSE(read_journal_file(path_ + ".none"));
}

TEST_F(JournalOfARun, OnAFullDiskSaysSo) {
  EXPECT_FALSE(JournalWriter::open("/dev/full", kRun, 0));
  EXPECT_FALSE(JournalWriter::open((folder_ / "no/such/folder").string(), kRun, 0));
}

}  // namespace
}  // namespace kerf::program
