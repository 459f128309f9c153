#include "tools/lentray-views/preview.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "camera/text.h"
#include "core/image/writer.h"
#include "tools/common/page_text.h"
#include "tools/lentray-views/join.h"
#include "tools/lentray-views/page_sources.h"
#include "tools/lentray-views/page_strips.h"
#include "tools/lentray-views/slanted.h"

namespace lentray::views {
namespace {

using camera::format;
using nlohmann::json;
using tool::html_text;

/// The full angle in which a lens shows its own strip, in degrees.
double viewing_angle(const camera::LensParameters& lens) {
  double slope = 0.0;
  if (!camera::slope_of(lens, 0.5 * lens.print_pitch(), slope)) return 180.0;
  return 2.0 * std::atan(slope) * 180.0 / std::numbers::pi;
}

/// To look at, not to compute with.
std::string shown(double value) { return format(std::round(100.0 * value) / 100.0); }

std::string page_tile(const std::string& name, const std::string& value) {
  return "<div><dt>" + name + "</dt><dd>" + html_text(value) + "</dd></div>\n";
}

std::string page_tiles(const Integral& integral) {
  const camera::LensSheet& sheet = integral.sheet.lenses;
  const camera::LensParameters& lens = sheet.lens();
  const double width = sheet.sheet_width(), height = width / integral.sheet.aspect;
  return page_tile("lenses", shown(sheet.counted_lenses())) +
         page_tile("pixels a lens", shown(lens.pixels)) +
         page_tile("sheet, mm", shown(integral.is_across ? height : width) + " \xC3\x97 " +
                                    shown(integral.is_across ? width : height)) +
         page_tile("made for an eye at",
                   lens.is_finite() ? shown(lens.view_distance) + " mm" : "infinity") +
         page_tile("viewing angle", shown(viewing_angle(lens)) + "\xC2\xB0");
}

/// What the strips are, where they are not the pixels of the picture.
std::string change_of(const PageStrips& strips, const Integral& integral) {
  std::string out;
  if (strips.quality > 0) out += "JPEG of quality " + std::to_string(strips.quality);
  if (strips.rows != integral.image.height) {
    out += ", " + std::to_string(integral.image.height) + " rows scaled to " +
           std::to_string(strips.rows);
  }
  return out;
}

json matrices() {
  json out = json::array();
  for (const bool is_left : {true, false}) out.push_back(matrix_of(Anaglyph::kDubois, is_left));
  return out;
}

json page_data(const Integral& integral, const Arguments& a, const PageStrips& strips) {
  const camera::LensSheet& sheet = integral.sheet.lenses;
  const camera::LensParameters& lens = sheet.lens();
  const Eye eye = eye_of(a, integral);
  return {{"lenses", sheet.lenses()},
          {"count", sheet.lens_count()},
          {"columns", sheet.width()},
          {"pixels", lens.pixels},
          {"pitch", lens.pitch},
          {"focal_length", lens.focal_length},
          {"ior", lens.ior},
          {"is_paraxial", lens.model == camera::LensModel::kParaxial},
          {"first", sheet.column(0).centre},
          {"pixel_size", lens.pixel_size()},
          {"view_distance", lens.is_finite() ? lens.view_distance : 0.0},
          {"viewing_angle", viewing_angle(lens)},
          {"height_mm", sheet.sheet_width() / integral.sheet.aspect},
          {"is_across", integral.is_across},
          {"angle", eye.angle},
          {"distance", eye.distance},
          {"eyes", a.eyes},
          {"anaglyph", matrices()},
          {"rows", strips.rows},
          {"strips", strips.links}};
}

}  // namespace

Preview preview_of(const Integral& integral, const Arguments& arguments) {
  refuse_slanted(integral.sheet, integral.name, "a page shows the views of upright ones only");
  need_optics(integral.sheet, integral.name);
  need_aspect(integral.sheet, integral.name);
  const auto limit = static_cast<std::size_t>(std::min(arguments.page_limit, 2000.0) * 1e6);
  const std::string title =
      html_text(tool::cut_text(std::filesystem::path(integral.name).filename().string(), 300)) +
      " through its lenses";
  const auto whole = [&](const PageStrips& strips) {
    const std::string change = change_of(strips, integral);
    const std::string note =
        change.empty()
            ? ""
            : "<p class=\"is-warning note\">For the size of this page: " + change + ".</p>";
    const std::string body = tool::filled(
        kPageHtml, {{"title", title}, {"tiles", page_tiles(integral)}, {"note", note}});
    return tool::page_of({"lentray-views", title, kPageCss, body,
                          tool::script_text(page_data(integral, arguments, strips)), kPageJs});
  };
  constexpr std::size_t kNote = 200;
  const std::size_t frame = whole({{}, integral.image.height, 0}).size() + kNote;
  if (frame >= limit) {
    throw core::ImageError("a page takes " + std::to_string(frame / 1000 + 1) +
                           " kB before it has a picture: raise --page-limit");
  }
  const PageStrips strips = page_strips(integral.image, integral.sheet.lenses, limit - frame);
  const std::string change = change_of(strips, integral);
  Preview preview{whole(strips), {}};
  preview.told = std::to_string((preview.page.size() + 999) / 1000) + " kB, " +
                 (change.empty() ? "the picture's own pixels" : change);
  return preview;
}

}  // namespace lentray::views
