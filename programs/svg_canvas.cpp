#include "programs/svg_canvas.hpp"

#include <iterator>
#include <utility>

#include <spdlog/fmt/fmt.h>

namespace kerf::program {

namespace {

// Bytes from 0x80 pass: a file name in UTF-8 is what it is. Those that are not UTF-8 would make the
// document unreadable.
bool is_utf8(std::string_view text) {
  std::size_t follow = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (follow > 0) {
      if ((byte & 0xC0U) != 0x80U) {
        return false;
      }
      --follow;
    } else if (byte >= 0x80U) {
      follow = byte >= 0xF5U ? 9 : byte >= 0xF0U ? 3 : byte >= 0xE0U ? 2 : byte >= 0xC2U ? 1 : 9;
      if (follow == 9) {
        return false;
      }
    }
  }
  return follow == 0;
}

std::string escaped(std::string_view words) {
  const bool utf8 = is_utf8(words);
  std::string text;
  for (const char c : words) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '<') {
      text += "&lt;";
    } else if (c == '>') {
      text += "&gt;";
    } else if (c == '&') {
      text += "&amp;";
    } else if (byte < 0x20U || byte == 0x7FU || (byte >= 0x80U && !utf8)) {
      text += '?';
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
  fmt::format_to(std::back_inserter(svg_), " stroke=\"{}\" stroke-width=\"{:.2f}\"", stroke.colour,
                 stroke.width);
  if (!stroke.dashes.empty()) {
    fmt::format_to(std::back_inserter(svg_), " stroke-dasharray=\"{}\"", stroke.dashes);
  }
}

void SvgCanvas::line(const Pixel& from, const Pixel& to, const Stroke& stroke_with) {
  fmt::format_to(std::back_inserter(svg_),
                 "<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\"", from.x, from.y,
                 to.x, to.y);
  stroke(stroke_with);
  svg_ += "/>\n";
}

void SvgCanvas::polylines(std::span<const std::vector<Pixel>> lines, const Stroke& stroke_with) {
  svg_ += "<path fill=\"none\" stroke-linejoin=\"round\" stroke-linecap=\"round\"";
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

void SvgCanvas::box(const PixelBox& box, std::string_view fill, const Stroke& stroke_with) {
  fmt::format_to(std::back_inserter(svg_),
                 "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"",
                 box.left, box.top, box.width, box.height, fill);
  stroke(stroke_with);
  svg_ += "/>\n";
}

void SvgCanvas::dot(const Pixel& at, double radius, std::string_view fill,
                    const Stroke& stroke_with) {
  fmt::format_to(std::back_inserter(svg_),
                 "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" fill=\"{}\"", at.x, at.y, radius,
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
