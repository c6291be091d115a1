// SVG by hand: the few shapes that a plot needs.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kerf::program {

// Pixels, y downwards.
struct Pixel {
  double x = 0.0;
  double y = 0.0;
};

struct PixelBox {
  double left = 0.0;
  double top = 0.0;
  double width = 0.0;
  double height = 0.0;
  [[nodiscard]] double right() const noexcept { return left + width; }
  [[nodiscard]] double bottom() const noexcept { return top + height; }
};

struct Stroke {
  std::string colour = "#333";
  double width = 1.0;
  std::string_view dashes{};  // as SVG has them
};

enum class Anchor : unsigned char { start, middle, end };

struct TextStyle {
  Anchor anchor = Anchor::start;
  double size = 12.0;
  std::string_view colour = "#444";
  bool bold = false;
};

class SvgCanvas {
 public:
  SvgCanvas(double width, double height);

  void line(const Pixel& from, const Pixel& to, const Stroke& stroke);
  // Several lines of one look.
  void polylines(std::span<const std::vector<Pixel>> lines, const Stroke& stroke);
  // A closed line, filled, as thin as it may be beside that.
  void area(std::span<const Pixel> outline, std::string_view colour);
  // From here to end_clip() nothing shows outside of the box.
  void clip(const PixelBox& box);
  void end_clip();
  void box(const PixelBox& box, std::string_view fill, const Stroke& stroke);
  void dot(const Pixel& at, double radius, std::string_view fill, const Stroke& stroke);
  // Any text: what means something to XML is escaped, what it does not allow becomes '?'.
  void text(const Pixel& at, std::string_view words, const TextStyle& style = {});

  // Closes the document.
  [[nodiscard]] std::string take();

 private:
  void stroke(const Stroke& stroke);
  std::string svg_;
  int clips_ = 0;
};

}  // namespace kerf::program
