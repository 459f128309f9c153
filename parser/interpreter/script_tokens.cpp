#include "parser/interpreter/script_tokens.h"

#include "parser/interpreter/interpreter.h"

namespace lentray::parser {

ScriptTokens::ScriptTokens(Interpreter& in) : m_in(in), m_tokens(in.tokens) {}

const Token& ScriptTokens::peek() { return m_tokens.peek(); }
const Token& ScriptTokens::peek_operand() { return m_tokens.peek_operand(); }
Token ScriptTokens::next() { return m_tokens.next(); }
void ScriptTokens::skip() { m_tokens.skip(); }
bool ScriptTokens::at(Punct p) { return m_tokens.at(p); }
bool ScriptTokens::accept(Punct p) { return m_tokens.accept(p); }

bool ScriptTokens::expect(Punct p) {
  m_tokens.expect(p);
  return true;
}

// The first dialect has no arithmetic.
Precedence ScriptTokens::precedence() {
  const Precedence here = parser::precedence(m_tokens.peek());
  return here >= Precedence::kSum && !m_in.has_arithmetic() ? Precedence::kNone : here;
}

Location ScriptTokens::location() const { return m_tokens.location(); }
std::string ScriptTokens::describe(const Token& token) const { return m_tokens.describe(token); }
std::string_view ScriptTokens::name(const Token& token) const {
  return m_in.names.text(token.name);
}

bool ScriptTokens::fail_expected(std::string_view what) { m_tokens.fail_expected(what); }
bool ScriptTokens::fail(const Location& where, const std::string& message) {
  m_in.fail(where, message);
}

bool ScriptTokens::warn(const Location& where, const std::string& message) {
  m_in.warn(where, message);
  return true;
}

bool ScriptTokens::enter() {
  constexpr int kOften = 64;
  if (++m_depth % kOften == 0) m_in.guard_stack();
  return true;
}

bool ScriptTokens::quick(Number& n, Precedence least) {
  if (m_in.expressions.read_plain(m_tokens.raw(), n, least)) return true;
  n = {};
  return false;
}

// The place is looked for only where it has to be, if the token stands in the list.
bool ScriptTokens::quick(Number& n, Precedence least, Location& where) {
  const Token* first = m_tokens.raw();
  const bool read = first && quick(n, least);
  where = first && (read || first->passive) ? first->where : m_tokens.peek_operand().where;
  return read;
}

bool ScriptTokens::quick(std::string& text) {
  return m_in.expressions.read_plain(m_tokens.raw(), text);
}

bool ScriptTokens::literal_vector(Number& n) {
  if (m_tokens.accept_literal_vector(n)) return true;
  n = {};
  return false;
}

void ScriptTokens::open_vector() { m_tokens.enter(); }
void ScriptTokens::close_vector() { m_tokens.leave(); }

bool ScriptTokens::at_string() { return m_in.expressions.at_string(); }

bool ScriptTokens::literal(std::string& text, bool path) {
  const Token token = m_tokens.next();
  if (path) {
    text += m_in.names.raw_string(token.name);
    return true;
  }
  if (token.keyword == Keyword::kError) {
    m_in.fail(token.where,
              "a string has an escape that does not exist; known are \\a \\b \\f \\n \\r "
              "\\t \\v \\\\ \\\" \\' \\uXXXX");
  }
  const std::string* ascii = m_in.names.ascii_string(token.name);
  const bool replaced = ascii && !m_in.utf8;
  text += replaced ? *ascii : m_in.names.string(token.name);
  if (replaced)
    m_in.warn(token.where, "text that is not ASCII, replaced by spaces; charset utf8 keeps it");
  return true;
}

bool ScriptTokens::identifier(Number& n) {
  const Value* value = m_tokens.value();
  if (const Number* number = value ? std::get_if<Number>(value) : nullptr) {
    n = *number;
    m_tokens.skip();
    return true;
  }
  const Token token = m_tokens.peek_operand();
  const std::string name(m_in.names.text(token.name));
  if (value) {
    if (const auto* f = std::get_if<Ref<FunctionDesc>>(value)) {
      const Ref<FunctionDesc> function = *f;
      m_tokens.skip();
      enter();
      n = call_function(function, name);
      leave();
      return true;
    }
    if (const auto* s = std::get_if<Ref<SplineDesc>>(value)) {
      const Ref<SplineDesc> spline = *s;
      m_tokens.skip();
      enter();
      n = call_spline(spline);
      leave();
      return true;
    }
  } else if (m_tokens.element_array()) {
    m_in.fail(token.where, "element " + std::to_string(m_tokens.element_index()) + " of array '" +
                               name + "' has no value yet");
  } else if (const Symbol* symbol = m_tokens.symbol(); !symbol) {
    m_in.fail(token.where, "undeclared identifier '" + name + "'" + m_in.suggestion(name));
  } else if (!symbol->macro() && !symbol->file()) {
    m_in.fail(token.where, "'" + name + "' has no value yet");
  }
  m_tokens.fail_expected("a number, vector or identifier of one");
}

bool ScriptTokens::identifier(std::string& text) {
  const Value* value = m_tokens.value();
  const std::string* held = value ? std::get_if<std::string>(value) : nullptr;
  if (!held) m_tokens.fail_expected("a string");
  text += *held;
  m_tokens.skip();
  return true;
}

bool ScriptTokens::keyword_float(Keyword keyword, double& x) {
  return m_in.expressions.keyword_float(keyword, x);
}

bool ScriptTokens::old_dialect() const { return m_in.version < 350; }
std::size_t ScriptTokens::most_bytes() const { return m_in.options.limits.string_bytes; }

bool ScriptTokens::random(double stream, double& x) {
  const int index = core::to_int(stream);
  if (index < 0 || static_cast<std::size_t>(index) >= m_in.random.size())
    m_in.fail(m_tokens.location(), "rand() of a stream that no seed() has made");
  x = next_random(m_in.random[static_cast<std::size_t>(index)]);
  return true;
}

}  // namespace lentray::parser
