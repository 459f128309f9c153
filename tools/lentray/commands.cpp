#include "tools/lentray/commands.h"

#include <spawn.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>

#include "core/base/joined.h"
#include "parser/base/shown.h"
#include "parser/files/files.h"
#include "tools/common/process.h"

namespace lentray::tool {
namespace {

using parser::CommandKind;

/// File names are put into the shell's text as they are.
const std::string& harmless(const std::string& name, const std::string& command) {
  const bool harms = std::any_of(name.begin(), name.end(), [](unsigned char c) {
    return c < 0x20 || std::string_view("\"'`$\\;&|<>(){}*?[]!#~").find(static_cast<char>(c)) !=
                           std::string_view::npos;
  });
  if (!harms) return name;
  throw parser::OptionError("the command '" + parser::shown_name(command) + "' is not run: '" +
                            parser::shown_name(name) +
                            "' holds characters that the shell would act upon");
}

/// Its exit status; 128 + n if signal n ended it.
int run_in_shell(const std::string& command) {
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t usual;
  sigemptyset(&usual);
  for (const int signal : {SIGPIPE, SIGXFSZ})
    sigaddset(&usual, signal);  // this program ignores them
  posix_spawnattr_setsigdefault(&attributes, &usual);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
  std::string text = command, shell = "sh", option = "-c";
  char* const arguments[] = {shell.data(), option.data(), text.data(), nullptr};
  std::fflush(nullptr);
  pid_t child = 0;
  const int error = posix_spawn(&child, "/bin/sh", nullptr, &attributes, arguments, environ);
  posix_spawnattr_destroy(&attributes);
  if (error != 0) throw parser::OptionError("no shell starts for the command '" + command + "'");
  return end_of(child);
}

Action action_of(char letter) {
  switch (letter) {
    case 'S': return Action::kSkip;
    case 'A': return Action::kSkipAll;
    case 'Q': return Action::kQuit;
    case 'U': return Action::kAbort;
    default: return Action::kGoOn;
  }
}

}  // namespace

const char* name_of(CommandKind kind) {
  constexpr std::array<const char*, parser::kCommands> kNames{
      "Pre_Scene_Command",  "Pre_Frame_Command",  "Post_Frame_Command",
      "Post_Scene_Command", "User_Abort_Command", "Fatal_Error_Command"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::string expanded(const std::string& command, const CommandContext& c) {
  std::string out;
  for (std::size_t i = 0; i < command.size(); ++i) {
    if (command[i] != '%' || i + 1 == command.size()) {
      out += command[i];
      continue;
    }
    switch (command[++i]) {
      case 'o': out += harmless(c.output, command); break;
      case 's': out += harmless(c.scene, command); break;
      case 'n': out += std::to_string(c.frame); break;
      case 'k': out += std::to_string(c.clock); break;
      case 'w': out += std::to_string(c.width); break;
      case 'h': out += std::to_string(c.height); break;
      case '%': out += '%'; break;
      default: out += {'%', command[i]};
    }
  }
  return out;
}

bool has_frame_commands(const parser::RenderOptions& options) {
  return std::ranges::any_of(
      std::array{CommandKind::kPreFrame, CommandKind::kPostFrame}, [&options](CommandKind kind) {
        return !options.commands[static_cast<std::size_t>(kind)].text.empty();
      });
}

Commands::Commands(const parser::RenderOptions& options,
                   const std::vector<parser::PovrayConf>& confs, const MessageForm& form)
    : m_options(options), m_form(form) {
  std::string names;
  for (std::size_t i = 0; i < parser::kCommands; ++i) {
    if (!options.commands[i].text.empty())
      names += (names.empty() ? "" : ", ") + std::string(name_of(static_cast<CommandKind>(i)));
  }
  if (names.empty()) return;
  m_allowed = parser::shellout_allowed(confs);
  if (m_allowed || options.warning_level == 0) return;
  std::string where = core::joined(parser::conf_places(), " or ");
  for (const parser::PovrayConf& conf : confs) {
    if (conf.shellout == parser::PovrayConf::Shellout::kForbidden) where = conf.path;
  }
  form.texts().write(parser::Stream::kWarning,
                     form.warning(names + ": not run; 'allowed' below [Shellout Security] in " +
                                  where + " would permit it") +
                         "\n");
}

Action Commands::run(CommandKind kind, const CommandContext& context) {
  if (m_options.commands[static_cast<std::size_t>(kind)].text.empty()) return Action::kGoOn;
  if (kind != CommandKind::kFatalError) return run_now(kind, context);
  try {
    run_now(kind, context);
  } catch (const parser::OptionError& error) {
    m_form.texts().write(parser::Stream::kWarning, m_form.warning(error.what()) + "\n");
  }
  return Action::kGoOn;
}

Action Commands::run_now(CommandKind kind, const CommandContext& context) {
  const parser::ShellCommand& command = m_options.commands[static_cast<std::size_t>(kind)];
  const std::string text = expanded(command.text, context);
  // As in stock, what may not run has failed.
  const int status = m_allowed ? run_in_shell(text) : 1;
  const bool triggered = (status == 0) == command.on_success;
  if (!triggered || command.action == 'I') return Action::kGoOn;
  const std::string what =
      std::string(name_of(kind)) + " '" + parser::shown_name(text) + "' " +
      (m_allowed ? "ended with status " + std::to_string(status) : "may not run");
  if (command.action == 'F') throw parser::OptionError(what + ", which is to be a fatal error");
  if (kind == CommandKind::kUserAbort) return Action::kGoOn;
  m_form.texts().write(parser::Stream::kRender, what + ": its action is " + command.action + "\n");
  return action_of(command.action);
}

}  // namespace lentray::tool
