// Messages about a scene: every one says where (file:line:column, the line with a caret, the
// includes and macros on the way there) and what was expected. One Diagnostics a run, one thread.
//
// Five streams as POV-Ray has them (debug, render, statistics, warning, fatal); each goes to
// standard error until the program connects it elsewhere.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "parser/source/source.h"

namespace lentray::parser {

enum class Stream { kDebug, kRender, kStatistics, kWarning, kFatal };
inline constexpr std::size_t kStreams = 5;

/// One step of the way to a place: "in macro Foo, called from" / "included from", and where.
struct StackEntry {
  std::string what;
  Location where;
};

struct Diagnostic {
  Location where;
  std::string message;            ///< the bare message
  std::vector<StackEntry> stack;  ///< innermost first
  std::string text;               ///< as printed: place, message, line, caret, stack
};

/// What stops a parse. what() is the whole text, ready to print.
class ParseError : public std::runtime_error {
 public:
  explicit ParseError(Diagnostic diagnostic)
      : std::runtime_error(diagnostic.text), m_diagnostic(std::move(diagnostic)) {}
  const Diagnostic& diagnostic() const { return m_diagnostic; }
  const std::string& message() const { return m_diagnostic.message; }
  Location where() const { return m_diagnostic.where; }

 private:
  Diagnostic m_diagnostic;
};

/// What stands around the first line of a message about a scene.
struct Heading {
  std::string before;  ///< "scene.pov:3:14: error: "
  std::string after;   ///< a line between the message and the scene's; empty: none
};
/// `severity` is "error" or "warning".
using HeadingMaker = Heading (*)(const SourceManager&, const Location&, std::string_view severity);

/// "scene.pov:3:14: error: "; "lentray: error: " for nowhere.
Heading own_heading(const SourceManager& sources, const Location& where, std::string_view severity);

class Diagnostics {
 public:
  using Sink = std::function<void(std::string_view)>;

  explicit Diagnostics(const SourceManager& sources);

  /// Sends a stream elsewhere; an empty sink silences it. Warnings are collected all the same.
  void connect(Stream stream, Sink sink);
  void write(Stream stream, std::string_view text);

  /// own_heading unless this is called.
  void set_headings(HeadingMaker make) { m_make_heading = make; }
  Heading heading(const Location& where, std::string_view severity) const {
    return m_make_heading(m_sources, where, severity);
  }

  /// The same warning at the same place (in a loop, a macro) is given once, and at eight places at
  /// most; report_repeats() gives how many more there are (and forgets them).
  void warn(const Location& where, const std::string& message, std::vector<StackEntry> stack = {});
  /// Whether it has been given: then its stack need not be made.
  bool has_warned(const Location& where, const std::string& message) const;
  /// `shown`: what people read in place of a long message; empty: the message.
  [[noreturn]] void fail(const Location& where, const std::string& message,
                         std::vector<StackEntry> stack = {}, const std::string& shown = "");

  void report_repeats();

  /// A feature the scene really uses and that is parsed, kept and not rendered yet. The build step
  /// calls this; report_not_yet() then names all of them in one warning (and forgets them).
  void not_yet(const std::string& feature, const Location& where = {});
  void report_not_yet();

  const std::vector<Diagnostic>& warnings() const { return m_warnings; }

  /// "scene.pov:3:14"; "lentray" for nowhere.
  std::string place(const Location& where) const;
  /// Heading and message, with line, caret and stack.
  std::string format(const Location& where, std::string_view severity, std::string_view message,
                     std::span<const StackEntry> stack) const;

 private:
  const SourceManager& m_sources;
  HeadingMaker m_make_heading = own_heading;
  Sink m_sinks[kStreams];
  std::vector<Diagnostic> m_warnings;
  std::set<std::string> m_given;                // places and messages of the warnings
  std::map<std::string, std::size_t> m_places;  // of each message, in how many places
  std::set<std::string> m_not_yet;
  Location m_first_not_yet;
};

/// Of `names` the one that looks most like `name` and could be a slip of the pen; "" if none does.
std::string_view nearest_name(std::string_view name, std::span<const std::string_view> names);

}  // namespace lentray::parser
