// The options of POV-Ray's command line as what a session takes. Pure functions, but for the
// clock's.
#pragma once

#include <atomic>
#include <string>

#include "core/image/writer.h"
#include "parser/options/animation.h"
#include "parser/options/options.h"
#include "tools/session/session.h"

namespace lentray::tool {

Reading reading_of(const parser::RenderOptions& options, const parser::FrameClock& clock,
                   const std::string& scene, const std::atomic<bool>* cancel = nullptr);
/// Of the frame or view that the options name.
CameraOptions camera_options(const parser::RenderOptions& options);
FilmSettings film_settings(const parser::RenderOptions& options);
/// `settings` of the scene: what space colours are computed in.
core::ImageFormat image_format(const parser::RenderOptions& options, core::FileType type,
                               const core::SceneSettings& settings);

/// Of the views that are rendered, which need not begin at 0; a picture that is none, too.
bool is_first_view(const parser::RenderOptions& options);
/// One picture a view of the one sheet, and not of a clock that runs over them.
bool has_views_of_one_sheet(const parser::RenderOptions& options);

}  // namespace lentray::tool
