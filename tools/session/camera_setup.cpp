#include "tools/session/camera_setup.h"

#include <cmath>
#include <utility>

#include "camera/bent.h"
#include "camera/blurred.h"
#include "camera/conversion.h"
#include "camera/parallax.h"
#include "camera/projected.h"
#include "camera/sheet_views.h"
#include "camera/text.h"
#include "camera/thin_lens.h"
#include "camera/upright_view.h"

namespace lentray::tool {
namespace {

/// What a lens is like.
bool asks_for_lens_itself(const CameraOptions& o) {
  return !o.lens.is_empty() || o.lens.pixels || o.lens.print_dpi || o.lens.model ||
         o.lens.automatic_model || o.lens.tolerance || o.lens.rays || o.lens.slant || o.lens.across;
}

bool asks_for_lens(const CameraOptions& o) {
  return asks_for_lens_itself(o) || o.lens.front || o.lens.view_distance || o.sheet_distance ||
         !o.sheet_at.empty() || o.lens.depth_budget || o.lens.depth;
}

/// Of a survey: a part of what the pictures of the sheet will need, but as many as show what there is.
std::uint64_t survey_rays(const CameraOptions& o) {
  constexpr std::uint64_t kLeast = std::uint64_t{1} << 15, kPixelsARay = 12;
  std::uint64_t pixels = std::uint64_t{o.width} * o.height;
  if (o.views.count && o.views.size)
    pixels = std::uint64_t{*o.views.count} * o.views.size->width * o.views.size->height;
  return std::clamp(pixels / kPixelsARay, kLeast, camera::kSurveyRays);
}

/// `most_parallax`: pixels a view, beyond which things jump.
camera::Sheet make_sheet(const parser::CameraRequest& request, const CameraOptions& options,
                         const camera::SceneProbe& probe,
                         double most_parallax = camera::kMostParallax) {
  const std::uint32_t width = options.width, height = options.height;
  const camera::Projection frame =
      options.is_on_its_side() ? camera::on_its_side(request.projection) : request.projection;
  if (request.kind != "lenticular") {
    return camera::sheet_of_camera(request.kind, frame,
                                   {options.lens, options.sheet_distance, options.sheet_at,
                                    options.depths, survey_rays(options), most_parallax},
                                   width, height, probe);
  }
  camera::LensRequest lens = request.lens;
  lens.override_by(options.lens);
  camera::Sheet sheet = camera::sheet_of_statement(frame, lens, width, height, probe);
  for (const auto& [is_said, name] :
       {std::pair{options.sheet_distance.has_value(), "Sheet_Distance"},
        std::pair{!options.sheet_at.empty(), "Sheet_At"}}) {
    if (!is_said) continue;
    sheet.warnings.push_back(std::string(name) +
                             " has no effect: the scene's own camera is lenticular");
  }
  return sheet;
}

std::unique_ptr<camera::Camera> make_ordinary(const parser::CameraRequest& request,
                                              const CameraOptions& options) {
  const std::uint32_t width = options.width, height = options.height;
  if (const auto kind = camera::projected_kind(request.kind, request.cylinder_type)) {
    return std::make_unique<camera::Projected>(*kind, request.projection, request.angles, width,
                                               height);
  }
  if (request.mesh) return std::make_unique<camera::MeshCamera>(*request.mesh, width, height);
  throw camera::CameraError("the camera kind `" + request.kind + "`: not yet");
}

/// Views of a sheet that was not asked for.
void refuse_views(const CameraOptions& o) {
  std::string what;
  if (const auto view = o.view) what = "View=" + std::to_string(*view);
  if (const auto views = o.views.count) what = "Views=" + std::to_string(*views);
  if (!what.empty()) {
    throw camera::CameraError(what + " needs a lens sheet: add Lenticular=On", {"View", "Views"});
  }
}

/// The ordinary camera that a scene has.
CameraSetup ordinary_setup(const parser::CameraRequest& request, const CameraOptions& options) {
  refuse_views(options);
  CameraSetup setup;
  setup.ordinary = make_ordinary(request, options);
  if (request.blur && request.mesh) {
    setup.warnings.push_back("a mesh_camera has no aperture: its picture is not blurred");
  } else if (request.blur) {
    setup.ordinary = std::make_unique<camera::Blurred>(
        std::move(setup.ordinary), camera::lens_of_camera(request.projection, *request.blur),
        request.blur->samples);
  }
  if (request.normal) {
    setup.ordinary = std::make_unique<camera::Bent>(std::move(setup.ordinary), request.normal);
  }
  if (options.lens.size) {
    setup.warnings.push_back(
        "the picture has the columns and rows of the lens sheet, but without Lenticular=On it is "
        "none");
  } else if (asks_for_lens(options)) {
    setup.warnings.push_back("the lens options have no effect without Lenticular=On");
  }
  return setup;
}

/// The strip of one view, one pixel a lens.
std::shared_ptr<const camera::Camera> strip_of(const camera::Lenticular& sheet,
                                               std::uint32_t view) {
  const std::uint32_t views = camera::usual_views(sheet.sheet());
  if (view >= views || camera::view_width(sheet.sheet(), view, views) == 0) {
    throw camera::CameraError("there is no view " + std::to_string(view) + ": the views are 0 to " +
                                  std::to_string(views - 1),
                              {"View", "Lens_Pixels", "Print_DPI"});
  }
  return std::make_shared<camera::SheetView>(sheet, view);
}

/// The size of each of the pictures of Views=, upright.
parser::PixelSize view_size(const CameraOptions& o) {
  const parser::PixelSize whole{o.width, o.height}, turned{o.height, o.width};
  return o.views.size.value_or(o.is_on_its_side() ? turned : whole);
}

std::string size_text(const parser::PixelSize& size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height) + " pixels";
}

/// One of Views=, in its size.
std::shared_ptr<const camera::Camera> picture_of_view(const camera::Lenticular& sheet,
                                                      const CameraOptions& o, std::uint32_t view,
                                                      std::vector<std::string>& report) {
  const parser::PixelSize size = view_size(o);
  const double offset = ((view + 0.5) / *o.views.count - 0.5) * sheet.sheet().lens().print_pitch();
  report.push_back("View " + std::to_string(view) + " of " + std::to_string(*o.views.count) + ", " +
                   size_text(size) + ", at the print offset " + camera::format(offset) + " mm");
  if (o.is_on_its_side())
    return camera::make_view(sheet, view, *o.views.count, size.height, size.width);
  return camera::make_view(sheet, view, *o.views.count, size.width, size.height);
}

/// The lens whose views are the cameras of a quilt's cone. `like` has the same size in scene units.
camera::LensRequest cone_lens(const camera::LensParameters& like, double degrees,
                              const CameraOptions& o) {
  const camera::LensParameters lens =
      camera::lens_of_cone(degrees, o.views.quilt->views(), like.pitch, like.view_distance);
  camera::LensRequest out;
  out.pitch = lens.pitch;
  out.focal_length = lens.focal_length;
  out.ior = lens.ior;
  out.pixels = lens.pixels;
  out.model = lens.model;
  out.slant = 0.0;
  out.view_distance = o.lens.view_distance;
  out.front = o.lens.front;
  return out;
}

/// The sheet of a quilt's cone: a pixel of a tile is as wide as a lens, so that the report's
/// parallax is in pixels of the tile.
camera::Sheet cone_sheet(const parser::CameraRequest& request, const CameraOptions& options,
                         const camera::SceneProbe& probe) {
  constexpr double kTilePixels = 5.0;  // up to which displays show no ghosts
  CameraOptions o = options;
  o.width = options.width * options.views.quilt->views();
  const double degrees = options.views.cone.value_or(parser::kUsualViewCone);
  o.lens = cone_lens({}, degrees, options);
  if (options.lens.depth.value_or(camera::DepthMode::kViewer) != camera::DepthMode::kViewer) {
    // The scene's eye alone decides: a viewer who is infinitely far sees slopes of equal steps.
    o.lens.view_distance = 0.0;
    o.lens.model = camera::LensModel::kParaxial;
    o.lens.depth = options.lens.depth;
    o.lens.depth_budget = options.lens.depth_budget;
    return make_sheet(request, o, probe, kTilePixels);
  }
  // The eye's distance in mm is known once there is a sheet.
  o.lens = cone_lens(make_sheet(request, o, probe).camera->sheet().lens(), degrees, options);
  o.lens.depth_budget = options.lens.depth_budget;
  return make_sheet(request, o, probe);
}

std::string quilt_line(const CameraOptions& o, double aspect) {
  const parser::QuiltGrid& grid = *o.views.quilt;
  const std::string columns = std::to_string(grid.columns), rows = std::to_string(grid.rows);
  return "Quilt of " + columns + " x " + rows + " views, " + size_text(*o.views.size) +
         " each; displays want its file's name to end in _qs" + columns + "x" + rows + "a" +
         camera::format(aspect);
}

std::string cone_line(const camera::Lenticular& sheet, double degrees) {
  const std::string text = "Its cameras look over " + camera::format(degrees) + " degrees";
  const double distance = sheet.eye_distance();
  if (!sheet.has_near_eye()) return text + ", along parallel rays";
  constexpr double kHalf = 0.5 * 3.14159265358979323846 / 180.0;
  const double reach = distance * std::tan(kHalf * degrees);
  const auto& eye = sheet.placement().eye;
  return text + ": " + camera::format(2.0 * reach * (eye ? eye->factor : 1.0)) +
         " scene units from the first to the last, " + camera::format(distance) +
         " before the sheet";
}

/// The scene's picture, as high as it is and as wide as the display.
void fit_to_display(const CameraOptions& o, camera::Projection& projection) {
  if (!o.views.aspect) return;
  const double width = core::length(projection.right), height = core::length(projection.up);
  if (width > 0.0) projection.right = projection.right * (*o.views.aspect * height / width);
}

/// All that is said of a sheet but, of a quilt's, what is of lenses.
void take_report(camera::Sheet& sheet, bool has_lenses, CameraSetup& setup) {
  if (!has_lenses) {
    sheet.report.resize(sheet.scene_lines);
    // How deep it looks in mm: nobody knows of the display.
    if (sheet.composed) sheet.report.erase(sheet.report.begin() + 1);
  }
  for (std::string& line : sheet.report) setup.report.push_back(std::move(line));
  for (std::string& text : sheet.warnings) setup.warnings.push_back(std::move(text));
  setup.stand = sheet.stand;
  if (sheet.composed)
    setup.composed = std::make_shared<const camera::Composition>(std::move(*sheet.composed));
}

void make_quilt(const parser::CameraRequest& request, const CameraOptions& o,
                const camera::SceneProbe& probe, CameraSetup& setup) {
  const std::uint32_t views = o.views.quilt->views();
  const bool of_cone = !o.views.count;
  const double degrees = o.views.cone.value_or(parser::kUsualViewCone);
  if (of_cone && views < 2) throw camera::CameraError("a quilt has at least two views", {"Quilt"});
  if (of_cone && o.lens.depth_budget && o.lens.depth_budget->is_mm) {
    throw camera::CameraError(
        "Depth_Budget in mm is of a print; of a quilt it is a number of pixels of its tiles, "
        "without "
        "a unit",
        {"Depth_Budget", "Quilt"});
  }
  camera::Sheet sheet = of_cone ? cone_sheet(request, o, probe) : make_sheet(request, o, probe);
  setup.sheet = std::move(sheet.camera);
  const camera::SheetPlacement& place = setup.sheet->placement();
  const double aspect = o.views.aspect.value_or(place.width / place.height);
  std::vector<std::shared_ptr<const camera::Camera>> tiles;
  for (std::uint32_t i = 0; i < views; ++i) {
    // The leftmost camera first: the view through the cells' right edges.
    tiles.push_back(camera::make_view(*setup.sheet, views - 1 - i, views, o.views.size->width,
                                      o.views.size->height));
  }
  camera::Properties about{{"camera", std::string("quilt")}};
  if (!of_cone) about = setup.sheet->describe();
  about.emplace_back("quilt.aspect", aspect);
  if (const double factor = setup.sheet->depth_factor(); of_cone && factor != 1.0) {
    about.emplace_back("quilt.depth_factor", factor);
  }
  if (of_cone) about.emplace_back("quilt.view_cone_degrees", degrees);
  setup.view = std::make_shared<camera::Quilt>(std::move(tiles), o.views.quilt->columns, about);
  setup.report.push_back(quilt_line(o, aspect));
  if (of_cone) setup.report.push_back(cone_line(*setup.sheet, degrees));
  take_report(sheet, !of_cone, setup);
  if (of_cone && asks_for_lens_itself(o)) {
    setup.warnings.push_back(
        "the lens options have no effect on a quilt: Views= makes it of the views of the sheet");
  }
}

/// The view that is asked for, if one is.
void take_view(const CameraOptions& o, CameraSetup& setup) {
  if (!o.view) return;
  setup.view = o.views.count ? picture_of_view(*setup.sheet, o, *o.view, setup.report)
                             : strip_of(*setup.sheet, *o.view);
  if (setup.is_on_its_side) {
    setup.view = std::make_shared<camera::UprightView>(std::move(setup.view));
  }
}

void blur_sheet(const parser::CameraRequest& request, CameraSetup& setup) {
  const camera::ThinLens lens =
      request.kind == "lenticular"
          ? camera::lens_of_statement(*setup.sheet, *request.blur)
          : camera::lens_of_conversion(*setup.sheet, request.projection, *request.blur);
  std::shared_ptr<const camera::Camera> sharp = setup.sheet;
  if (setup.view) sharp = setup.view;
  setup.blurred = std::make_unique<camera::Blurred>(std::move(sharp), lens, request.blur->samples);
}

}  // namespace

camera::Properties properties_of(const CameraSetup& setup) {
  camera::Properties out = setup.camera().describe();
  if (setup.is_on_its_side) out.emplace_back("lens.lenses_lie", std::string("across"));
  return out;
}

CameraSetup make_camera(const parser::CameraRequest& asked, const CameraOptions& options,
                        const camera::SceneProbe& probe) {
  const bool is_quilt = options.views.quilt.has_value();
  if (asked.kind != "lenticular" && !options.lenticular && !is_quilt) {
    return ordinary_setup(asked, options);
  }
  parser::CameraRequest request = asked;
  if (is_quilt) fit_to_display(options, request.projection);
  CameraSetup setup;
  if (request.normal) {
    setup.warnings.push_back("the camera's normal bends no rays of a lens sheet: it is left out");
  }
  if (is_quilt) {
    make_quilt(request, options, probe, setup);
  } else {
    camera::Sheet sheet = make_sheet(request, options, probe);
    setup.sheet = std::move(sheet.camera);
    setup.is_on_its_side = options.is_on_its_side();
    take_report(sheet, true, setup);
    if (!options.is_first_view) setup.report.clear();
    take_view(options, setup);
  }
  if (options.lens.depth_budget && options.is_animated && !setup.composed) {
    setup.warnings.push_back(
        "Depth_Budget: each frame has its own factor, so that depth may change between frames");
  }
  if (request.blur) blur_sheet(request, setup);
  return setup;
}

CameraSetup another_view(const CameraSetup& sheet, const parser::CameraRequest& request,
                         const CameraOptions& options) {
  CameraSetup setup;
  setup.sheet = sheet.sheet;
  setup.stand = sheet.stand;
  setup.composed = sheet.composed;
  setup.is_on_its_side = sheet.is_on_its_side;
  take_view(options, setup);
  if (request.blur) blur_sheet(request, setup);
  return setup;
}

}  // namespace lentray::tool
