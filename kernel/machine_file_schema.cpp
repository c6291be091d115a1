#include "kernel/machine_file_schema.hpp"

#include <array>
#include <cmath>
#include <limits>

#include <kerf/machine.hpp>

#include "kernel/machine_file_text.hpp"
#include "lookahead/path/limits.hpp"
#include "parser/modal/machine_data.hpp"
#include "parser/modal/tool_table.hpp"

namespace kerf {
namespace {

using Settings = MachineSettings;

constexpr double kOpen = std::numeric_limits<double>::infinity();

constexpr std::array kTick{
    NumberRule{"period_s", 1e-5, 0.1,
               [](Settings& s, std::size_t) -> double& { return s.limits.period_s; }},
};

constexpr std::array kPath{
    NumberRule{"max_velocity_mm_s", 1e-6, 1e6,
               [](Settings& s, std::size_t) -> double& { return s.limits.path.velocity_mm_s; }, 1.0,
               kOpen},
    NumberRule{"max_acceleration_mm_s2", 1e-6, 1e9,
               [](Settings& s, std::size_t) -> double& { return s.limits.path.acceleration_mm_s2; },
               1.0, kOpen},
    NumberRule{"max_jerk_mm_s3", 1e-6, 1e12,
               [](Settings& s, std::size_t) -> double& { return s.limits.path.jerk_mm_s3; }, 1.0,
               kOpen},
    NumberRule{
        "max_normal_acceleration_mm_s2", 1e-6, 1e9,
        [](Settings& s, std::size_t) -> double& { return s.limits.normal_acceleration_mm_s2; }, 1.0,
        kOpen},
    NumberRule{"max_normal_jerk_mm_s3", 1e-6, 1e12,
               [](Settings& s, std::size_t) -> double& { return s.limits.normal_jerk_mm_s3; }, 1.0,
               kOpen},
    NumberRule{"chord_tolerance_mm", 1e-9, 1e3,
               [](Settings& s, std::size_t) -> double& { return s.limits.chord_tolerance_mm; }, 1.0,
               kOpen},
    NumberRule{"corner_tolerance_mm", 0.0, 1e3,
               [](Settings& s, std::size_t) -> double& { return s.program.corner_tolerance_mm; }},
    NumberRule{"merge_tolerance_mm", 0.0, 1e3,
               [](Settings& s, std::size_t) -> double& { return s.program.merge_tolerance_mm; }},
};

// What the planner keeps on one axis.
template <double lookahead::MotionLimits::*kMember>
double& limit(Settings& settings, std::size_t axis) {
  return settings.limits.axes[axis].*kMember;
}

template <double AxisDrive::*kMember>
double& drive(Settings& settings, std::size_t axis) {
  return settings.table.axes[axis].*kMember;
}

template <double Travel::*kMember>
double& travel(Settings& settings, std::size_t axis) {
  return settings.table.axes[axis].travel.*kMember;
}

template <double AxisHoming::*kMember>
double& homing(Settings& settings, std::size_t axis) {
  return settings.manual.homing[axis].*kMember;
}

using lookahead::MotionLimits;

constexpr std::array kAxis{
    NumberRule{"min_mm", -1e6, 1e6, travel<&Travel::min_mm>, 1.0, -kOpen},
    NumberRule{"max_mm", -1e6, 1e6, travel<&Travel::max_mm>, 1.0, kOpen},
    NumberRule{"max_velocity_mm_s", 1e-6, 1e6, limit<&MotionLimits::velocity_mm_s>, 1.0, kOpen},
    NumberRule{"max_acceleration_mm_s2", 1e-6, 1e9, limit<&MotionLimits::acceleration_mm_s2>, 1.0,
               kOpen},
    NumberRule{"max_jerk_mm_s3", 1e-6, 1e12, limit<&MotionLimits::jerk_mm_s3>, 1.0, kOpen},
    NumberRule{"screw_lead_mm", 1e-3, 1e3, drive<&AxisDrive::screw_lead_mm>},
    NumberRule{"counts_per_rev", 1.0, 1e9, drive<&AxisDrive::counts_per_rev>, 1.0, kOpen},
    NumberRule{"drive_velocity_mm_s", 1e-6, 1e6, drive<&AxisDrive::drive_velocity_mm_s>},
    NumberRule{"drive_acceleration_mm_s2", 1e-6, 1e9, drive<&AxisDrive::drive_acceleration_mm_s2>},
    NumberRule{"position_gain_per_s", 1e-3, 1e4, drive<&AxisDrive::position_gain_per_s>},
    NumberRule{"velocity_gain_per_s", 1e-3, 1e5, drive<&AxisDrive::velocity_gain_per_s>},
    NumberRule{"velocity_integral_per_s2", 0.0, 1e8, drive<&AxisDrive::velocity_integral_per_s2>},
    NumberRule{"feed_forward", 0.0, 1.0, drive<&AxisDrive::feed_forward>},
    NumberRule{"coulomb_friction_mm_s2", 0.0, 1e6, drive<&AxisDrive::coulomb_friction_mm_s2>},
    NumberRule{"viscous_friction_per_s", 0.0, 1e5, drive<&AxisDrive::viscous_friction_per_s>},
    NumberRule{"max_following_error_mm", 1e-6, 1e3, drive<&AxisDrive::max_following_error_mm>},
    NumberRule{"home_switch_mm", -1e6, 1e6, homing<&AxisHoming::switch_mm>, 1.0, kOpen},
    NumberRule{"home_mm", -1e6, 1e6, homing<&AxisHoming::home_mm>, 1.0, kOpen},
    NumberRule{"home_search_mm_s", -1e6, 1e6, homing<&AxisHoming::search_mm_s>},
    NumberRule{"home_latch_mm_s", 1e-6, 1e6, homing<&AxisHoming::latch_mm_s>},
    NumberRule{"home_back_off_mm", 1e-3, 1e6, homing<&AxisHoming::back_off_mm>},
    NumberRule{"home_travel_mm", 1e-3, 1e6, homing<&AxisHoming::travel_mm>, 1.0, kOpen},
    NumberRule{"home_time_s", 1e-3, 86'400.0, homing<&AxisHoming::time_s>},
    NumberRule{"home_order", -1e6, 1e6, homing<&AxisHoming::order>},
};

template <double lookahead::MotionLimits::*kMember>
double& extra_limit(Settings& settings, std::size_t axis) {
  return settings.limits.extra[axis].*kMember;
}

template <double AuxiliaryTravel::*kMember>
double& extra_travel(Settings& settings, std::size_t axis) {
  return settings.table.extra[axis].*kMember;
}

constexpr std::array kLinearAxis{
    NumberRule{"min_mm", -1e6, 1e6, extra_travel<&AuxiliaryTravel::min_rad_mm>, 1.0, -kOpen},
    NumberRule{"max_mm", -1e6, 1e6, extra_travel<&AuxiliaryTravel::max_rad_mm>, 1.0, kOpen},
    NumberRule{"max_velocity_mm_s", 1e-6, 1e6, extra_limit<&MotionLimits::velocity_mm_s>, 1.0,
               kOpen},
    NumberRule{"max_acceleration_mm_s2", 1e-6, 1e9, extra_limit<&MotionLimits::acceleration_mm_s2>,
               1.0, kOpen},
    NumberRule{"max_jerk_mm_s3", 1e-6, 1e12, extra_limit<&MotionLimits::jerk_mm_s3>, 1.0, kOpen},
};

constexpr double kRad = 3.14159265358979323846 / 180.0;  // of a degree

constexpr std::array kRotaryAxis{
    NumberRule{"min_deg", -1e6, 1e6, extra_travel<&AuxiliaryTravel::min_rad_mm>, kRad, -kOpen},
    NumberRule{"max_deg", -1e6, 1e6, extra_travel<&AuxiliaryTravel::max_rad_mm>, kRad, kOpen},
    NumberRule{"max_velocity_deg_s", 1e-6, 1e6, extra_limit<&MotionLimits::velocity_mm_s>, kRad,
               kOpen},
    NumberRule{"max_acceleration_deg_s2", 1e-6, 1e9, extra_limit<&MotionLimits::acceleration_mm_s2>,
               kRad, kOpen},
    NumberRule{"max_jerk_deg_s3", 1e-6, 1e12, extra_limit<&MotionLimits::jerk_mm_s3>, kRad, kOpen},
};

constexpr std::array<std::string_view, 13> kOffsetSections{"g54", "g55",    "g56",   "g57",   "g58",
                                                           "g59", "g59_1",  "g59_2", "g59_3", "g28",
                                                           "g30", "g30_p3", "g30_p4"};

template <std::size_t kAxisOfPoint>
double& offset(Settings& settings, std::size_t section) {
  parser::MachineData& data = settings.program;
  constexpr std::size_t kSystems = kWorkSystems;
  return section < kSystems        ? data.work[section].origin_mm[kAxisOfPoint]
         : section == kSystems     ? data.first_home_mm[kAxisOfPoint]
         : section == kSystems + 1 ? data.second_home_mm[kAxisOfPoint]
                                   : data.further_homes[section - kSystems - 2].mm[kAxisOfPoint];
}

template <std::size_t kAxisOfExtra>
double& extra_offset(Settings& settings, std::size_t section) {
  parser::MachineData& data = settings.program;
  constexpr std::size_t kSystems = kWorkSystems;
  return section < kSystems    ? data.work[section].extra_deg_mm[kAxisOfExtra]
         : section == kSystems ? data.first_home_extra_deg_mm[kAxisOfExtra]
         : section == kSystems + 1
             ? data.second_home_extra_deg_mm[kAxisOfExtra]
             : data.further_homes[section - kSystems - 2].extra_deg_mm[kAxisOfExtra];
}

constexpr double kFarthest = 999999.999;

constexpr std::array kOffset{
    NumberRule{"x_mm", -kFarthest, kFarthest, offset<0>},
    NumberRule{"y_mm", -kFarthest, kFarthest, offset<1>},
    NumberRule{"z_mm", -kFarthest, kFarthest, offset<2>},
    NumberRule{"a_deg", -kFarthest, kFarthest, extra_offset<0>},
    NumberRule{"b_deg", -kFarthest, kFarthest, extra_offset<1>},
    NumberRule{"c_deg", -kFarthest, kFarthest, extra_offset<2>},
    NumberRule{"u_mm", -kFarthest, kFarthest, extra_offset<3>},
    NumberRule{"v_mm", -kFarthest, kFarthest, extra_offset<4>},
    NumberRule{"w_mm", -kFarthest, kFarthest, extra_offset<5>},
    NumberRule{"rotation_deg", -360.0, 360.0,
               [](Settings& s, std::size_t section) -> double& {
                 return s.program.work[section].rotation_deg;
               }},
};

template <std::size_t kAxisOfPoint, bool kUpper>
double& probe_face(Settings& settings, std::size_t /*unused*/) {
  auto& box = settings.simulation.surface->box;
  return (kUpper ? box.max_mm : box.min_mm)[kAxisOfPoint];
}

constexpr std::array kProbe{
    NumberRule{"x_min_mm", -kFarthest, kFarthest, probe_face<0, false>, 1.0, -kOpen},
    NumberRule{"x_max_mm", -kFarthest, kFarthest, probe_face<0, true>, 1.0, kOpen},
    NumberRule{"y_min_mm", -kFarthest, kFarthest, probe_face<1, false>, 1.0, -kOpen},
    NumberRule{"y_max_mm", -kFarthest, kFarthest, probe_face<1, true>, 1.0, kOpen},
    NumberRule{"z_min_mm", -kFarthest, kFarthest, probe_face<2, false>, 1.0, -kOpen},
    NumberRule{"z_max_mm", -kFarthest, kFarthest, probe_face<2, true>, 1.0, kOpen},
};

constexpr double kLongestWait_s = 86'400.0;
constexpr std::array kProgram{
    NumberRule{"least_increment_mm", 0.0, 1.0,
               [](Settings& s, std::size_t) -> double& { return s.program.least_increment_mm; }},
    NumberRule{"tool_change_s", 0.0, kLongestWait_s,
               [](Settings& s, std::size_t) -> double& { return s.program.tool_change_s; }},
    NumberRule{"spindle_start_s", 0.0, kLongestWait_s,
               [](Settings& s, std::size_t) -> double& { return s.program.spindle_start_s; }},
    NumberRule{"safe_z_mm", -kFarthest, kFarthest,
               [](Settings& s, std::size_t) -> double& { return s.program.safe_z_mm; }, 1.0, kOpen},
};

constexpr std::array kManual{
    NumberRule{"jog_mm_s", 1e-6, 1e6,
               [](Settings& s, std::size_t) -> double& { return s.manual.jog_mm_s; }, 1.0, kOpen},
    NumberRule{"unhomed_jog_mm_s", 0.0, 1e6,
               [](Settings& s, std::size_t) -> double& { return s.manual.unhomed_jog_mm_s; }},
    NumberRule{"jog_timeout_s", 1e-3, 3600.0,
               [](Settings& s, std::size_t) -> double& { return s.manual.jog_timeout_s; }},
};

constexpr std::array kInputs{
    InputRule{{"adaptive_feed", 0.0, Outputs::kAnalog - 1.0, nullptr},
              &FeedInputNumbers::adaptive_feed},
    InputRule{{"feed_stop", 0.0, Outputs::kDigital - 1.0, nullptr}, &FeedInputNumbers::feed_stop},
};

constexpr std::array kTool{
    NumberRule{"number", 0.0, double{parser::ToolTable::kHighestNumber}, nullptr},
    NumberRule{"pocket", 0.0, double{parser::ToolTable::kHighestNumber}, nullptr},
    NumberRule{"diameter_mm", 0.0, kFarthest, nullptr},
    NumberRule{"x_mm", -kFarthest, kFarthest, nullptr},
    NumberRule{"y_mm", -kFarthest, kFarthest, nullptr},
    NumberRule{"z_mm", -kFarthest, kFarthest, nullptr},
};

constexpr std::array kBounds{
    BoundRule{"max_velocity_mm_s", "velocity"},
    BoundRule{"max_acceleration_mm_s2", "acceleration"},
    BoundRule{"max_jerk_mm_s3", "jerk"},
};

std::string range_text(const NumberRule& rule, double number) {
  return "found " + text_of(number) + ", expected a number from " + text_of(rule.min) + " to " +
         text_of(rule.max);
}

}  // namespace

std::optional<std::string> range_problem(const NumberRule& rule, double number) {
  if (number >= rule.min && number <= rule.max) {
    return std::nullopt;
  }
  return range_text(rule, number);
}

std::optional<std::string> range_problem(const NumberRule& rule, MachineSettings& settings,
                                         std::size_t axis) {
  const double inside = rule.field(settings, axis);
  const bool is_open = rule.open != 0.0 && inside == rule.open;
  if (is_open || (inside >= rule.min * rule.factor && inside <= rule.max * rule.factor)) {
    return std::nullopt;
  }
  return range_text(rule, inside / rule.factor);
}

std::span<const NumberRule> tick_rules() {
  return kTick;
}
std::span<const NumberRule> path_rules() {
  return kPath;
}
std::span<const NumberRule> axis_rules() {
  return kAxis;
}
std::span<const NumberRule> extra_axis_rules(bool rotary) {
  return rotary ? kRotaryAxis : kLinearAxis;
}
std::span<const std::string_view> offset_sections() {
  return kOffsetSections;
}
std::span<const NumberRule> offset_rules(std::size_t section) {
  const bool turns = section < kWorkSystems;
  return std::span(kOffset).first(turns ? 10 : 9);
}
std::span<const NumberRule> program_rules() {
  return kProgram;
}
std::span<const NumberRule> manual_rules() {
  return kManual;
}
std::span<const InputRule> input_rules() {
  return kInputs;
}
std::optional<std::string> input_problem(const InputRule& rule, double number) {
  if (auto problem = range_problem(rule.number, number)) {
    return problem;
  }
  return number == std::floor(number)
             ? std::nullopt
             : std::optional("found " + text_of(number) + ", expected a whole number");
}
std::span<const NumberRule> tool_rules() {
  return kTool;
}
std::span<const NumberRule> probe_rules() {
  return kProbe;
}
std::span<const BoundRule> bound_rules() {
  return kBounds;
}

}  // namespace kerf
