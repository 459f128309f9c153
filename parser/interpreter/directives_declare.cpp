// #declare, #local, #undef, arrays, and what may stand on their right side.
// Source: reference manual 3.7, "Identifiers", "Arrays"; semicolons and scopes measured on stock.
#include "core/base/memory_limit.h"
#include "parser/interpreter/interpreter.h"

namespace lentray::parser {

namespace {

struct ArrayTooBig {};

// An array within an array is copied too: `elements` and `depth` are what may be copied yet.
Value copy_within(const Value& value, std::size_t& elements, std::size_t depth) {
  const auto* array = std::get_if<std::shared_ptr<ArrayValue>>(&value);
  if (!array) return value;
  const std::size_t size = (*array)->elements.size();
  if (depth == 0 || size > elements) throw ArrayTooBig();
  elements -= size;
  auto copy = std::make_shared<ArrayValue>();
  copy->sizes = (*array)->sizes;
  copy->elements.reserve(size);
  for (const Value& element : (*array)->elements) {
    copy->elements.push_back(copy_within(element, elements, depth - 1));
  }
  return copy;
}

}  // namespace

Value Directives::copy_value(const Value& value) {
  std::size_t elements = m_in.options.limits.array_elements;
  try {
    return copy_within(value, elements, m_in.options.limits.array_depth);
  } catch (const ArrayTooBig&) {
    m_in.fail(m_in.tokens.location(),
              "the array to be copied has too many elements, or arrays within arrays");
  }
}

bool Directives::parse_defined() {
  TokenReader& tokens = m_in.tokens;
  tokens.expect(Punct::kLeftParen);
  const bool before = tokens.plain_names;
  tokens.plain_names = true;
  bool defined = false;  // a reserved word is not
  const Token& token = tokens.peek();
  if (token.kind == TokenKind::kIdentifier) {
    Symbol* symbol = tokens.symbol();
    defined = tokens.element_array() ? !std::holds_alternative<std::monostate>(
                                           tokens.element_array()->elements[tokens.element_index()])
                                     : symbol && symbol->is_set();
  } else if (token.kind == TokenKind::kNumber || token.kind == TokenKind::kString) {
    defined = token.kind == TokenKind::kString;
  } else if (token.kind != TokenKind::kKeyword) {
    tokens.fail_expected("a name");
  }
  tokens.skip();
  tokens.plain_names = before;
  tokens.expect(Punct::kRightParen);
  return defined;
}

void Directives::deprecation(std::string& text, bool& once) {
  if (!m_in.tokens.accept(Keyword::kDeprecated)) return;
  once = m_in.tokens.accept(Keyword::kOnce);
  text = m_in.tokens.peek().kind == TokenKind::kString ? m_in.expressions.parse_string()
                                                       : std::string("deprecated identifier");
}

// Nearly all declarations: a number or a string for a plain identifier. The expression has no side
// effects that could reach the symbol.
bool Directives::declare_plain(const Location& directive, bool local) {
  const Token* name = m_in.tokens.raw();
  if (!name || name->kind != TokenKind::kIdentifier || !name[1].is(Punct::kEqual)) return false;
  const std::uint32_t level = local ? m_in.symbols.level() : 0;
  Symbol* symbol = m_in.symbols.find(name->name);
  if (symbol && (symbol->macro() || (!local && !symbol->is_plain()))) return false;
  if (symbol && local && symbol->level != level) symbol = nullptr;
  if (symbol && (!symbol->is_plain() || symbol->file())) return false;
  Number number;
  std::string text;
  const Expressions::Item item =
      m_in.expressions.read_plain_item(name + 2, number, text, Punct::kSemicolon);
  if (item == Expressions::Item::kNone) return false;
  if (!symbol) symbol = &m_in.symbols.declare_at(name->name, level);
  Number* held = std::get_if<Number>(&symbol->value);
  if (item == Expressions::Item::kString)
    symbol->value = std::move(text);
  else if (held)
    *held = stored(number);
  else
    symbol->value = stored(number);
  end_of_declaration(symbol->value, directive);
  return true;
}

// Which symbol is meant is settled before the right side is read: a macro there may have symbols of
// the same name, and may not have ended when the value is complete. An array element is held by its
// array.
void Directives::declare(const Location directive, bool local) {
  if (declare_plain(directive, local)) return;
  TokenReader& tokens = m_in.tokens;
  std::string deprecated;
  bool once = false;
  tokens.plain_names = true;
  deprecation(deprecated, once);
  const Token name = tokens.read_name("an identifier");
  const std::shared_ptr<ArrayValue> array = tokens.element_array();
  const std::size_t index = tokens.element_index();
  const bool is_macro = tokens.symbol() && tokens.symbol()->macro() && !array;
  const std::uint32_t level = local ? m_in.symbols.level() : 0;
  SymbolPtr target;
  if (Symbol* visible = m_in.symbols.find(name.name);
      visible && (!local || visible->level == level)) {
    target = visible;
  }
  tokens.plain_names = false;
  if (is_macro)
    m_in.fail(name.where, "'" + std::string(m_in.names.text(name.name)) +
                              "' is a macro: #undef it before declaring it anew");
  tokens.skip();
  tokens.expect(Punct::kEqual);

  const TokenReader::Hold hold(tokens);
  const Value value = parse_rvalue();
  if (array) {
    array->elements[index] = value;
  } else {
    if (!target) target = &m_in.symbols.declare_at(name.name, level);
    target->assign(value);
    if (!deprecated.empty()) {
      target->edit_extras().deprecated.reset(new Deprecation{std::move(deprecated), once});
    }
  }
  // Last: looking for what follows may end the macro, and its symbols with it.
  end_of_declaration(value, directive);
}

void Directives::end_of_declaration(const Value& value, const Location& where) {
  const Token* raw = m_in.tokens.raw();
  if (raw && raw->is(Punct::kSemicolon) && raw + 1 < m_in.stream.top().end &&
      !raw[1].is(Punct::kSemicolon)) {
    return m_in.tokens.go_on_at(raw + 1);
  }
  if (m_in.tokens.accept(Punct::kSemicolon)) {
    // One more is no mistake, even behind the macro that ends with the first. Only the text is
    // looked at: what follows must not be executed yet.
    const auto& frames = m_in.stream.frames();
    auto frame = frames.rbegin();
    while (frame != frames.rend() && frame->cursor == frame->end &&
           frame->kind == FrameKind::kMacro) {
      ++frame;
    }
    const Token* next =
        frame != frames.rend() && frame->cursor < frame->end ? frame->cursor : nullptr;
    if (next && next->is(Punct::kSemicolon)) m_in.tokens.accept(Punct::kSemicolon);
    return;
  }
  if (!std::holds_alternative<Number>(value)) return;
  const std::string rule =
      "a #declare or #local of a float, vector or colour must end with a semicolon";
  if (m_in.version >= 350) {
    const Token& next = m_in.tokens.peek();
    std::string found =
        next.kind == TokenKind::kEnd ? "the end of the scene" : m_in.tokens.describe(next);
    m_in.fail(where, rule + " since version 3.5 (found " + found + " instead)");
  }
  if (m_in.version >= 310) m_in.warn(where, rule);
}

void Directives::undef() {
  const Token name = m_in.tokens.read_name("an identifier");
  const std::shared_ptr<ArrayValue> array = m_in.tokens.element_array();
  const std::size_t index = m_in.tokens.element_index();
  m_in.tokens.skip();
  if (array) {
    array->elements[index] = std::monostate{};
  } else if (!m_in.symbols.find(name.name)) {
    m_in.warn(name.where,
              "#undef of '" + std::string(m_in.names.text(name.name)) + "', which is not declared");
  } else {
    m_in.symbols.remove(name.name);
  }
}

Value Directives::parse_rvalue() {
  m_in.guard_stack();
  TokenReader& tokens = m_in.tokens;
  if (Number n; m_in.expressions.read_plain(tokens.raw(), n, Precedence::kSum)) return stored(n);
  const Token first = tokens.peek_operand();
  if (first.is(Keyword::kArray)) {
    tokens.skip();
    return array_value();
  }
  if (first.is(Keyword::kFunction)) {
    tokens.skip();
    return m_in.functions.parse_body();
  }
  if (first.is(Keyword::kSpline)) {
    tokens.skip();
    return m_in.expressions.parse_spline();
  }
  if (first.is(Keyword::kTransform)) {
    return std::make_shared<const core::Transform>(m_in.expressions.parse_transform_statement());
  }
  if (m_in.expressions.at_string()) return m_in.expressions.parse_string();
  if (m_in.expressions.at_colour_keyword()) return m_in.expressions.parse_colour();
  if (Value* value = tokens.value()) {
    if (std::holds_alternative<Number>(*value)) return stored(m_in.expressions.parse_additive());
    const bool callable = std::holds_alternative<Ref<FunctionDesc>>(*value) ||
                          std::holds_alternative<Ref<SplineDesc>>(*value);
    const Token* after = tokens.following();
    const bool called = callable && after && after->is(Punct::kLeftParen);
    if (callable && !called) {
      Value copy = *value;
      tokens.skip();
      return copy;
    }
    if (called) {
      return stored(m_in.expressions.parse_additive());
    }
    if (std::optional<Value> made = m_in.productions.rvalue(m_in.parser)) return std::move(*made);
    Value copy = copy_value(*tokens.value());
    tokens.skip();
    return copy;
  }
  if (m_in.expressions.at_expression()) return stored(m_in.expressions.parse_additive());
  if (std::optional<Value> made = m_in.productions.rvalue(m_in.parser)) return std::move(*made);
  // A name without a value: the expression knows what to say about it.
  if (tokens.peek().kind == TokenKind::kIdentifier) return m_in.expressions.parse_operand();
  tokens.fail_expected("a value");
}

Value Directives::array_value() {
  TokenReader& tokens = m_in.tokens;
  auto array = std::make_shared<ArrayValue>();
  const double most = static_cast<double>(m_in.options.limits.array_elements);
  double count = 1.0;
  while (tokens.accept(Punct::kLeftSquare)) {
    const Location where = tokens.peek_operand().where;
    const double size = m_in.expressions.parse_float();
    count *= std::floor(size + 1e-10);
    if (!(size + 1e-10 >= 1.0) || count > most) {
      m_in.fail(where, "an array cannot have " + std::to_string(size) + " elements");
    }
    array->sizes.push_back(static_cast<int>(size + 1e-10));
    tokens.expect(Punct::kRightSquare);
  }
  if (array->sizes.empty()) tokens.fail_expected("'[' and the size of the array");
  try {
    core::check_room(count * sizeof(Value));
  } catch (const core::NoRoom& error) {
    m_in.fail(tokens.location(), error.what());
  }
  array->elements.resize(static_cast<std::size_t>(count));
  if (tokens.at(Punct::kLeftCurly)) array_initialiser(*array, 0, 0);
  return array;
}

void Directives::array_initialiser(ArrayValue& array, std::size_t dimension, std::size_t base) {
  TokenReader& tokens = m_in.tokens;
  const std::size_t size = static_cast<std::size_t>(array.sizes[dimension]);
  std::size_t stride = 1;
  for (std::size_t d = dimension + 1; d < array.sizes.size(); ++d) {
    stride *= static_cast<std::size_t>(array.sizes[d]);
  }
  tokens.expect(Punct::kLeftCurly);
  for (std::size_t i = 0; i < size; ++i) {
    if (tokens.at(Punct::kRightCurly)) {
      tokens.fail_expected("value " + std::to_string(i + 1) + " of the array's " +
                           std::to_string(size));
    }
    if (dimension + 1 < array.sizes.size()) {
      array_initialiser(array, dimension + 1, base + i * stride);
    } else {
      array.elements[base + i] = parse_rvalue();
    }
    tokens.comma();
  }
  if (!tokens.accept(Punct::kRightCurly)) {
    tokens.fail_expected("'}' after the " + std::to_string(size) + " values of the array");
  }
}

}  // namespace lentray::parser
