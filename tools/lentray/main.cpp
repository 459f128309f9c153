// lentray: renders POV-Ray scenes, also as integral images for lenticular sheets.
#include <malloc.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "camera/lens_request.h"
#include "core/base/damaged_record.h"
#include "core/base/deep_threads.h"
#include "core/base/memory_limit.h"
#include "core/image/writer.h"
#include "core/image/written_bytes.h"
#include "parser/base/shown.h"
#include "parser/files/files.h"
#include "parser/options/lens_sheets.h"
#include "parser/options/options.h"
#include "parser/options/options_help.h"
#include "parser/restrictions/run_rules.h"
#include "parser/source/build_error.h"
#include "parser/source/diagnostics.h"
#include "tools/common/machine.h"
#include "tools/common/standard_streams.h"
#include "tools/common/version.h"
#include "tools/lentray/message_form.h"
#include "tools/lentray/picture_run.h"
#include "tools/lentray/run.h"
#include "tools/lentray/run_sandbox.h"
#include "tools/lentray/stock_form.h"
#include "tools/lentray/text_streams.h"
#include "tools/lentray/warnings.h"
#include "tools/session/run_guard.h"

namespace {

using namespace lentray;

/// What reading a scene gave back is used again by what is built of it, large blocks too: memory from
/// the system costs more than filling it.
void keep_memory() {
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  mallopt(M_TOP_PAD, 1 << 20);
}

using parser::Stream;

std::string line(const std::string& text) { return text.ends_with('\n') ? text : text + "\n"; }

constexpr const char* kNoMemory = "there is not enough memory for this scene and picture";

/// Where texts go and how they look once the options are known.
struct Output {
  std::optional<tool::TextStreams> texts;
  std::unique_ptr<tool::MessageForm> form;

  /// What ended the run is said whatever the options are.
  int fail(const std::string& text, int status = tool::kUserError) {
    std::fputs(parser::shown_text(text).c_str(), stderr);
    if (texts) texts->log(Stream::kFatal, text);
    return status;
  }
  /// What is wrong has no place in the scene.
  int fail_nowhere(const std::string& text, int status = tool::kUserError) {
    return fail(line(form ? form->error(text) : "lentray: " + text), status);
  }
  template <typename Work>
  int guarded(Work work);
};

template <class... Errors>
bool is_one_of(const std::exception& error) {
  return (dynamic_cast<const Errors*>(&error) || ...);
}

/// Runs `work`; what it throws becomes a message and an exit status.
template <typename Work>
int Output::guarded(Work work) {
  try {
    return work();
  } catch (const parser::ParseError& error) {
    return fail(line(error.what()));
  } catch (const std::exception& error) {
    if (is_one_of<parser::OptionError, parser::BuildError, parser::FileRefused, camera::CameraError,
                  core::ImageError, core::NoRoom, core::DamagedRecord, std::system_error>(error))
      return fail_nowhere(error.what());
    // A length_error: more than any memory holds.
    if (is_one_of<std::bad_alloc, std::length_error>(error)) return fail_nowhere(kNoMemory);
    return fail_nowhere(std::string("internal error: ") + error.what(), tool::kInternalError);
  }
}

/// By a link, for programs that run povray.
bool called_as_povray(const std::filesystem::path& program) {
  return program.filename().string().starts_with("povray");
}

/// Stock reports of itself on standard error, and callers look for "POV-Ray 3.7" there.
void tell(const parser::RenderOptions& options, bool as_povray) {
  std::FILE* const out = as_povray ? stderr : stdout;
  if (options.help) {
    std::fputs((options.help_all ? parser::full_help_text() : parser::help_text()).c_str(), out);
  } else if (as_povray) {
    std::fputs(tool::stock_title().c_str(), out);
  } else {
    std::fprintf(out, "Lentray %s\n", tool::kVersion);
  }
}

/// The pictures, with guards and warnings around them.
int render(const parser::RenderOptions& options, tool::RunGuard& guard, Output& out) {
  tool::Warnings warnings(*out.form, options.warning_level);
  for (const std::string& text : options.warnings) warnings.tell(text);
  warnings.say();
  guard.limit_memory(options.max_memory > 0.0 ? options.max_memory : tool::machine_memory());
  if (options.max_time > 0.0) guard.limit_time(options.max_time);
  if (options.max_written > 0.0) core::limit_written(options.max_written);
  const int status = out.guarded([&] {
    try {
      return tool::run(options, guard.asked(), *out.form, warnings);
    } catch (...) {
      // Warnings first: they often say what the error is about.
      warnings.say();
      throw;
    }
  });
  if (status == tool::kAborted) {
    guard.asked() ? guard.tell_stopped()
                  : (void)std::fputs("lentray: stopped by a command\n", stderr);
  }
  return status;
}

int run_main(int argc, char** argv) {
  const std::string program = argc > 0 ? argv[0] : "";
  const bool as_povray = called_as_povray(program);
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  parser::RenderOptions options;
  Output out;
  bool is_over = false;
  int status = out.guarded([&] {
    try {
      options = parser::read_options(arguments, parser::installed_sources());
      if (as_povray) options.sampling_method = std::min(options.sampling_method, 2);
    } catch (...) {
      if (as_povray) std::fputs(tool::stock_option_problem(program, arguments).c_str(), stderr);
      throw;
    }
    const bool tells = options.help || options.version;
    is_over = tells || options.list_lens_sheets;
    if (tells) {
      tell(options, as_povray);
    } else if (options.list_lens_sheets) {
      const auto files = parser::installed_lens_sheet_files();
      std::fputs(parser::lens_sheet_list(options, files).c_str(), stdout);
    } else {
      parser::judge_outputs(options);
      parser::check_pixels(options);
      out.texts.emplace(options);
      out.form = tool::make_message_form(options.stock_messages.value_or(as_povray), *out.texts);
    }
    return tool::kDone;
  });
  if (status != tool::kDone || is_over) return status;
  if (const std::string lack = tool::enter_sandbox(options); !lack.empty())
    options.warnings.push_back(lack);
  tool::RunGuard guard([&out] { out.texts->keep_at_end(); });
  if (tool::renders(options)) out.form->begin_run();
  status = render(options, guard, out);
  const int kept = out.guarded([&] {
    out.texts->keep();
    return tool::kDone;
  });
  if (status == tool::kDone) status = kept;
  if (status == tool::kDone && !out.texts->trouble().empty())
    status = out.fail_nowhere(out.texts->trouble());
  if (tool::renders(options)) out.form->end_run(status);
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  tool::hold_standard_streams();
  keep_memory();
  int status = tool::kInternalError;
  // Scenes nest objects, textures and expressions in each other as deep as they like.
  core::run_on_deep_stack([&] { status = run_main(argc, argv); });
  return tool::finish_standard_output("lentray", status);
}
