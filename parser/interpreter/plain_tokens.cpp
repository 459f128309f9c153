#include "parser/interpreter/plain_tokens.h"

#include <algorithm>

#include "parser/interpreter/interpreter.h"

namespace lentray::parser {

PlainTokens::PlainTokens(Interpreter& in) : m_in(in), m_symbols(in.symbols) {}

bool PlainTokens::give_up() {
  *m_failure = {m_first, m_at};
  for (; !m_random.empty(); m_random.pop_back()) {
    m_in.random[m_random.back().first] = m_random.back().second;
  }
  return false;
}

// A directive or a macro might belong to the expression; so might what follows the file or macro.
bool PlainTokens::ends_at_name() const {
  if (m_at->kind != TokenKind::kIdentifier) return false;
  Symbol* symbol = m_symbols.find(m_at->name);
  return !symbol || !symbol->target().macro();
}

bool PlainTokens::literal_vector(Number& n) {
  if (!m_at->is_literal_vector()) return false;
  n.size = static_cast<int>(m_at->name);
  std::copy_n(m_list->components.data() + m_at->jump, m_at->name, n.v.data());
  ++m_at;
  return true;
}

// What is wrong or replaced in it has to be said.
bool PlainTokens::literal(std::string& text, bool) {
  const std::string* plain = m_in.names.ascii_alone(m_at->name);
  if (!plain || m_at->keyword == Keyword::kError) return false;
  text += *plain;
  ++m_at;
  return true;
}

// What the name here, with its subscripts, stands for; null if it cannot be said.
const Value* PlainTokens::value() {
  Symbol* visible = m_symbols.find(m_at->name);
  if (!visible) return nullptr;
  Symbol& symbol = visible->target();
  if (symbol.macro() || symbol.deprecated()) return nullptr;
  symbol.note_read();
  const Value* value = symbol.extras ? &symbol.resolve() : &symbol.value;
  ++m_at;
  return at(Punct::kLeftSquare) && !element(value) ? nullptr : value;
}

// [i][j]... of an array, and of an array that is its element.
bool PlainTokens::element(const Value*& value) {
  while (at(Punct::kLeftSquare)) {
    const auto* found = std::get_if<std::shared_ptr<ArrayValue>>(value);
    if (!found) return false;
    const ArrayValue& array = **found;
    std::size_t index = 0;
    for (const int size : array.sizes) {
      double subscript = 0.0;
      if (!accept(Punct::kLeftSquare) || !m_in.expressions.plain_subscript(subscript) ||
          !accept(Punct::kRightSquare)) {
        return false;
      }
      const int i = subscript_of(subscript);
      if (i < 0 || i >= size) return false;
      index = index * static_cast<std::size_t>(size) + static_cast<std::size_t>(i);
    }
    value = &array.elements[index];
  }
  return true;
}

bool PlainTokens::resolved(Number& n) {
  const Value* found = value();
  const Number* number = found ? std::get_if<Number>(found) : nullptr;
  if (number) n = *number;
  return number;
}

bool PlainTokens::identifier(std::string& text) {
  const Value* found = value();
  const std::string* string = found ? std::get_if<std::string>(found) : nullptr;
  if (string) text += *string;
  return string;
}

bool PlainTokens::keyword_float(Keyword keyword, double& x) {
  return m_in.expressions.keyword_float(keyword, x);
}

bool PlainTokens::old_dialect() const { return m_in.version < 350; }
std::size_t PlainTokens::most_bytes() const { return m_in.options.limits.string_bytes; }

bool PlainTokens::random(double stream, double& x) {
  const auto index = static_cast<std::size_t>(core::to_int(stream));
  if (index >= m_in.random.size()) return false;
  m_random.emplace_back(index, m_in.random[index]);
  x = next_random(m_in.random[index]);
  return true;
}

// defined() of a name without subscripts.
bool PlainTokens::function(Keyword word, Number& n) {
  if (word != Keyword::kDefined || !at(Punct::kLeftParen) ||
      m_at[1].kind != TokenKind::kIdentifier || !m_at[2].is(Punct::kRightParen)) {
    return false;
  }
  Symbol* symbol = m_symbols.find(m_at[1].name);
  n.v[0] = symbol && symbol->is_set();
  m_at += 3;
  return true;
}

}  // namespace lentray::parser
