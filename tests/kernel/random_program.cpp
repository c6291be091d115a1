#include "tests/kernel/random_program.hpp"

#include <algorithm>
#include <cmath>

#include "tests/kernel/printed_words.hpp"

namespace kerf::test {

namespace {

constexpr double kLongestMove_s = 0.7;
constexpr double kTravel_mm = 2000.0;

class RandomWriter {
 public:
  RandomWriter(std::uint64_t seed, const Mix& mix) : random_(seed), mix_(mix) {}

  RandomProgram write() {
    add_line("G21 G90 G17 G94 G40 G49 G80 G91.1", 0.0);
    for (int i = 0; i < mix_.blocks; ++i) {
      const double pick = uniform(0.0, 1.0);
      if (mix_.contour) {
        contour_line();
      } else if (mix_.extra && uniform(0.0, 1.0) < 0.3) {
        extra_line();
      } else if (mix_.nurbs && pick < 0.15) {
        nurbs();
      } else if (mix_.arcs && pick < 0.5) {
        arc();
      } else {
        line();
      }
    }
    add_line("M2", 0.0);
    program_.end_mm = here_;
    return std::move(program_);
  }

 private:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  double log_uniform(double low, double high) {
    return std::exp(uniform(std::log(low), std::log(high)));
  }

  void add_line(const std::string& text, double feedrate_mm_s) {
    program_.text += text + "\n";
    program_.feedrate_mm_s.push_back(feedrate_mm_s);
  }

  void add_stretch(Stretch stretch, std::size_t line) {
    stretch.line = line;
    program_.path.push_back(std::move(stretch));
  }

  // A G1 to a place that far away.
  void line_by(const Vec& step, std::string& text) {
    const Vec from = here_;
    text = "G1";
    here_ = print_axes({from[0] + step[0], from[1] + step[1], from[2] + step[2]}, text);
    add_stretch(line_stretch(from, here_), program_.lines() + 1);
  }

  double feed_word(double length_mm, std::string& text) {
    const double slowest_mm_min = std::max(1e-3, length_mm / kLongestMove_s * 60.0);
    const double feed = log_uniform(std::min(slowest_mm_min, 1e5), 1e5);
    text += " F";
    return print_number(feed, text) / 60.0;
  }

  Vec direction() {
    Vec d{};
    if (uniform(0.0, 1.0) < 0.2 && last_ != Vec{}) {
      const double wobble = log_uniform(1e-9, 1e-1);  // nearly straight on
      for (std::size_t k = 0; k < 3; ++k) {
        d[k] = last_[k] + uniform(-wobble, wobble);
      }
    } else {
      for (double& x : d) {
        x = uniform(0.0, 1.0) < 0.2 ? 0.0 : uniform(-1.0, 1.0);
      }
      d[0] = d == Vec{} ? 1.0 : d[0];
    }
    const double norm = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    for (double& x : d) {
      x /= norm;
    }
    last_ = d;
    return d;
  }

  // Towards the origin once the travel is left.
  void keep_inside(Vec& d) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (std::abs(here_[k]) > kTravel_mm) {
        d[k] = std::copysign(std::abs(d[k]), -here_[k]);
      }
    }
  }

  // Where A and U go, for some of the blocks.
  void extra_words(double share, std::string& text) {
    if (mix_.extra && uniform(0.0, 1.0) < share) {
      text += " A";
      program_.end_a_deg =
          print_number(program_.end_a_deg + uniform(-1.0, 1.0) * log_uniform(1e-3, 60.0), text);
    }
    if (mix_.extra && uniform(0.0, 1.0) < share) {
      text += " U";
      program_.end_u_mm =
          print_number(program_.end_u_mm + uniform(-1.0, 1.0) * log_uniform(1e-3, 20.0), text);
    }
  }

  void extra_line() {
    std::string text =
        uniform(0.0, 1.0) < 0.2 ? "G0" : "G1 F" + std::to_string(log_uniform(600.0, 1e5));
    extra_words(0.7, text);
    add_line(text, 0.0);
    last_ = {};
  }

  void line() {
    const double length = log_uniform(1e-6, mix_.longest_mm);
    Vec d = direction();
    keep_inside(d);
    std::string text;
    line_by({length * d[0], length * d[1], length * d[2]}, text);
    extra_words(0.4, text);
    const double feedrate = feed_word(length, text);
    add_line(text, feedrate);
  }

  // One of a run of short lines, as a finishing pass has them.
  void contour_line() {
    const double turn = log_uniform(1e-4, 0.3);
    if (last_ == Vec{}) {
      contour_step_mm_ = log_uniform(0.02, 3.0);
      contour_feed_mm_min_ = log_uniform(300.0, 2e4);
      last_ = {1.0, 0.0, 0.0};
    }
    double norm = 0.0;
    for (double& x : last_) {
      x += uniform(-turn, turn);
      norm += x * x;
    }
    Vec step{};
    for (std::size_t k = 0; k < 3; ++k) {
      last_[k] /= std::sqrt(norm);
      step[k] = contour_step_mm_ * uniform(0.9, 1.1) * last_[k];
    }
    std::string text;
    line_by(step, text);
    text += " F";
    const double feedrate = print_number(contour_feed_mm_min_, text) / 60.0;
    add_line(text, feedrate);
  }

  void arc() {
    const double radius = log_uniform(1e-3, 0.3 * mix_.longest_mm);
    const double sweep = uniform(0.0, 1.0) < 0.15 ? 2.0 * 3.141592653589793 : uniform(0.05, 6.0);
    const auto plane = static_cast<std::size_t>(uniform(0.0, 2.999));  // normal axis
    const std::size_t first = (plane + 1) % 3;
    const std::size_t second = (plane + 2) % 3;
    const double begin = uniform(0.0, 6.28);
    const bool clockwise = uniform(0.0, 1.0) < 0.5;
    const double end = begin + (clockwise ? -sweep : sweep);
    const bool full = sweep > 6.1;
    const double rise = uniform(0.0, 1.0) < 0.4 ? uniform(-1.0, 1.0) * radius * sweep : 0.0;
    const char* planes[] = {"G19", "G18", "G17"};
    const Vec centre_offset = [&] {
      Vec c{};
      c[first] = -radius * std::cos(begin);
      c[second] = -radius * std::sin(begin);
      return c;
    }();
    std::string text = std::string(planes[plane]) + (clockwise ? " G2" : " G3");
    ArcWords words{.from_mm = here_, .normal = plane, .clockwise = clockwise, .full_turn = full};
    Vec to = here_;
    to[first] += full ? 0.0 : centre_offset[first] + radius * std::cos(end);
    to[second] += full ? 0.0 : centre_offset[second] + radius * std::sin(end);
    to[plane] += rise;
    words.to_mm = here_ = print_axes(to, text);
    for (const std::size_t k : {first, second}) {
      text += std::string(" ") + "IJK"[k];
      words.centre_offset_mm[k] = print_number(centre_offset[k], text);
    }
    extra_words(0.4, text);
    add_stretch(arc_stretch(words), program_.lines() + 1);
    const double feedrate = feed_word(std::hypot(radius * sweep, rise), text);
    add_line(text, feedrate);
    last_ = {};
  }

  void nurbs() {
    const int degree = 1 + static_cast<int>(uniform(0.0, 5.0));
    const int points = degree + 1 + static_cast<int>(uniform(0.0, 6.0));
    const double size = log_uniform(1e-2, 0.1 * mix_.longest_mm);
    const int order = degree + 1;
    std::vector<double> knots(static_cast<std::size_t>(order), 0.0);
    for (int i = 1; i <= points - order; ++i) {
      knots.push_back(knots.back() + std::floor(uniform(1.0, 4.0)));
    }
    knots.insert(knots.end(), static_cast<std::size_t>(order), knots.back() + 1.0);
    // Points march on, so that the curve has no cusp; the march is what bounds its length.
    Vec d = direction();
    keep_inside(d);
    double feedrate = 0.0;
    std::vector<WeightedPoint> control_points;
    const std::size_t first_line = program_.lines() + 1;
    for (int i = 0; i < points; ++i) {
      std::string text = i == 0 ? "G6.2 P" + std::to_string(order) : "";
      text += " K" + std::to_string(knots[static_cast<std::size_t>(i)]);
      Vec to = here_;
      for (std::size_t k = 0; k < 3; ++k) {
        to[k] += i == 0 ? 0.0 : size * (d[k] + uniform(-0.4, 0.4));
      }
      here_ = print_axes(to, text);
      text += " R";
      control_points.push_back(
          {.position_mm = here_, .weight = print_number(uniform(0.3, 3.0), text)});
      feedrate = i == 0 ? feed_word(1.5 * size * points, text) : feedrate;
      add_line(text, i == 0 ? feedrate : 0.0);
    }
    for (int i = 0; i < order; ++i) {
      add_line("K" + std::to_string(knots.back()), 0.0);
    }
    for (Stretch& stretch : nurbs_stretches(control_points, knots)) {
      add_stretch(std::move(stretch), first_line);
    }
    last_ = {};
  }

  std::mt19937_64 random_;
  Mix mix_;
  RandomProgram program_;
  Vec here_{};
  Vec last_{};
  double contour_step_mm_ = 0.0;
  double contour_feed_mm_min_ = 0.0;
};

}  // namespace

double RandomProgram::fastest_mm_s(std::size_t from_line, std::size_t to_line) const {
  double fastest = 0.0;
  const auto [first, last] = std::minmax(from_line, to_line);
  for (std::size_t line = first; line <= last; ++line) {
    fastest = std::max(fastest, feedrate_mm_s[line - 1]);
  }
  return fastest;
}

RandomProgram random_program(std::uint64_t seed, const Mix& mix) {
  return RandomWriter(seed, mix).write();
}

}  // namespace kerf::test
