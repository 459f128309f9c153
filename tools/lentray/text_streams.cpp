#include "tools/lentray/text_streams.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "core/image/file_swap.h"
#include "core/image/run_files.h"
#include "core/image/writer.h"
#include "core/image/written_bytes.h"
#include "parser/base/shown.h"

namespace lentray::tool {
namespace {

void put(std::string_view text, std::FILE* file) {
  if (file) std::fwrite(text.data(), 1, text.size(), file);
}

[[noreturn]] void fail(const std::string& name) {
  throw parser::OptionError("cannot write the text file '" + parser::shown_name(name) + "'");
}

/// A run that is stopped leaves what was said.
std::FILE* by_lines(std::FILE* file) {
  if (file) std::setvbuf(file, nullptr, _IOLBF, BUFSIZ);
  return file;
}

/// Pipes and devices take what comes; a pipe is not waited for.
std::FILE* open_text(const std::string& name, bool append) {
  struct stat status {};
  const bool is_special =
      ::stat(name.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
  if (!is_special) return by_lines(std::fopen(name.c_str(), append ? "ae" : "we"));
  const int file = core::open_device(name);
  return file < 0 ? nullptr : by_lines(::fdopen(file, "w"));
}

bool is_plain_file(const std::string& name) {
  struct stat status {};
  return ::stat(name.c_str(), &status) == 0 && S_ISREG(status.st_mode);
}

/// All that was written to `from`, which others may write to meanwhile.
void copy(std::FILE* from, std::FILE* to) {
  char buffer[1 << 14];
  off_t at = 0;
  for (ssize_t got; (got = ::pread(::fileno(from), buffer, sizeof buffer, at)) > 0; at += got)
    put({buffer, static_cast<std::size_t>(got)}, to);
}

}  // namespace

TextStreams::File* TextStreams::open(const std::string& name) {
  if (name.empty()) return nullptr;
  std::error_code error;
  for (File& known : m_opened) {
    if (known.name == name || std::filesystem::equivalent(known.name, name, error)) return &known;
  }
  File& out = m_opened.emplace_back();
  out.name = name;
  core::claim_output(name, "a text stream");
  out.waits = is_plain_file(name);
  if (out.waits && ::access(name.c_str(), W_OK) != 0) fail(name);
  out.file.reset(out.waits ? by_lines(std::tmpfile()) : open_text(name, m_append));
  if (!out.file) fail(name);
  if (!out.waits) core::note_made(name);
  return &out;
}

TextStreams::TextStreams(const parser::RenderOptions& o) : m_append(o.append_files) {
  const auto set = [&](parser::Stream stream, bool console, const std::string& file) {
    const auto i = static_cast<std::size_t>(stream);
    m_console[i] = console;
    m_files[i] = open(file);
  };
  set(parser::Stream::kDebug, o.debug_console, o.debug_file);
  set(parser::Stream::kRender, o.render_console, o.render_file);
  set(parser::Stream::kStatistics, o.statistic_console, o.statistic_file);
  set(parser::Stream::kWarning, o.warning_console, o.warning_file);
  set(parser::Stream::kFatal, o.fatal_console, o.fatal_file);
  m_all = open(o.all_file);
}

void TextStreams::keep() {
  const std::lock_guard lock(m_keeping);
  for (File& file : m_opened) keep(file);
}

void TextStreams::keep(File& file) {
  if (!file.waits) return;
  file.waits = false;
  const core::OpenFile said = std::move(file.file);
  std::fflush(said.get());
  core::check_not_input(file.name);
  file.file.reset(open_text(file.name, m_append));
  if (!file.file) fail(file.name);
  core::note_made(file.name);
  copy(said.get(), file.file.get());
}

void TextStreams::keep_at_end() {
  if (!m_keeping.try_lock()) return;
  for (File& file : m_opened) {
    if (!file.waits) continue;
    try {
      core::check_not_input(file.name);
    } catch (const core::ImageError&) {
      continue;
    }
    const core::OpenFile to(open_text(file.name, m_append));
    if (to) copy(file.file.get(), to.get());
  }
}

void TextStreams::write(parser::Stream stream, std::string_view text) {
  if (m_console[static_cast<std::size_t>(stream)]) put(parser::shown_text(text), stderr);
  log(stream, text);
}

void TextStreams::log(parser::Stream stream, std::string_view text) {
  for (const File* file : {m_files[static_cast<std::size_t>(stream)], m_all}) {
    if (!file || !m_limit.empty()) continue;
    m_limit = core::count_written(text.size());
    if (m_limit.empty()) put(text, file->file.get());
  }
}

std::string TextStreams::trouble() const {
  const auto bad = std::ranges::find_if(m_opened, [](const File& one) {
    return one.file && (std::fflush(one.file.get()) != 0 || std::ferror(one.file.get()) != 0);
  });
  if (bad != m_opened.end())
    return "cannot write the text file '" + bad->name + "': no space, or the disk failed";
  return m_limit.empty() ? "" : "text files lack what was said last: " + m_limit;
}

}  // namespace lentray::tool
