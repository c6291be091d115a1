#include "tests/conformance/answer.hpp"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace kerf::conformance {

namespace {

using parser::Point;

Point read_point(std::istream& in) {
  Point point;
  in >> point[0] >> point[1] >> point[2];
  return point;
}

void expect(std::istream& in, const std::string& wanted) {
  std::string word;
  if (!(in >> word) || word != wanted) {
    throw std::runtime_error("a golden file has '" + word + "' in place of '" + wanted + "'");
  }
}

Step read_step(std::string line) {
  Step step;
  if (const auto at = line.find(" turned "); at != std::string::npos) {
    std::istringstream angles(line.substr(at + 8));
    angles >> step.turned_deg[0] >> step.turned_deg[1] >> step.turned_deg[2];
    line.erase(at);
  }
  std::istringstream in(line);
  in >> step.kind;
  if (step.kind == "event") {
    std::getline(in >> std::ws, step.way);
  } else if (step.kind == "dwell") {
    in >> step.time_s;
  } else if (step.kind != "spline") {
    step.end_mm = read_point(in);
  }
  if (step.kind == "feed" || step.kind == "probe" || step.kind == "arc") {
    expect(in, "at");
    in >> step.feed_mm_min;
  }
  if (step.kind == "arc") {
    expect(in, "about");
    step.centre_mm = read_point(in);
    std::getline(in >> std::ws, step.way);
  }
  if (!in) {
    throw std::runtime_error("not a line of a golden file: " + line);
  }
  return step;
}

double distance_mm(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

bool is_straight(const Step& step) {
  return step.kind == "rapid" || step.kind == "feed";
}

// Both sides leave out straight moves that go nowhere and dwells of no time, one where they are met
// and one in its answer.
std::vector<Step> moving_steps(const Answer& answer, double shortest_mm) {
  std::vector<Step> steps;
  Point position{};
  Point turned_deg{};
  for (const Step& step : answer.steps) {
    const bool has_end = step.kind != "dwell" && step.kind != "spline" && step.kind != "event";
    if (is_straight(step) && distance_mm(step.end_mm, position) <= shortest_mm &&
        distance_mm(step.turned_deg, turned_deg) <= shortest_mm) {
      continue;
    }
    if (step.kind == "dwell" && step.time_s == 0.0) {
      continue;
    }
    position = has_end ? step.end_mm : position;
    turned_deg = has_end ? step.turned_deg : turned_deg;
    steps.push_back(step);
  }
  return steps;
}

bool agree(const Step& wanted, const Step& found, double tolerance_mm) {
  constexpr double kRadiusDigits = 2.0;  // a centre comes of two rounded points
  constexpr double kTime_s = 1e-4;
  if (wanted.kind != found.kind || wanted.way != found.way) {
    return false;
  }
  if (wanted.kind == "dwell") {
    return std::fabs(wanted.time_s - found.time_s) <= kTime_s;
  }
  if (wanted.kind == "spline" || wanted.kind == "event") {
    return true;
  }
  const bool same_feed = is_straight(wanted) && wanted.kind == "rapid"
                             ? true
                             : std::fabs(wanted.feed_mm_min - found.feed_mm_min) <=
                                   0.01 + 1e-5 * std::fabs(wanted.feed_mm_min);
  Point centre = found.centre_mm;
  const std::size_t normal = wanted.way.find("xy") != std::string::npos   ? 2
                             : wanted.way.find("zx") != std::string::npos ? 1
                                                                          : 0;
  centre[normal] = wanted.centre_mm[normal];
  return same_feed && distance_mm(wanted.end_mm, found.end_mm) <= 2 * tolerance_mm &&
         distance_mm(wanted.turned_deg, found.turned_deg) <= 2 * tolerance_mm &&
         (wanted.kind != "arc" ||
          distance_mm(wanted.centre_mm, centre) <= 2 * kRadiusDigits * tolerance_mm);
}

std::string text_of(const Point& point) {
  char text[96];
  std::snprintf(text, sizeof text, "%.4f %.4f %.4f", point[0], point[1], point[2]);
  return text;
}

}  // namespace

std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

Answer read_answer(const std::filesystem::path& golden) {
  std::istringstream lines(read_file(golden));
  Answer answer;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#') {
      continue;
    }
    if (line.rfind("tolerance_mm ", 0) == 0) {
      answer.tolerance_mm = std::stod(line.substr(13));
    } else if (line.rfind("refused: ", 0) == 0) {
      answer.refusal = line.substr(9);
    } else {
      answer.steps.push_back(read_step(line));
    }
  }
  if (answer.tolerance_mm <= 0.0) {
    throw std::runtime_error(golden.string() + " has no tolerance");
  }
  return answer;
}

std::string text_of(const Step& step) {
  std::string text = step.kind;
  if (step.kind == "dwell") {
    return text + ' ' + std::to_string(step.time_s);
  }
  if (step.kind == "spline") {
    return text;
  }
  if (step.kind == "event") {
    return text + ' ' + step.way;
  }
  text += ' ' + text_of(step.end_mm) + " turned " + text_of(step.turned_deg);
  if (step.kind == "feed" || step.kind == "arc" || step.kind == "probe") {
    text += " at " + std::to_string(step.feed_mm_min);
  }
  return step.kind == "arc" ? text + " about " + text_of(step.centre_mm) + ' ' + step.way : text;
}

std::string first_difference(const Answer& wanted, const Answer& found) {
  if (wanted.refusal.empty() != found.refusal.empty()) {
    return "wanted: " + (wanted.refusal.empty() ? "no refusal" : wanted.refusal) +
           "\nfound: " + (found.refusal.empty() ? "no refusal" : found.refusal);
  }
  if (!wanted.refusal.empty()) {
    return "";
  }
  const std::vector<Step> want = moving_steps(wanted, wanted.tolerance_mm);
  const std::vector<Step> find = moving_steps(found, wanted.tolerance_mm);
  for (std::size_t i = 0; i < std::max(want.size(), find.size()); ++i) {
    const bool both = i < want.size() && i < find.size();
    if (!both || !agree(want[i], find[i], wanted.tolerance_mm)) {
      return "move " + std::to_string(i + 1) +
             "\nwanted: " + (i < want.size() ? text_of(want[i]) : "the end") +
             "\nfound:  " + (i < find.size() ? text_of(find[i]) : "the end");
    }
  }
  return "";
}

}  // namespace kerf::conformance
