#include "lookahead/optimum/solver/band_system.hpp"

#include <cassert>

namespace kerf::lookahead {

void BandSystem::clear(std::size_t size) {
  for (std::vector<double>* band : {&diagonal, &first, &second, &gradient}) {
    band->assign(size, 0.0);
  }
}

bool BandSystem::solve(const Rows& rows, std::vector<double>& x) {
  assert(rows.begin <= rows.end && rows.end <= diagonal.size() && x.size() == diagonal.size());
  if (!eliminate(rows, x)) {
    return false;
  }
  const auto [begin, end] = rows;
  for (std::size_t i = end; i-- > begin;) {
    x[i] /= diagonal[i];
    if (i + 1 < end) {
      x[i] -= first[i] * x[i + 1];
    }
    if (i + 2 < end) {
      x[i] -= second[i] * x[i + 2];
    }
  }
  return true;
}

bool BandSystem::eliminate(const Rows& rows, std::vector<double>& x) {
  const auto [begin, end] = rows;
  for (std::size_t i = begin; i < end; ++i) {
    const double d = diagonal[i];
    if (!(d > 0.0)) {
      return false;
    }
    x[i] = -gradient[i];
    if (i > begin) {
      x[i] -= first[i - 1] * x[i - 1];
    }
    if (i > begin + 1) {
      x[i] -= second[i - 2] * x[i - 2];
    }
    const double l1 = first[i] / d;
    const double l2 = second[i] / d;
    if (i + 1 < end) {
      diagonal[i + 1] -= l1 * first[i];
      first[i + 1] -= l1 * second[i];
    }
    if (i + 2 < end) {
      diagonal[i + 2] -= l2 * second[i];
    }
    first[i] = l1;
    second[i] = l2;
  }
  return true;
}

}  // namespace kerf::lookahead
