#include "lookahead/optimum/solver/limit_rows.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace kerf::lookahead {

namespace {

// A bound that the coefficients keep within rounding.
constexpr double kSeenTo = 1.0001;

using Row = std::array<double, 4>;

struct CellForms {
  Forms begin{};
  Forms end{};
  Bounds at_begin{};
  Bounds at_end{};
  bool goes_on = false;  // the next cell has the acceleration at its end
};

double squared(double x) {
  return x * x;
}

double cap_of(const Cell& cell) {
  return 0.5 * squared(cell.shares.feedrate) *
         (squared(cell.begin.feedrate_mm_s) + squared(cell.end.feedrate_mm_s));
}

class Builder {
 public:
  Builder(std::span<const Cell> cells, std::span<const CellBasis> basis, const PlanLimits& limits)
      : cells_(cells), basis_(basis), forms_(cells.size()) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      CellForms& forms = forms_[i];
      const double cap = cells[i].shares.feedrate *
                         std::max(cells[i].begin.feedrate_mm_s, cells[i].end.feedrate_mm_s);
      forms.begin = forms_at(cells[i], cells[i].begin, limits);
      forms.at_begin = bounds_of(forms.begin, cap);
      if (cells[i].straight) {
        forms.end = forms.begin;
        forms.at_end = forms.at_begin;
      } else {
        forms.end = forms_at(cells[i], cells[i].end, limits);
        forms.at_end = bounds_of(forms.end, cap);
      }
      if (i > 0) {
        join(forms_[i - 1], forms);
      }
    }
  }

  LimitRows build() {
    for (std::size_t i = 0; i < cells_.size(); i += kSimdWidth) {
      add_pair(i);
    }
    return std::move(result_);
  }

 private:
  static void join(CellForms& before, CellForms& after) {
    if (!are_one_place(before.end, after.begin, before.at_end.squared_mm2_s2)) {
      return;
    }
    before.goes_on = true;
    for (std::size_t k = 0; k < kForms; ++k) {
      double& limit = after.begin[k].acceleration_mm_s2;
      limit = std::min(limit, before.end[k].acceleration_mm_s2);
    }
  }

  // Of cells: their begins, or their ends.
  struct Place {
    std::size_t cell = 0;
    bool at_end = false;
  };
  // Of a row: the coefficients that it is over.
  struct Columns {
    std::size_t first = 0;
    std::size_t end = 3;
  };

  // Of both cells; a cell to which it does not apply has a row of zeros. False: it applies to none.
  template <typename RowOf>
  bool append_row(std::size_t i, const Columns& columns, RowOf row_of) {
    std::array<Row, kSimdWidth> rows{};
    bool any = false;
    for (std::size_t lane = 0; lane < kSimdWidth && i + lane < cells_.size(); ++lane) {
      any = row_of(i + lane, rows[lane]) || any;
    }
    for (std::size_t k = columns.first; any && k < columns.end; ++k) {
      result_.rows.emplace_back(rows[0][k], rows[1][k]);
    }
    return any;
  }

  bool cap_row(std::size_t i, Row& row) const {
    if (i == 0) {
      return false;  // what launches or moves on there has its own
    }
    const double cap =
        std::min(squared(cells_[i - 1].shares.feedrate * cells_[i - 1].end.feedrate_mm_s),
                 squared(cells_[i].shares.feedrate * cells_[i].begin.feedrate_mm_s));
    const std::array<double, 3>& value = basis_[i].begin.value;
    if (value[0] * cap_of(cells_[i - 1]) + value[1] * cap_of(cells_[i]) <= kSeenTo * cap) {
      return false;  // the bounds of the coefficients see to it
    }
    row = {value[0] / cap, value[1] / cap};
    return true;
  }

  bool acceleration_row(const Place& place, std::size_t k, Row& row) const {
    const auto [i, at_end] = place;
    const CellForms& cell = forms_[i];
    const Forms& forms = at_end ? cell.end : cell.begin;
    const Form& form = forms[k];
    if ((at_end && cell.goes_on) ||
        !acceleration_may_bind(forms, k, at_end ? cell.at_end : cell.at_begin)) {
      return false;
    }
    const Basis& basis = at_end ? basis_[i].end : basis_[i].begin;
    for (std::size_t c = 0; c < 3; ++c) {
      row[c] = (0.5 * form.first * basis.slope[c] + form.second_per_mm * basis.value[c]) /
               form.acceleration_mm_s2;
    }
    return true;
  }

  // of_jumps: the rows of places beside jumps, or all others.
  bool jerk_row(const Place& place, std::size_t k, bool of_jumps, Row& row) const {
    const auto [i, at_end] = place;
    const CellForms& cell = forms_[i];
    const Forms& forms = at_end ? cell.end : cell.begin;
    const Form& form = forms[k];
    if ((form.jumps_per_mm_s > 0.0) != of_jumps ||
        !jerk_may_bind(forms, k, at_end ? cell.at_end : cell.at_begin)) {
      return false;
    }
    row[3] = form.jumps_per_mm_s / form.jerk_mm_s3;
    const Basis& basis = at_end ? basis_[i].end : basis_[i].begin;
    for (std::size_t c = 0; c < 3; ++c) {
      row[c] = (0.5 * form.first * basis.bend[c] + 1.5 * form.second_per_mm * basis.slope[c] +
                form.third_per_mm2 * basis.value[c]) /
               form.jerk_mm_s3;
    }
    return true;
  }

  // How many forms have a row there.
  std::uint8_t append_accelerations(const Place& at) {
    std::uint8_t count = 0;
    for (std::size_t k = 0; k < kForms; ++k) {
      const auto row_of = [&](std::size_t cell, Row& row) {
        return acceleration_row({cell, at.at_end}, k, row);
      };
      if (append_row(at.cell, at.at_end ? Columns{1, 3} : Columns{0, 2}, row_of)) {
        ++count;
      }
    }
    return count;
  }
  std::uint8_t append_jerks(const Place& at, bool of_jumps) {
    std::uint8_t count = 0;
    for (std::size_t k = 0; k < kForms; ++k) {
      const auto row_of = [&](std::size_t cell, Row& row) {
        return jerk_row({cell, at.at_end}, k, of_jumps, row);
      };
      if (append_row(at.cell, {.first = 0, .end = of_jumps ? 4U : 3U}, row_of)) {
        ++count;
      }
    }
    return count;
  }

  void add_pair(std::size_t i) {
    CellPair pair;
    pair.middle = {SimdPair::Zero(), SimdPair::Ones(), SimdPair::Zero()};
    for (std::size_t lane = 0; lane < kSimdWidth && i + lane < cells_.size(); ++lane) {
      const auto l = static_cast<Eigen::Index>(lane);
      const CellBasis& basis = basis_[i + lane];
      pair.length_mm[l] = cells_[i + lane].length_mm;
      pair.begin[l] = basis.begin.value[0];
      pair.end[l] = basis.end.value[2];
      pair.cap[l] = 1.0 / cap_of(cells_[i + lane]);
      for (std::size_t c = 0; c < 3; ++c) {
        pair.middle[c][l] = basis.middle.value[c];
      }
    }
    const auto cap = [&](std::size_t cell, Row& row) { return cap_row(cell, row); };
    pair.caps = append_row(i, {.first = 0, .end = 2}, cap) ? 1 : 0;
    pair.accelerations = append_accelerations({.cell = i, .at_end = false});
    pair.end_accelerations = append_accelerations({.cell = i, .at_end = true});
    pair.jerks = append_jerks({.cell = i, .at_end = false}, false);
    pair.end_jerks = append_jerks({.cell = i, .at_end = true}, false);
    pair.jump_jerks = append_jerks({.cell = i, .at_end = false}, true);
    pair.end_jump_jerks = append_jerks({.cell = i, .at_end = true}, true);
    result_.pairs.push_back(pair);
  }

  std::span<const Cell> cells_;
  std::span<const CellBasis> basis_;
  std::vector<CellForms> forms_;
  LimitRows result_;
};

}  // namespace

LimitRows limit_rows(std::span<const Cell> cells, std::span<const CellBasis> basis,
                     const PlanLimits& limits) {
  assert(basis.size() == cells.size());
  return Builder(cells, basis, limits).build();
}

}  // namespace kerf::lookahead
