#include "programs/kerf/cli/error_page_text.hpp"

#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

TEST(ErrorPageText, IsWhatTheDocumentHolds) {
  std::ifstream file(KERF_SOURCE_DIR "/docs/errors.md", std::ios::binary);
  const std::string document{std::istreambuf_iterator<char>(file), {}};
  EXPECT_TRUE(document == error_pages_markdown())
      << "write it anew: kerf errors --markdown > docs/errors.md";
}

TEST(ErrorPageText, FindsAPageHoweverItsNumberIsWritten) {
  const std::string page = error_page_text("E0120").value();
  EXPECT_EQ(page.rfind("E0120: error: negative feed\n", 0), 0U);
  EXPECT_NE(page.find("    G1 X10 F-100\n    M2\n"), std::string::npos);
  for (const char* written : {"e0120", "E120", "120"}) {
    EXPECT_EQ(error_page_text(written).value(), page);
  }
}

TEST(ErrorPageText, RefusesWhatIsNoPage) {
  for (const char* wrong : {"", "E", "E9999", "feed", "E0120x", "E-1", "E99999"}) {
    EXPECT_FALSE(error_page_text(wrong)) << wrong;
  }
}

TEST(ErrorPageText, ListsEachPageInALine) {
  const std::string list = error_page_list();
  EXPECT_NE(list.find("\nE0120  error    negative feed\n"), std::string::npos);
  EXPECT_NE(list.find("\nE0127  warning  tool change with no tool selected\n"), std::string::npos);
}

TEST(ErrorPageText, ShowsBytesThatCannotBeSeen) {
  EXPECT_NE(error_page_text("E0023")->find("G0 X1 \\x01\n"), std::string::npos);
  EXPECT_NE(error_page_text("E0012")->find("... (101 of these)\n"), std::string::npos);
}

}  // namespace
}  // namespace kerf::program
