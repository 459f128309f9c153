// Commands of INI files: what is put in, what their exit status leads to, and that nothing runs unless allowed.
#include "tools/lentray/commands.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tools/common/process.h"

namespace lentray::tool {
namespace {

using parser::CommandKind;
using parser::PovrayConf;

PovrayConf conf_of(PovrayConf::Shellout shellout) {
  PovrayConf conf;
  conf.path = "some.conf";
  conf.shellout = shellout;
  return conf;
}

class UnitCommands : public ::testing::Test {
 protected:
  UnitCommands() { m_options.all_file = (m_folder / "texts").string(); }
  parser::ShellCommand& of(CommandKind kind) {
    return m_options.commands[static_cast<std::size_t>(kind)];
  }
  Action run(CommandKind kind, PovrayConf::Shellout shellout = PovrayConf::Shellout::kAllowed) {
    m_options.warning_console = m_options.render_console = false;
    TextStreams texts(m_options);
    const auto form = make_message_form(false, texts);
    Commands commands(m_options, {conf_of(shellout)}, *form);
    return commands.run(kind, {"o.png", "s", 7, 0.5, 4, 3});
  }
  std::string texts() const { return tool::read_text(m_folder / "texts"); }

  tool::TemporaryFolder m_folder;
  parser::RenderOptions m_options;
};

TEST(UnitCommandText, Substitutions) {
  const CommandContext context{"dir/my picture.png", "scene", 12, 0.25, 640, 480};
  EXPECT_EQ(expanded("a %o %s %n %k %h %w %% %z 100%", context),
            "a dir/my picture.png scene 12 0.250000 480 640 % %z 100%");
  for (const char* name : {"a;b", "$(b)", "a`b`", "a'b", "a\nb"}) {
    EXPECT_THROW(expanded("x %s", {"o", name, 0, 0.0, 1, 1}), parser::OptionError) << name;
    EXPECT_EQ(expanded("x %o", {"o", name, 0, 0.0, 1, 1}), "x o");
  }
}

TEST_F(UnitCommands, StatusAndAction) {
  struct Case {
    const char* command;
    char action;
    bool on_success;
    Action expected;
  };
  for (const Case& c : {Case{"true", 'S', false, Action::kGoOn},
                        {"false", 'S', false, Action::kSkip},
                        {"false", 'S', true, Action::kGoOn},
                        {"true", 'S', true, Action::kSkip},
                        {"exit 3", 'A', false, Action::kSkipAll},
                        {"exit 3", 'Q', false, Action::kQuit},
                        {"exit 3", 'U', false, Action::kAbort},
                        {"exit 3", 'I', false, Action::kGoOn},
                        {"kill -9 $$", 'Q', false, Action::kQuit}}) {
    of(CommandKind::kPreFrame) = {c.command, c.action, c.on_success};
    EXPECT_EQ(run(CommandKind::kPreFrame), c.expected) << c.command << c.action << c.on_success;
  }
  of(CommandKind::kPreFrame) = {"exit 3", 'F', false};
  EXPECT_THROW(run(CommandKind::kPreFrame), parser::OptionError);
  of(CommandKind::kUserAbort) = {"exit 3", 'F', false};
  EXPECT_THROW(run(CommandKind::kUserAbort), parser::OptionError);
  of(CommandKind::kUserAbort) = {"exit 3", 'Q', false};
  EXPECT_EQ(run(CommandKind::kUserAbort), Action::kGoOn);
  of(CommandKind::kFatalError) = {"exit 3", 'F', false};
  EXPECT_EQ(run(CommandKind::kFatalError), Action::kGoOn);
  EXPECT_EQ(run(CommandKind::kPostScene), Action::kGoOn) << "there is none";
}

TEST_F(UnitCommands, NothingRunsUnlessAllowed) {
  const std::string made = (m_folder / "made").string();
  of(CommandKind::kPreScene) = {"touch " + made + "; exit 1", 'I', false};
  for (const auto shellout : {PovrayConf::Shellout::kForbidden, PovrayConf::Shellout::kUnsaid}) {
    EXPECT_EQ(run(CommandKind::kPreScene, shellout), Action::kGoOn);
    EXPECT_FALSE(std::filesystem::exists(made));
    EXPECT_NE(texts().find("Pre_Scene_Command: not run; 'allowed' below [Shellout Security] in "),
              std::string::npos);
  }
  of(CommandKind::kPreScene).action = 'F';
  EXPECT_THROW(run(CommandKind::kPreScene, PovrayConf::Shellout::kForbidden), parser::OptionError)
      << "as in stock, what may not run has failed";
  EXPECT_FALSE(std::filesystem::exists(made));
  EXPECT_THROW(run(CommandKind::kPreScene), parser::OptionError);
  EXPECT_TRUE(std::filesystem::exists(made));
}

}  // namespace
}  // namespace lentray::tool
