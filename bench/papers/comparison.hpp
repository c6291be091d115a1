// A published figure beside ours: the rows of the tables that `kerf-bench papers` prints.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kerf::bench {

struct PaperFigure {
  std::string name;        // what and in which unit: "time, sigmoid [s]"
  double published = 0.0;  // as printed
  int decimals = 0;        // of both in the table
  double here = 0.0;
  // How far from the published one it may be to count as reproduced; 0: one of the last digit. The
  // table states it, as it does the band.
  double tolerance = 0.0;
  // Beyond that it is approached, as long as it is no farther than this, and `why` says what parts
  // them; 0: it has to be reproduced.
  double band = 0.0;
  std::string why{};
  bool impossible = false;  // `why` says so, with figures; ours is what is possible
};

// Rows of published figures, and whether each is what it is said to be.
class Comparison {
 public:
  void add(const PaperFigure& figure);
  // What holds or does not, whatever was published: a limit that is kept, a count.
  void require(std::string_view what, bool holds);
  void print(std::string_view heading) const;
  // Prints what is not as it is said to be. True: nothing.
  [[nodiscard]] bool judge() const;

 private:
  std::vector<std::string> rows_;
  std::vector<std::string> broken_;
};

// A figure as text.
std::string fixed(double value, int decimals);

}  // namespace kerf::bench
