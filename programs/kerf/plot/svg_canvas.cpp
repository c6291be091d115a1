#include "programs/kerf/plot/svg_canvas.hpp"

#include <iterator>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "programs/kerf/io/visible_text.hpp"

namespace kerf::program {

namespace {

std::string escaped(std::string_view words) {
  std::string text;
  for (const char c : visible(words)) {
    if (c == '<') {
      text += "&lt;";
    } else if (c == '>') {
      text += "&gt;";
    } else if (c == '&') {
      text += "&amp;";
    } else {
      text += c;
    }
  }
  return text;
}

std::string_view name_of(Anchor anchor) {
  switch (anchor) {
    case Anchor::middle:
      return "middle";
    case Anchor::end:
      return "end";
    case Anchor::start:
      break;
  }
  return "start";
}

}  // namespace

SvgCanvas::SvgCanvas(double width, double height) {
  svg_ = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\" font-family=\"Helvetica, Arial, sans-serif\">\n"
      "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"#fff\"/>\n",
      width, height);
}

void SvgCanvas::stroke(const Stroke& stroke) {
  fmt::format_to(std::back_inserter(svg_), R"( stroke="{}" stroke-width="{:.2f}")", stroke.colour,
                 stroke.width);
  if (!stroke.dashes.empty()) {
    fmt::format_to(std::back_inserter(svg_), R"( stroke-dasharray="{}")", stroke.dashes);
  }
}

void SvgCanvas::line(const Pixel& from, const Pixel& to, const Stroke& stroke_with) {
  fmt::format_to(std::back_inserter(svg_),
                 R"(<line x1="{:.2f}" y1="{:.2f}" x2="{:.2f}" y2="{:.2f}")", from.x, from.y, to.x,
                 to.y);
  stroke(stroke_with);
  svg_ += "/>\n";
}

void SvgCanvas::polylines(std::span<const std::vector<Pixel>> lines, const Stroke& stroke_with) {
  svg_ += R"(<path fill="none" stroke-linejoin="round" stroke-linecap="round")";
  stroke(stroke_with);
  svg_ += " d=\"";
  for (const std::vector<Pixel>& line : lines) {
    char command = 'M';
    for (const Pixel& point : line) {
      fmt::format_to(std::back_inserter(svg_), "{}{:.1f} {:.1f}", command, point.x, point.y);
      command = 'L';
    }
  }
  svg_ += "\"/>\n";
}

void SvgCanvas::area(std::span<const Pixel> outline, std::string_view colour) {
  fmt::format_to(std::back_inserter(svg_),
                 R"(<path fill="{0}" fill-opacity="0.45" stroke-linejoin="round")", colour);
  stroke({.colour = std::string(colour), .width = 0.5});
  svg_ += " d=\"";
  char command = 'M';
  for (const Pixel& point : outline) {
    fmt::format_to(std::back_inserter(svg_), "{}{:.1f} {:.1f}", command, point.x, point.y);
    command = 'L';
  }
  svg_ += "Z\"/>\n";
}

void SvgCanvas::clip(const PixelBox& box) {
  ++clips_;
  fmt::format_to(std::back_inserter(svg_),
                 "<clipPath id=\"clip{0}\"><rect x=\"{1:.2f}\" y=\"{2:.2f}\" width=\"{3:.2f}\" "
                 "height=\"{4:.2f}\"/></clipPath>\n<g clip-path=\"url(#clip{0})\">\n",
                 clips_, box.left, box.top, box.width, box.height);
}

void SvgCanvas::end_clip() {
  svg_ += "</g>\n";
}

void SvgCanvas::box(const PixelBox& box, std::string_view fill, const Stroke& stroke_with) {
  fmt::format_to(std::back_inserter(svg_),
                 R"(<rect x="{:.2f}" y="{:.2f}" width="{:.2f}" height="{:.2f}" fill="{}")",
                 box.left, box.top, box.width, box.height, fill);
  stroke(stroke_with);
  svg_ += "/>\n";
}

void SvgCanvas::dot(const Pixel& at, double radius, std::string_view fill,
                    const Stroke& stroke_with) {
  fmt::format_to(std::back_inserter(svg_),
                 R"(<circle cx="{:.2f}" cy="{:.2f}" r="{:.2f}" fill="{}")", at.x, at.y, radius,
                 fill);
  stroke(stroke_with);
  svg_ += "/>\n";
}

void SvgCanvas::text(const Pixel& at, std::string_view words, const TextStyle& style) {
  fmt::format_to(std::back_inserter(svg_),
                 "<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.0f}\" text-anchor=\"{}\" "
                 "fill=\"{}\"{}>{}</text>\n",
                 at.x, at.y, style.size, name_of(style.anchor), style.colour,
                 style.bold ? " font-weight=\"bold\"" : "", escaped(words));
}

std::string SvgCanvas::take() {
  svg_ += "</svg>\n";
  return std::move(svg_);
}

}  // namespace kerf::program
