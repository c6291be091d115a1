// A symmetric system of equations with two bands beside the diagonal.
#pragma once

#include <cstddef>
#include <vector>

namespace kerf::lookahead {

// H x = -g, H positive definite. O(n): L D L^T without pivoting.
struct BandSystem {
  std::vector<double> diagonal;
  std::vector<double> first;   // H(i, i + 1)
  std::vector<double> second;  // H(i, i + 2)
  std::vector<double> gradient;

  void clear(std::size_t size);

  // Of the rows in [begin, end); x keeps its other entries. Destroys the system. False: H is not
  // positive definite to rounding.
  struct Rows {
    std::size_t begin = 0;
    std::size_t end = 0;
  };
  bool solve(const Rows& rows, std::vector<double>& x);
  // Its first half: the diagonal becomes D, the bands the columns of L, x is L^-1 (-g).
  bool eliminate(const Rows& rows, std::vector<double>& x);
};

}  // namespace kerf::lookahead
