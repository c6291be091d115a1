#include "smoothing/compressor.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace kerf::smoothing {

namespace {

constexpr std::size_t kAhead = 24;           // of them, after which corners are known
constexpr std::size_t kLongestLine = 65536;  // in lines of the program
constexpr double kShortestLine = 0.25;       // of the tolerance
// Lines of G61, at their feedrate: longer ones stay as they are, and what they become is no longer
// than that. It is one block, so single block rests no later where it is switched on in motion.
constexpr double kShortExact_s = 0.01;
constexpr double kLongestExact_s = 0.1;
constexpr double kShortestExact_mm = 1e-6;  // a shorter line stays as it is

using curves::vec;

const Eigen::AlignedBox3d kAnyDirection(Eigen::Vector3d::Constant(-2.0),
                                        Eigen::Vector3d::Constant(2.0));

bool is_exact(const parser::Move& move) {
  return move.mode == parser::PathMode::exact_path;
}

double distance_mm(const curves::Position& a, const curves::Position& b) {
  return (vec(b) - vec(a)).norm();
}

double distance_mm(const Vertex& a, const Vertex& b) {
  return distance_mm(a.point_mm, b.point_mm);
}

double aside_mm(const curves::Position& point, const curves::Position& begin,
                const curves::Position& end) {
  const Eigen::Vector3d way = vec(end) - vec(begin);
  const Eigen::Vector3d seen = vec(point) - vec(begin);
  const double share = std::clamp(seen.dot(way) / way.squaredNorm(), 0.0, 1.0);
  return (seen - share * way).norm();
}

}  // namespace

bool Compressor::takes(const parser::Move& move) {
  const auto* line = std::get_if<parser::LineMove>(&move.shape);
  if (line == nullptr || move.rapid || move.auxiliary.moves() || !curves::is_usable(line->end_mm)) {
    return false;
  }
  if (is_exact(move)) {
    const double length_mm = distance_mm(move.start_mm, line->end_mm);
    return length_mm > kShortestExact_mm && length_mm < kShortExact_s * move.feedrate_mm_s;
  }
  return move.mode == parser::PathMode::blend && move.merge_tolerance_mm > 0.0;
}

bool Compressor::continues(const parser::Move& move) const {
  if (run_.empty()) {
    return true;
  }
  const parser::Move& like = curves_.like();
  if (move.mode != like.mode || move.auxiliary.begin_rad_mm != like.auxiliary.begin_rad_mm ||
      move.start_mm != last().point_mm) {
    return false;
  }
  return is_exact(move) ? goes_straight_on(move)
                        : move.merge_tolerance_mm == like.merge_tolerance_mm &&
                              move.blend_tolerance_mm == like.blend_tolerance_mm;
}

bool Compressor::goes_straight_on(const parser::Move& move) const {
  const Vertex& at = run_.back();
  if (run_.size() < 2) {
    return true;
  }
  const curves::Position& end_mm = std::get<parser::LineMove>(move.shape).end_mm;
  if (run_.size() > kLongestLine || move.feedrate_mm_s != at.feedrate_mm_s ||
      move.follows != at.follows ||
      distance_mm(run_[0].point_mm, end_mm) > kLongestExact_s * move.feedrate_mm_s) {
    return false;
  }
  const Eigen::Vector3d end = vec(end_mm);
  const Eigen::Vector3d before = vec(at.point_mm) - vec(run_[run_.size() - 2].point_mm);
  return before.dot(end - vec(at.point_mm)) > 0.0 &&
         straight_on_.contains((end - vec(run_[0].point_mm)).normalized());
}

// A line in a direction d leaves a vertex in the direction e, r away, by no more than r |d - e|.
void Compressor::narrow_straight_on() {
  const Eigen::Vector3d seen = vec(run_.back().point_mm) - vec(run_[0].point_mm);
  const double r_mm = seen.norm();
  const Eigen::Vector3d bound = Eigen::Vector3d::Constant(0.5 * kExact_mm / r_mm);
  straight_on_ =
      straight_on_.intersection(Eigen::AlignedBox3d(seen / r_mm - bound, seen / r_mm + bound));
}

void Compressor::push(const parser::Move& move, std::vector<PathSegment>& out, const About& about) {
  assert(takes(move) && (run_.empty() || continues(move)));
  const curves::Position& end = std::get<parser::LineMove>(move.shape).end_mm;
  if (run_.empty()) {
    curves_.begin(move, about.beside_mm);
    straight_on_ = kAnyDirection;
    run_.push_back({.point_mm = move.start_mm, .source = move.source});
    scanned_ = 0;
  }
  Vertex vertex{.point_mm = end,
                .feedrate_mm_s = move.feedrate_mm_s,
                .follows = move.follows,
                .source = move.source,
                .run_block = move.block};
  if (!(distance_mm(last(), vertex) > 0.0)) {
    return;
  }
  if (short_ && !is_of_one_feedrate(*short_, vertex)) {
    append(*short_);
  }
  short_.reset();
  // A spline that goes on has begun with the tolerance that there was.
  if (!tail_ && !about.has_changes &&
      distance_mm(run_.back(), vertex) <= kShortestLine * curves_.like().merge_tolerance_mm) {
    short_ = vertex;
    left_out_.push_back(end);
    return;
  }
  append(vertex);
  if (is_exact(move)) {
    narrow_straight_on();
  }
  if (run_.size() > awaited_) {
    reduce(false, out);
  }
}

void Compressor::append(Vertex vertex) {
  const double length_mm = distance_mm(run_.back(), vertex);
  // Lines that lead back to where the run begins miss it by rounding: what is left is no line.
  if (length_mm >= parser::kShortestWay_mm) {
    vertex.w_mm = run_.back().w_mm + length_mm;
    for (const curves::Position& point : left_out_) {
      curves_.widen_beside(aside_mm(point, run_.back().point_mm, vertex.point_mm));
    }
    left_out_.clear();
    run_.push_back(vertex);
  }
}

// The line before it goes to where it ends, if there is one to do so.
void Compressor::append_short() {
  if (run_.size() > 1 && is_of_one_feedrate(run_.back(), *short_)) {
    Vertex end = run_.back();
    left_out_.push_back(end.point_mm);
    end.point_mm = short_->point_mm;
    run_.pop_back();
    append(end);
  } else {
    append(*short_);
  }
  short_.reset();
}

void Compressor::flush(std::vector<PathSegment>& out) {
  if (short_) {
    append_short();
  }
  if (run_.size() > 1) {
    reduce(true, out);
  }
  run_.clear();
  left_out_.clear();
  breaks_.clear();
  tail_.reset();
}

void Compressor::reduce(bool ended, std::vector<PathSegment>& out) {
  while (run_.size() > (ended ? 1 : awaited_)) {
    const std::size_t last = run_.size() - 1;
    const std::size_t known = ended ? last : last - kAhead;
    const auto corner = is_exact(curves_.like()) ? std::nullopt : find_corner(known);
    if (corner || ended) {
      close_at(corner.value_or(last), out);
    } else if (!tail_ && is_straight_to(known) && known < kLongestLine) {
      straight_ = known;
      awaited_ = 2 * run_.size();
    } else if (straight_ > 0) {
      close_at(straight_, out);
    } else {
      advance(known, out);
    }
  }
}

std::optional<std::size_t> Compressor::find_corner(std::size_t known) {
  while (scanned_ + 1 < known) {
    if (is_corner(run_, scanned_ + 1, tolerance_mm())) {
      return scanned_ + 1;
    }
    ++scanned_;
  }
  return std::nullopt;
}

void Compressor::close_at(std::size_t vertex, std::vector<PathSegment>& out) {
  std::size_t last = vertex;
  if (straight_ > 0 && straight_ < last && !is_straight_to(last)) {
    last = straight_;
  }
  while (tail_ || !(is_straight_to(last) || curves_.append_circle(run_, last, out))) {
    const RunFit fit = fit_run(
        run_, {.last = last, .judged = last, .pinned = true, .before = curves_.end_direction()},
        tail_, {}, curves_.settings());
    if (fit.fails_at && last == 1) {
      curves_.append_first_line(run_, curves::to_position(tail_->derivatives[0]), out);
      break;
    }
    if (!fit.fails_at) {
      curves_.append_spans(run_, fit,
                           {.count = fit.spline.spans.size(),
                            .continue_segment = tail_.has_value(),
                            .to_vertex = true},
                           out);
      break;
    }
    last = std::min(*fit.fails_at, last - 1);
  }
  if (!tail_ && is_straight_to(last)) {
    curves_.append_line(run_, last, out);
  }
  tail_.reset();
  breaks_.clear();
  drop_front(last);
}

void Compressor::advance(std::size_t known, std::vector<PathSegment>& out) {
  const std::size_t half = known / 2;
  const RunFit fit = fit_run(run_,
                             {.last = known,
                              .judged = half + half / 2,
                              .pinned = false,
                              .before = curves_.end_direction()},
                             tail_, breaks_, curves_.settings());
  if (fit.fails_at) {
    close_at(*fit.fails_at, out);
    return;
  }
  std::size_t count = 1;
  while (count + 1 < fit.breaks.size() && fit.breaks[count + 1] <= half) {
    ++count;
  }
  curves_.append_spans(run_, fit, {.count = count, .continue_segment = tail_.has_value()}, out);
  tail_ = fit.spline.tail_after(count);
  const std::size_t gone = fit.breaks[count];
  breaks_.clear();
  for (std::size_t k = count; k < fit.breaks.size() && fit.breaks[k] <= half + half / 2; ++k) {
    breaks_.push_back(fit.breaks[k] - gone);
  }
  drop_front(gone);
}

void Compressor::drop_front(std::size_t vertices) {
  run_.erase(run_.begin(), run_.begin() + static_cast<std::ptrdiff_t>(vertices));
  scanned_ -= std::min(scanned_, vertices);
  straight_ = 0;
  awaited_ = kWindow;
}

}  // namespace kerf::smoothing
