#include "lookahead/optimum/solver/barrier_objective.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "lookahead/optimum/grid/speed_estimate.hpp"
#include "lookahead/optimum/solver/pair_sums.hpp"

namespace kerf::lookahead {

namespace {

double square(double x) {
  return x * x;
}

}  // namespace

struct BarrierObjective::Sums {
  const BarrierWeights* weights = nullptr;
  BandSystem* system = nullptr;  // null: of the value alone
  double time_s = 0.0;
  double barrier_s = 0.0;
};

// With s = J t^3 / 6: v^2 = J^(2/3) (6 s)^(4/3) / 4.
BarrierObjective::RestCell BarrierObjective::rest_cell(const Cell& cell, const RestEnds& ends,
                                                       double neighbour_mm) const {
  const double h = cell.length_mm;
  const double jerk = tangential_jerk_mm_s3(cell, *ends.rest, *limits_);
  return {.length_mm = h,
          .cap = std::min(0.25 * square(std::cbrt(jerk * square(6.0 * h))),
                          square(cell.shares.feedrate * ends.inner->feedrate_mm_s)),
          .gain = 1.0 / (1.0 + 2.0 * neighbour_mm / (3.0 * h))};
}

// The basis of a cell depends on its neighbours' lengths.
BarrierObjective::BarrierObjective(const CellSequence& sequence, const PlanLimits& limits,
                                   const SplineRange& range)
    : sequence_(&sequence), limits_(&limits), range_(range) {
  const std::vector<Cell>& cells = sequence.cells;
  const std::size_t first = sequence.first_spline_cell();
  const std::size_t count = sequence.spline_cells();
  const std::size_t before = range.begin > 0 ? 1 : 0;
  const std::size_t after = range.end < count ? 1 : 0;
  std::vector<double> lengths;
  for (std::size_t i = range.begin - before; i < range.end + after; ++i) {
    lengths.push_back(cells[first + i].length_mm);
  }
  const std::vector<CellBasis> basis = feed_basis(lengths);
  rows_ = limit_rows({cells.data() + first + range.begin, range.size()},
                     std::span(basis).subspan(before, range.size()), limits);
  if (sequence.begin.at_rest() && range.begin == 0) {
    launch_ = rest_cell(cells.front(), {.rest = &cells.front().begin, .inner = &cells.front().end},
                        lengths.front());
  }
  if (range.end == count) {
    landing_ = rest_cell(cells.back(), {.rest = &cells.back().end, .inner = &cells.back().begin},
                         lengths.back());
  }
}

BandSystem::Rows BarrierObjective::free_rows() const noexcept {
  return {.begin = launches() ? 1U : 2U, .end = size() - (lands() ? 1U : 2U)};
}

void BarrierObjective::bind(std::vector<double>& coefficients) const noexcept {
  if (launches()) {
    coefficients.front() = launch_.gain * coefficients[1];
  } else if (begins_in_motion()) {
    const StartState& begin = sequence_->begin;
    coefficients[0] = square(begin.v_mm_s);
    coefficients[1] = coefficients[0] + begin.a_mm_s2 * sequence_->cells.front().length_mm;
  }
  if (lands()) {
    coefficients.back() = landing_.gain * coefficients[size() - 2];
  }
}

void BarrierObjective::bind_change(std::vector<double>& change) const noexcept {
  if (launches()) {
    change.front() = launch_.gain * change[1];
  } else {
    change[0] = change[1] = 0.0;
  }
  if (lands()) {
    change.back() = landing_.gain * change[size() - 2];
  } else {
    change[size() - 2] = change[size() - 1] = 0.0;
  }
}

// The spline's value at its ends is its outermost coefficient.
void BarrierObjective::add_rest(const RestCell& rest, std::size_t outer,
                                const std::vector<double>& coefficients, Sums& sums) const {
  const double b = coefficients[outer];
  const double t = 3.0 * rest.length_mm / std::sqrt(b);
  Barrier::Sum sum;
  const Barrier::Slopes slopes =
      Barrier(sums.weights->relaxed).below(SimdPair(b / rest.cap, 0.0), sum);
  const double weight = sums.weights->weight_s;
  sums.time_s += t;
  sums.barrier_s += sum.value()[0];
  if (sums.system == nullptr) {
    return;
  }
  sums.system->gradient[outer] += -0.5 * t / b + weight * slopes.rise[0] / rest.cap;
  sums.system->diagonal[outer] +=
      0.75 * t / (b * b) + sums.weights->stiffness_s * slopes.bend[0] / square(rest.cap);
}

BarrierObjective::Value BarrierObjective::value(const std::vector<double>& coefficients,
                                                const BarrierWeights& weights) const {
  return sum<Order::value>(coefficients, {.weights = &weights});
}

BarrierObjective::Value BarrierObjective::derive(const std::vector<double>& coefficients,
                                                 const BarrierWeights& weights,
                                                 BandSystem& system) const {
  system.clear(size());
  return sum<Order::derivatives>(coefficients, {.weights = &weights, .system = &system});
}

template <Order kOrder>
BarrierObjective::Value BarrierObjective::sum(const std::vector<double>& coefficients,
                                              Sums ends) const {
  const BarrierWeights& weights = *ends.weights;
  const std::size_t count = range_.size();
  SimdPair time = SimdPair::Zero();
  SimdPair barrier_sum = SimdPair::Zero();
  const SimdPair* row = rows_.rows.data();
  std::size_t i = 0;
  for (const CellPair& pair : rows_.pairs) {
    const std::size_t cells = std::min(kSimdWidth, count - i);
    PairSums<kOrder> sums(pair, &coefficients[i], cells, weights);
    if (!sums.are_positive()) {
      return {.time_s = kUnbounded, .objective_s = kUnbounded};
    }
    time += sums.add_time();
    row = sums.add_limits(row);
    barrier_sum += sums.barrier();
    if constexpr (kOrder == Order::derivatives) {
      sums.store(i, *ends.system);
    }
    i += cells;
  }
  if (launches()) {
    add_rest(launch_, 0, coefficients, ends);
  }
  if (lands()) {
    add_rest(landing_, size() - 1, coefficients, ends);
  }
  if constexpr (kOrder == Order::derivatives) {
    fold_ends(*ends.system);
  }
  Value value;
  value.time_s = time.sum() + ends.time_s;
  const double objective = value.time_s + weights.weight_s * (barrier_sum.sum() + ends.barrier_s);
  value.objective_s = std::isfinite(objective) ? objective : kUnbounded;
  return value;
}

void BarrierObjective::fold_ends(BandSystem& system) const {
  const std::size_t last = size() - 1;
  const auto fold = [&system](std::size_t outer, std::size_t inner, std::size_t band, double gain) {
    system.gradient[inner] += gain * system.gradient[outer];
    system.diagonal[inner] += gain * (2.0 * system.first[band] + gain * system.diagonal[outer]);
  };
  if (launches()) {
    fold(0, 1, 0, launch_.gain);
    system.first[1] += launch_.gain * system.second[0];
  }
  if (lands()) {
    fold(last, last - 1, last - 1, landing_.gain);
    system.first[last - 2] += landing_.gain * system.second[last - 2];
  }
}

}  // namespace kerf::lookahead
