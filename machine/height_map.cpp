// The text of a height map.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include <kerf/simulation.hpp>

namespace kerf {
inline namespace v0 {

namespace {

// Of the spacing: how far a point may be from its place on the grid.
constexpr double kUneven = 1e-2;  // coordinates in whole micrometres of 0.1 mm apart

using Row = std::array<double, 3>;

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == ',' || c == '\r';
}

// Nothing: these are not three finite numbers.
std::optional<Row> row_of(std::string_view line) {
  Row row{};
  const char* at = line.data();
  const char* const end = at + line.size();
  for (double& number : row) {
    at = std::find_if_not(at, end, is_blank);
    if (at != end && *at == '+') {  // which from_chars does not take
      ++at;
      if (at != end && *at == '-') {
        return std::nullopt;
      }
    }
    const auto read = std::from_chars(at, end, number);
    if (read.ec != std::errc{} || !std::isfinite(number)) {
      return std::nullopt;
    }
    at = read.ptr;
  }
  return std::find_if_not(at, end, is_blank) == end ? std::optional(row) : std::nullopt;
}

struct GridLines {
  double begin = 0.0;
  double spacing = 0.0;
  std::size_t points = 0;

  // Nothing: it is beside the grid.
  [[nodiscard]] std::optional<std::size_t> index_of(double at) const {
    const double place = (at - begin) / spacing;
    const double nearest = std::round(place);
    return std::abs(place - nearest) <= kUneven ? std::optional(static_cast<std::size_t>(nearest))
                                                : std::nullopt;
  }
};

// The grid's lines along one axis, from the places of all points.
GridLines line_of(std::vector<double> places) {
  std::sort(places.begin(), places.end());
  const double span = places.back() - places.front();
  GridLines line{.begin = places.front(), .points = 1};
  // Places that belong together differ by rounding.
  const double apart = span / (2.0 * static_cast<double>(HeightMap::kMaxColumns));
  for (std::size_t i = 1; i < places.size(); ++i) {
    line.points += places[i] - places[i - 1] > apart ? 1U : 0U;
  }
  line.spacing = line.points > 1 ? span / static_cast<double>(line.points - 1) : 0.0;
  return line;
}

tl::expected<HeightMap, HeightMapError> grid_of(const std::vector<Row>& rows,
                                                const std::vector<std::uint32_t>& lines) {
  const auto refuse = [](std::uint32_t line, std::string_view message) {
    return tl::unexpected(HeightMapError{.line = line, .message = message});
  };
  std::array<GridLines, 2> along{};
  for (std::size_t k = 0; k < along.size(); ++k) {
    std::vector<double> places;
    std::transform(rows.begin(), rows.end(), std::back_inserter(places),
                   [k](const Row& row) { return row[k]; });
    along[k] = places.empty() ? GridLines{} : line_of(std::move(places));
    if (along[k].points < 2 || along[k].points > HeightMap::kMaxColumns) {
      return refuse(1, "expected from 2 to 1000 different x and as many different y");
    }
  }
  if (along[0].points * along[1].points != rows.size()) {
    return refuse(1, "the points make no grid: expected every x with every y once");
  }
  HeightMap map{.origin_mm = {along[0].begin, along[1].begin},
                .spacing_mm = {along[0].spacing, along[1].spacing},
                .columns = along[0].points,
                .heights_mm = std::vector<double>(rows.size(), std::nan(""))};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto column = along[0].index_of(rows[i][0]);
    const auto row = along[1].index_of(rows[i][1]);
    if (!column || !row) {
      return refuse(lines[i], "the points are not evenly spaced");
    }
    double& height = map.heights_mm[*row * map.columns + *column];
    if (!std::isnan(height)) {
      return refuse(lines[i], "this x and y came before");
    }
    height = rows[i][2];
  }
  return map;
}

}  // namespace

tl::expected<HeightMap, HeightMapError> read_height_map(std::string_view text) {
  std::vector<Row> rows;
  std::vector<std::uint32_t> lines;
  for (std::uint32_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    line = line.substr(0, line.find('#'));
    text.remove_prefix(std::min(end + 1, text.size()));
    const auto* const first = std::find_if_not(line.begin(), line.end(), is_blank);
    if (first == line.end()) {
      continue;
    }
    const auto row = row_of(line);
    if (!row || rows.size() == HeightMap::kMaxColumns * HeightMap::kMaxColumns) {
      return tl::unexpected(HeightMapError{
          .line = number, .message = row ? "too many points" : "expected x, y and z in mm"});
    }
    rows.push_back(*row);
    lines.push_back(number);
  }
  return grid_of(rows, lines);
}

}  // namespace v0
}  // namespace kerf
