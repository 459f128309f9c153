#include "tools/lentray/text_streams.h"

#include <string>

namespace lentray::tool {
namespace {

std::FILE* open(const std::string& name, bool append) {
  if (name.empty()) return nullptr;
  std::FILE* file = std::fopen(name.c_str(), append ? "a" : "w");
  if (!file) throw parser::OptionError("cannot write the text file '" + name + "'");
  std::setvbuf(file, nullptr, _IOLBF, BUFSIZ);  // a run that is stopped leaves what was said
  return file;
}

void put(std::string_view text, std::FILE* file) {
  if (file) std::fwrite(text.data(), 1, text.size(), file);
}

}  // namespace

TextStreams::TextStreams(const parser::RenderOptions& o) {
  const auto set = [&](parser::Stream stream, bool console, const std::string& file) {
    const auto i = static_cast<std::size_t>(stream);
    m_console[i] = console;
    m_files[i].reset(open(file, o.append_files));
  };
  set(parser::Stream::kDebug, o.debug_console, o.debug_file);
  set(parser::Stream::kRender, o.render_console, o.render_file);
  set(parser::Stream::kStatistics, o.statistic_console, o.statistic_file);
  set(parser::Stream::kWarning, o.warning_console, o.warning_file);
  set(parser::Stream::kFatal, o.fatal_console, o.fatal_file);
  m_all.reset(open(o.all_file, o.append_files));
}

void TextStreams::write(parser::Stream stream, std::string_view text) {
  if (m_console[static_cast<std::size_t>(stream)]) put(text, stderr);
  log(stream, text);
}

void TextStreams::log(parser::Stream stream, std::string_view text) {
  put(text, m_files[static_cast<std::size_t>(stream)].get());
  put(text, m_all.get());
}

}  // namespace lentray::tool
