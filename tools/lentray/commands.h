// Programs that INI files have run around scenes and frames, where povray.conf allows it:
// Pre_Scene_Command and its kin. Source: reference manual 3.7, 3.2.6 "Shell Command Options".
// Errors: parser::OptionError where a command's action is a fatal error, where a name cannot be put into a
// command, or no shell starts. One thread.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "parser/options/options.h"
#include "parser/restrictions/povray_conf.h"
#include "tools/lentray/message_form.h"

namespace lentray::tool {

/// What a command's %o, %s, %n, %k, %w and %h stand for.
struct CommandContext {
  std::string output;  ///< the picture's file
  std::string scene;   ///< its name without folder and extension
  int frame = 0;
  double clock = 0.0;
  std::int64_t width = 0, height = 0;
};

/// What is to be done now. Which steps kSkip and kSkipAll mean depends on the command: see the manual.
enum class Action { kGoOn, kSkip, kSkipAll, kQuit, kAbort };

class Commands {
 public:
  /// Warns at once of commands that no povray.conf allows; they are then never run.
  Commands(const parser::RenderOptions& options, const std::vector<parser::PovrayConf>& confs,
           const MessageForm& form);
  /// Runs the command of that kind, if there is one, and waits for its end. Fatal_Error_Command never throws
  /// and has no action; that of User_Abort_Command goes on with the abort.
  Action run(parser::CommandKind kind, const CommandContext& context);

 private:
  Action run_now(parser::CommandKind kind, const CommandContext& context);

  const parser::RenderOptions& m_options;
  const MessageForm& m_form;
  bool m_allowed = false;
};

/// Whether there are commands between frames, which may change what the scene reads.
bool has_frame_commands(const parser::RenderOptions& options);

/// The INI file's name of a command: "Pre_Scene_Command".
const char* name_of(parser::CommandKind kind);

/// The command with its % signs replaced. Throws OptionError where a value holds what a shell
/// would act upon.
std::string expanded(const std::string& command, const CommandContext& context);

}  // namespace lentray::tool
