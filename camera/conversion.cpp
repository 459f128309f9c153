#include "camera/conversion.h"

#include <algorithm>
#include <cmath>

#include "camera/composition_report.h"
#include "camera/depth_budget.h"
#include "camera/projected.h"
#include "camera/sheet_collisions.h"
#include "camera/sheet_report.h"
#include "camera/sheet_sanity.h"
#include "camera/slanted_lenticular.h"
#include "camera/text.h"
#include "camera/thick_lenticular.h"
#include "core/base/bounds.h"

namespace lentray::camera {
namespace {

using core::Vec3;

/// The sheet's axes from a camera's vectors; the normal is on direction's side.
SheetPlacement placement_of(const Projection& p) {
  const double width = core::length(p.right), height = core::length(p.up);
  if (!(width > 0.0) || !(height > 0.0) || !std::isfinite(width) || !std::isfinite(height)) {
    throw CameraError("a lens sheet needs `right` and `up` vectors of some length");
  }
  SheetPlacement place;
  place.right = p.right / width;
  place.up = p.up / height;
  if (std::fabs(core::dot(place.right, place.up)) > 1e-6) {
    throw CameraError("`right` is not perpendicular to `up`, so this camera has no lens sheet");
  }
  const Vec3 across = core::normalized(core::cross(place.right, place.up));
  const double along = core::dot(across, p.direction);
  if (std::fabs(along) <= 1e-9 * core::length(p.direction)) {
    throw CameraError("`direction` lies in the picture plane, so this camera has no lens sheet");
  }
  place.normal = along > 0.0 ? across : -across;
  place.centre = p.location;
  place.width = width;
  place.height = height;
  place.eye_slope_x = core::dot(p.direction, place.right) / std::fabs(along);
  place.eye_slope_y = core::dot(p.direction, place.up) / std::fabs(along);
  // A camera set up by look_at is straight up to rounding; its sheet is exactly so.
  if (std::fabs(place.eye_slope_x) < 1e-12) place.eye_slope_x = 0.0;
  if (std::fabs(place.eye_slope_y) < 1e-12) place.eye_slope_y = 0.0;
  return place;
}

/// What a coarse grid of the camera's rays meets, in multiples of `direction`, sorted.
struct CoarseDepths {
  std::vector<double> depths;
  bool has_background = false;
  std::optional<double> median() const {
    if (depths.empty()) return std::nullopt;
    return depths[depths.size() / 2];
  }
};

CoarseDepths coarse_depths(ProjectedKind kind, const Projection& p, const Vec3& normal,
                           const SceneProbe& probe) {
  constexpr std::uint32_t kColumns = 32, kRows = 24;
  CoarseDepths out;
  if (!probe) return out;
  const Projected camera(kind, p, {}, kColumns, kRows);
  for (std::uint32_t row = 0; row < kRows; ++row) {
    for (std::uint32_t column = 0; column < kColumns; ++column) {
      core::Ray ray;
      camera.ray(column + 0.5, row + 0.5, ray);
      if (const auto hit = probe(ray, core::Bounds::kInf)) {
        out.depths.push_back(hit->distance * core::dot(ray.direction, normal) /
                             core::dot(p.direction, normal));
      } else {
        out.has_background = true;
      }
    }
  }
  std::ranges::sort(out.depths);
  return out;
}

/// A distance along direction, in scene units, and a line that says where it is from.
struct FoundDistance {
  double distance = 0.0;
  std::string line;
};

/// Where the camera looks. Nothing where it looks at nothing.
std::optional<FoundDistance> usual_distance(const Projection& p,
                                            const std::optional<double>& median) {
  if (p.look_at_distance && *p.look_at_distance > 0.0) {
    const double distance = *p.look_at_distance;
    return FoundDistance{distance,
                         "Sheet distance " + format(distance) + ", where the camera looks at"};
  }
  if (!median) return std::nullopt;
  const double distance = *median * core::length(p.direction);
  return FoundDistance{distance,
                       "Sheet distance " + format(distance) +
                           ", the median depth of what the camera sees (it has no look_at)"};
}

double checked_distance(double distance) {
  if (distance > 0.0 && std::isfinite(distance)) return distance;
  throw CameraError("Sheet_Distance must be greater than 0", {"Sheet_Distance"});
}

/// The sheet's distance.
FoundDistance sheet_distance(const Projection& p, const Conversion& conversion, const Vec3& normal,
                             const SceneProbe& probe) {
  if (const auto& asked = conversion.sheet_distance)
    return {checked_distance(*asked), "Sheet distance " + format(*asked) + ", as asked for"};
  std::optional<double> median;
  if (!p.look_at_distance || !(*p.look_at_distance > 0.0))
    median = coarse_depths(ProjectedKind::kPerspective, p, normal, probe).median();
  const auto usual = usual_distance(p, median);
  if (!usual) {
    throw CameraError(
        "the camera has no look_at and sees nothing, so the sheet's distance is "
        "unknown: give Sheet_Distance");
  }
  checked_distance(usual->distance);
  return *usual;
}

/// The sheet's height in mm, where one was asked for: to a whole number of the print's rows.
void set_height(const LensParameters& lens, const SheetSize& size, std::uint32_t rows,
                SheetPlacement& place) {
  const double larger = lens.print_pitch() / lens.pitch;
  place.height_mm = size.rows_fill_it
                        ? size.height
                        : rows * 25.4 / size.dpi_down.value_or(lens.print_dpi()) / larger;
}

/// A sheet that is not as wide as asked for is of another lens than the picture's columns are.
void check_width(const Lenticular& camera, const LensRequest& asked) {
  const LensSheet& sheet = camera.sheet();
  const bool has_scenes_eye = sheet.lens().is_finite() && !asked.view_distance;
  const double pixel = sheet.sheet_width() / sheet.width();
  if (has_scenes_eye || std::fabs(sheet.sheet_width() - asked.size->width) <= 1.5 * pixel) return;
  throw CameraError(
      "the scene's own lens makes the sheet " + format(sheet.sheet_width()) + " mm wide, not " +
          format(asked.size->width) +
          " mm: give its lens data and view_distance as options, from which the picture's "
          "columns follow",
      {"Sheet_Width", "Sheet_Height", kCameraToo});
}

/// The picture fills the sheet, so one of another shape is stretched.
void warn_of_shape(const Projection& p, const LensRequest& asked, std::uint32_t width,
                   std::uint32_t height, std::vector<std::string>& warnings) {
  constexpr double kNoticeable = 0.005;
  double of_picture = core::length(p.right) / core::length(p.up);
  double of_sheet = asked.size->width / asked.size->height;
  const bool square = std::fabs(width / (height * of_sheet) - 1.0) <= kNoticeable;
  if (asked.across.value_or(false)) {
    of_picture = 1.0 / of_picture;
    of_sheet = 1.0 / of_sheet;
  }
  const double stretch = of_sheet / of_picture - 1.0;
  if (std::fabs(stretch) <= kNoticeable) return;
  warnings.push_back("the camera's picture is " + brief(of_picture) +
                     " times as wide as high, the sheet " + brief(of_sheet) +
                     " times: things look " + brief(100.0 * std::fabs(stretch)) + " % too " +
                     (stretch > 0.0 ? "wide" : "narrow") + " (" +
                     (square ? std::string("right x*image_width/image_height")
                             : "up y right " + brief(of_sheet) + "*x") +
                     " in the camera would fit)");
}

/// What Lens_Model=auto stands for.
void choose_model(const LensRequest& asked, double eye_slope, std::uint32_t width,
                  LensParameters& lens) {
  if (!asked.automatic_model) return;
  lens.model =
      LensSheet(lens, width, eye_slope).cheapest_model(asked.tolerance.value_or(kModelTolerance));
}

std::unique_ptr<Lenticular> make_sheet(const LensParameters& lens, const SheetPlacement& place,
                                       std::uint32_t width, std::uint32_t height) {
  if (lens.slant != 0.0) {
    return std::make_unique<SlantedLenticular>(lens, place, width, height);
  }
  if (lens.model == LensModel::kThick) {
    return std::make_unique<ThickLenticular>(lens, place, width, height);
  }
  return std::make_unique<Lenticular>(lens, place, width, height);
}

/// Squares of all lengths can be computed.
void check_computable(const SheetPlacement& place) {
  constexpr double kFarthest = 1e30;  // scene units
  for (const double size : {place.width, place.height, 1.0 / place.width, 1.0 / place.height,
                            place.front, core::length(place.centre)}) {
    if (!(std::fabs(size) < kFarthest)) {
      throw CameraError("the sheet is too large, too small or too far away to be computed",
                        {"Sheet_Distance", "Lens_Front", kCameraToo});
    }
  }
}

void append(std::vector<std::string> lines, std::vector<std::string>& out) {
  for (std::string& line : lines) out.push_back(std::move(line));
}

/// Depth compressed to the budget, by the viewer's own eye.
void keep_budget(const SheetPlacement& place, const DepthBudget& budget, std::uint32_t width,
                 std::uint32_t height, const SceneProbe& probe, LensParameters& lens,
                 std::vector<std::string>& report) {
  FittedDepth fitted = fit_depth(
      budget, lens, [&](const LensParameters& l) { return make_sheet(l, place, width, height); },
      probe);
  lens.depth_factor = fitted.factor;
  append(std::move(fitted.report), report);
}

/// What is to be said of a sheet.
void report_on(const LensRequest& asked, const SceneProbe& probe, Sheet& sheet) {
  if (asked.size) check_width(*sheet.camera, asked);
  if (!sheet.composed) {
    const VisibleDepths seen = visible_depths(*sheet.camera, probe);
    append(depth_lines(*sheet.camera, seen), sheet.report);
    if (asked.has_print_data()) append(jump_warnings(*sheet.camera, seen), sheet.warnings);
  }
  const LensSheet& lenses = sheet.camera->sheet();
  append(
      sheet_sanity(lenses.lens(), asked, lenses.sheet_width(), sheet.camera->placement().height_mm),
      sheet.warnings);
  Collisions met = collisions_of(*sheet.camera, probe);
  append(std::move(met.notes), sheet.report);
  sheet.scene_lines = sheet.report.size();
  append(report_of(*sheet.camera, asked), sheet.report);
  append(sheet.camera->warnings(), sheet.warnings);
  append(viewing_warnings(*sheet.camera, asked), sheet.warnings);
  append(std::move(met.warnings), sheet.warnings);
}

/// Seen by the viewer's own eye.
Sheet finish(LensParameters lens, SheetPlacement place, const LensRequest& asked,
             std::uint32_t width, std::uint32_t height, std::vector<std::string> report,
             const SceneProbe& probe) {
  choose_model(asked, place.eye_slope_x, width, lens);
  if (asked.size) set_height(lens, *asked.size, height, place);
  check_computable(place);
  Sheet sheet;
  sheet.report = std::move(report);
  if (asked.depth_budget)
    keep_budget(place, *asked.depth_budget, width, height, probe, lens, sheet.report);
  sheet.camera = make_sheet(lens, place, width, height);
  report_on(asked, probe, sheet);
  return sheet;
}

/// What was asked for in vain.
void add_warnings(const LensRequest& asked, const Projection& projection, Sheet& sheet) {
  if (asked.size) {
    warn_of_shape(projection, asked, sheet.camera->width(), sheet.camera->height(), sheet.warnings);
  }
  if (asked.tolerance && !asked.automatic_model) {
    sheet.warnings.push_back("Lens_Tolerance has no effect: it is what Lens_Model=auto goes by");
  }
  if (asked.rays && sheet.camera->sheet().lens().model != LensModel::kThick) {
    sheet.warnings.push_back(
        "the number of rays (lens_rays, Lens_Rays) has no effect: only the lens model thick has "
        "several");
  }
}

double eye_in_scene(const LensParameters& lens, const SheetPlacement& place, std::uint32_t width) {
  return lens.view_distance * place.width /
         (width / lens.pixels * lens.pitch / lens.slant_cosine());
}

}  // namespace

Sheet sheet_of_statement(const Projection& projection, const LensRequest& request,
                         std::uint32_t width, std::uint32_t height, const SceneProbe& probe) {
  SheetPlacement place = placement_of(projection);
  LensRequest asked = request;
  if (!asked.view_distance) asked.view_distance = 0.0;
  if (!asked.model && !asked.automatic_model) asked.model = LensModel::kPinhole;
  const LensParameters lens = resolve(asked, width, nullptr);
  place.front = asked.front.value_or(std::min(place.width, eye_in_scene(lens, place, width)));
  Sheet sheet = finish(lens, place, request, width, height, {}, probe);
  add_warnings(request, projection, sheet);
  return sheet;
}

namespace {

/// A perspective or orthographic camera, and where a sheet of it would stand.
class ConvertedCamera {
 public:
  ConvertedCamera(std::string_view kind, const Projection& projection)
      : m_projection(projection), m_place(placement_of(projection)),
        m_is_perspective(kind == "perspective"), m_size(core::length(projection.direction)),
        m_along(core::dot(projection.direction, m_place.normal) / m_size) {}

  const Projection& projection() const { return m_projection; }
  bool is_perspective() const { return m_is_perspective; }
  const Vec3& normal() const { return m_place.normal; }
  const Vec3& right() const { return m_place.right; }
  /// Of the sheet's normal, in a unit of the camera's direction.
  double along() const { return m_along; }
  /// The sheet at that many scene units along the direction.
  SheetPlacement at(double distance) const {
    SheetPlacement out = m_place;
    if (m_is_perspective) {
      out.width *= distance / m_size;
      out.height *= distance / m_size;
    }
    out.centre = m_projection.location + m_projection.direction * (distance / m_size);
    return out;
  }
  /// Of the sheet before the camera, along its normal.
  double depth_of(const SheetPlacement& place) const {
    return core::dot(place.centre - m_projection.location, place.normal);
  }
  SheetStand stand(double distance) const { return {distance, m_along, m_is_perspective}; }

 private:
  const Projection& m_projection;
  SheetPlacement m_place;
  bool m_is_perspective;
  double m_size, m_along;
};

/// The viewer's eye sees the scene.
Sheet viewers_sheet(const ConvertedCamera& camera, const Conversion& conversion,
                    std::uint32_t width, std::uint32_t height, const SceneProbe& probe) {
  std::vector<std::string> report;
  double distance = 0.0;  // along direction
  LensRequest asked = conversion.lens;
  if (camera.is_perspective()) {
    FoundDistance found = sheet_distance(camera.projection(), conversion, camera.normal(), probe);
    distance = found.distance;
    report.push_back(std::move(found.line));
  } else {
    distance = conversion.sheet_distance.value_or(0.0);
    if (distance < 0.0)
      throw CameraError("Sheet_Distance must not be negative", {"Sheet_Distance"});
    if (!asked.view_distance) asked.view_distance = 0.0;
  }
  SheetPlacement place = camera.at(distance);
  const double depth = camera.depth_of(place);
  const EyeInScene eye{depth, place.width};
  const LensParameters lens = resolve(asked, width, camera.is_perspective() ? &eye : nullptr);
  place.front = conversion.lens.front.value_or(std::min(depth, eye_in_scene(lens, place, width)));
  Sheet sheet = finish(lens, place, conversion.lens, width, height, std::move(report), probe);
  sheet.stand = camera.stand(distance);
  return sheet;
}

/// Prints are composed to what an eye sees without jumps, unless another budget is asked for.
std::optional<DepthBudget> budget_of(const Conversion& conversion) {
  const LensRequest& asked = conversion.lens;
  if (asked.depth_budget || asked.depth != DepthMode::kPrint) return asked.depth_budget;
  return DepthBudget{conversion.most_parallax, false};
}

/// Makes sheets of one camera, seen by an eye of the scene's.
class SheetComposer {
 public:
  SheetComposer(const ConvertedCamera& camera, const Conversion& conversion, std::uint32_t width,
                std::uint32_t height, const SceneProbe& probe)
      : m_camera(camera), m_conversion(conversion), m_probe(probe), m_width(width),
        m_height(height),
        m_coarse(coarse_depths(
            camera.is_perspective() ? ProjectedKind::kPerspective : ProjectedKind::kOrthographic,
            camera.projection(), camera.normal(), probe)),
        m_lens(lens()) {}

  /// Where the sheet stands along the camera's direction, and the part of the depth it shows.
  std::unique_ptr<Lenticular> make(double distance, double factor) const {
    SheetPlacement place = m_camera.at(distance / m_camera.along());
    place.eye.emplace();
    if (m_camera.is_perspective()) place.eye->distance = distance;
    place.eye->factor = factor;
    place.front = m_conversion.lens.front.value_or(std::max(distance, 0.0));
    if (m_conversion.lens.size) set_height(m_lens, *m_conversion.lens.size, m_height, place);
    check_computable(place);
    return make_sheet(m_lens, place, m_width, m_height);
  }

  CompositionRequest request() const {
    CompositionRequest out;
    out.mode = *m_conversion.lens.depth;
    out.is_perspective = m_camera.is_perspective();
    if (const auto& asked = m_conversion.sheet_distance)
      out.distance = (out.is_perspective ? checked_distance(*asked) : *asked) * m_camera.along();
    out.usual_distance = usual() * m_camera.along();
    out.sheet_at = m_conversion.sheet_at;
    out.budget = budget_of(m_conversion);
    out.most_parallax = m_conversion.most_parallax;
    out.expected.has_background = m_coarse.has_background;
    if (!m_coarse.depths.empty()) {
      const double unit = core::dot(m_camera.projection().direction, m_camera.normal());
      out.expected.points = {m_coarse.depths.front() * unit, m_coarse.depths.back() * unit};
    }
    out.depths = m_conversion.depths;
    if (out.mode == DepthMode::kPrint && out.is_perspective) find_free_way(out);
    out.rays = m_conversion.survey_rays;
    return out;
  }

 private:
  /// The eyes of a print's views do not run into objects beside the camera.
  void find_free_way(CompositionRequest& out) const {
    constexpr double kPart = 0.9;
    if (!m_probe) return;
    for (const double side : {-1.0, 1.0}) {
      const auto hit =
          m_probe({m_camera.projection().location, m_camera.right() * side}, core::Bounds::kInf);
      if (!hit || kPart * hit->distance >= out.free_way) continue;
      out.free_way = kPart * hit->distance;
      out.in_the_way = hit->name();
    }
  }
  /// Where the camera looks; a unit of its direction where that is nowhere.
  double usual() const {
    if (!m_camera.is_perspective()) return 0.0;
    const auto found = usual_distance(m_camera.projection(), m_coarse.median());
    return found ? found->distance : core::length(m_camera.projection().direction);
  }
  LensParameters lens() const {
    const LensRequest& asked = m_conversion.lens;
    LensParameters out;
    if (asked.view_distance || asked.depth == DepthMode::kPrint || !m_camera.is_perspective()) {
      out = resolve(asked, m_width, nullptr);
    } else {
      // The viewer is where the scene's eye is: as many mm before the sheet, wherever that stands.
      const SheetPlacement place = m_camera.at(usual());
      const EyeInScene eye{m_camera.depth_of(place), place.width};
      out = resolve(asked, m_width, &eye);
    }
    choose_model(asked, 0.0, m_width, out);
    return out;
  }

  const ConvertedCamera& m_camera;
  const Conversion& m_conversion;
  const SceneProbe& m_probe;
  std::uint32_t m_width, m_height;
  CoarseDepths m_coarse;
  LensParameters m_lens;
};

/// Sheet_At, as the Sheet_Distance that it stands for.
Conversion at_object(const ConvertedCamera& camera, Conversion conversion, std::uint32_t width,
                     std::uint32_t height, const SceneProbe& probe) {
  Conversion scenes = conversion;
  scenes.lens.depth = DepthMode::kScene;
  scenes.lens.depth_budget.reset();
  const SheetComposer composer(camera, scenes, width, height, probe);
  const Composition found = compose(
      composer.request(),
      [&](double distance, double factor) { return composer.make(distance, factor); }, probe);
  conversion.sheet_distance = found.distance / camera.along();
  conversion.sheet_at.clear();
  return conversion;
}

/// An eye of the scene's sees it.
Sheet composed_sheet(const ConvertedCamera& camera, const Conversion& conversion,
                     std::uint32_t width, std::uint32_t height, const SceneProbe& probe) {
  const SheetComposer composer(camera, conversion, width, height, probe);
  const CompositionRequest request = composer.request();
  Sheet sheet;
  sheet.composed = compose(
      request, [&](double distance, double factor) { return composer.make(distance, factor); },
      probe);
  sheet.camera = composer.make(sheet.composed->distance, sheet.composed->factor);
  CompositionText text = composition_text(*sheet.camera, request, *sheet.composed);
  sheet.report = std::move(text.lines);
  sheet.warnings = std::move(text.warnings);
  report_on(conversion.lens, probe, sheet);
  sheet.stand = camera.stand(sheet.composed->distance / camera.along());
  return sheet;
}

}  // namespace

Sheet sheet_of_camera(std::string_view kind, const Projection& projection,
                      const Conversion& conversion, std::uint32_t width, std::uint32_t height,
                      const SceneProbe& probe) {
  if (kind != "perspective" && kind != "orthographic") {
    throw CameraError("a `" + std::string(kind) +
                          "` camera has no lens sheet: only perspective and orthographic ones have",
                      {"Lenticular", "Quilt", kCameraToo});
  }
  const ConvertedCamera camera(kind, projection);
  const bool is_viewers = conversion.lens.depth.value_or(DepthMode::kViewer) == DepthMode::kViewer;
  Sheet sheet = !is_viewers ? composed_sheet(camera, conversion, width, height, probe)
                : conversion.sheet_at.empty()
                    ? viewers_sheet(camera, conversion, width, height, probe)
                    : viewers_sheet(camera, at_object(camera, conversion, width, height, probe),
                                    width, height, probe);
  add_warnings(conversion.lens, projection, sheet);
  return sheet;
}

}  // namespace lentray::camera
