#include "parser/options/view_options_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include "core/base/joined.h"
#include "parser/options/ini.h"

namespace lentray::parser {
namespace {

/// Displays whose makers' and users' tables agree on grid, pixels and aspect.
struct QuiltDisplay {
  std::string_view name;
  std::uint32_t columns, rows;
  PixelSize size;
  double aspect;
};
constexpr double kWide = 16.0 / 9.0, kTall = 9.0 / 16.0;
constexpr QuiltDisplay kDisplays[] = {
    {"portrait", 8, 6, {3360, 3360}, 0.75},      {"go", 11, 6, {4092, 4092}, kTall},
    {"16-portrait", 11, 6, {5995, 6000}, kTall}, {"27-landscape", 8, 6, {7680, 4320}, kWide},
    {"27-portrait", 12, 4, {7680, 4320}, kTall}, {"32-landscape", 7, 7, {8190, 8190}, kWide},
    {"32-portrait", 11, 6, {8184, 8184}, kTall}};

/// Two numbers with an x between them.
std::optional<PixelSize> pair_of(std::string_view text) {
  PixelSize out;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, out.width);
  if (first.ec != std::errc() || first.ptr == end || (*first.ptr != 'x' && *first.ptr != 'X')) {
    return std::nullopt;
  }
  const auto second = std::from_chars(first.ptr + 1, end, out.height);
  if (second.ec != std::errc() || second.ptr != end) return std::nullopt;
  if (out.width == 0 || out.height == 0) return std::nullopt;
  return out;
}

std::optional<double> clock_of(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// A part of the quilt's width or height.
std::uint32_t share(std::uint64_t pixels, std::uint32_t parts, const char* what) {
  if (pixels >= parts && pixels % parts == 0) return static_cast<std::uint32_t>(pixels / parts);
  throw OptionError("a quilt of " + std::to_string(pixels) + " pixels is not divided into " +
                    std::to_string(parts) + " " + what + ": take " +
                    std::to_string(std::max<std::uint64_t>(1, pixels / parts) * parts) +
                    ", or say Quilt_Tile=WxH");
}

void settle_quilt(RenderOptions& o) {
  ViewOptions& v = o.views;
  const QuiltGrid& quilt = *v.quilt;
  if (o.view) throw OptionError("Quilt= has all views: View= does not go with it");
  if (o.lens.across.value_or(false)) {
    throw OptionError(
        "Quilt= is for displays, whose views lie beside each other: Lens_Direction=across does not "
        "go with it");
  }
  if (v.clocks) throw OptionError("View_Clock= does not go with Quilt=, which is one picture");
  if (v.count && *v.count != quilt.views()) {
    throw OptionError("Views=" + std::to_string(*v.count) + " and a quilt of " +
                      std::to_string(quilt.columns) + " x " + std::to_string(quilt.rows) +
                      " views contradict each other");
  }
  if (v.count && v.cone) {
    throw OptionError(
        "View_Cone= and Views= contradict each other: the views are cameras of a cone, or those of "
        "the lens sheet");
  }
  if (!v.aspect) v.aspect = quilt.display_aspect;
  if (!v.size) {
    const PixelSize whole = quilt.display_size.value_or(
        PixelSize{static_cast<std::uint32_t>(o.width), static_cast<std::uint32_t>(o.height)});
    v.size = {share(whole.width, quilt.columns, "columns"),
              share(whole.height, quilt.rows, "rows")};
  }
  if (v.count) return;
  o.width = v.size->width;
  o.height = v.size->height;
}

}  // namespace

PixelSize size_of(const GivenOption& given) {
  const auto size = pair_of(given.value);
  if (!size) refuse(given, "a size such as 420x560 is expected");
  return *size;
}

QuiltGrid quilt_of(const GivenOption& given) {
  constexpr std::uint32_t kMostSide = 1000;
  for (const QuiltDisplay& display : kDisplays) {
    if (same_word(display.name, given.value)) {
      return {display.columns, display.rows, display.size, display.aspect};
    }
  }
  const auto grid = pair_of(given.value);
  if (!grid || grid->width > kMostSide || grid->height > kMostSide) {
    refuse(given, "columns x rows of views are expected, such as 8x6, or a display: " +
                      core::joined(kDisplays, ", ", &QuiltDisplay::name));
  }
  return {grid->width, grid->height};
}

std::pair<double, double> clocks_of(const GivenOption& given) {
  const std::size_t dots = given.value.find("..");
  const auto first = clock_of(std::string_view(given.value).substr(0, dots));
  const auto last = dots == std::string::npos
                        ? std::nullopt
                        : clock_of(std::string_view(given.value).substr(dots + 2));
  if (!first || !last) refuse(given, "two clocks are expected, such as 0..1");
  return {*first, *last};
}

void settle_views(RenderOptions& o) {
  ViewOptions& v = o.views;
  if (v.quilt) {
    settle_quilt(o);
    return;
  }
  if (v.cone) throw OptionError("View_Cone= is of quilts: there is no Quilt=");
  if (v.aspect) throw OptionError("Quilt_Aspect= is of quilts: there is no Quilt=");
  if (!v.count) {
    if (v.size) throw OptionError("View_Size= is of the pictures of Views= and Quilt=");
    if (v.clocks) throw OptionError("View_Clock= is of the pictures of Views=: say how many");
    return;
  }
  if (o.view) {
    if (*o.view >= *v.count) {
      throw OptionError("there is no view " + std::to_string(*o.view) + ": the views are 0 to " +
                        std::to_string(*v.count - 1));
    }
    if (!v.clocks) return;
    o.clock = view_clock(*v.clocks, *o.view, *v.count);
    o.clock_given = true;
    return;
  }
  if (is_animation(o.animation)) {
    throw OptionError(
        "Views= makes a picture of each view, and so does an animation of each frame: "
        "name one View=");
  }
  o.animation.views = {*v.count, still_clock(o.clock, o.clock_given), v.clocks};
  AnimationOptions first = o.animation;
  first.step = static_cast<int>(*v.count);  // one of them is enough to know
  if (frames_of(first).empty()) {
    throw OptionError("Subset_Start_Frame and Subset_End_Frame leave no view: the views are 0 to " +
                      std::to_string(*v.count - 1));
  }
}

}  // namespace lentray::parser
