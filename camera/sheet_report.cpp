#include "camera/sheet_report.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "camera/text.h"
#include "core/base/bounds.h"
#include "core/base/formed.h"

namespace lentray::camera {
namespace {

using core::Vec3;

std::string parallax_text(const Lenticular& sheet, double step) {
  if (!std::isfinite(step)) return "at the eyes, which is no parallax";
  const double sweep = step * (sheet.sheet().lens().pixels - 1.0);
  return "parallax " + format(step) + " pixels a view, " + format(sweep) + " over all views" +
         (std::fabs(step) > kMostParallax ? "; the eye sees jumps" : "");
}

std::string parallax_line(const Lenticular& sheet, const char* which, double depth) {
  return std::string(which) + " visible point " + format(std::fabs(depth)) +
         (depth < 0.0 ? " before" : " behind") +
         " the sheet: " + parallax_text(sheet, parallax(sheet, depth));
}

/// "48 x 36 mm (1.89 x 1.417 in)".
std::string size_text(double width, double height) {
  return format(width) + " x " + format(height) + " mm (" + format(width / 25.4) + " x " +
         format(height / 25.4) + " in)";
}

bool lies_across(const LensRequest& asked) { return asked.across.value_or(false); }

/// Both sides of the upright picture, whose lenses may lie across.
template <class Value>
std::pair<Value, Value> upright(const LensRequest& asked, Value across, Value along) {
  return lies_across(asked) ? std::pair(along, across) : std::pair(across, along);
}

/// By how much the sheet differs from what was asked for.
std::string size_line(const Lenticular& sheet, const LensRequest& asked) {
  const auto [width, height] = upright(asked, sheet.sheet().sheet_width(), sheet.sheet_height());
  const auto [wanted_width, wanted_height] = upright(asked, asked.size->width, asked.size->height);
  const auto [columns, rows] = upright(asked, sheet.width(), sheet.height());
  constexpr double kNothing = 5e-4;  // mm
  const auto differs = [](double by, const char* as, const char* more, const char* less) {
    return std::fabs(by) < kNothing ? std::string("as ") + as + " as asked for"
                                    : brief(std::fabs(by)) + " mm " + (by > 0.0 ? more : less);
  };
  const bool cut =
      !sheet.sheet().is_slanted() && sheet.sheet().columns().is_last_cut(sheet.width());
  return "Rounded to whole pixels, " + std::to_string(columns) + " x " + std::to_string(rows) +
         ", for a sheet of " + format(wanted_width) + " x " + format(wanted_height) +
         " mm: " + differs(width - wanted_width, "wide", "wider", "narrower") + ", " +
         differs(height - wanted_height, "high", "higher", "lower") +
         (cut ? "; the last lens is cut" : "");
}

/// Where the lens data are from.
std::vector<std::string> data_lines(const LensParameters& lens, const LensRequest& asked) {
  std::vector<std::string> out;
  if (asked.sheet_is_nominal) {
    out.push_back("Lens_Sheet=" + asked.sheet_name +
                  " is nominal: its thickness is computed, so measure yours");
  }
  if (asked.print_lpi) {
    out.push_back("Print_LPI=" + format(*asked.print_lpi) + ": lenses of " +
                  format(lens.lenses_per_inch()) + " lpi");
  }
  for (std::string& note : solve(with_lens_pitch(asked)).notes) out.push_back(std::move(note));
  if (lens.surface_radius <= 0.0 || lens.ior <= 1.0) return out;
  const double focus = lens.ior * lens.surface_radius / (lens.ior - 1.0);
  const double off = focus - lens.focal_length;
  // The cone of a far eye's light, as wide as the lens, is not yet or no longer a point.
  const double blur = lens.pitch * std::fabs(off) / focus / lens.pixel_size();
  if (std::fabs(off) <= kLensDataTolerance * lens.focal_length) {
    out.push_back("The lenses focus on the sheet's back");
  } else {
    out.push_back("The lenses focus " + brief(std::fabs(off)) + " mm " +
                  (off > 0.0 ? "behind" : "before") + " the sheet's back: an eye sees " +
                  brief(blur) + " pixels of the print at once");
  }
  return out;
}

/// The model, why it is taken, and what another would do.
std::string model_line(const Lenticular& sheet, const LensRequest& asked) {
  const LensSheet& columns = sheet.sheet();
  const LensModel model = columns.lens().model;
  const std::string error = format(columns.paraxial_error()) + " pixels of the print";
  const std::string off = "off Snell's law by at most " + error;
  std::string out = std::string("Lens model ") + name_of(model);
  if (asked.automatic_model) {
    return out + ", the cheapest within " + format(asked.tolerance.value_or(kModelTolerance)) +
           " pixels: paraxial rays are " + off;
  }
  if (model == LensModel::kParaxial) {
    return out + ": " +
           (columns.lens().is_finite() ? "each view is a picture that any renderer can make, "
                                       : "") +
           "its rays are " + off;
  }
  return out + ": paraxial rays would be " + off +
         (columns.paraxial_error() <= kModelTolerance ? ", so that paraxial would do" : "");
}

/// What a lens and its model are worth.
std::vector<std::string> lens_lines(const Lenticular& sheet, const LensRequest& asked) {
  const LensParameters& lens = sheet.sheet().lens();
  std::vector<std::string> out;
  out.push_back("Lens pitch " + format(lens.pitch) + " mm, " +
                (asked.thickness ? "thickness " : "focal length ") + format(lens.focal_length) +
                " mm, index " + format(lens.ior) + ", model " + name_of(lens.model) +
                ", viewing distance " +
                (lens.is_finite() ? format(lens.view_distance) + " mm" : "infinite"));
  for (std::string& line : data_lines(lens, asked)) out.push_back(std::move(line));
  out.push_back(model_line(sheet, asked));
  for (std::string& line : sheet.model_report()) out.push_back(std::move(line));
  return out;
}

/// What eyes at a finite viewing distance see of the lens in the sheet's middle, by Snell's law.
struct Viewing {
  double angle = 0.0;              ///< degrees
  double zone = 0.0;               ///< width at the eye, mm; infinite with an angle of 180
  double left = 0.0, right = 0.0;  ///< the pixels that the eyes see, from 0 to N in the zone
};

/// The angle, in degrees, whose tangents are larger by 1/cosine.
double widened(double degrees, double cosine) {
  constexpr double kHalf = 0.5 * 3.14159265358979323846 / 180.0;
  return std::atan(std::tan(degrees * kHalf) / cosine) / kHalf;
}

Viewing viewing_of(const Lenticular& sheet) {
  LensParameters lens = sheet.sheet().lens();
  lens.model = LensModel::kPinhole;
  Viewing out;
  out.angle = viewing_angle(lens.print_pitch(), lens.focal_length, lens.ior);
  // The eyes lie on a level line, which runs across slanted lenses at their angle.
  const double cosine = lens.slant_cosine();
  if (lens.slant != 0.0) out.angle = widened(out.angle, cosine);
  if (!lens.is_finite()) return out;
  double edge = 0.0;
  out.zone = slope_of(lens, 0.5 * lens.print_pitch(), edge)
                 ? 2.0 * lens.view_distance * edge / cosine
                 : LensParameters::kInfinity;
  const double oblique = sheet.sheet().eye_slope();
  const double shift = oblique * lens.focal_length / lens.ior;
  const auto pixel_at = [&](double eye) {
    const double offset = offset_of(lens, oblique - eye * cosine / lens.view_distance) - shift;
    return (offset / lens.print_pitch() + 0.5) * lens.pixels;
  };
  out.left = pixel_at(-0.5 * kEyesApart);
  out.right = pixel_at(0.5 * kEyesApart);
  return out;
}

bool are_in_zone(const Viewing& viewing, double pixels) {
  return viewing.right >= 0.0 && viewing.left <= pixels;
}

std::vector<std::string> viewing_lines(const Lenticular& sheet, const LensRequest& asked) {
  const LensParameters& lens = sheet.sheet().lens();
  const Viewing viewing = viewing_of(sheet);
  std::vector<std::string> out;
  out.push_back("Viewing angle " + brief(viewing.angle) + " degrees");
  if (!lens.is_finite()) return out;
  if (std::isfinite(viewing.zone)) {
    out.back() += "; at " + brief(lens.view_distance) + " mm the zone to view it from is " +
                  brief(viewing.zone) + (lies_across(asked) ? " mm high" : " mm wide") +
                  ", and a view " + brief(viewing.zone / lens.pixels) + " mm";
  }
  if (lies_across(asked)) {
    out.emplace_back("Both eyes see the same view: lenses that lie across show two eyes no depth");
    return out;
  }
  if (!are_in_zone(viewing, lens.pixels)) return out;
  if (sheet.sheet().views() > 0) {
    const auto view = [&](double pixel) {
      return std::to_string(
          std::min<std::uint32_t>(static_cast<std::uint32_t>(pixel), sheet.sheet().views() - 1));
    };
    out.push_back("The left eye sees view " + view(viewing.left) + ", the right eye view " +
                  view(viewing.right) + " of 0 to " + view(lens.pixels));
  } else {
    out.push_back(core::formed("The left eye sees place %.1f, the right eye place %.1f of the ",
                               viewing.left, viewing.right) +
                  brief(lens.pixels) + " pixels behind each lens");
  }
  return out;
}

/// What a print still needs to know.
std::vector<std::string> missing_lines(const Lenticular& sheet, const LensRequest& asked) {
  std::string list;
  const auto add = [&list](const char* text) {
    list += (list.empty() ? "" : ", ") + std::string(text);
  };
  if (asked.is_empty() && !asked.print_lpi) add("Lens_Sheet or Lens_LPI (your sheet's)");
  if (!asked.print_dpi) add("Print_DPI (your printer's)");
  if (!asked.size) add("Sheet_Width and Sheet_Height");
  if (!asked.view_distance && sheet.sheet().lens().is_finite()) {
    add(asked.depth == DepthMode::kPrint ? "View_Distance (yours; 40 cm is taken)"
                                         : "View_Distance (yours; this is the scene's camera's)");
  }
  if (list.empty()) return {};
  return {"For a print say also: " + list};
}

}  // namespace

std::vector<std::string> report_of(const Lenticular& sheet, const LensRequest& asked) {
  const LensParameters& lens = sheet.sheet().lens();
  std::vector<std::string> out;
  const auto append = [&out](std::vector<std::string> lines) {
    for (std::string& line : lines) out.push_back(std::move(line));
  };
  const auto size = upright(asked, sheet.sheet().sheet_width(), sheet.sheet_height());
  const auto print = upright(asked, sheet.print_width(), sheet.print_height());
  out.push_back("Lens sheet " + size_text(size.first, size.second) + ", " +
                format(sheet.sheet().counted_lenses()) + " lenses, " +
                format(lens.lenses_per_inch()) + " lpi, " + format(lens.pixels) + " pixels a lens");
  if (lies_across(asked)) {
    out.emplace_back("The lenses lie across: view 0 is seen from below, the last one from above");
  }
  out.push_back("Print " + size_text(print.first, print.second) + ", " +
                format(sheet.print_dpi_x()) + " x " + format(sheet.print_dpi_y()) +
                (lies_across(asked) ? " ppi across and along the lenses, pitch " : " ppi, pitch ") +
                format(lens.print_pitch()) + " mm");
  if (asked.size) out.push_back(size_line(sheet, asked));
  append(lens_lines(sheet, asked));
  append(viewing_lines(sheet, asked));
  append(missing_lines(sheet, asked));
  return out;
}

VisibleDepths visible_depths(const Lenticular& sheet, const SceneProbe& probe) {
  constexpr int kAcross = 48, kDown = 36;
  VisibleDepths range;
  if (!probe) return range;
  for (int down = 0; down < kDown; ++down) {
    for (int across = 0; across < kAcross; ++across) {
      core::Ray ray;
      const double column = std::floor((across + 0.5) * sheet.width() / kAcross) + 0.5;
      const double row = std::floor((down + 0.5) * sheet.height() / kDown) + 0.5;
      if (!sheet.ray(column, row, ray)) continue;
      const auto hit = probe(ray, core::Bounds::kInf);
      if (!hit) {
        range.open = true;
        continue;
      }
      const Vec3 from_sheet = ray.at(hit->distance) - sheet.placement().centre;
      const double depth = core::dot(from_sheet, sheet.placement().normal);
      range.nearest = std::min(range.nearest, depth);
      range.farthest = std::max(range.farthest, depth);
    }
  }
  return range;
}

std::vector<std::string> depth_lines(const Lenticular& sheet, const VisibleDepths& range) {
  std::vector<std::string> out;
  if (range.nearest <= range.farthest) {
    out.push_back(parallax_line(sheet, "Nearest", range.nearest));
    out.push_back(parallax_line(sheet, "Farthest", range.farthest));
  }
  if (range.open) {
    out.push_back("Background, infinitely far: " +
                  (sheet.has_near_eye() ? parallax_text(sheet, parallax(sheet, core::Bounds::kInf))
                                        : std::string("it moves along with the eye")));
  }
  return out;
}

std::vector<std::string> jump_warnings(const Lenticular& sheet, const VisibleDepths& range) {
  double most = 0.0;
  const auto add = [&](double depth) { most = std::max(most, std::fabs(parallax(sheet, depth))); };
  if (range.nearest <= range.farthest) {
    add(range.nearest);
    add(range.farthest);
  }
  if (range.open && sheet.has_near_eye()) add(core::Bounds::kInf);
  if (most <= kMostParallax) return {};
  return {"jumps: things move by up to " + brief(most) +
          " pixels a view, an eye sees that beyond " + brief(kMostParallax) +
          ": Depth=print, or Depth_Budget=" + brief(kMostParallax) +
          ", compresses depth until they do not"};
}

std::vector<std::string> viewing_warnings(const Lenticular& sheet, const LensRequest& asked) {
  const LensParameters& lens = sheet.sheet().lens();
  if (!asked.view_distance || !lens.is_finite() || lies_across(asked)) return {};
  const Viewing viewing = viewing_of(sheet);
  if (!are_in_zone(viewing, lens.pixels)) {
    return {"reversed: at " + format(lens.view_distance) +
            " mm the zone to view the sheet from is " + brief(viewing.zone) +
            " mm wide, less than the " + brief(kEyesApart) +
            " mm between two eyes: depth is reversed; " +
            brief(lens.view_distance * kEyesApart / viewing.zone) + " mm is the least distance"};
  }
  const double view = viewing.zone / lens.pixels;
  if (std::isfinite(view) && view > kEyesApart) {
    return {"flat: at " + format(lens.view_distance) + " mm a view is " + brief(view) +
            " mm wide, more than the " + brief(kEyesApart) +
            " mm between two eyes: there is little depth or none"};
  }
  return {};
}

}  // namespace lentray::camera
