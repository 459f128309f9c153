#include "tools/lentray-views/interlace_plan.h"

#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>
#include <variant>

#include "camera/conversion.h"
#include "camera/text.h"
#include "core/image/orientation.h"
#include "core/image/writer.h"
#include "parser/options/said_options.h"
#include "parser/options/sheet_size.h"
#include "tools/lentray-views/lens_words.h"
#include "tools/lentray-views/slanted.h"
#include "tools/lentray-views/source.h"

namespace lentray::views {
namespace {

using camera::format;
using core::ImageError;

/// What a sheet's camera says of the sheet and the print, and not of a scene.
constexpr std::string_view kOfSheet[] = {"lens.pitch_mm",
                                         "lens.focal_length_mm",
                                         "lens.ior",
                                         "lens.pixels",
                                         "lens.view_distance_mm",
                                         "lens.model",
                                         "lens.slant_deg",
                                         "lens.rays",
                                         "lens.paraxial_error_px",
                                         "lens.eye_miss_px",
                                         "lens.print_pitch_mm",
                                         "lens.lpi",
                                         "lens.lenses",
                                         "lens.views",
                                         "lens.sheet_width_mm",
                                         "lens.sheet_height_mm",
                                         "lens.print_width_mm",
                                         "lens.print_height_mm",
                                         "lens.print_dpi_x",
                                         "lens.print_dpi_y",
                                         "lens.dark_pixels"};

void add_facts(const camera::Properties& properties, Facts& facts) {
  for (const auto& [name, value] : properties) {
    if (std::ranges::find(kOfSheet, name) == std::end(kOfSheet)) continue;
    if (const auto* text = std::get_if<std::string>(&value)) facts[name] = *text;
    if (const auto* number = std::get_if<double>(&value)) facts[name] = exact(*number);
  }
}

/// Of a sheet whose lenses lie across: as its strips are columns.
Size on_its_side(const Arguments& a, Size size) {
  if (a.sheet.across) std::swap(size.width, size.height);
  return size;
}

/// The pixels of the sheet that are asked for, or where nothing says them: a pixel of the pictures is a lens.
Size size_in_pixels(const Arguments& a, double pixels, tool::PhotoReader& reader) {
  if (a.size) return on_its_side(a, *a.size);
  const core::StoredImage first = reader.read(a.pictures[0]);
  const Size size = on_its_side(a, {first.width, first.height});
  const double width = std::round(size.width * pixels);
  if (width > 1e6) {
    throw ImageError(
        "a lens for each of " + std::to_string(size.width) + " " +
        (a.sheet.across ? "rows makes the sheet too high" : "columns makes the sheet too wide") +
        ": --size WxH gives its pixels");
  }
  return {static_cast<std::uint32_t>(width), size.height};
}

/// Of a picture of that size in pixels: the sheet that it fills.
camera::SheetSize sheet_of_pixels(const Arguments& a, const camera::LensRequest& lens, Size size) {
  const camera::LensParameters known = camera::resolve(lens, size.width, nullptr);
  const double width = camera::LensSheet(known, size.width).sheet_width();
  camera::SheetSize out{width, width, a.lens_words.print_dpi_down, false};
  if (a.sheet.aspect) {
    out.height = a.sheet.across ? width * *a.sheet.aspect : width / *a.sheet.aspect;
    out.rows_fill_it = true;
    return out;
  }
  const double dpi = out.dpi_down.value_or(known.print_dpi());
  out.height = size.height * 25.4 / dpi * known.pitch / known.print_pitch();
  return out;
}

std::string size_text(double width, double height) {
  return format(width) + " x " + format(height) + " mm";
}

void describe(const camera::Lenticular& made, const camera::LensRequest& asked, PlannedSheet& out) {
  const camera::LensParameters& lens = made.sheet().lens();
  const auto upright = [&asked](double width, double height) {
    return asked.across.value_or(false) ? size_text(height, width) : size_text(width, height);
  };
  out.lines.push_back(
      "Lens sheet " + upright(made.sheet().sheet_width(), made.sheet_height()) + ", " +
      format(made.sheet().counted_lenses()) + " lenses of " + format(lens.pixels) +
      " pixels; print " + upright(made.print_width(), made.print_height()) + ", " +
      format(made.print_dpi_x()) + " x " + format(made.print_dpi_y()) + " pixels an inch" +
      (asked.across.value_or(false) ? " across and along the lenses, " : ", ") +
      (lens.is_finite() ? "for eyes " + format(lens.view_distance) + " mm away"
                        : std::string("for eyes far away")));
  for (std::string& note : camera::solve(camera::with_lens_pitch(asked)).notes)
    out.lines.push_back(std::move(note));
}

/// A sheet whose lens is known, with all that lentray would say of it.
PlannedSheet known_sheet(const Arguments& a, tool::PhotoReader& reader) {
  parser::RenderOptions words = a.lens_words;
  words.lens.across = a.sheet.across;
  if (a.size_mm) {
    words.sheet_width = a.size_mm->width;
    words.sheet_height = a.size_mm->height;
    parser::fit_picture_to_sheet(words);
    if (a.sheet.across) std::swap(words.width, words.height);
  } else {
    const Size size = size_in_pixels(a, a.sheet.pixels.value_or(1.0), reader);
    words.width = size.width;
    words.height = size.height;
    words.lens.size = sheet_of_pixels(a, words.lens, size);
  }
  constexpr std::int64_t kMost = 1'000'000;
  if (words.width > kMost || words.height > kMost) {
    throw ImageError("the integral image would have " + std::to_string(words.width) + " x " +
                     std::to_string(words.height) + " pixels: a million each way are possible");
  }
  const auto width = static_cast<std::uint32_t>(words.width),
             height = static_cast<std::uint32_t>(words.height);
  // As lentray chooses it for a camera.
  if (!words.lens.model && words.lens.view_distance.value_or(0.0) > 0.0) {
    words.lens.model = camera::LensModel::kParaxial;
  }
  camera::Projection window;
  window.right = {words.lens.size->width, 0, 0};
  window.up = {0, words.lens.size->height, 0};
  const camera::Sheet made = camera::sheet_of_statement(
      window, words.lens, width, height,
      [](const core::Ray&, double) { return std::optional<camera::ProbeHit>(); });
  PlannedSheet out;
  out.plan.pixels = made.camera->sheet().lens().pixels;
  out.plan.width = width;
  out.plan.height = height;
  add_facts(made.camera->describe(), out.about.facts);
  out.about.dpi_x = made.camera->print_dpi_x();
  out.about.dpi_y = made.camera->print_dpi_y();
  out.plan.slanted =
      slanted_sheet(made.camera->sheet().lens(), width, height,
                    made.camera->sheet().sheet_width() / made.camera->sheet_height());
  for (const std::string& warning : made.camera->warnings()) reader.warn(warning);
  describe(*made.camera, words.lens, out);
  return out;
}

PlannedSheet sheet_like(const Arguments& a, tool::PhotoReader& reader) {
  if (a.size || a.size_mm) throw ImageError("--size and --like contradict each other");
  const Integral like = open_integral(a.like, a.sheet, reader);
  PlannedSheet out;
  out.plan.slanted = like.sheet.slanted;
  out.plan.pixels = like.sheet.lenses.lens().pixels;
  out.plan.width = like.image.width;
  out.plan.height = like.image.height;
  out.is_across = like.is_across;
  out.about.facts = like.facts;
  out.about.dpi_x = tool::number_of(like.image.attributes, "XResolution");
  out.about.dpi_y = tool::number_of(like.image.attributes, "YResolution");
  return out;
}

/// Pixels a lens, and perhaps words that do not make a lens.
PlannedSheet sheet_of_pixels_alone(const Arguments& a, tool::PhotoReader& reader) {
  PlannedSheet out;
  Facts& facts = out.about.facts;
  out.plan.pixels = *a.sheet.pixels;
  const Size size = size_in_pixels(a, out.plan.pixels, reader);
  out.plan.width = size.width;
  out.plan.height = size.height;
  facts["lens.pixels"] = exact(out.plan.pixels);
  if (a.sheet.focal_length) facts["lens.focal_length_mm"] = exact(*a.sheet.focal_length);
  if (a.sheet.ior) facts["lens.ior"] = exact(*a.sheet.ior);
  if (a.sheet.view_distance) facts["lens.view_distance_mm"] = exact(*a.sheet.view_distance);
  if (a.sheet.model) facts["lens.model"] = camera::name_of(*a.sheet.model);
  if (a.sheet.slant && *a.sheet.slant != 0.0) {
    out.plan.slanted = slanted_sheet(out.plan.pixels, *a.sheet.slant, size.width, size.height,
                                     said_aspect(a.sheet));
    facts["lens.slant_deg"] = exact(camera::slant_degrees(out.plan.slanted->lens()));
  }
  return out;
}

PlannedSheet sheet_of_words(const Arguments& a, tool::PhotoReader& reader) {
  if (!says_pitch(a.lens_words)) return sheet_of_pixels_alone(a, reader);
  try {
    return known_sheet(a, reader);
  } catch (const camera::CameraError& error) {
    throw parser::OptionError(parser::with_said(error.what(), a.lens_words, error.about()));
  }
}

}  // namespace

std::string exact(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

PlannedSheet planned_sheet(const Arguments& a, tool::PhotoReader& reader) {
  PlannedSheet out = a.like.empty() ? sheet_of_words(a, reader) : sheet_like(a, reader);
  out.is_across |= a.sheet.across;
  if (out.is_across) {
    out.about.facts["lens.lenses_lie"] = "across";
    out.about.orientation = core::kTurned;
  }
  out.plan.views = static_cast<std::uint32_t>(a.pictures.size());
  out.plan.filter = a.filter;
  out.about.description = "integral image for a lenticular sheet";
  if (a.is_loop) out.about.facts["views.motion"] = *a.is_loop ? "loop" : "sway";
  out.lines.push_back(motion_line(a, out.is_across));
  return out;
}

void warn_of_stretch(const Arguments& a, const PlannedSheet& sheet, tool::PhotoReader& reader) {
  constexpr double kNoticeable = 0.02;
  if (!a.size && !a.size_mm) return;
  const core::StoredImage first = reader.read(a.pictures[0]);
  const Facts facts = facts_of(first);
  // A pixel a lens is no shape.
  const std::uint32_t rows = sheet.is_across ? first.width : first.height;
  if (facts.contains("lens.view") || rows == sheet.plan.height) return;
  const double high = tool::number_of(sheet.about.facts, "lens.sheet_height_mm");
  const double of_side =
      high > 0.0 ? tool::number_of(sheet.about.facts, "lens.sheet_width_mm") / high
                 : said_aspect(a.sheet).value_or(double(sheet.plan.width) / sheet.plan.height);
  const double of_sheet = sheet.is_across ? 1.0 / of_side : of_side;
  const double of_picture = double(first.width) / first.height;
  const double stretch = of_sheet / of_picture - 1.0;
  if (std::fabs(stretch) <= kNoticeable) return;
  reader.warn("'" + a.pictures[0].string() + "' is " + camera::brief(of_picture) +
              " times as wide as high, the sheet " + camera::brief(of_sheet) +
              " times: things look " + camera::brief(100.0 * std::fabs(stretch)) + " % too " +
              (stretch > 0.0 ? "wide" : "narrow"));
}

std::string motion_line(const Arguments& a, bool is_across) {
  const auto name = [](const std::filesystem::path& path) {
    return "'" + path.filename().string() + "'";
  };
  struct Ends {
    const char *first, *last, *edge;
  };
  constexpr Ends kEnds[] = {{"the right", "the left", "right"},
                            {"the left", "the right", "left"},
                            {"below", "above", "lower"},
                            {"above", "below", "upper"}};
  const Ends& ends = kEnds[(is_across ? 2 : 0) + (a.from_left ? 1 : 0)];
  return "The first picture, " + name(a.pictures.front()) + ", is seen from " + ends.first +
         ", the last, " + name(a.pictures.back()) + ", from " + ends.last +
         ": they come in order as the sheet's " + ends.edge + " edge turns away from the eye";
}

void check_no_integral(const core::StoredImage& picture, const std::string& name) {
  if (!tool::is_integral(facts_of(picture))) return;
  throw ImageError("'" + name +
                   "' is an integral image already, and interlacing tears its strips apart: "
                   "lentray-views '" +
                   name + "' --all takes its views out of it; --take-any takes it as it is");
}

}  // namespace lentray::views
