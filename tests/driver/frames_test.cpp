// What a machine is told and answers, as bytes.
#include "programs/kerf/driver/frames.hpp"

#include <cstring>

#include <gtest/gtest.h>

#include "tests/driver/sample_frames.hpp"

namespace kerf::program {
namespace {

using test::sample_answer;
using test::sample_told;

TEST(Frames, KeepEveryFieldOfASetpoint) {
  const Setpoint told = sample_told().setpoint;
  const auto read = told_from(to_bytes(sample_told()));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->call, MachineCall::write);
  const Setpoint& found = read->setpoint;
  EXPECT_EQ(found.tick, told.tick);
  EXPECT_EQ(found.line, told.line);
  EXPECT_EQ(found.rapid, told.rapid);
  EXPECT_EQ(found.limit, told.limit);
  EXPECT_EQ(found.s_mm, told.s_mm);
  EXPECT_EQ(found.v_mm_s, told.v_mm_s);
  EXPECT_EQ(found.a_mm_s2, told.a_mm_s2);
  EXPECT_EQ(found.j_mm_s3, told.j_mm_s3);
  EXPECT_EQ(found.position_mm, told.position_mm);
  EXPECT_TRUE(std::signbit(found.position_mm[2]));
  EXPECT_EQ(found.velocity_mm_s, told.velocity_mm_s);
  EXPECT_EQ(found.acceleration_mm_s2, told.acceleration_mm_s2);
  EXPECT_EQ(found.extra_rad_mm, told.extra_rad_mm);
  EXPECT_EQ(found.outputs, told.outputs);
}

TEST(Frames, KeepEveryFieldOfAnAnswer) {
  const machine::MachineState told = sample_answer().state;
  const auto read = answer_from(to_bytes(sample_answer()));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->tick, 77);
  const machine::MachineState& found = read->state;
  EXPECT_EQ(found.actual_mm, told.actual_mm);
  EXPECT_EQ(found.extra_rad_mm, told.extra_rad_mm);
  EXPECT_EQ(found.following_error_mm, told.following_error_mm);
  EXPECT_EQ(found.contour_error_mm, told.contour_error_mm);
  EXPECT_EQ(found.outputs, told.outputs);
  EXPECT_EQ(found.inputs, told.inputs);
  EXPECT_EQ(found.axes, told.axes);
  EXPECT_EQ(found.fault, told.fault);
  EXPECT_EQ(found.fault_axis, told.fault_axis);
}

TEST(Frames, AreRefusedWhereAnyBitIsAnother) {
  ToldBytes told = to_bytes(sample_told());
  for (std::size_t bit = 0; bit < 8 * told.size(); ++bit) {
    told[bit / 8] ^= std::byte{1} << (bit % 8);
    EXPECT_FALSE(told_from(told)) << bit;
    told[bit / 8] ^= std::byte{1} << (bit % 8);
  }
  EXPECT_TRUE(told_from(told));
  AnswerBytes answer = to_bytes(sample_answer());
  for (std::size_t bit = 0; bit < 8 * answer.size(); ++bit) {
    answer[bit / 8] ^= std::byte{1} << (bit % 8);
    EXPECT_FALSE(answer_from(answer)) << bit;
    answer[bit / 8] ^= std::byte{1} << (bit % 8);
  }
  EXPECT_TRUE(answer_from(answer));
}

TEST(Frames, AreRefusedWhereTheyAreShorterOrLonger) {
  std::array<std::byte, kToldBytes + kAnswerBytes> room{};
  const ToldBytes told = to_bytes(sample_told());
  std::memcpy(room.data(), told.data(), told.size());
  for (std::size_t size = 0; size < room.size(); ++size) {
    EXPECT_EQ(told_from(std::span(room).first(size)).has_value(), size == told.size()) << size;
  }
  EXPECT_FALSE(answer_from(told));
}

// A checksum says that the bytes came as they were sent, not that a number means something.
TEST(Frames, AreRefusedWhereANumberMeansNothing) {
  ToldFrame told = sample_told();
  told.setpoint.limit = static_cast<Constraint>(35);
  EXPECT_FALSE(told_from(to_bytes(told)));
  told = sample_told();
  told.call = static_cast<MachineCall>(0);
  EXPECT_FALSE(told_from(to_bytes(told)));
  AnswerFrame answer = sample_answer();
  answer.state.fault = static_cast<machine::DriveFault>(200);
  EXPECT_FALSE(answer_from(to_bytes(answer)));
  answer = sample_answer();
  answer.state.axes[8] = static_cast<machine::AxisState>(3);
  EXPECT_FALSE(answer_from(to_bytes(answer)));
  answer = sample_answer();
  answer.state.fault_axis = 9;
  EXPECT_FALSE(answer_from(to_bytes(answer)));
}

}  // namespace
}  // namespace kerf::program
