#include "programs/kerf/run/planning_beside.hpp"

#include <new>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "tests/program/no_memory.hpp"

namespace kerf::program {
namespace {

class NoText final : public TextFeed {
 public:
  tl::expected<TextPiece, std::string> read() override { return TextPiece{}; }
  [[nodiscard]] double share_read() const noexcept override { return 1.0; }
};

TEST(PlanningBeside, ThrowsWhatPlanningThrewInTheThreadOfTheTicks) {
  Kernel kernel(default_machine(), {.one_thread = true});
  NoMemory planning(kernel);
  NoText text;
  Progress progress;
  Feeder feeder(planning, text, progress);
  PlanningBeside beside(kernel, feeder);
  EXPECT_THROW(beside.reach_tick(), std::bad_alloc);
}

}  // namespace
}  // namespace kerf::program
