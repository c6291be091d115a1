#include "programs/kerf/run/passed_place.hpp"

#include <algorithm>
#include <limits>
#include <variant>
#include <vector>

#include "curves/curve.hpp"
#include "kernel/program_path.hpp"
#include "programs/kerf/run/path_walk.hpp"

namespace kerf::program {

namespace {

constexpr double kSample_mm = 0.05;
constexpr int kMinSamples = 16;
constexpr int kMaxSamples = 100'000;
constexpr int kHalvings = 60;  // of the way between three samples, down to rounding

// The nearest of samples, and the nearest place around it.
double distance_mm(const curves::Piece& piece, const Position& place_mm) {
  const double begin = curves::s_begin_mm(piece);
  const double length = curves::s_end_mm(piece) - begin;
  const auto off_mm = [&](double s_mm) {
    return (curves::vec(curves::position_at(piece, s_mm)) - curves::vec(place_mm)).norm();
  };
  const int samples =
      std::max(static_cast<int>(std::min(length / kSample_mm, 1.0 * kMaxSamples)), kMinSamples);
  const double step = length / samples;
  double nearest = begin;
  for (int i = 1; i <= samples; ++i) {
    const double s_mm = begin + i * step;
    nearest = off_mm(s_mm) < off_mm(nearest) ? s_mm : nearest;
  }
  double low = std::max(nearest - step, begin);
  double high = std::min(nearest + step, begin + length);
  for (int i = 0; i < kHalvings; ++i) {
    const double third = (high - low) / 3.0;
    if (off_mm(low + third) < off_mm(high - third)) {
      high -= third;
    } else {
      low += third;
    }
  }
  return off_mm(0.5 * (low + high));
}

double distance_mm(const curves::Curve& curve, const Position& place_mm) {
  double nearest = std::numeric_limits<double>::infinity();
  curves::for_each_piece(curve, [&](const curves::Piece& piece) {
    nearest = std::min(nearest, distance_mm(piece, place_mm));
  });
  return nearest;
}

}  // namespace

tl::expected<double, std::string> distance_from_path_mm(ProgramFile& file,
                                                        const MachineSettings& settings,
                                                        KernelOptions options,
                                                        const PassedPlace& place) {
  options.start_in_program.reset();
  ProgramPath path(settings, options, {});
  struct Known {
    std::uint64_t block = 0;
    curves::Curve curve;
  };
  std::vector<Known> around;  // all of the latest block, and the last one before it
  const auto walked = walk_path(file, path, [&](const ProgramPath::Output& output) {
    const auto* segment = std::get_if<smoothing::PathSegment>(&output);
    if (segment == nullptr) {
      return true;
    }
    const std::uint64_t block = segment->first_block();
    if (!around.empty() && around.back().block != block && block <= place.block) {
      around.erase(around.begin(), around.end() - 1);
    }
    around.push_back({.block = block, .curve = segment->curve});
    return block <= place.block;
  });
  if (!walked) {
    return tl::unexpected(walked.error());
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (const Known& known : around) {
    nearest = std::min(nearest, distance_mm(known.curve, place.position_mm));
  }
  return nearest;
}

}  // namespace kerf::program
