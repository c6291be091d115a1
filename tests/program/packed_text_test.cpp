#include "programs/kerf/page/packed_text.hpp"

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

// The examples of RFC 4648.
TEST(Base64, EndsWithEqualsSigns) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe"), "//4=");
}

}  // namespace
}  // namespace kerf::program
