#include "smoothing/compressor.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "smoothing/circle_run.hpp"
#include "smoothing/run_parts.hpp"
#include "smoothing/travel.hpp"

namespace kerf::smoothing {

using curves::vec;

namespace {

constexpr std::size_t kAhead = 24;           // of them, behind which corners are known
constexpr std::size_t kLongestLine = 65536;  // in lines of the program
constexpr std::size_t kSpansOfPart = 24;

}  // namespace

bool Compressor::takes(const parser::Move& move) {
  const auto* line = std::get_if<parser::LineMove>(&move.shape);
  return line != nullptr && curves::is_usable(line->end_mm) && !move.rapid &&
         move.mode == parser::PathMode::blend && move.merge_tolerance_mm > 0.0 &&
         !move.extra.moves();
}

bool Compressor::continues(const parser::Move& move) const {
  return run_.empty() || (move.merge_tolerance_mm == like_.merge_tolerance_mm &&
                          move.blend_tolerance_mm == like_.blend_tolerance_mm &&
                          move.extra.begin_rad_mm == like_.extra.begin_rad_mm &&
                          move.start_mm == run_.back().point_mm);
}

void Compressor::push(const parser::Move& move, std::vector<PathPart>& out) {
  const curves::Position& end = std::get<parser::LineMove>(move.shape).end_mm;
  if (run_.empty()) {
    like_ = move;
    settings_.tolerance_mm = move.merge_tolerance_mm;
    run_.push_back({.point_mm = move.start_mm, .source = move.source});
    scanned_ = 0;
  }
  const double length = (vec(end) - vec(run_.back().point_mm)).norm();
  if (!(length > 0.0)) {
    return;
  }
  run_.push_back({.point_mm = end,
                  .w_mm = run_.back().w_mm + length,
                  .feedrate_mm_s = move.feedrate_mm_s,
                  .source = move.source,
                  .run_block = move.block});
  if (run_.size() > awaited_) {
    reduce(false, out);
  }
}

void Compressor::flush(std::vector<PathPart>& out) {
  if (run_.size() > 1) {
    reduce(true, out);
  }
  run_.clear();
  breaks_.clear();
  tail_.reset();
}

void Compressor::reduce(bool ended, std::vector<PathPart>& out) {
  while (run_.size() > (ended ? 1 : awaited_)) {
    const std::size_t last = run_.size() - 1;
    const std::size_t known = ended ? last : last - kAhead;
    const auto corner = find_corner(known);
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
    if (is_corner(run_, scanned_ + 1, settings_.tolerance_mm)) {
      return scanned_ + 1;
    }
    ++scanned_;
  }
  return std::nullopt;
}

void Compressor::close_at(std::size_t vertex, std::vector<PathPart>& out) {
  std::size_t last = vertex;
  if (straight_ > 0 && straight_ < last && !is_straight_to(last)) {
    last = straight_;
  }
  while (tail_ || !(is_straight_to(last) || emit_circle(last, out))) {
    const RunFit fit =
        fit_run(run_, {.last = last, .judged = last, .pinned = true}, tail_, {}, settings_);
    if (fit.fails_at && last == 1) {
      emit_chords({0, 1}, {curves::to_position(tail_->derivatives[0]), run_[1].point_mm}, out);
      break;
    }
    if (!fit.fails_at) {
      emit_spans(fit, fit.spline.spans.size(), true, out);
      break;
    }
    last = std::min(*fit.fails_at, last - 1);
  }
  if (!tail_ && is_straight_to(last)) {
    emit_line(last, out);
  }
  tail_.reset();
  broken_ = false;
  breaks_.clear();
  drop_front(last);
}

void Compressor::advance(std::size_t known, std::vector<PathPart>& out) {
  const std::size_t half = known / 2;
  const RunFit fit = fit_run(run_, {.last = known, .judged = half + half / 2, .pinned = false},
                             tail_, breaks_, settings_);
  if (fit.fails_at) {
    close_at(*fit.fails_at, out);
    return;
  }
  std::size_t count = 1;
  while (count + 1 < fit.breaks.size() && fit.breaks[count + 1] <= half) {
    ++count;
  }
  emit_spans(fit, count, false, out);
  tail_ = fit.spline.tail_after(count);
  const std::size_t gone = fit.breaks[count];
  breaks_.clear();
  for (std::size_t k = count; k < fit.breaks.size() && fit.breaks[k] <= half + half / 2; ++k) {
    breaks_.push_back(fit.breaks[k] - gone);
  }
  drop_front(gone);
}

bool Compressor::emit_circle(std::size_t vertex, std::vector<PathPart>& out) {
  const auto circle = circle_of(run_, vertex, settings_.tolerance_mm);
  if (!circle || (settings_.travel && leaves_travel(circle->arc.extents(), *settings_.travel))) {
    return false;
  }
  departure_.widen({.distance_mm = circle->departure_mm,
                    .at_mm = run_[vertex / 2].point_mm,
                    .line = run_[vertex / 2].source.line,
                    .tolerance_mm = settings_.tolerance_mm});
  append_parts(run_,
               {.curve = circle->arc,
                .first = 0,
                .last = vertex,
                .s_mm = circle->s_mm,
                .departure_mm = circle->departure_mm},
               like_, out);
  return true;
}

void Compressor::emit_line(std::size_t vertex, std::vector<PathPart>& out) {
  const auto line = curves::Line::between(run_[0].point_mm, run_[vertex].point_mm);
  if (!line) {
    return;
  }
  const Eigen::Vector3d begin = vec(run_[0].point_mm);
  const Eigen::Vector3d direction = vec(line->direction());
  MergedCurve merged{.curve = *line, .first = 0, .last = vertex};
  Departure away;
  for (std::size_t i = 0; i < vertex; ++i) {
    const Eigen::Vector3d seen = vec(run_[i].point_mm) - begin;
    merged.s_mm.push_back(i == 0 ? 0.0 : seen.dot(direction));
    away.widen({.distance_mm = (seen - merged.s_mm.back() * direction).norm(),
                .at_mm = run_[i].point_mm,
                .line = run_[i].source.line,
                .tolerance_mm = settings_.tolerance_mm});
  }
  merged.departure_mm = away.distance_mm;
  departure_.widen(away);
  append_parts(run_, merged, like_, out);
}

void Compressor::emit_spans(const RunFit& fit, std::size_t count, bool to_end,
                            std::vector<PathPart>& out) {
  for (std::size_t from = 0; from < count;) {
    const std::size_t to = std::min(count, from + kSpansOfPart);
    const FitSpan& last = fit.spline.spans[to - 1];
    const curves::Position end = to == count && to_end
                                     ? run_[fit.breaks[to]].point_mm
                                     : curves::to_position(last.at(last.w_end_mm));
    std::vector<curves::BezierSpan> spans;
    double away = 0.0;
    for (std::size_t k = from; k < to; ++k) {
      spans.push_back(fit.spline.spans[k].bezier());
      away = std::max(away, fit.away_mm[k]);
      departure_.widen({.distance_mm = fit.away_mm[k],
                        .at_mm = run_[fit.breaks[k]].point_mm,
                        .line = run_[fit.breaks[k] + 1].source.line,
                        .tolerance_mm = settings_.tolerance_mm});
    }
    const auto made = curves::NurbsCurve::from_spans(spans, end);
    if (!made || made->size() != 1) {
      const FitSpan& first = fit.spline.spans[from];
      emit_chords({fit.breaks[from], fit.breaks[to]},
                  {curves::to_position(first.at(first.w_begin_mm)), end}, out);
    } else {
      MergedCurve merged{.curve = made->front(),
                         .first = fit.breaks[from],
                         .last = fit.breaks[to],
                         .continues = !broken_ && (tail_.has_value() || from > 0),
                         .departure_mm = away};
      for (std::size_t i = merged.first; i < merged.last; ++i) {
        merged.s_mm.push_back(i == merged.first ? 0.0 : made->front().s_at(run_[i].w_mm));
      }
      append_parts(run_, merged, like_, out);
      broken_ = false;
    }
    from = to;
  }
}

// The lines themselves, but for a begin and an end on the spline, which are no farther from their
// vertices than the tolerance; so no point of the chords is.
void Compressor::emit_chords(const Vertices& between, const ChordEnds& ends,
                             std::vector<PathPart>& out) {
  broken_ = true;
  for (std::size_t i = between.first; i < between.last; ++i) {
    const bool last = i + 1 == between.last;
    const curves::Position& from = i == between.first ? ends.begin_mm : run_[i].point_mm;
    const curves::Position& to = last ? ends.end_mm : run_[i + 1].point_mm;
    const Vertex& at = run_[last ? i + 1 : i];
    departure_.widen({.distance_mm = (vec(last ? to : from) - vec(at.point_mm)).norm(),
                      .at_mm = at.point_mm,
                      .line = run_[i + 1].source.line,
                      .tolerance_mm = settings_.tolerance_mm});
    if (const auto line = curves::Line::between(from, to)) {
      append_parts(run_, {.curve = *line, .first = i, .last = i + 1, .s_mm = {0.0}}, like_, out);
    }
  }
}

void Compressor::drop_front(std::size_t vertices) {
  run_.erase(run_.begin(), run_.begin() + static_cast<std::ptrdiff_t>(vertices));
  scanned_ -= std::min(scanned_, vertices);
  straight_ = 0;
  awaited_ = kWindow;
}

}  // namespace kerf::smoothing
