// lentray: renders POV-Ray scenes, also as integral images for lenticular sheets.
#include <malloc.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "camera/lens_request.h"
#include "core/base/deep_threads.h"
#include "core/image/writer.h"
#include "parser/options/lens_sheets.h"
#include "parser/options/options.h"
#include "parser/options/options_help.h"
#include "parser/source/build_error.h"
#include "parser/source/diagnostics.h"
#include "tools/common/standard_streams.h"
#include "tools/common/version.h"
#include "tools/lentray/run.h"
#include "tools/lentray/run_guard.h"
#include "tools/lentray/text_streams.h"
#include "tools/lentray/warnings.h"

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

std::string line(const std::string& text) {
  return text.empty() || text.back() != '\n' ? text + "\n" : text;
}

/// Where texts go once the options are known.
std::optional<tool::TextStreams> g_texts;

/// What ended the run is said whatever the options are.
int fail(const char* prefix, const std::string& text, int status) {
  const std::string whole = line(prefix + text);
  std::fputs(whole.c_str(), stderr);
  if (g_texts) g_texts->log(Stream::kFatal, whole);
  return status;
}

constexpr const char* kError = "lentray: ";

/// Runs `work`; what it throws becomes a message and an exit status.
template <typename Work>
int guarded(Work work) {
  try {
    return work();
  } catch (const parser::ParseError& error) {
    return fail("", error.what(), tool::kUserError);
  } catch (const parser::OptionError& error) {
    return fail(kError, error.what(), tool::kUserError);
  } catch (const camera::CameraError& error) {
    return fail(kError, error.what(), tool::kUserError);
  } catch (const core::ImageError& error) {
    return fail(kError, error.what(), tool::kUserError);
  } catch (const parser::BuildError& error) {
    return fail(kError, error.what(), tool::kUserError);
  } catch (const std::bad_alloc&) {
    return fail(kError, "there is not enough memory for this scene and picture", tool::kUserError);
  } catch (const std::length_error&) {  // more than any memory holds
    return fail(kError, "there is not enough memory for this scene and picture", tool::kUserError);
  } catch (const std::system_error& error) {
    return fail(kError, error.what(), tool::kUserError);
  } catch (const std::exception& error) {
    return fail("lentray: internal error: ", error.what(), tool::kInternalError);
  }
}

/// By a link, for programs that run povray.
bool called_as_povray(const std::filesystem::path& program) {
  return program.filename().string().starts_with("povray");
}

/// Stock tells of itself on standard error, and callers look for "POV-Ray 3.7" there.
void tell(const parser::RenderOptions& options, bool as_povray) {
  std::FILE* const out = as_povray ? stderr : stdout;
  if (options.help) {
    std::fputs((options.help_all ? parser::full_help_text() : parser::help_text()).c_str(), out);
  } else if (as_povray) {
    std::fprintf(out,
                 "POV-Ray %s compatible: Lentray %s\n\nThis is not POV-Ray, but a renderer that "
                 "reads its scenes and options.\n",
                 tool::kPovRayVersion, tool::kVersion);
  } else {
    std::fprintf(out, "Lentray %s\n", tool::kVersion);
  }
}

int run_main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  parser::RenderOptions options;
  int status = guarded([&] {
    options = parser::read_options(arguments, parser::installed_sources());
    return static_cast<int>(tool::kDone);
  });
  if (status != tool::kDone) return status;
  if (options.list_lens_sheets && !options.help && !options.version) {
    return guarded([&] {
      const auto files = parser::installed_lens_sheet_files();
      std::fputs(parser::lens_sheet_list(options, files).c_str(), stdout);
      return static_cast<int>(tool::kDone);
    });
  }
  if (options.help || options.version) {
    tell(options, called_as_povray(argc > 0 ? argv[0] : ""));
    return tool::kDone;
  }
  status = guarded([&] {
    g_texts.emplace(options);
    return static_cast<int>(tool::kDone);
  });
  if (status != tool::kDone) return status;
  tool::Warnings warnings(*g_texts, options.warning_level);
  for (const std::string& text : options.warnings) warnings.add("warning: " + text);
  warnings.say();
  tool::RunGuard guard;
  if (options.max_time > 0.0) guard.limit_time(options.max_time);
  status = guarded([&] {
    try {
      return static_cast<int>(tool::run(options, guard.asked(), *g_texts, warnings));
    } catch (...) {
      // Warnings first: they often tell what the error is about.
      warnings.say();
      throw;
    }
  });
  if (status == tool::kAborted) {
    guard.asked() ? tool::tell_stopped()
                  : (void)std::fputs("lentray: stopped by a command\n", stderr);
  }
  if (status == tool::kDone && !g_texts->trouble().empty())
    return fail(kError, g_texts->trouble(), tool::kUserError);
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  tool::hold_standard_streams();
  keep_memory();
  int status = tool::kInternalError;
  // Scenes nest objects, looks and expressions in each other as deep as they like.
  core::run_on_deep_stack([&] { status = run_main(argc, argv); });
  return tool::finish_standard_output("lentray", status);
}
