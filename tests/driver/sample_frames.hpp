// Frames in which every field has a value of its own.
#pragma once

#include "programs/kerf/driver/frames.hpp"

namespace kerf::program::test {

inline Outputs sample_outputs() {
  Outputs outputs{
      .spindle_rad_s = 1.5,
      .follows_speed_override = false,
      .follows_adaptive_feed = true,
      .heeds_feed_stop = false,
      .surface = {.mm_s = 2.5, .max_rad_s = 3.5, .per_x = 4.5, .per_y = 5.5, .at_origin_mm = 6.5},
      .spindle_angle_rad = 7.5,
      .tool = -8,
      .spindle_held = true,
      .mist = true,
      .flood = true,
      .digital = 0x8000'0000'0000'0001};
  for (std::size_t i = 0; i < outputs.analog.size(); ++i) {
    outputs.analog[i] = 10.25 + static_cast<double>(i);
  }
  return outputs;
}

inline ToldFrame sample_told() {
  return {.call = MachineCall::write,
          .setpoint = {.tick = -7,
                       .line = 0xFFFF'FFFF,
                       .rapid = true,
                       .limit = static_cast<Constraint>(34),
                       .s_mm = 0.1,
                       .v_mm_s = 0.2,
                       .a_mm_s2 = 0.3,
                       .j_mm_s3 = 0.4,
                       .position_mm = {1.1, 1.2, -0.0},
                       .velocity_mm_s = {2.1, 2.2, 2.3},
                       .acceleration_mm_s2 = {3.1, 3.2, 3.3},
                       .extra_rad_mm = {4.1, 4.2, 4.3, 4.4, 4.5, 4.6},
                       .outputs = sample_outputs()}};
}

inline AnswerFrame sample_answer() {
  using machine::AxisState;
  AnswerFrame answer{.tick = 77,
                     .state = {.actual_mm = {5.1, 5.2, 5.3},
                               .extra_rad_mm = {6.1, 6.2, 6.3, 6.4, 6.5, 6.6},
                               .following_error_mm = {7.1, 7.2, 7.3},
                               .contour_error_mm = 8.1,
                               .outputs = sample_outputs(),
                               .inputs = {.probe = true,
                                          .door_open = true,
                                          .emergency_loop_open = true,
                                          .tool_changed = false,
                                          .spindle_at_speed = false,
                                          .home = 0x155,
                                          .lower_limit = 0x0AA,
                                          .upper_limit = 0x100,
                                          .digital = 0xFEDC'BA98'7654'3210},
                               .axes = {AxisState::on, AxisState::stopping, AxisState::off,
                                        AxisState::on, AxisState::off, AxisState::stopping,
                                        AxisState::on, AxisState::on, AxisState::off},
                               .fault = machine::DriveFault::following_error,
                               .fault_axis = -1}};
  for (std::size_t i = 0; i < answer.state.inputs.analog.size(); ++i) {
    answer.state.inputs.analog[i] = 20.25 + static_cast<double>(i);
  }
  return answer;
}

}  // namespace kerf::program::test
