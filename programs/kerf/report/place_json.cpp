#include "programs/kerf/report/place_json.hpp"

#include <array>
#include <cmath>

namespace kerf::program {

namespace {

// Keys in the order in which they are set.
using Json = nlohmann::ordered_json;

constexpr std::array kAxes{"x", "y", "z"};

Json box_json(const curves::Extents& box) {
  return {{"min_mm", axes_json(box.min_mm)}, {"max_mm", axes_json(box.max_mm)}};
}

// Infinite: null.
Json bound_json(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

}  // namespace

nlohmann::ordered_json axes_json(const std::array<double, 3>& values) {
  return {{"x", values[0]}, {"y", values[1]}, {"z", values[2]}};
}

nlohmann::ordered_json boxes_json(const PathBoxes& boxes) {
  Json json{{"machine", {{"all", box_json(boxes.all)}}}, {"work", nullptr}};
  if (boxes.cutting) {
    json["machine"]["cutting"] = box_json(*boxes.cutting);
  }
  if (boxes.work.is_known) {
    Json systems = Json::array();
    for (const std::size_t system : boxes.work.systems) {
      systems.push_back(work_system_name(system));
    }
    json["work"] = {{"systems", systems}, {"all", box_json(boxes.work.all)}};
    if (boxes.cutting) {
      json["work"]["cutting"] = box_json(boxes.work.cutting);
    }
  }
  return json;
}

nlohmann::ordered_json fit_json(const FitReport& fit) {
  Json json{{"fits", fit.fits()}, {"axes", Json::object()}, {"work_offsets", Json::array()}};
  for (std::size_t k = 0; k < kAxes.size(); ++k) {
    const AxisFit& axis = fit.axes[k];
    json["axes"][kAxes[k]] = {
        {"travel_mm", {bound_json(axis.travel.min_mm), bound_json(axis.travel.max_mm)}},
        {"over_mm", axis.over_mm},
        {"fixed_over_mm", axis.fixed_over_mm}};
  }
  if (fit.extra_excess) {
    json["other_axes"] = *fit.extra_excess;
  }
  for (const OffsetFit& offset : fit.offsets) {
    Json ranges = Json::object();
    for (std::size_t k = 0; k < kAxes.size(); ++k) {
      if (const auto& range = offset.ranges[k]) {
        ranges[kAxes[k]] = {{"origin_mm", offset.origin_mm[k]},
                            {"min_mm", bound_json(range->min_mm)},
                            {"max_mm", bound_json(range->max_mm)},
                            {"fits_somewhere", !range->is_empty()}};
      }
    }
    json["work_offsets"].push_back({{"name", offset.name}, {"axes", ranges}});
  }
  return json;
}

}  // namespace kerf::program
