#include "programs/kerf/exit_status.hpp"

#include <new>
#include <stdexcept>
#include <system_error>

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

TEST(ExitStatus, OfADefectIs6) {
  EXPECT_EQ(to_int(status_of(std::logic_error("a defect"))), 6);
  EXPECT_EQ(to_int(status_of(std::out_of_range("a defect"))), 6);
}

TEST(ExitStatus, OfASystemThatGivesNoMemoryOrThreadIs5) {
  const auto code = std::make_error_code(std::errc::resource_unavailable_try_again);
  EXPECT_EQ(to_int(status_of(std::bad_alloc())), 5);
  EXPECT_EQ(to_int(status_of(std::system_error(code))), 5);
}

}  // namespace
}  // namespace kerf::program
