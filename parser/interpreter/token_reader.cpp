#include "parser/interpreter/token_reader.h"

#include <algorithm>
#include <cmath>

#include "parser/interpreter/interpreter.h"
#include "parser/tokens/keywords.h"
#include "parser/values/arithmetic.h"

namespace lentray::parser {

namespace {

bool is_unmarked_directive(const Token& token) {
  return token.kind == TokenKind::kKeyword &&
         (token.keyword == Keyword::kDeclare || token.keyword == Keyword::kInclude);
}

}  // namespace

Token TokenReader::next() {
  if (!m_ready) fetch();
  const Token token = m_token;
  consume();
  return token;
}

void TokenReader::fail_without(Keyword k) { fail_expected("'" + std::string(spelling(k)) + "'"); }
void TokenReader::fail_without(Punct p) { fail_expected("'" + std::string(spelling(p)) + "'"); }

// While a declaration's value may be complete: whether a directive or macro follows it here.
bool TokenReader::must_hold() {
  if (!m_holding || m_nesting != m_hold_nesting) return false;
  // A macro whose text ends here gives way to the text that invoked it.
  while (m_stream.depth() > m_hold_depth && !m_stream.look() &&
         m_stream.top().kind == FrameKind::kMacro) {
    m_in.directives.leave_frame();
  }
  if (m_stream.depth() != m_hold_depth) return false;
  const Token* raw = m_stream.look();
  // The declaration may be the last thing in its macro or file: what follows stands further out.
  for (auto f = m_stream.frames().rbegin(); !raw && f != m_stream.frames().rend(); ++f) {
    if (f->cursor < f->end) raw = f->cursor;
  }
  if (!raw) return false;
  const Symbol* symbol = raw->kind == TokenKind::kIdentifier ? m_symbols.find(raw->name) : nullptr;
  const bool is_directive = raw->kind == TokenKind::kDirective || is_unmarked_directive(*raw);
  if (!is_directive && !(symbol && symbol->macro())) return false;
  m_held = true;
  m_boundary.where = raw->where;
  return true;
}

void TokenReader::fetch_or_hold() {
  m_held = false;
  if (!must_hold()) fetch(true);
}

void TokenReader::fetch(bool may_hold) {
  m_held = false;
  for (bool first = true;; first = false) {
    // What ended the macro that gave the value has been executed by now.
    if (may_hold && !first && must_hold()) return;
    const Token* raw = m_stream.empty() ? nullptr : m_stream.read();
    if (!raw) {
      if (m_stream.empty() || !m_in.directives.leave_frame()) {
        Token end;
        end.where = m_last;
        show(end);
        return;
      }
      continue;
    }
    switch (raw->kind) {
      case TokenKind::kDirective:
        if (raw->keyword != Keyword::kNone && !Directives::has(raw->keyword)) {
          Token statement = *raw;  // which some scenes write with a #
          statement.kind = TokenKind::kKeyword;
          show(statement);
          return;
        }
        m_in.directives.execute(*raw);
        if (m_ready) return;
        continue;
      case TokenKind::kIdentifier:
        if (identifier(*raw)) return;
        continue;
      case TokenKind::kKeyword:
        // The oldest dialects have directives without the #.
        if (is_unmarked_directive(*raw) || (raw->keyword == Keyword::kDefault && m_stream.look() &&
                                            m_stream.look()->is(Punct::kLeftCurly))) {
          m_in.directives.execute_unmarked(*raw);
          if (m_ready) return;
          continue;
        }
        break;
      case TokenKind::kPunct:
        if (raw->punct != Punct::kHash) break;
        m_in.warn(raw->where, "'#' without a directive, ignored");
        continue;
      case TokenKind::kBad:
        m_last = raw->where;
        m_in.fail(raw->where, m_in.names.string(raw->name));
      default: break;
    }
    show(*raw);
    m_raw = raw;
    return;
  }
}

// False if it was a macro and has been invoked.
bool TokenReader::identifier(const Token& raw) {
  m_array.reset();
  const Symbol* found = m_symbols.find(raw.name);
  if (found) {
    Symbol& symbol = const_cast<Symbol*>(found)->target();
    const Token* after = m_stream.look();
    if (symbol.macro() && !plain_names && after && after->is(Punct::kLeftParen)) {
      const auto macro = symbol.extras->macro;  // it may be undefined within
      m_last = raw.where;
      m_in.directives.invoke(*macro, raw);
      return false;
    }
    if (after && after->is(Punct::kLeftSquare)) {
      Value& value = symbol.resolve();
      if (auto* array = std::get_if<std::shared_ptr<ArrayValue>>(&value)) {
        subscripts(raw, *array);
        return true;
      }
    }
    if (!plain_names) symbol.note_read();
    if (symbol.deprecated() && !plain_names) {
      m_in.warn(raw.where, symbol.deprecated()->text);
      if (symbol.deprecated()->once) symbol.extras->deprecated.reset();
    }
  }
  show(raw);
  m_raw = &raw;
  return true;
}

// Reads [i][j]... and shows the identifier as the element it names. The raw token is copied: the
// subscripts may end the frame it stands in.
void TokenReader::subscripts(const Token& raw, std::shared_ptr<ArrayValue> array) {
  const Token token = raw;
  const bool before = plain_names;
  plain_names = false;
  std::size_t index = 0;
  for (;;) {
    index = 0;
    for (std::size_t dimension = 0; dimension < array->sizes.size(); ++dimension) {
      expect(Punct::kLeftSquare);
      const Location where = peek_operand().where;
      const double subscript = m_in.expressions.parse_float();
      const int size = array->sizes[dimension];
      const int i = subscript_of(subscript);
      if (i < 0 || i >= size) {
        m_in.fail(where, "array subscript " +
                             std::to_string(to_int(std::floor(subscript + 1e-10))) +
                             " out of range: " + std::string(m_in.names.text(token.name)) +
                             " has " + std::to_string(size) + " elements in this dimension");
      }
      index = index * static_cast<std::size_t>(size) + static_cast<std::size_t>(i);
      expect(Punct::kRightSquare);
    }
    // An element that is itself an array goes on.
    const auto* inner = std::get_if<std::shared_ptr<ArrayValue>>(&array->elements[index]);
    const Token* after = m_stream.look();
    if (!inner || !after || !after->is(Punct::kLeftSquare)) break;
    array = std::shared_ptr<ArrayValue>(*inner);
  }
  plain_names = before;
  m_array = std::move(array);
  m_index = index;
  show(token);
}

bool TokenReader::accept_literal_matrix(core::Matrix& rows) {
  const Token& t = peek_operand();
  if (!t.is_literal_matrix()) return false;
  const double* component = m_stream.top().list->components.data() + t.jump;
  for (auto& row : rows) {
    for (double& x : row) x = *component++;
  }
  m_last = t.where;
  m_ready = false;
  return true;
}

// `<` has been shown: it may stand for the whole vector. Or else the tokens behind it, if they are
// numbers and nothing else up to `>`, become n's components and are consumed with it.
bool TokenReader::accept_literal_vector(Number& n) {
  Frame& frame = m_stream.top();
  if (m_token.is_literal_vector()) {
    n.size = static_cast<int>(m_token.name);
    std::copy_n(frame.list->components.data() + m_token.jump, m_token.name, n.v.data());
    m_last = m_token.where;
    m_ready = false;
    return true;
  }
  const Token* t = frame.cursor;
  std::size_t size = 0;
  for (;; ++size) {
    // A number and what ends it: three tokens at most.
    if (frame.end - t < 3 || size == n.v.size()) return false;
    const bool minus = t->is(Punct::kMinus);
    if (minus) ++t;
    if (t->kind != TokenKind::kNumber) return false;
    n.v[size] = minus ? -t->number : t->number;
    ++t;
    if (t->is(Punct::kGreater)) break;
    if (!t->is(Punct::kComma)) return false;
    ++t;
  }
  if (size == 0) return false;
  n.size = static_cast<int>(size + 1);
  m_last = t->where;
  frame.cursor = t + 1;
  m_ready = false;
  return true;
}

Token TokenReader::read_name(std::string_view what) {
  const bool before = plain_names;
  plain_names = true;
  const Token token = peek_operand();
  plain_names = before;
  if (token.kind == TokenKind::kKeyword) {
    m_in.fail(token.where, "expected " + std::string(what) + " but found the reserved word '" +
                               std::string(spelling(token.keyword)) + "'");
  }
  if (token.kind != TokenKind::kIdentifier) fail_expected(what);
  return token;
}

std::string TokenReader::describe(const Token& token) const {
  switch (token.kind) {
    case TokenKind::kEnd: return "the end of the scene";
    case TokenKind::kKeyword: return "'" + std::string(m_in.names.text(token.name)) + "'";
    case TokenKind::kPunct:
      return token.punct == Punct::kNone ? "a directive"
                                         : "'" + std::string(spelling(token.punct)) + "'";
    case TokenKind::kNumber: return "a number";
    case TokenKind::kString: return "a string";
    case TokenKind::kDirective: return "#" + std::string(m_in.names.text(token.name));
    case TokenKind::kIdentifier: {
      const std::string name(m_in.names.text(token.name));
      Symbol* s = m_symbols.find(token.name);
      if (!s) return "the undeclared identifier '" + name + "'";
      if (s->target().macro()) return "the macro '" + name + "'";
      if (m_array && m_ready)
        return std::string(kind_name(m_array->elements[m_index])) + " element of '" + name + "'";
      return std::string(kind_name(s->resolve())) + " '" + name + "'";
    }
    default: return "something unreadable";
  }
}

namespace {

/// "one of a, b, c ..." with a few of its words: what looks like the word found comes first.
std::string shortened(std::string_view what, std::string_view found) {
  constexpr std::string_view kBegin = "one of ", kBrace = " or }";
  constexpr std::size_t kMost = 6;
  std::vector<std::string_view> words;
  const bool or_brace = what.ends_with(kBrace);
  if (what.starts_with(kBegin)) {
    std::string_view rest = what.substr(kBegin.size());
    if (or_brace) rest.remove_suffix(kBrace.size());
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find(", "), rest.size());
      words.push_back(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 2, rest.size()));
    }
  }
  if (words.size() <= kMost + 1) return std::string(what);
  const auto near = std::ranges::find(words, nearest_name(found, words));
  if (near != words.end()) std::rotate(words.begin(), near, near + 1);
  std::string out(kBegin);
  for (std::size_t i = 0; i < kMost; ++i) out += (i > 0 ? ", " : "") + std::string(words[i]);
  const std::string others = std::to_string(words.size() - kMost) + " others";
  return out + (or_brace ? ", " + others + std::string(kBrace) : " or " + others);
}

}  // namespace

void TokenReader::fail_expected(std::string_view what) {
  const Token token = peek();
  const bool is_word = token.kind == TokenKind::kIdentifier || token.kind == TokenKind::kKeyword;
  const std::string_view found = is_word ? m_in.names.text(token.name) : std::string_view{};
  std::string but = " but found " + describe(token);
  if (token.kind == TokenKind::kIdentifier && !m_symbols.find(token.name))
    but += m_in.suggestion(found);
  m_in.fail(token.kind == TokenKind::kEnd ? m_last : token.where,
            "expected " + std::string(what) + but, "expected " + shortened(what, found) + but);
}

TokenReader::Hold::Hold(TokenReader& reader)
    : m_reader(reader), m_active(reader.m_holding), m_nesting(reader.m_hold_nesting),
      m_depth(reader.m_hold_depth) {
  reader.m_holding = true;
  reader.m_hold_nesting = reader.m_nesting;
  reader.m_hold_depth = reader.m_stream.depth();
}

TokenReader::Hold::~Hold() {
  m_reader.m_holding = m_active;
  m_reader.m_hold_nesting = m_nesting;
  m_reader.m_hold_depth = m_depth;
  m_reader.m_held = false;
}

}  // namespace lentray::parser
