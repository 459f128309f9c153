#include "parser/interpreter/directives.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "parser/base/shown.h"
#include "parser/base/text.h"
#include "parser/interpreter/interpreter.h"
#include "parser/tokens/keywords.h"

namespace lentray::parser {
namespace {

constexpr Keyword kDirectives[] = {
    Keyword::kIf,      Keyword::kIfdef,   Keyword::kIfndef,  Keyword::kElse,       Keyword::kElseif,
    Keyword::kEnd,     Keyword::kSwitch,  Keyword::kCase,    Keyword::kRange,      Keyword::kWhile,
    Keyword::kFor,     Keyword::kBreak,   Keyword::kMacro,   Keyword::kDeclare,    Keyword::kLocal,
    Keyword::kUndef,   Keyword::kInclude, Keyword::kVersion, Keyword::kDefault,    Keyword::kDebug,
    Keyword::kWarning, Keyword::kError,   Keyword::kRender,  Keyword::kStatistics, Keyword::kFopen,
    Keyword::kFclose,  Keyword::kRead,    Keyword::kWrite};

// Stock cuts long messages; scenes are not known to rely on it, comparisons of output are.
std::string cut(std::string text, std::size_t longest, std::size_t kept) {
  if (text.size() <= longest) return text;
  return text.substr(0, kept - 3) + "...";
}

}  // namespace

bool Directives::has(Keyword keyword) {
  static constexpr auto kHas = [] {
    std::array<bool, static_cast<std::size_t>(Keyword::kEndOfKeywords)> has{};
    for (const Keyword directive : kDirectives) has[static_cast<std::size_t>(directive)] = true;
    return has;
  }();
  return kHas[static_cast<std::size_t>(keyword)];
}

void Directives::execute(const Token& directive) {
  m_in.guard_stack();
  switch (directive.keyword) {
    case Keyword::kIf:
    case Keyword::kIfdef:
    case Keyword::kIfndef: return if_directive(directive);
    case Keyword::kElse:
    case Keyword::kElseif: return else_part(directive);
    case Keyword::kEnd: return end_part(directive);
    case Keyword::kSwitch: return switch_directive(directive);
    case Keyword::kCase:
    case Keyword::kRange: return case_part(directive);
    case Keyword::kWhile: return while_directive(directive);
    case Keyword::kFor: return for_directive(directive);
    case Keyword::kBreak: return break_directive(directive);
    case Keyword::kMacro: return define_macro(directive);
    case Keyword::kDeclare: return declare(directive.where, false);
    case Keyword::kLocal: return declare(directive.where, true);
    case Keyword::kUndef: return undef();
    case Keyword::kInclude: return include_directive();
    case Keyword::kVersion: return version();
    case Keyword::kDefault: return m_in.productions.set_default(m_in.parser);
    case Keyword::kDebug:
    case Keyword::kWarning:
    case Keyword::kError:
    case Keyword::kRender:
    case Keyword::kStatistics: return message(directive);
    case Keyword::kFopen: return m_in.files.open();
    case Keyword::kFclose: return m_in.files.close();
    case Keyword::kRead: return m_in.files.read();
    case Keyword::kWrite: return m_in.files.write();
    default: break;
  }
  std::vector<std::string_view> names;
  for (const Keyword keyword : kDirectives) names.push_back(spelling(keyword));
  const std::string_view word = m_in.names.text(directive.name);
  const std::string_view near = nearest_name(word, names);
  m_in.fail(directive.where,
            "unknown directive #" + std::string(word) +
                (near.empty() ? "" : ", did you mean #" + std::string(near) + "?"));
}

void Directives::execute_unmarked(const Token& word) {
  if (m_in.version >= 300)
    m_in.warn(word.where, "expected '#' before '" + std::string(m_in.names.text(word.name)) + "'");
  execute(word);
}

bool Directives::leave_frame() {
  Frame& frame = m_in.stream.top();
  if (m_blocks.size() > frame.blocks)
    missing_end(*m_blocks.back().opener);  // no piece ends in a block
  if (frame.next_piece(m_in.options.piece_tokens)) return true;
  if (frame.kind == FrameKind::kScene) return false;
  // Scopes hold symbols a description may still need nowhere: values are copied when read.
  m_in.symbols.pop_scope();
  m_in.stream.pop();
  return true;
}

void Directives::include_directive() {
  const Location where = m_in.tokens.peek_operand().where;
  include(m_in.expressions.parse_path(), where);
}

void Directives::include(const std::string& name, const Location& where) {
  if (m_in.stream.depth() >= m_in.options.limits.nesting) {
    m_in.fail(where, "includes and macros nest too deeply: a file that includes itself?");
  }
  m_in.count_turn();
  std::optional<std::string> path = m_in.find_file(name, where);
  if (!path && !std::filesystem::path(name).has_extension())
    path = m_in.find_file(name + ".inc", where);
  Frame* const frame = path ? m_in.push_file(*path, where) : nullptr;
  if (!frame) {
    std::string message = "cannot find the include file '" + shown_name(name) + "', looked in: .";
    if (!m_in.scene_folder.empty()) message += ", " + m_in.scene_folder;
    for (const std::string& folder : m_in.options.library_paths) message += ", " + folder;
    m_in.fail(where, message);
  }
  frame->blocks = m_blocks.size();
  m_in.symbols.push_scope();
}

void Directives::message(const Token& directive) {
  const std::string text = to_ascii(m_in.expressions.parse_string());
  switch (directive.keyword) {
    case Keyword::kDebug: return m_in.diagnostics.write(Stream::kDebug, cut(text, 200, 159));
    case Keyword::kRender:
    case Keyword::kStatistics:
      m_in.warn(directive.where, "#render and #statistics have no streams any more: as #debug");
      return m_in.diagnostics.write(Stream::kDebug, cut(text, 200, 159));
    case Keyword::kWarning: return m_in.warn(directive.where, text);
    default: m_in.fail(directive.where, "parse halted by #error: " + text);
  }
}

void Directives::version() {
  const bool is_late = m_in.tokens.started();
  const Location where = m_in.tokens.peek_operand().where;
  if (!m_in.has_own_version && m_in.is_in_scene(where)) {
    m_in.has_own_version = true;
    m_in.is_version_late = is_late;
  }
  double number = 0.0;
  bool ends = false;
  {
    const TokenReader::Hold hold(m_in.tokens);
    number = m_in.expressions.parse_float();
    ends = m_in.tokens.accept(Punct::kSemicolon);
  }
  const int version = to_int(std::round(number * 100.0));
  if (version < 100 || version > 9900) {
    m_in.fail(where, "#version " + std::to_string(number) + " is no version of the language");
  }
  if (version > 370) {
    m_in.warn(where, "#version " + std::to_string(version / 100) + "." +
                         std::to_string(version % 100) + " is newer than 3.7, read as 3.7");
  }
  m_in.version = std::min(version, 370);
  m_in.version_set = true;
  if (!m_in.noise_generator_set) *m_in.noise_generator = m_in.version < 350 ? 1 : 2;
  if (!ends && m_in.version >= 310) m_in.warn(where, "#version should end with a semicolon");
}

}  // namespace lentray::parser
