#include "tools/lentray/run.h"

#include <algorithm>
#include <cstdio>

#include "parser/animation.h"
#include "tools/lentray/picture_run.h"
#include "tools/lentray/scene_file.h"

namespace lentray::tool {
namespace {

/// What several frames warn of is said once.
void add_new(const std::vector<std::string>& more, std::vector<std::string>& warnings) {
  for (const std::string& text : more) {
    if (std::find(warnings.begin(), warnings.end(), text) == warnings.end()) warnings.push_back(text);
  }
}

std::string frame_line(const parser::FrameClock& clock, std::size_t number, std::size_t count) {
  char text[128];
  std::snprintf(text, sizeof text, "Frame %d (%zu of %zu), clock %g\n", clock.frame_number, number, count, clock.clock);
  return text;
}

/// Every frame reads the scene afresh, for it may read what the frame before wrote.
Status run_frames(const parser::RenderOptions& options, const std::string& scene, const std::atomic<bool>& cancel,
                  TextStreams& texts, std::vector<std::string>& warnings) {
  const std::vector<parser::AnimationFrame> frames = parser::frames_of(options.animation);
  parser::RenderOptions one = options;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (options.verbose) texts.write(parser::Stream::kRender, frame_line(frames[i].clock, i + 1, frames.size()));
    one.frame_digits = frames[i].digits;
    std::vector<std::string> more;
    Status status = kDone;
    try {
      status = run_picture({one, frames[i].clock, scene, i + 1 == frames.size()}, cancel, texts, more);
    } catch (...) {
      add_new(more, warnings);
      throw;
    }
    add_new(more, warnings);
    if (status != kDone) return status;
  }
  return kDone;
}

}  // namespace

Status run(const parser::RenderOptions& options, const std::atomic<bool>& cancel,
           TextStreams& texts, std::vector<std::string>& warnings) {
  const SceneFile file(options);
  if (parser::is_animation(options.animation)) return run_frames(options, file.path(), cancel, texts, warnings);
  const parser::FrameClock clock = parser::still_clock(options.clock, options.clock_given);
  return run_picture({options, clock, file.path()}, cancel, texts, warnings);
}

}  // namespace lentray::tool
