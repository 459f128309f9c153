// A page to be printed: pictures on a grid of pixels, bars, and lines with text. What it looks like does not depend on
// the kind of file it goes into.
//
// Units: mm from the page's upper left corner, x to the right, y down; pictures stand at whole pixels of the grid,
// which starts in that corner too and has dpi_x by dpi_y pixels an inch.
// Errors: none. Plain data: one thread changes it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/image/reader.h"

namespace lentray::print {

inline constexpr double kInch = 25.4;  ///< mm

/// As the file stores it, 0 to 1.
struct Colour {
  double red = 0.0, green = 0.0, blue = 0.0;
  bool operator==(const Colour&) const = default;
};
inline constexpr Colour kWhite{1.0, 1.0, 1.0};

struct Point {
  double x = 0.0, y = 0.0;
  bool operator==(const Point&) const = default;
};

struct Box {
  double left = 0.0, top = 0.0, width = 0.0, height = 0.0;
  double right() const { return left + width; }
  double bottom() const { return top + height; }
  bool operator==(const Box&) const = default;
};

/// A line through points, with round ends and joints.
struct Stroke {
  std::vector<Point> points;
  double width = 0.1;
};

/// Grey or RGB of 8 or 16 bits, pixel for pixel.
struct Picture {
  core::StoredImage image;
  std::int64_t column = 0, row = 0;  ///< of its upper left pixel
};

struct Page {
  double width = 0.0, height = 0.0;
  double dpi_x = 0.0, dpi_y = 0.0;
  Colour background = kWhite, ink{};
  std::vector<Picture> pictures{};
  std::vector<Box> bars{};  ///< filled with ink, over the pictures
  std::vector<Stroke> strokes{};
  Box trim{},
      bleed{};  ///< where the sheet is cut, and what is printed beyond; of no width: not told
  std::string title{};

  double pixel_width() const { return kInch / dpi_x; }
  double pixel_height() const { return kInch / dpi_y; }
  /// Of the page as pixels: the nearest whole numbers.
  std::uint32_t columns() const;
  std::uint32_t rows() const;
  /// The ICC profile that its pictures have, all one; empty: sRGB.
  std::string profile() const { return pictures.empty() ? "" : pictures[0].image.profile; }
};

/// An empty page. Its ink is black or white, whichever shows better.
Page page_of(double width, double height, double dpi_x, double dpi_y, Colour background = kWhite);

/// "600 dpi", or "720 x 1440 dpi" where they differ.
std::string dpi_text(double dpi_x, double dpi_y);

enum class Align { left, centre, right };
/// `foot`: of the text on its base line. `height`: of capital letters.
void add_text(Page& page, std::string_view text, Point foot, double height,
              Align align = Align::left);
/// Lines no wider than `width`, as many as it takes; returns how many.
int add_paragraph(Page& page, std::string_view text, Point foot, double height, double width);
inline constexpr double kLineStep = 1.7;  ///< from line to line of a paragraph, in heights

/// Vertical, with a head at either end.
void add_double_arrow(Page& page, Point middle, double length);

/// As seen from the back: left and right change places, in pictures and text as well.
Page mirrored(Page page);
/// By a quarter turn clockwise: what ran from left to right runs down.
Page turned(Page page);

}  // namespace lentray::print
