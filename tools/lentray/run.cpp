#include "tools/lentray/run.h"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>

#include "core/image/run_files.h"
#include "core/image/writer.h"
#include "parser/options/animation.h"
#include "parser/options/create_ini.h"
#include "parser/restrictions/povray_conf.h"
#include "tools/common/process.h"
#include "tools/lentray/commands.h"
#include "tools/lentray/frame_depths.h"
#include "tools/lentray/picture_run.h"
#include "tools/session/picture_journal.h"
#include "tools/session/scene_file.h"
#include "tools/session/seen.h"

namespace lentray::tool {
namespace {

using parser::CommandKind;
using parser::RenderOptions;

CommandContext command_context(const RenderOptions& o, const parser::FrameClock& clock) {
  CommandContext context;
  core::FileType type = o.type;
  context.output = parser::output_path(o, type);
  context.scene = o.input == "-" ? "stdin" : std::filesystem::path(o.input).stem().string();
  context.frame = clock.frame_number;
  context.clock = clock.clock;
  context.width = o.width;
  context.height = o.height;
  return context;
}

/// All frames there are: those of the animation, or the still alone.
parser::AnimationFrames frames_of(const RenderOptions& o) {
  if (parser::is_animation(o.animation)) return parser::frames_of(o.animation);
  const parser::AnimationFrame still{parser::still_clock(o.clock, o.clock_given), ""};
  return {0, 0, 1, [still](int) { return still; }};
}

/// One run of the program over its frames. Every frame reads the scene afresh, for it may read what
/// the frame before wrote; views of one sheet are pictures of one reading.
class Loop {
 public:
  Loop(const RenderOptions& options, const std::string& scene, const std::atomic<bool>& cancel,
       MessageForm& form, Warnings& warnings)
      : m_options(options), m_scene(scene), m_cancel(cancel), m_form(form), m_warnings(warnings),
        m_frames(frames_of(options)), m_is_animation(parser::is_animation(options.animation)),
        m_depths(frame_depths(options, scene, cancel)) {}

  Status without_commands() {
    for (std::size_t i = 0; i < m_frames.size(); ++i) {
      const Status status = make(i);
      if (status != kDone) return status;
    }
    return kDone;
  }

  /// Once, when it is known that the scene does not read that file.
  void write_ini() {
    const std::string ini = parser::ini_path(m_options);
    if (ini.empty() || m_has_ini) return;
    m_has_ini = true;
    write_whole(ini, parser::ini_text(m_options));
  }

  Status with_commands(Commands& commands) {
    const CommandContext scene = command_context(m_options, m_frames.front().clock);
    try {
      const Status status = scene_with_commands(commands, scene);
      if (status == kAborted) commands.run(CommandKind::kUserAbort, scene);
      return status;
    } catch (...) {
      commands.run(CommandKind::kFatalError, scene);
      throw;
    }
  }

 private:
  /// What a frame leads to.
  enum class Next { kFrame, kEndOfScene, kQuit, kAbort };

  Status make(std::size_t i) {
    const parser::AnimationFrame frame = m_frames[i];
    RenderOptions one = m_options;
    one.frame_digits = frame.digits;
    if (m_is_animation) m_form.begin_frame(one, frame.clock, i + 1, m_frames.size());
    const bool is_last = i + 1 == m_frames.size();
    return run_picture({one, frame.clock, m_scene, m_kept, is_last, m_is_animation, m_depths,
                        [this](const SceneDisk& disk) {
                          keep_to_one_version(disk);
                          m_form.texts().keep();
                          write_ini();
                        }},
                       m_cancel, m_form, m_warnings);
  }

  /// All frames are of one version of their files, but for those that the run itself wrote. A command between frames
  /// may be there to change them.
  void keep_to_one_version(const SceneDisk& disk) {
    if (has_frame_commands(m_options)) return;
    m_written.insert(disk.written().begin(), disk.written().end());
    Seen seen = disk.seen();
    const auto is_own = [this](const std::string& path) {
      return m_written.contains(path) || core::is_made(path);
    };
    std::erase_if(seen.files, [&](const auto& file) { return is_own(file.first); });
    std::erase_if(seen.missing, is_own);
    std::erase_if(seen.there, is_own);
    if (const std::string change = change_in_common(m_seen, seen); !change.empty()) {
      throw parser::OptionError("the frames would be of two versions: " + change +
                                " since the first of this run was read");
    }
    m_seen.files.merge(seen.files);
    m_seen.missing.merge(seen.missing);
    m_seen.there.merge(seen.there);
  }

  /// Frames say that they are finished only while there is one that is not. Of the first `count`.
  void forget_frames(std::size_t count) const {
    if (!m_is_animation || !m_options.output_to_file) return;
    forget_frame_depths(m_options);
    RenderOptions one = m_options;
    for (std::size_t i = 0; i < count; ++i) {
      one.frame_digits = m_frames[i].digits;
      core::FileType type = one.type;
      PictureJournal::forget(parser::output_path(one, type));
    }
  }

  static Next next_after(Action action, Next skipped) {
    switch (action) {
      case Action::kGoOn: return Next::kFrame;
      case Action::kSkip: return skipped;
      case Action::kSkipAll: return Next::kEndOfScene;
      case Action::kQuit: return Next::kQuit;
      case Action::kAbort: break;
    }
    return Next::kAbort;
  }

  Next frame_with_commands(Commands& commands, std::size_t i) {
    RenderOptions one = m_options;
    const parser::AnimationFrame frame = m_frames[i];
    one.frame_digits = frame.digits;
    const CommandContext context = command_context(one, frame.clock);
    const Action first = commands.run(CommandKind::kPreFrame, context);
    if (first != Action::kGoOn) return next_after(first, Next::kFrame);
    if (make(i) == kAborted) return Next::kAbort;
    return next_after(commands.run(CommandKind::kPostFrame, context), Next::kEndOfScene);
  }

  Status scene_with_commands(Commands& commands, const CommandContext& scene) {
    const Action first = commands.run(CommandKind::kPreScene, scene);
    if (first == Action::kQuit || first == Action::kSkipAll) return kDone;
    if (first == Action::kAbort) return kAborted;
    Next next = first == Action::kSkip ? Next::kEndOfScene : Next::kFrame;
    std::size_t i = 0;
    for (; i < m_frames.size() && next == Next::kFrame; ++i) {
      next = frame_with_commands(commands, i);
    }
    if (next == Next::kQuit) return kDone;
    if (next == Next::kAbort) return kAborted;
    forget_frames(i);
    return commands.run(CommandKind::kPostScene, scene) == Action::kAbort ? kAborted : kDone;
  }

  const RenderOptions& m_options;
  const std::string& m_scene;
  const std::atomic<bool>& m_cancel;
  MessageForm& m_form;
  Warnings& m_warnings;
  const parser::AnimationFrames m_frames;
  const bool m_is_animation;
  const std::optional<camera::SceneDepths> m_depths;
  std::shared_ptr<SceneInUse> m_kept;
  bool m_has_ini = false;
  Seen m_seen;                      ///< by the frames so far
  std::set<std::string> m_written;  ///< paths, by their scene
};

Status run_loop(const RenderOptions& options, Loop& loop, MessageForm& form) {
  if (!renders(options)) return loop.without_commands();
  Commands commands(options, parser::installed_confs(), form);
  return loop.with_commands(commands);
}

}  // namespace

Status run(const RenderOptions& options, const std::atomic<bool>& cancel, MessageForm& form,
           Warnings& warnings) {
  const SceneFile file(options);
  core::claim_writable(parser::ini_path(options), "Create_Ini");
  if (options.create_ini) (void)parser::ini_text(options);  // that there can be one
  Loop loop(options, file.path(), cancel, form, warnings);
  try {
    const Status status = run_loop(options, loop, form);
    loop.write_ini();
    return status;
  } catch (...) {
    loop.write_ini();  // as in stock, of a scene with errors too
    throw;
  }
}

}  // namespace lentray::tool
