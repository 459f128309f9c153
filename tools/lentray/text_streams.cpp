#include "tools/lentray/text_streams.h"

#include <algorithm>
#include <string>

#include "parser/base/shown.h"

namespace lentray::tool {
namespace {

void put(std::string_view text, std::FILE* file) {
  if (file) std::fwrite(text.data(), 1, text.size(), file);
}

}  // namespace

TextStreams::File TextStreams::open(const std::string& name, bool append) {
  if (name.empty()) return {};
  File out{std::unique_ptr<std::FILE, Close>(std::fopen(name.c_str(), append ? "a" : "w")), name};
  if (!out.file) throw parser::OptionError("cannot write the text file '" + name + "'");
  std::setvbuf(out.file.get(), nullptr, _IOLBF,
               BUFSIZ);  // a run that is stopped leaves what was said
  return out;
}

TextStreams::TextStreams(const parser::RenderOptions& o) {
  const auto set = [&](parser::Stream stream, bool console, const std::string& file) {
    const auto i = static_cast<std::size_t>(stream);
    m_console[i] = console;
    m_files[i] = open(file, o.append_files);
  };
  set(parser::Stream::kDebug, o.debug_console, o.debug_file);
  set(parser::Stream::kRender, o.render_console, o.render_file);
  set(parser::Stream::kStatistics, o.statistic_console, o.statistic_file);
  set(parser::Stream::kWarning, o.warning_console, o.warning_file);
  set(parser::Stream::kFatal, o.fatal_console, o.fatal_file);
  m_all = open(o.all_file, o.append_files);
}

void TextStreams::write(parser::Stream stream, std::string_view text) {
  if (m_console[static_cast<std::size_t>(stream)]) put(parser::shown_text(text), stderr);
  log(stream, text);
}

void TextStreams::log(parser::Stream stream, std::string_view text) {
  put(text, m_files[static_cast<std::size_t>(stream)].file.get());
  put(text, m_all.file.get());
}

std::string TextStreams::trouble() const {
  const auto failed = [](const File& one) {
    return one.file && (std::fflush(one.file.get()) != 0 || std::ferror(one.file.get()) != 0);
  };
  const auto bad = std::find_if(m_files.begin(), m_files.end(), failed);
  const File* found = bad != m_files.end() ? &*bad : failed(m_all) ? &m_all : nullptr;
  return found ? "cannot write the text file '" + found->name + "': no space, or the disk failed"
               : "";
}

}  // namespace lentray::tool
