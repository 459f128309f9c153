#include "parser/source/diagnostics.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <numeric>
#include <utility>

#include "core/base/joined.h"
#include "parser/base/shown.h"

namespace lentray::parser {
namespace {

void to_standard_error(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

// The line and a caret under the column.
std::string excerpt(const SourceManager& sources, const Location& where) {
  const std::string_view line = sources.line(where);
  if (line.empty()) return {};
  const ShownLine shown = shown_line(line, sources.position(where).column);
  return "  " + shown.line + "\n  " + shown.indent + "^\n";
}

// Letters put in, left out, changed, or exchanged with their neighbour; case does not count.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  std::vector<std::size_t> before_last, last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = lower(a[i - 1]) == lower(b[j - 1]);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
      const bool exchanged = i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
                             lower(a[i - 2]) == lower(b[j - 1]);
      if (exchanged) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last = last;
    last = row;
  }
  return last.back();
}

// Deep recursion would bury the message: the ends of a long stack are enough.
constexpr std::size_t kStackShown = 12;
constexpr std::size_t kPlacesShown = 8;  // of one warning

}  // namespace

Heading own_heading(const SourceManager& sources, const Location& where,
                    std::string_view severity) {
  const std::string place = where.file == 0 ? "lentray" : sources.place(where);
  return {place + ": " + std::string(severity) + ": ", ""};
}

Diagnostics::Diagnostics(const SourceManager& sources) : m_sources(sources) {
  for (Sink& sink : m_sinks) sink = to_standard_error;
}

void Diagnostics::connect(Stream stream, Sink sink) {
  m_sinks[static_cast<std::size_t>(stream)] = std::move(sink);
}

std::string Diagnostics::place(const Location& where) const {
  return where.file == 0 ? "lentray" : m_sources.place(where);
}

void Diagnostics::write(Stream stream, std::string_view text) {
  const Sink& sink = m_sinks[static_cast<std::size_t>(stream)];
  if (sink) sink(text);
}

std::string Diagnostics::format(const Location& where, std::string_view severity,
                                std::string_view message, std::span<const StackEntry> stack) const {
  const Heading around = heading(where, severity);
  message = message.substr(0, message.find_last_not_of('\n') + 1);
  std::string text = around.before + shown_message(shown_text(message)) + "\n" + around.after +
                     excerpt(m_sources, where);
  for (std::size_t i = 0; i < stack.size(); ++i) {
    if (stack.size() > kStackShown && i == kStackShown / 2) {
      const std::size_t skipped = stack.size() - kStackShown;
      text += "  ... " + std::to_string(skipped) + " more\n";
      i += skipped;
    }
    text += "  " + stack[i].what;
    if (stack[i].where.file != 0) text += " " + place(stack[i].where);
    text += "\n";
  }
  return text;
}

void Diagnostics::warn(const Location& where, const std::string& message,
                       std::vector<StackEntry> stack) {
  if (!m_given.insert(place(where) + ": " + message).second) return;
  if (++m_places[message] > kPlacesShown) return;
  std::string text = format(where, "warning", message, stack);
  write(Stream::kWarning, text);
  m_warnings.push_back({where, message, std::move(stack), std::move(text)});
}

void Diagnostics::report_repeats() {
  for (const auto& [message, places] : std::exchange(m_places, {})) {
    if (places <= kPlacesShown) continue;
    const std::size_t more = places - kPlacesShown;
    warn({},
         "at " + std::to_string(more) + (more == 1 ? " more place: " : " more places: ") + message);
  }
}

bool Diagnostics::has_warned(const Location& where, const std::string& message) const {
  return m_given.count(place(where) + ": " + message) > 0;
}

void Diagnostics::fail(const Location& where, const std::string& message,
                       std::vector<StackEntry> stack, const std::string& shown) {
  std::string text = format(where, "error", shown.empty() ? message : shown, stack);
  throw ParseError({where, message, std::move(stack), std::move(text)});
}

void Diagnostics::not_yet(const std::string& feature, const Location& where) {
  if (m_not_yet.empty()) m_first_not_yet = where;
  m_not_yet.insert(feature);
}

void Diagnostics::report_not_yet() {
  if (m_not_yet.empty()) return;
  const std::string list = core::joined(m_not_yet);
  m_not_yet.clear();
  warn(m_first_not_yet, "not rendered yet, left out of the picture: " + list);
}

std::string_view nearest_name(std::string_view name, std::span<const std::string_view> names) {
  std::string_view best;
  std::size_t best_distance = std::max<std::size_t>(1, name.size() / 3) + 1;
  for (const std::string_view candidate : names) {
    const std::size_t longer = std::max(candidate.size(), name.size());
    const std::size_t shorter = std::min(candidate.size(), name.size());
    if (candidate == name || longer - shorter >= best_distance) continue;
    const std::size_t distance = edit_distance(name, candidate);
    if (distance < best_distance && distance < shorter) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

}  // namespace lentray::parser
