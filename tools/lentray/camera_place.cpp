#include "tools/lentray/camera_place.h"

#include <algorithm>
#include <string>

#include "parser/options/said_options.h"

namespace lentray::tool {

void fail_with_place(const camera::CameraError& error, Session& session,
                     const parser::RenderOptions& options) {
  const parser::CameraDesc* const camera = session.camera_statement();
  const std::size_t said = parser::said_count(options, error.about());
  const std::string text = parser::with_said(error.what(), options, error.about());
  const bool names_camera =
      std::ranges::find(error.about(), camera::kCameraToo) != error.about().end();
  const bool is_of_statement = said == 0 || names_camera;
  if (!camera) {
    throw camera::CameraError(
        text + (is_of_statement ? "; the scene has no camera, this is the default one" : ""));
  }
  // What a lens sheet's own statement does not say is said by options, and the other way round.
  const bool is_sheet = camera->kind == parser::CameraKind::kLenticular;
  if (is_of_statement || (is_sheet && said < error.about().size())) session.fail_at_camera(text);
  throw camera::CameraError(text);
}

}  // namespace lentray::tool
