#include "parser/options/sheet_size.h"

#include <cmath>
#include <limits>

#include "camera/lens_request.h"
#include "camera/text.h"
#include "parser/options/said_options.h"

namespace lentray::parser {
namespace {

using camera::format;

/// What sets the number of pixels, for messages.
std::string resolution_text(const RenderOptions& o) {
  if (o.lens.print_dpi) return format(*o.lens.print_dpi) + " pixels an inch";
  return format(*o.lens.pixels) + " pixels a lens";
}

/// The whole number next to it.
std::int64_t whole(const RenderOptions& o, double exact, const char* what) {
  constexpr double kMost = std::numeric_limits<std::int32_t>::max();
  const std::vector<std::string> names{"Sheet_Width", "Sheet_Height", "Sheet_Size", "Print_DPI",
                                       "Lens_Pixels"};
  if (!(exact <= kMost)) {
    throw OptionError(with_said(std::string("the print would have ") + format(exact) + " " + what +
                                    ": 2147483647 are the most; a smaller sheet or Print_DPI has "
                                    "fewer",
                                o, names));
  }
  if (exact < 0.5) {
    throw OptionError(with_said(std::string("the print would have less than one of its ") + what +
                                    ": a larger sheet or Print_DPI has more",
                                o, names));
  }
  return std::llround(exact);
}

/// A number of pixels that was given too.
void expect(const RenderOptions& o, std::int64_t given, double exact, const char* name, double mm,
            const std::string& resolution) {
  constexpr double kAPixel = 1.0 + 1e-6;
  if (std::fabs(static_cast<double>(given) - exact) <= kAPixel) return;
  throw OptionError(
      with_said(std::string(name) + "=" + std::to_string(given) + " and Sheet_" + name + "=" +
                    format(mm) + "mm at " + resolution + " (" + format(std::round(exact)) +
                    " pixels) contradict each other: leave out one of them",
                o, {name, std::string("Sheet_") + name, "Sheet_Size", "Print_DPI", "Lens_Pixels"}));
}

/// A side of the upright picture: pixels, whether they were given, mm, and how options and pixels are called.
struct Side {
  std::int64_t& pixels;
  const bool is_given;
  const double mm;
  const char *name, *lines;
};

/// The lenses' pitch, N and the first number of Print_DPI are those of `across` the lenses.
void fit(RenderOptions& o, const Side& across, const Side& along) {
  camera::SheetSize size{across.mm, along.mm, o.print_dpi_down, false};
  const bool resolved = o.lens.print_dpi || o.lens.pixels;
  if (!resolved && (across.is_given || along.is_given)) {
    const double pitch = camera::solve(o.lens).pitch;
    const Side& given = across.is_given ? across : along;
    o.lens.pixels = static_cast<double>(given.pixels) / given.mm * pitch;
  }
  size.rows_fill_it = along.is_given && (across.is_given || resolved) && !o.lens.print_dpi;
  const camera::ExactPixels exact = camera::exact_pixels(o.lens, size);
  if (!across.is_given) {
    across.pixels = whole(o, exact.columns, across.lines);
  } else if (resolved) {
    expect(o, across.pixels, exact.columns, across.name, across.mm, resolution_text(o));
  }
  if (!along.is_given) {
    along.pixels = whole(o, exact.rows, along.lines);
  } else if (o.lens.print_dpi) {
    const double down = o.print_dpi_down.value_or(*o.lens.print_dpi);
    expect(o, along.pixels, exact.rows, along.name, along.mm, format(down) + " pixels an inch");
  }
  o.lens.size = size;
}

}  // namespace

void fit_picture_to_sheet(RenderOptions& o) {
  if (o.sheet_width.has_value() != o.sheet_height.has_value()) {
    throw OptionError(with_said(
        std::string(o.sheet_width ? "Sheet_Width needs Sheet_Height"
                                  : "Sheet_Height needs Sheet_Width") +
            " too: they are the sizes of the lens sheet. Sheet_Size=A5, or =100x75mm, gives both",
        o, {"Sheet_Width", "Sheet_Height"}));
  }
  if (!o.sheet_width) {
    if (!o.print_dpi_down) return;
    throw OptionError(with_said(
        "a second number of Print_DPI, for pixels downwards, needs Sheet_Width and Sheet_Height", o,
        {"Print_DPI"}));
  }
  try {
    const Side width{o.width, o.width_given, *o.sheet_width, "Width", "columns"},
        height{o.height, o.height_given, *o.sheet_height, "Height", "rows"};
    const bool is_across = o.lens.across.value_or(false);
    fit(o, is_across ? height : width, is_across ? width : height);
  } catch (const camera::CameraError& error) {
    throw OptionError(with_said(error.what(), o, error.about()));
  }
}

}  // namespace lentray::parser
