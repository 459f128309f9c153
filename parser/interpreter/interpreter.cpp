#include "parser/interpreter/interpreter.h"

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "core/base/deep_threads.h"
#include "core/base/memory_limit.h"
#include "parser/base/shown.h"
#include "parser/tokens/keywords.h"

namespace lentray::parser {
namespace {

/// What the memory has room for, beside what nests.
double room() { return core::memory_limit() / 4.0; }

/// Of nested statements and expressions.
std::uintptr_t stack_budget() {
  constexpr double kMost = 1 << 30, kPart = 5.0 / 8.0;
  const double stack = static_cast<double>(core::own_stack().bytes);
  return static_cast<std::uintptr_t>(std::min({kMost, kPart * stack, room()}));
}

std::size_t levels_that_fit() {
  const std::size_t levels = core::own_stack().levels();
  const double bytes = static_cast<double>(levels) * core::kStackBytesALevel;
  return bytes > room() ? static_cast<std::size_t>(room() / core::kStackBytesALevel) : levels;
}

}  // namespace

Interpreter::Interpreter(SourceManager& sources_, Diagnostics& diagnostics_,
                         const ParserOptions& options_, Productions& productions_, Parser& parser_)
    : sources(sources_), diagnostics(diagnostics_), options(options_), productions(productions_),
      parser(parser_), tokens(*this, stream, symbols), expressions(*this), functions(*this),
      directives(*this), files(*this) {
  m_stack_end = stack_address() - std::min(stack_budget(), stack_address());
  most_levels = std::min(options.limits.nested, levels_that_fit());
  if (options.language_version > 0) {
    version = options.language_version;
    version_set = has_own_version = true;
    *noise_generator = version < 350 ? 1 : 2;
  }
}

void Interpreter::stack_exhausted() {
  fail(tokens.location(), "statements or expressions nest too deeply: endless recursion?");
}

void Interpreter::too_many_turns() {
  fail(tokens.location(), "more than " + std::to_string(options.limits.turns) +
                              " turns of loops and calls of macros: an endless loop?");
}

void Interpreter::fail(const Location& where, const std::string& message,
                       const std::string& shown) {
  diagnostics.fail(where, message, stream.stack(names), shown);
}

void Interpreter::warn(const Location& where, const std::string& message) {
  if (diagnostics.has_warned(where, message)) return;
  diagnostics.warn(where, message, stream.stack(names));
}

Frame* Interpreter::push_scene(const std::string& path) {
  auto text = sources.disk().read_scene(path);
  if (!text) return nullptr;
  scene_file = sources.add(path, std::move(*text));
  Text scene{scene_file, nullptr};
  return &push_text(scene);
}

Frame* Interpreter::push_file(const std::string& path, const Location& where) {
  auto found = texts.find(path);
  if (found == texts.end()) {
    const auto file = ask_files(where, [&](Files&) { return sources.load(path); });
    if (!file) return nullptr;
    found = texts.emplace(path, Text{*file, nullptr}).first;
  }
  Frame& frame = push_text(found->second);
  frame.kind = FrameKind::kInclude;
  frame.call = where;
  return &frame;
}

Frame& Interpreter::push_text(Text& text) {
  constexpr std::size_t kBytesAToken = 64;  // more than most have
  const std::string_view bytes = sources.text(text.file);
  Frame& frame = stream.push();
  if (bytes.size() / kBytesAToken >= options.piece_tokens) {
    frame.pieces = std::make_unique<TokenPieces>(text.file, bytes, names);
    frame.next_piece(options.piece_tokens);
    return frame;
  }
  if (!text.tokens) text.tokens = tokenise(text.file, bytes, names);
  frame.begin(text.tokens);
  return frame;
}

std::vector<std::string> Interpreter::search_folders() const {
  std::vector<std::string> folders;
  if (!scene_folder.empty()) folders.push_back(scene_folder);
  folders.insert(folders.end(), options.library_paths.begin(), options.library_paths.end());
  return folders;
}

void Interpreter::check_file_name(const std::string& name, const Location& where) {
  if (name.find('\0') != name.npos)
    fail(where, "no file has a name with a NUL in it: '" + shown_name(name) + "'");
}

/// `refused` keeps the first reason why not.
bool Interpreter::may_read(const std::string& path, std::string& refused) const {
  try {
    return sources.disk().exists(path);
  } catch (const FileRefused& why) {
    if (refused.empty()) refused = why.what();
    return false;
  }
}

std::optional<std::string> Interpreter::find_file(const std::string& name, const Location& where) {
  check_file_name(name, where);
  std::string refused;
  if (auto found = search(name, refused)) return found;
  if (auto found = search_loosely(name, refused)) return found;
  if (!refused.empty()) fail(where, refused);
  return std::nullopt;
}

std::optional<std::string> Interpreter::find_exactly(const std::string& name,
                                                     const Location& where) {
  check_file_name(name, where);
  std::string refused;
  auto found = search(name, refused);
  if (!found && !refused.empty()) fail(where, refused);
  return found;
}

std::optional<std::string> Interpreter::search_loosely(const std::string& name,
                                                       std::string& refused) {
  std::vector<std::string> folders = search_folders();
  folders.insert(folders.begin(), "");
  for (const std::string& folder : folders) {
    const auto found = sources.disk().find_loosely(folder, name);
    if (!found || !may_read(*found, refused)) continue;
    if (!m_warned_of_names) {
      warn(tokens.location(), "there is no file '" + name + "', read '" + *found +
                                  "' as Windows would (of other such names nothing is said)");
    }
    m_warned_of_names = true;
    return found;
  }
  return std::nullopt;
}

std::optional<std::string> Interpreter::search(const std::string& name,
                                               std::string& refused) const {
  namespace fs = std::filesystem;
  if (name.empty()) return std::nullopt;
  if (may_read(name, refused)) return name;
  if (fs::path(name).is_absolute()) return std::nullopt;
  for (const std::string& folder : search_folders()) {
    std::string path = (fs::path(folder) / name).string();
    if (may_read(path, refused)) return path;
  }
  return std::nullopt;
}

void Interpreter::declare_constants() {
  const auto declare = [&](std::string_view name, Value value) {
    symbols.declare_global(names.intern(name)).reset(std::move(value));
  };
  const auto number = [&](std::string_view name, double x) { declare(name, Number::scalar(x)); };
  const auto watched = [&](std::string_view name, double x, bool& was_read) {
    Symbol& symbol = symbols.declare_global(names.intern(name));
    symbol.reset(Number::scalar(x));
    symbol.edit_extras().was_read = &was_read;
  };
  const FrameClock& frame = options.frame;
  watched("clock_delta", frame.clock_delta, reads.clock);
  watched("frame_number", frame.frame_number, reads.frames);
  watched("initial_frame", frame.initial_frame, reads.frames);
  watched("final_frame", frame.final_frame, reads.frames);
  watched("initial_clock", frame.initial_clock, reads.clock);
  watched("final_clock", frame.final_clock, reads.clock);
  watched("image_width", options.image_width, reads.width);
  watched("image_height", options.image_height, reads.height);
  for (const auto& [name, text] : options.declares) {
    char* end = nullptr;
    const double x = std::strtod(text.c_str(), &end);
    if (!text.empty() && end == text.c_str() + text.size()) {
      number(name, x);
    } else {
      const bool quoted = text.size() > 1 && text.front() == '"' && text.back() == '"';
      declare(name, quoted ? text.substr(1, text.size() - 2) : text);
    }
  }
}

double Interpreter::now() {
  constexpr double kSecondsTo2000 = 946684800.0, kDay = 86400.0;
  constexpr int kOfOneMoment = 1000;
  const auto clock = [] {
    const auto since = std::chrono::system_clock::now().time_since_epoch();
    return (std::chrono::duration<double>(since).count() - kSecondsTo2000) / kDay;
  };
  if (!reads.now) {
    m_first_asked = clock();
    reads.now = options.now.value_or(m_first_asked);
  }
  if (m_asked < kOfOneMoment) {
    ++m_asked;
    return *reads.now;
  }
  return *reads.now + (clock() - m_first_asked);
}

std::string Interpreter::suggestion(std::string_view name) const {
  std::vector<std::string_view> known;
  for (const NameId id : symbols.visible_names()) known.push_back(names.text(id));
  // Nobody who writes T means the reserved word t.
  constexpr std::size_t kShortest = 3;
  const std::size_t end =
      name.size() < kShortest ? 1 : static_cast<std::size_t>(Keyword::kEndOfKeywords);
  for (std::size_t i = 1; i < end; ++i) {
    known.push_back(spelling(static_cast<Keyword>(i)));
  }
  const std::string_view near = nearest_name(name, known);
  return near.empty() ? "" : ", did you mean '" + std::string(near) + "'?";
}

}  // namespace lentray::parser
