// [probe] and [simulation] of a machine file.
#include <cmath>
#include <string>
#include <vector>

#include <kerf/machine.hpp>

#include "kernel/machine_file_reader.hpp"
#include "kernel/machine_file_text.hpp"

namespace kerf {
namespace {

using Settings = MachineSettings;

constexpr double kFarthest = 999'999.999;
constexpr double kRadPerRevolution = 6.283185307179586477;

template <auto kMember, std::size_t kAxis>
double& of_plane(Settings& settings, std::size_t /*unused*/) {
  return (settings.simulation.surface->plane.*kMember)[kAxis];
}

constexpr std::array kPlane{
    NumberRule{"x_mm", -kFarthest, kFarthest, of_plane<&TouchPlane::point_mm, 0>},
    NumberRule{"y_mm", -kFarthest, kFarthest, of_plane<&TouchPlane::point_mm, 1>},
    NumberRule{"z_mm", -kFarthest, kFarthest, of_plane<&TouchPlane::point_mm, 2>},
    NumberRule{"normal_x", -1e3, 1e3, of_plane<&TouchPlane::normal, 0>},
    NumberRule{"normal_y", -1e3, 1e3, of_plane<&TouchPlane::normal, 1>},
    NumberRule{"normal_z", -1e3, 1e3, of_plane<&TouchPlane::normal, 2>},
};

template <std::size_t kAxis>
double& of_centre(Settings& settings, std::size_t /*unused*/) {
  return settings.simulation.surface->sphere.centre_mm[kAxis];
}

constexpr std::array kSphere{
    NumberRule{"x_mm", -kFarthest, kFarthest, of_centre<0>},
    NumberRule{"y_mm", -kFarthest, kFarthest, of_centre<1>},
    NumberRule{"z_mm", -kFarthest, kFarthest, of_centre<2>},
    NumberRule{
        "radius_mm", 1e-3, 1e4,
        [](Settings& s, std::size_t) -> double& { return s.simulation.surface->sphere.radius_mm; }},
};

template <double AxisSwitches::*kMember>
double& of_switches(Settings& settings, std::size_t axis) {
  return settings.simulation.switches[axis].*kMember;
}

constexpr std::array kSwitches{
    NumberRule{"home_min_mm", -kFarthest, kFarthest, of_switches<&AxisSwitches::home_min_mm>},
    NumberRule{"home_max_mm", -kFarthest, kFarthest, of_switches<&AxisSwitches::home_max_mm>},
    NumberRule{"lower_limit_mm", -kFarthest, kFarthest, of_switches<&AxisSwitches::lower_limit_mm>},
    NumberRule{"upper_limit_mm", -kFarthest, kFarthest, of_switches<&AxisSwitches::upper_limit_mm>},
};

constexpr NumberRule kSpindle{
    "spindle_per_min_s", 0.0, 1e9,
    [](Settings& s, std::size_t) -> double& { return s.simulation.spindle_rad_s2; },
    kRadPerRevolution / 60.0};

constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};
constexpr std::array<std::string_view, 6> kFaces{"x_min_mm", "x_max_mm", "y_min_mm",
                                                 "y_max_mm", "z_min_mm", "z_max_mm"};

}  // namespace

void MachineFileReader::read_box(const Section& probe) {
  auto& box = settings_.simulation.surface.emplace(TouchBox{}).box;
  for (std::size_t at = 0; at < probe_rules().size(); ++at) {
    const NumberRule& rule = probe_rules()[at];
    const toml::node* node = probe.table->get(rule.key);
    const auto number = node != nullptr ? read_number(probe, rule, *node) : std::nullopt;
    if (number) {
      rule.field(settings_, 0) = *number;
    }
    const std::size_t axis = at / 2;
    if (node != nullptr && at % 2 == 1 && box.max_mm[axis] < box.min_mm[axis]) {
      report(node->source(), probe.path_to(rule.key) + ": must not be below " +
                                 probe.path_to(probe_rules()[at - 1].key));
    }
  }
}

bool MachineFileReader::read_plane(const Section& probe) {
  if (const auto plane = subsection(probe, "plane")) {
    settings_.simulation.surface.emplace(TouchPlane{});
    read_numbers(*plane, kPlane, 0);
    const auto& normal = settings_.simulation.surface->plane.normal;
    if (normal[0] == 0.0 && normal[1] == 0.0 && normal[2] == 0.0) {
      report(plane->table->source(), plane->name + ": the normal has no direction");
    }
    return true;
  }
  return false;
}

// One surface: faces of a block, a plane, a sphere or a height map.
void MachineFileReader::read_probe(const Section& probe) {
  std::vector<std::string_view> known(kFaces.begin(), kFaces.end());
  known.insert(known.end(), {"plane", "sphere", "height_map", "latches"});
  check_keys(probe, known);
  std::size_t surfaces = 0;
  surfaces += read_plane(probe) ? 1U : 0U;
  if (const auto sphere = subsection(probe, "sphere")) {
    settings_.simulation.surface.emplace(TouchSphere{});
    read_numbers(*sphere, kSphere, 0);
    ++surfaces;
  }
  if (const toml::node* file = probe.table->get("height_map")) {
    const auto* name = file->as_string();
    if (name == nullptr || name->get().empty()) {
      report(file->source(), "probe.height_map: expected the name of a file");
    } else {
      settings_.height_map_file = name->get();
    }
    ++surfaces;
  }
  bool has_face = false;
  for (const std::string_view face : kFaces) {
    has_face = has_face || probe.table->contains(face);
  }
  if (has_face || surfaces == 0) {
    read_box(probe);
    ++surfaces;
  }
  if (surfaces > 1) {
    report(probe.table->source(),
           "probe: found " + std::to_string(surfaces) +
               " surfaces, expected one: faces, plane, sphere or height_map");
  }
  read_truth(probe, "latches", settings_.simulation.latches_probe);
}

bool MachineFileReader::read_array(const Section& section, std::string_view key, std::size_t most,
                                   std::vector<double>& numbers) {
  const toml::node* node = section.table->get(key);
  if (node == nullptr) {
    return true;
  }
  const toml::array* array = node->as_array();
  for (std::size_t i = 0; array != nullptr && i < array->size(); ++i) {
    numbers.push_back((*array)[i].value<double>().value_or(std::nan("")));
  }
  bool fine = array != nullptr && numbers.size() <= most;
  for (const double number : numbers) {
    fine = fine && std::isfinite(number);
  }
  if (!fine) {
    report(node->source(), section.path_to(key) + ": expected an array of at most " +
                               std::to_string(most) + " numbers");
  }
  return fine;
}

// With one end it is closed from there on, to the side of the other.
void MachineFileReader::read_home_switch(const Section& section, std::size_t axis) {
  const toml::node* const from = section.table->get(kSwitches[0].key);
  const toml::node* const to = section.table->get(kSwitches[1].key);
  AxisSwitches& switches = settings_.simulation.switches[axis];
  if (from == nullptr && to != nullptr) {
    switches.home_min_mm = -kUnbounded;
  }
  if (from != nullptr && to != nullptr && switches.home_min_mm > switches.home_max_mm) {
    report(to->source(), section.path_to(kSwitches[1].key) + ": must not be below " +
                             section.path_to(kSwitches[0].key));
  }
}

void MachineFileReader::read_simulation(const Section& section) {
  constexpr std::array<std::string_view, 6> kKeys{"digital", "analog", kSpindle.key, "x", "y", "z"};
  check_keys(section, kKeys);
  SimulationSettings& world = settings_.simulation;
  std::vector<double> high;
  if (read_array(section, "digital", 64, high)) {
    for (const double input : high) {
      if (input != std::floor(input) || input < 0.0 || input > 63.0) {
        report(section.table->get("digital")->source(),
               section.path_to("digital") + ": found " + text_of(input) +
                   ", expected numbers of inputs from 0 to 63");
        break;
      }
      world.digital |= std::uint64_t{1} << static_cast<unsigned>(input);
    }
  }
  std::vector<double> analog;
  if (read_array(section, "analog", world.analog.size(), analog)) {
    std::copy(analog.begin(), analog.end(), world.analog.begin());
  }
  if (const toml::node* node = section.table->get(kSpindle.key)) {
    world.spindle_rad_s2 = read_number(section, kSpindle, *node).value_or(0.0) * kSpindle.factor;
  }
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    if (const auto switches = subsection(section, kAxes[axis])) {
      read_numbers(*switches, kSwitches, axis);
      read_home_switch(*switches, axis);
    }
  }
}

}  // namespace kerf
