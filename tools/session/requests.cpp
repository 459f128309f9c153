#include "tools/session/requests.h"

#include <algorithm>
#include <utility>

namespace lentray::tool {
namespace {

using parser::RenderOptions;

parser::ParserOptions parser_options(const RenderOptions& o, const parser::FrameClock& clock) {
  parser::ParserOptions out;
  out.library_paths = o.library_paths;
  out.declares = o.declares;
  out.include_header = o.include_header;
  if (const auto said = o.said.find("Include_Header"); said != o.said.end())
    out.header_place = said->second.where;
  out.frame = clock;
  out.image_width = static_cast<int>(o.width);
  out.image_height = static_cast<int>(o.height);
  out.language_version = o.language_version;
  return out;
}

core::Antialiasing antialiasing(const RenderOptions& o) {
  core::Antialiasing out;
  using enum core::AntialiasingMethod;
  constexpr core::AntialiasingMethod kMethods[] = {kPlain, kCentres, kCorners, kSpread};
  if (o.antialias) out.method = kMethods[o.sampling_method];
  out.threshold = o.antialias_threshold;
  out.depth = o.antialias_depth;
  if (o.antialias_grid > 0) {
    out.method = kGrid;
    out.blends_light = o.sampling_method == 3;
    out.depth = o.antialias_grid;
  }
  out.jitter = o.jitter ? o.jitter_amount : 0.0;
  constexpr double kOfEye = 2.0;  // quick to take, and near to brightness
  out.gamma = out.method == kSpread ? kOfEye : o.antialias_gamma;
  return out;
}

/// Frames of a clock, or views with clocks of their own.
bool has_frames(const RenderOptions& o) {
  return o.animation.views.count > 0 ? o.animation.views.clocks.has_value()
                                     : parser::is_animation(o.animation);
}

}  // namespace

Reading reading_of(const RenderOptions& o, const parser::FrameClock& clock,
                   const std::string& scene, const std::atomic<bool>* cancel) {
  Reading out;
  out.scene = scene;
  out.parser = parser_options(o, clock);
  out.parser.cancel = cancel;
  out.build.quality = o.quality;
  out.build.alpha = o.alpha;
  out.build.overrides = o.overrides;
  if (o.accelerator == "grid") out.compile.accelerator = core::Accelerator::kGrid;
  if (o.accelerator == "list") out.compile.accelerator = core::Accelerator::kList;
  out.compile.general_path = !o.specialised_paths;
  out.light_buffers = o.light_buffer;
  out.names_objects = o.lenticular || o.views.quilt;
  out.threads = o.threads;
  return out;
}

CameraOptions camera_options(const RenderOptions& o) {
  CameraOptions out;
  out.width = static_cast<std::uint32_t>(o.width);
  out.height = static_cast<std::uint32_t>(o.height);
  out.lenticular = o.lenticular;
  out.lens = o.lens;
  if (out.is_on_its_side()) std::swap(out.width, out.height);
  out.sheet_distance = o.sheet_distance;
  out.sheet_at = o.sheet_at;
  out.view = parser::rendered_view(o);
  out.views = o.views;
  out.is_first_view = is_first_view(o);
  out.is_animated = has_frames(o);
  return out;
}

FilmSettings film_settings(const RenderOptions& o) {
  FilmSettings out;
  out.antialiasing = antialiasing(o);
  out.angles = o.antialias_angles;
  out.alpha = o.alpha;
  out.quality = o.quality;
  out.part = {o.start_column, o.end_column, o.start_row, o.end_row};
  out.pixel_order = o.pixel_order;
  out.shadow_cache = o.shadow_cache;
  out.threads = o.threads;
  out.most_radiosity_samples = o.radiosity_samples;
  out.band_height = o.band_height;
  out.max_memory = o.max_memory;
  out.bundles = o.specialised_paths;
  out.count_tests = !o.statistics_file.empty() && o.count_tests;
  out.log_shadows = o.shadow_log;
  return out;
}

core::ImageFormat image_format(const parser::RenderOptions& options, core::FileType type,
                               const core::SceneSettings& settings) {
  constexpr int kLeastQuality = 2, kBestQuality = 100;
  core::ImageFormat format;
  format.type = type;
  format.bits = options.bits;
  format.alpha = options.alpha;
  format.grey = options.grayscale;
  if (options.dither) format.dither = options.dither_type;
  if (options.compression >= kLeastQuality)
    format.quality = std::min(options.compression, kBestQuality);
  format.srgb = options.srgb;
  format.file_gamma = options.file_gamma;
  if (settings.assumed_gamma > 0.0) {
    format.working_gamma = settings.assumed_gamma;
  } else if (settings.assumed_gamma_set) {
    format.working_srgb = true;
  } else {
    // Scenes older than 3.7 without an assumed_gamma: colours are the display's, and so is the
    // file.
    format.srgb = format.working_srgb = options.display_srgb;
    format.file_gamma = format.working_gamma = options.display_gamma;
  }
  return format;
}

bool is_first_view(const RenderOptions& o) {
  if (o.animation.views.count == 0 || o.frame_digits.empty()) return true;
  parser::AnimationOptions first = o.animation;
  first.step = static_cast<int>(first.views.count);  // one of them is enough to know
  const parser::AnimationFrames frames = parser::frames_of(first);
  return !frames.empty() && frames.front().digits == o.frame_digits;
}

bool has_views_of_one_sheet(const RenderOptions& o) {
  return o.animation.views.count > 0 && !o.animation.views.clocks;
}

}  // namespace lentray::tool
