// All that the fuzzer once found, and what it starts from.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include <gtest/gtest.h>

#include "tests/fuzz/judge/judge.hpp"

namespace kerf::fuzz {
namespace {

std::vector<std::filesystem::path> corpus() {
  const auto folder = std::filesystem::path(KERF_SOURCE_DIR) / "tests/fuzz/corpus";
  std::vector<std::filesystem::path> files;
  std::copy(std::filesystem::directory_iterator(folder), {}, std::back_inserter(files));
  std::sort(files.begin(), files.end());
  return files;
}

class FuzzCorpus : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(FuzzCorpus, IsReadPlannedAndRun) {
  std::ifstream file(GetParam(), std::ios::binary);
  const std::vector<char> text{std::istreambuf_iterator<char>(file), {}};
  ASSERT_GE(text.size(), kHead);
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  judge(bytes);
}

INSTANTIATE_TEST_SUITE_P(Files, FuzzCorpus, testing::ValuesIn(corpus()),
                         [](const auto& file) { return file.param.filename().string(); });

}  // namespace
}  // namespace kerf::fuzz
