// The raw tokens of a scene in the order they are read: a stack of frames, each a range of a token
// list being replayed (a file or a piece of it, the body of a macro). Loops move a frame's cursor back.
// Nothing is copied. Directives and names have no meaning here.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "parser/source/diagnostics.h"
#include "parser/tokens/lexer.h"

namespace lentray::parser {

enum class FrameKind : std::uint8_t { kScene, kInclude, kMacro };

struct Frame {
  FrameKind kind = FrameKind::kScene;
  std::shared_ptr<const TokenList> list;
  const Token* cursor = nullptr;
  const Token* end = nullptr;
  NameId name = 0;  ///< of the macro
  /// Of a long file, whose piece at hand `list` is; else null.
  std::unique_ptr<TokenPieces> pieces;
  Location call;           ///< where the macro was invoked, the file included
  std::size_t blocks = 0;  ///< open conditionals and loops when the frame began

  const Token* token(std::size_t index) const { return list->tokens.data() + index; }
  void begin(std::shared_ptr<const TokenList> tokens) {
    list = std::move(tokens);
    cursor = list->begin();
    end = list->end();
  }
  /// At the end of a piece: on to the next one. Tokens of the last one are gone. False if there is none.
  bool next_piece(std::size_t least) {
    if (!pieces) return false;
    list.reset();
    const bool any = pieces->next(least);
    begin(pieces->list());
    if (!any) pieces.reset();
    return any;
  }
};

class TokenStream {
 public:
  /// A new innermost frame, to be filled.
  Frame& push() { return m_frames.emplace_back(); }
  void pop() { m_frames.pop_back(); }
  bool empty() const { return m_frames.empty(); }
  std::size_t depth() const { return m_frames.size(); }
  Frame& top() { return m_frames.back(); }
  const Frame& top() const { return m_frames.back(); }
  const std::vector<Frame>& frames() const { return m_frames; }

  /// The next token of the innermost frame; null at its end.
  const Token* read() {
    Frame& f = m_frames.back();
    return f.cursor < f.end ? f.cursor++ : nullptr;
  }
  /// Past the token that look() found.
  void pass() { ++m_frames.back().cursor; }
  /// The same, left where it is.
  const Token* look() const {
    if (m_frames.empty()) return nullptr;
    const Frame& f = m_frames.back();
    return f.cursor < f.end ? f.cursor : nullptr;
  }

  /// The includes and macros being read, innermost first, for messages.
  std::vector<StackEntry> stack(const NameTable& names) const {
    std::vector<StackEntry> entries;
    for (auto f = m_frames.rbegin(); f != m_frames.rend(); ++f) {
      if (f->kind == FrameKind::kScene) continue;
      if (f->call.file == 0) continue;  // Include_Header's
      std::string what = f->kind == FrameKind::kMacro
                             ? "in macro " + std::string(names.text(f->name)) + ", invoked from"
                             : std::string("included from");
      entries.push_back({std::move(what), f->call});
    }
    return entries;
  }

 private:
  std::vector<Frame> m_frames;
};

}  // namespace lentray::parser
