// The tokens that the grammar reads. Directives are executed, macros are invoked, array elements are
// resolved, and a file or macro is left at its end. One token of look-ahead.
#pragma once

#include <string>
#include <string_view>

#include "parser/tokens/token.h"
#include "parser/tokens/token_stream.h"
#include "parser/values/symbols.h"

namespace lentray::parser {

struct Interpreter;

class TokenReader {
 public:
  TokenReader(Interpreter& in, TokenStream& stream, SymbolTable& symbols)
      : m_in(in), m_stream(stream), m_symbols(symbols) {
    m_boundary.kind = TokenKind::kPunct;
  }

  const Token& peek() {
    if (m_ready || show_plain()) return m_token;
    fetch_or_hold();
    return m_held ? m_boundary : m_token;
  }
  /// The same where an operand must follow: no directive or macro is held back.
  const Token& peek_operand() {
    if (!m_ready && !show_plain()) fetch();
    return m_token;
  }
  Token next();
  void skip() {
    if (!m_ready && !show_plain()) fetch();
    consume();
  }

  bool at(Keyword k) { return peek().is(k); }
  bool at(Punct p) { return peek().is(p); }
  template <typename Word>  // Keyword or Punct
  bool accept(Word word) {
    if (pass_plain(word)) return true;
    if (!peek().is(word)) return false;
    consume();
    return true;
  }
  /// As for an operand: nothing is held back.
  template <typename Word>
  void expect(Word word) {
    if (pass_plain(word)) return;
    if (!peek_operand().is(word)) fail_without(word);
    consume();
  }
  void comma() { accept(Punct::kComma); }

  /// The symbol of the identifier that peek() shows, or null. Valid until the next token is read.
  Symbol* symbol() {
    if (m_token.kind != TokenKind::kIdentifier) return nullptr;
    Symbol* found = m_symbols.find(m_token.name);
    return found ? &found->target() : nullptr;
  }
  /// The value of that identifier or array element, or null. Valid until the next token is read.
  Value* value() {
    if (m_held || m_token.kind != TokenKind::kIdentifier) return nullptr;
    Value* found = nullptr;
    if (m_array) {
      found = &m_array->elements[m_index];
    } else if (Symbol* s = symbol()) {
      found = &s->resolve();
    }
    return found && found->index() == 0 ? nullptr : found;
  }
  /// At `<`: reads a vector of literal numbers to its end. False if it has anything else; nothing is
  /// read then.
  bool accept_literal_vector(Number& n);
  /// The same for the twelve numbers of a matrix, behind `matrix`.
  bool accept_literal_matrix(core::Matrix& rows);
  /// The next token in its list, from which PlainTokens read on; null if the token shown is an
  /// element of an array. go_on_at() then skips the tokens that were read.
  const Token* raw() const {
    if (m_stream.empty() || plain_names) return nullptr;
    const Token* cursor = m_stream.top().cursor;
    if (!m_ready) return cursor;
    return m_raw && m_raw + 1 == cursor ? m_raw : nullptr;
  }
  /// The list that raw() is of.
  const TokenList& raw_list() const { return *m_stream.top().list; }
  void go_on_at(const Token* token) {
    m_stream.top().cursor = token;
    m_last = token[-1].where;
    m_ready = false;
    m_held = false;
  }
  /// If the identifier shown is an element of an array: that array and the index.
  const std::shared_ptr<ArrayValue>& element_array() const { return m_array; }
  std::size_t element_index() const { return m_index; }

  /// The next token, which must be an identifier; no macro is invoked. For #declare, #undef and the
  /// like. `what` is for the message.
  Token read_name(std::string_view what);
  /// The token after the one shown, as it stands in the text; null at the end of the frame.
  const Token* following() const { return m_stream.look(); }

  /// Where a message about "here" points: the token shown, else the last one read.
  Location location() const { return m_ready ? m_token.where : m_last; }
  std::string describe(const Token& token) const;
  [[noreturn]] void fail_expected(std::string_view what);
  [[noreturn]] void fail_without(Keyword k);
  [[noreturn]] void fail_without(Punct p);

  /// While one lives, a directive or macro that follows a complete value on the same level is left
  /// for later, so that `#declare A = 1` without a semicolon ends there.
  class Hold {
   public:
    explicit Hold(TokenReader& reader);
    ~Hold();
    Hold(const Hold&) = delete;
    Hold& operator=(const Hold&) = delete;

   private:
    TokenReader& m_reader;
    const bool m_active;
    const int m_nesting;
    const std::size_t m_depth;
  };

  /// Forgets the token shown (the cursor is about to be moved).
  void drop() {
    m_ready = false;
    m_held = false;
  }
  bool ready() const { return m_ready; }
  /// Anything but a directive's own word has been read.
  bool started() const { return m_last.file != 0; }
  /// No macro is invoked while true.
  bool plain_names = false;

  /// Around a vector: only the grammar knows which `<` and `>` are brackets.
  void enter() { ++m_nesting; }
  void leave() { --m_nesting; }

 private:
  friend class Hold;
  void fetch(bool may_hold = false);
  void fetch_or_hold();
  bool must_hold();
  void consume() {
    m_last = m_token.where;
    if (m_token.kind == TokenKind::kEnd) return;  // it stays: the end can be asked for again
    m_ready = false;
    if (m_token.kind == TokenKind::kPunct && m_token.punct <= Punct::kRightSquare)
      nest(m_token.punct);
  }
  void nest(Punct punct) {
    switch (punct) {
      case Punct::kLeftCurly:
      case Punct::kLeftParen:
      case Punct::kLeftSquare: ++m_nesting; break;
      case Punct::kRightCurly:
      case Punct::kRightParen:
      case Punct::kRightSquare: --m_nesting; break;
      default: break;
    }
  }
  /// Shows the next token if no directive, macro or array element begins there, as for most.
  bool show_plain() {
    const Token* raw = m_stream.look();
    if (!raw) return false;
    if (!raw->passive) {
      if (raw->kind != TokenKind::kIdentifier) return false;
      const Symbol* symbol = m_symbols.find(raw->name);
      if (!symbol || !symbol->is_plain()) return false;
      if (std::holds_alternative<std::shared_ptr<ArrayValue>>(symbol->value)) return false;
      if (m_array) m_array.reset();
    }
    m_stream.pass();
    m_held = false;
    m_token = *raw;
    m_raw = raw;
    m_ready = true;
    return true;
  }
  /// Skips the next token if it is that word and has not been shown yet.
  template <typename Word>
  bool pass_plain(Word word) {
    const Token* raw = m_ready ? nullptr : m_stream.look();
    if (!raw || !raw->passive || !raw->is(word)) return false;
    m_stream.pass();
    m_held = false;
    m_last = raw->where;
    if (raw->kind == TokenKind::kPunct && raw->punct <= Punct::kRightSquare) nest(raw->punct);
    return true;
  }
  bool identifier(const Token& token);
  void subscripts(const Token& token, std::shared_ptr<ArrayValue> array);
  const Token& show(const Token& token) {
    m_token = token;
    m_raw = nullptr;
    m_ready = true;
    return m_token;
  }

  Interpreter& m_in;
  TokenStream& m_stream;
  SymbolTable& m_symbols;
  Token m_token;
  Token m_boundary;              ///< shown while a directive is held back: equals no token
  const Token* m_raw = nullptr;  ///< the same in its list; null if it is an element of an array
  bool m_ready = false;
  bool m_held = false;
  std::shared_ptr<ArrayValue> m_array;
  std::size_t m_index = 0;
  Location m_last;
  int m_nesting = 0;  ///< brackets of all kinds consumed and not closed
  bool m_holding = false;
  int m_hold_nesting = 0;
  std::size_t m_hold_depth = 0;
};

}  // namespace lentray::parser
