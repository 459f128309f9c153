#include "tools/lentray/frame_depths.h"

#include <unistd.h>

#include <cstdio>
#include <set>
#include <stdexcept>

#include "core/base/formed.h"
#include "parser/options/animation.h"
#include "parser/options/create_ini.h"
#include "parser/source/cancelled.h"
#include "tools/common/companion.h"
#include "tools/common/process.h"
#include "tools/lentray/picture_run.h"
#include "tools/session/identity.h"
#include "tools/session/requests.h"
#include "tools/session/scene_disk.h"
#include "tools/session/session.h"

namespace lentray::tool {
namespace {

using camera::SceneDepths;
using parser::RenderOptions;

bool is_composed(const RenderOptions& o) {
  const auto mode = o.lens.depth.value_or(camera::DepthMode::kViewer);
  const bool has_clocks = o.animation.views.count == 0 || o.animation.views.clocks;
  return mode != camera::DepthMode::kViewer && (o.lenticular || o.views.quilt) &&
         parser::is_animation(o.animation) && has_clocks;
}

/// All of them, whichever this run makes.
parser::AnimationFrames all_frames(const RenderOptions& o) {
  parser::AnimationOptions all = o.animation;
  all.subset_start.reset();
  all.subset_end.reset();
  all.step = 1;
  return parser::frames_of(all);
}

std::optional<SceneDepths> depths_of_frame(const RenderOptions& options,
                                           const parser::AnimationFrame& frame,
                                           const std::string& scene,
                                           const std::atomic<bool>& cancel) {
  RenderOptions o = options;
  o.frame_digits = frame.digits;
  o.writes_to_disk = false;  // the frame itself writes what it writes
  SceneDisk disk(o, scene);
  try {
    Session session(
        reading_of(o, frame.clock, scene, &cancel), disk.files(),
        [](parser::Diagnostics& diagnostics) {
          for (const auto stream : {parser::Stream::kDebug, parser::Stream::kRender,
                                    parser::Stream::kStatistics, parser::Stream::kWarning})
            diagnostics.connect(stream, [](std::string_view) {});
        });
    const CameraSetup setup = session.camera(camera_options(o));
    if (setup.composed) return setup.composed->depths;
  } catch (const parser::Cancelled&) {
    throw;
  } catch (const std::runtime_error&) {
  }
  return std::nullopt;
}

std::optional<SceneDepths> find_depths(const RenderOptions& o, const std::string& scene,
                                       const std::atomic<bool>& cancel) {
  const parser::AnimationFrames frames = all_frames(o);
  if (frames.size() < 2) return std::nullopt;
  std::optional<SceneDepths> out;
  for (const std::size_t i : std::set<std::size_t>{0, frames.size() / 2, frames.size() - 1}) {
    const auto found = depths_of_frame(o, frames[i], scene, cancel);
    if (!found) continue;
    if (!out) out.emplace();
    out->add(*found);
  }
  return out;
}

/// Beside the pictures, which have digits in their names; empty: they go to no files.
std::string depths_path(const RenderOptions& o) {
  RenderOptions all = o;
  all.frame_digits.clear();
  core::FileType type = all.type;
  const std::string output = parser::output_path(all, type);
  return output.empty() || output == "-" || !renders(o) ? ""
                                                        : companion_path(output, ".lentray-depths");
}

/// What they are for.
Identity identity_of_depths(const RenderOptions& o) {
  return {identity_of(o, {}).program, parser::picture_lines(o), {}};
}

std::optional<SceneDepths> kept_depths(const std::string& path, const Identity& now) {
  try {
    const Identity then = Identity::of_text(read_text(path));
    if (then.program != now.program || !then.options.starts_with(now.options)) return std::nullopt;
    SceneDepths out;
    int has_background = 0;
    const int read = std::sscanf(
        then.options.c_str() + now.options.size(), "depths %lg %lg %lg %lg %d", &out.points.nearest,
        &out.points.farthest, &out.named.nearest, &out.named.farthest, &has_background);
    out.has_background = has_background != 0;
    if (read == 5) return out;
  } catch (const std::exception&) {  // there is none, or it is damaged
  }
  return std::nullopt;
}

}  // namespace

std::optional<SceneDepths> frame_depths(const RenderOptions& o, const std::string& scene,
                                        const std::atomic<bool>& cancel) {
  if (!is_composed(o)) return std::nullopt;
  const std::string path = depths_path(o);
  Identity identity = identity_of_depths(o);
  if (o.continues && !path.empty())
    if (const auto kept = kept_depths(path, identity)) return kept;
  std::optional<SceneDepths> out;
  try {
    out = find_depths(o, scene, cancel);
  } catch (const parser::Cancelled&) {
    return std::nullopt;  // the first picture is cancelled too, and says so
  }
  if (out && !path.empty() && o.output_to_file) {
    identity.options += depths_line(*out);
    write_whole(path, identity.text());
  }
  return out;
}

std::string depths_line(const SceneDepths& d) {
  return core::formed("depths %.17g %.17g %.17g %.17g %d\n", d.points.nearest, d.points.farthest,
                      d.named.nearest, d.named.farthest, int{d.has_background});
}

void forget_frame_depths(const RenderOptions& o) {
  const std::string path = depths_path(o);
  if (!path.empty() && kept_depths(path, identity_of_depths(o))) (void)::unlink(path.c_str());
}

}  // namespace lentray::tool
