#include "parser/interpreter/raw_expressions.h"

#include <algorithm>

#include "parser/interpreter/interpreter.h"
#include "parser/interpreter/raw_operators.h"

namespace lentray::parser {
RawExpressions::RawExpressions(Interpreter& in)
    : m_in(in), m_symbols(in.symbols), m_names(in.names) {}

RawExpressions::Item RawExpressions::read_item(const TokenList& list, const Token*& first,
                                               Number& value, std::string& text) {
  if (read_alone(first, text, Punct::kNone)) return Item::kString;
  if (read(list, first, Level::kAdditive, value)) return Item::kNumber;
  return read_whole(list, first, text, Punct::kNone) ? Item::kString : Item::kNone;
}

bool RawExpressions::read_whole(const TokenList& list, const Token*& first, Level level,
                                Number& value, Punct end) {
  m_list = &list;
  if (first->is_literal_vector() && ends_operand(first[1], end)) {
    literal_vector(*first++, value);
    return true;
  }
  if (first->kind == TokenKind::kString ||
      (first->kind == TokenKind::kKeyword &&
       function_kind(first->keyword) == FunctionKind::kString)) {
    return false;
  }
  // What stopped it once will stop it again.
  if (m_failed_number.within(first)) return false;
  m_at = first;
  m_depth = 0;
  m_operands_left = kMostOperands;
  // The components that a member leaves behind it are no part of what is stored.
  const bool members = level == Level::kEverything || end != Punct::kNone;
  const bool whole = only_floats(level, members, value.v[0]) ||
                     (level == Level::kAdditive ? additive(value) : expression(value));
  if (whole && (end == Punct::kNone ? ends_here() : is(end))) {
    if (!m_random.empty()) m_random.clear();
    first = m_at;
    return true;
  }
  m_failed_number = {first, m_at};
  undo_random();
  return false;
}

void RawExpressions::undo_random(std::size_t kept) {
  for (; m_random.size() > kept; m_random.pop_back()) {
    m_in.random[m_random.back().first] = m_random.back().second;
  }
}

// A directive or a macro might belong to the expression; so might what follows the file or macro.
bool RawExpressions::ends_here() const {
  if (m_at->passive) return true;
  if (m_at->kind != TokenKind::kIdentifier) return false;
  Symbol* symbol = m_symbols.find(m_at->name);
  return !symbol || !symbol->target().macro();
}

bool RawExpressions::expression(Number& n) {
  if (!binary(n, Precedence::kLogical)) return false;
  if (!accept(Punct::kQuestion)) return true;
  if (n.size != 1 || ++m_depth > kDeepest) return false;
  Number yes, no;
  if (!expression(yes) || !accept(Punct::kColon) || !expression(no)) return false;
  --m_depth;
  n = is_true(n.v[0]) ? yes : no;
  return true;
}

bool RawExpressions::additive(Number& n) { return binary(n, Precedence::kSum); }

bool RawExpressions::operand(Number& n) {
  if (--m_operands_left < 0) return false;
  if (m_at->kind == TokenKind::kNumber) {
    n.v[0] = m_at->number;
    ++m_at;
  } else if (!primary(n)) {
    return false;
  }
  return !is(Punct::kDot) || member(n);
}

bool RawExpressions::primary(Number& n) {
  switch (m_at->kind) {
    case TokenKind::kNumber:
      n.v[0] = m_at->number;
      ++m_at;
      return true;
    case TokenKind::kIdentifier: return identifier(n);
    case TokenKind::kKeyword: {
      const FunctionKind kind = function_kind(m_at->keyword);
      if (kind == FunctionKind::kVector) return vector_function(n);
      if (kind == FunctionKind::kUnitVector) return unit_vector(m_at++->keyword, n);
      n = {};
      return float_function(n.v[0]);
    }
    case TokenKind::kPunct: break;
    default: return false;
  }
  if (++m_depth > kDeepest) return false;
  bool read = false;
  switch (m_at->punct) {
    case Punct::kLess: read = vector_literal(n); break;
    case Punct::kLeftParen:
      ++m_at;
      read = expression(n) && accept(Punct::kRightParen);
      n.keeps_rest = false;
      break;
    case Punct::kPlus:
      ++m_at;
      read = primary(n);
      break;
    case Punct::kMinus:
      ++m_at;
      read = operand(n);
      negate(n);
      break;
    case Punct::kExclamation:
      ++m_at;
      read = operand(n);
      logical_not(n);
      break;
    default: break;
  }
  --m_depth;
  return read;
}

void RawExpressions::literal_vector(const Token& token, Number& n) const {
  n.size = static_cast<int>(token.name);
  std::copy_n(m_list->components.data() + token.jump, token.name, n.v.data());
}

bool RawExpressions::vector_literal(Number& n) {
  const Token& less = *m_at++;
  if (less.is_literal_vector()) {
    literal_vector(less, n);
    return true;
  }
  int size = 0;
  while (!is(Punct::kGreater)) {
    if (size == static_cast<int>(n.v.size()) || !scalar(n.v[static_cast<std::size_t>(size)])) {
      return false;
    }
    ++size;
    accept(Punct::kComma);
  }
  if (size < 2) return false;
  ++m_at;
  n.size = size;
  return true;
}

// What the name here, with its subscripts, stands for; null if it cannot be said.
const Value* RawExpressions::identifier_value() {
  Symbol* visible = m_symbols.find(m_at->name);
  if (!visible) return nullptr;
  Symbol& symbol = visible->target();
  if (symbol.macro() || symbol.deprecated()) return nullptr;
  symbol.note_read();
  const Value* value = symbol.extras ? &symbol.resolve() : &symbol.value;
  ++m_at;
  if (is(Punct::kLeftSquare) && !element(value)) return nullptr;
  return value;
}

bool RawExpressions::identifier(Number& n) {
  const Symbol* symbol = m_symbols.find(m_at->name);
  if (symbol && !symbol->alias && !symbol->extras) {
    if (const Number* number = std::get_if<Number>(&symbol->value)) {
      n = *number;
      ++m_at;
      return true;
    }
  }
  const Value* value = identifier_value();
  const Number* number = value ? std::get_if<Number>(value) : nullptr;
  if (!number) return false;
  n = *number;
  return true;
}

// [i][j]... of an array, and of an array that is its element.
bool RawExpressions::element(const Value*& value) {
  while (is(Punct::kLeftSquare)) {
    const auto* found = std::get_if<std::shared_ptr<ArrayValue>>(value);
    if (!found) return false;
    const ArrayValue& array = **found;
    std::size_t index = 0;
    for (const int size : array.sizes) {
      double subscript = 0.0;
      if (!accept(Punct::kLeftSquare) || !scalar(subscript) || !accept(Punct::kRightSquare)) {
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

bool RawExpressions::member(Number& n) {
  const Token& name = *++m_at;
  if (name.kind != TokenKind::kKeyword) return false;
  const int i = component_of(name.keyword);
  if (i < 0 || i >= n.size) return false;
  ++m_at;
  take_component(n, i);
  return true;
}

// The operand here, if it is the whole argument.
bool RawExpressions::lone_operand(Number& n) {
  if (m_at->is_literal_vector() && ends_operand(m_at[1], Punct::kNone)) {
    literal_vector(*m_at++, n);
    return true;
  }
  return read_alone(m_at, n, Punct::kNone);
}

bool RawExpressions::vector(core::Vec3& v) {
  Number n;
  if ((!lone_operand(n) && !additive(n)) || n.size > 3) return false;
  v = to_vector(n);
  return true;
}

}  // namespace lentray::parser
