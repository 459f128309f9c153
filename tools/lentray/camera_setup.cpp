#include "tools/lentray/camera_setup.h"

#include <utility>

#include "camera/bent.h"
#include "camera/blurred.h"
#include "camera/conversion.h"
#include "camera/curved.h"
#include "camera/orthographic.h"
#include "camera/perspective.h"
#include "camera/thin_lens.h"

namespace lentray::tool {
namespace {

bool asks_for_lens(const parser::RenderOptions& o) {
  return !o.lens.is_empty() || o.lens.pixels || o.lens.print_dpi || o.lens.front ||
         o.lens.view_distance || o.lens.model || o.lens.automatic_model || o.lens.tolerance ||
         o.lens.rays || o.sheet_distance;
}

camera::Sheet make_sheet(const parser::CameraRequest& request, const parser::RenderOptions& options,
                         const camera::SceneProbe& probe) {
  const auto width = static_cast<std::uint32_t>(options.width);
  const auto height = static_cast<std::uint32_t>(options.height);
  if (request.kind != "lenticular") {
    const camera::Conversion conversion{options.lens, options.sheet_distance};
    return camera::sheet_of_camera(request.kind, request.projection, conversion, width, height,
                                   probe);
  }
  camera::LensRequest lens = request.lens;
  lens.override_by(options.lens);
  camera::Sheet sheet = camera::sheet_of_statement(request.projection, lens, width, height, probe);
  if (options.sheet_distance) {
    sheet.warnings.push_back("Sheet_Distance has no effect: the scene's own camera is lenticular");
  }
  return sheet;
}

std::unique_ptr<camera::Camera> make_ordinary(const parser::CameraRequest& request,
                                              const parser::RenderOptions& options) {
  const auto width = static_cast<std::uint32_t>(options.width);
  const auto height = static_cast<std::uint32_t>(options.height);
  if (request.kind == "perspective") {
    return std::make_unique<camera::Perspective>(request.projection, width, height);
  }
  if (request.kind == "orthographic") {
    return std::make_unique<camera::Orthographic>(request.projection, width, height);
  }
  if (const auto kind = camera::curved_kind(request.kind, request.cylinder_type)) {
    return std::make_unique<camera::Curved>(*kind, request.projection, request.angles, width,
                                            height);
  }
  if (request.mesh) return std::make_unique<camera::MeshCamera>(*request.mesh, width, height);
  throw camera::CameraError("the camera kind `" + request.kind + "`: not yet");
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

CameraSetup make_camera(const parser::CameraRequest& request, const parser::RenderOptions& options,
                        const camera::SceneProbe& probe) {
  CameraSetup setup;
  if (request.kind != "lenticular" && !options.lenticular) {
    if (options.view) {
      throw camera::CameraError("View=" + std::to_string(*options.view) +
                                " needs a lens sheet: add Lenticular=On");
    }
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
  if (request.normal) {
    setup.warnings.push_back("the camera's normal bends no rays of a lens sheet: it is left out");
  }
  camera::Sheet sheet = make_sheet(request, options, probe);
  setup.sheet = std::move(sheet.camera);
  setup.report = std::move(sheet.report);
  setup.warnings = std::move(sheet.warnings);
  if (options.view) {
    const std::uint32_t views = setup.sheet->sheet().views();
    if (views == 0) {
      throw camera::CameraError("a sheet with a fractional number of pixels a lens has no views");
    }
    if (*options.view >= views || setup.sheet->sheet().view_width(*options.view) == 0) {
      throw camera::CameraError("there is no view " + std::to_string(*options.view) +
                                ": the views are 0 to " + std::to_string(views - 1));
    }
    setup.view = std::make_shared<camera::SheetView>(*setup.sheet, *options.view);
  }
  if (request.blur) blur_sheet(request, setup);
  return setup;
}

}  // namespace lentray::tool
