#include "smoothing/run_curves.hpp"

#include <algorithm>

#include "smoothing/run_segments.hpp"
#include "smoothing/travel.hpp"

namespace kerf::smoothing {

using curves::vec;

namespace {

constexpr std::size_t kSpansOfSegment = 24;

}  // namespace

void RunCurves::begin(const parser::Move& like, double beside_mm) {
  like_ = like;
  if (like_.mode == parser::PathMode::exact_path) {
    like_.blend_tolerance_mm = 0.0;
    like_.merge_tolerance_mm = kExact_mm;
  }
  beside_mm_ = beside_mm;
  end_direction_.reset();
  set_beside(beside_mm);
}

void RunCurves::widen_beside(double distance_mm) {
  set_beside(std::max(settings_.beside_mm, beside_mm_ + distance_mm));
}

void RunCurves::set_beside(double beside_mm) {
  settings_.beside_mm = beside_mm;
  settings_.tolerance_mm = like_.merge_tolerance_mm - beside_mm;
}

bool RunCurves::append_circle(const Polyline& run, std::size_t vertex,
                              std::vector<PathSegment>& out) {
  const auto circle = circle_of(run, vertex, settings_.tolerance_mm);
  if (!circle || (settings_.travel && leaves_travel(circle->arc.extents(), *settings_.travel))) {
    return false;
  }
  widen({run[vertex / 2], circle->arc.at(circle->s_mm[vertex / 2])}, circle->deviation_mm);
  append_merged(run,
                {.curve = circle->arc,
                 .first = 0,
                 .last = vertex,
                 .s_mm = circle->s_mm,
                 .deviation_mm = circle->deviation_mm},
                out);
  return true;
}

void RunCurves::append_line(const Polyline& run, std::size_t vertex,
                            std::vector<PathSegment>& out) {
  const auto line = curves::Line::between(run[0].point_mm, run[vertex].point_mm);
  if (!line) {
    return;
  }
  const Eigen::Vector3d begin = vec(run[0].point_mm);
  const Eigen::Vector3d direction = vec(line->direction());
  MergedCurve merged{.curve = *line, .first = 0, .last = vertex};
  for (std::size_t i = 0; i < vertex; ++i) {
    const Eigen::Vector3d seen = vec(run[i].point_mm) - begin;
    merged.s_mm.push_back(i == 0 ? 0.0 : seen.dot(direction));
    const double away = (seen - merged.s_mm.back() * direction).norm();
    merged.deviation_mm = std::max(merged.deviation_mm, away);
    widen({run[i], line->at(merged.s_mm.back())}, away);
  }
  append_merged(run, std::move(merged), out);
}

void RunCurves::append_spans(const Polyline& run, const RunFit& fit, const Spans& spans,
                             std::vector<PathSegment>& out) {
  broken_ = broken_ && spans.continue_segment;
  for (std::size_t from = 0; from < spans.count;) {
    const std::size_t to = std::min(spans.count, from + kSpansOfSegment);
    const bool continues = !broken_ && (spans.continue_segment || from > 0);
    append_segment(run, fit,
                   {.spans = {from, to},
                    .continues = continues,
                    .to_vertex = spans.to_vertex && to == spans.count},
                   out);
    from = to;
  }
}

void RunCurves::append_segment(const Polyline& run, const RunFit& fit, const FitSegment& segment,
                               std::vector<PathSegment>& out) {
  const Indices& spans = segment.spans;
  const Indices lines{fit.breaks[spans.first], fit.breaks[spans.last]};
  const FitSpan& first = fit.spline.spans[spans.first];
  const FitSpan& last = fit.spline.spans[spans.last - 1];
  const curves::Position end =
      segment.to_vertex ? run[lines.last].point_mm : curves::to_position(last.at(last.w_end_mm));
  std::vector<curves::BezierSpan> beziers;
  double away = 0.0;
  for (std::size_t k = spans.first; k < spans.last; ++k) {
    beziers.push_back(fit.spline.spans[k].bezier());
    away = std::max(away, fit.away_mm[k]);
    const Vertex& at = run[fit.breaks[k] + 1];
    widen({at, curves::to_position(fit.spline.spans[k].at(at.w_mm))}, fit.away_mm[k]);
  }
  const auto made = curves::NurbsCurve::from_spans(beziers, end);
  broken_ = !made || made->size() != 1;
  if (broken_) {
    append_chords(run, lines, {curves::to_position(first.at(first.w_begin_mm)), end}, out);
    return;
  }
  MergedCurve merged{.curve = made->front(),
                     .first = lines.first,
                     .last = lines.last,
                     .continues = segment.continues,
                     .deviation_mm = away};
  for (std::size_t i = merged.first; i < merged.last; ++i) {
    merged.s_mm.push_back(i == merged.first ? 0.0 : made->front().s_at(run[i].w_mm));
  }
  append_merged(run, std::move(merged), out);
}

void RunCurves::append_first_line(const Polyline& run, const curves::Position& begin_mm,
                                  std::vector<PathSegment>& out) {
  append_chords(run, {0, 1}, {begin_mm, run[1].point_mm}, out);
}

// The lines themselves, but for a begin and an end on the spline, which are no farther from their
// vertices than the tolerance; so no point of the chords is.
void RunCurves::append_chords(const Polyline& run, const Indices& lines, const ChordEnds& ends,
                              std::vector<PathSegment>& out) {
  for (std::size_t i = lines.first; i < lines.last; ++i) {
    const bool last = i + 1 == lines.last;
    const curves::Position& from = i == lines.first ? ends.begin_mm : run[i].point_mm;
    const curves::Position& to = last ? ends.end_mm : run[i + 1].point_mm;
    const Vertex& at = run[last ? i + 1 : i];
    const curves::Position& end = last ? to : from;
    widen({at, end}, (vec(end) - vec(at.point_mm)).norm());
    if (const auto line = curves::Line::between(from, to)) {
      append_merged(run, {.curve = *line, .first = i, .last = i + 1, .s_mm = {0.0}}, out);
    }
  }
}

void RunCurves::append_merged(const Polyline& run, MergedCurve merged,
                              std::vector<PathSegment>& out) {
  merged.deviation_mm += settings_.beside_mm;
  end_direction_ = vec(curves::derivatives_at(merged.curve, curves::length_mm(merged.curve)).first);
  append_segments(run, merged, like_, out);
}

void RunCurves::widen(const Place& place, double distance_mm) {
  if (like_.mode == parser::PathMode::exact_path) {
    return;
  }
  deviations_.add({.distance_mm = distance_mm + settings_.beside_mm,
                   .at_mm = place.at_mm,
                   .line = place.vertex.source.program_line(),
                   .tolerance_mm = like_.merge_tolerance_mm});
}

}  // namespace kerf::smoothing
