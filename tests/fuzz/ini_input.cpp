#include <stdexcept>
#include <string_view>
#include <vector>

#include "parser/options/create_ini.h"
#include "parser/options/lens_sheets.h"
#include "parser/options/options.h"
#include "tests/fuzz/input_file.h"
#include "tests/fuzz/text_input.h"

namespace lentray::test {
namespace {

constexpr std::int64_t kMostFrames = 1000;

parser::RenderOptions options_of(const std::vector<std::string>& words,
                                 const std::vector<std::string>& lens_sheets) {
  return parser::read_options(words, {{}, {}, lens_sheets});
}

/// What a run asks of its options before it reads the scene.
void ask(const parser::RenderOptions& options) {
  const parser::AnimationOptions& loop = options.animation;
  const std::int64_t first = loop.initial_frame.value_or(0), last = loop.final_frame.value_or(0);
  if (last - first < kMostFrames && loop.views.count < kMostFrames) frames_of(loop);
  core::FileType type = options.type;
  parser::output_path(options, type);
  parser::ini_path(options);
  parser::picture_lines(options);
  parser::rendered_view(options);
}

/// Create_Ini's file asks for the same again.
void read_again(const parser::RenderOptions& options) {
  const std::string text = parser::ini_text(options);
  const InputFile file(reinterpret_cast<const std::uint8_t*>(text.data()), text.size(),
                       "-again.ini");
  std::string again;
  try {
    again = parser::ini_text(options_of({file.path()}, {}));
  } catch (const parser::OptionError& error) {
    again = error.what();
  }
  if (again != text) throw std::logic_error("read again:\n" + again + "\ninstead of:\n" + text);
}

/// Its message, if one ends it.
template <typename Work>
void note(std::string& message, Work work) {
  try {
    work();
  } catch (const parser::OptionError& error) {
    message = error.what();
  } catch (const camera::CameraError& error) {
    message = error.what();
  }
}

}  // namespace

std::string use_ini(const std::uint8_t* data, std::size_t size) {
  const InputFile file(data, size, ".ini");
  std::string message;
  note(message, [&] { ask(options_of({"--scene-ini", file.path()}, {})); });
  note(message, [&] { parser::lens_sheets(std::vector{file.path()}); });
  note(message, [&] { ask(options_of({file.path() + "[a]", "Restrict_IO=On"}, {file.path()})); });
  note(message, [&] {
    const parser::RenderOptions options = options_of({file.path()}, {});
    ask(options);
    read_again(options);
  });
  return message;
}

}  // namespace lentray::test
