// #macro and its invocation. Arguments that are bare names or array elements are passed by
// reference, all others by value; a body is replayed in a scope of its own.
// Source: reference manual 3.7, "User Defined Macros".
#include "parser/interpreter/interpreter.h"

namespace lentray::parser {

void Directives::define_macro(const Token& directive) {
  const std::size_t depth = m_in.stream.depth();
  auto macro = std::make_shared<Macro>();
  const Token name = m_in.tokens.read_name("the name of the macro");
  m_in.tokens.skip();
  macro->name = name.name;
  macro->where = name.where;
  macro->parameters = macro_parameters();
  if (m_in.stream.depth() != depth)
    m_in.fail(name.where, "the head of a #macro must be in one file");
  Frame& frame = m_in.stream.top();
  const Token* end = part_after(directive);
  if (!end || end->keyword != Keyword::kEnd) missing_end(directive);
  macro->list = frame.list;
  macro->begin = static_cast<std::size_t>(frame.cursor - frame.list->tokens.data());
  macro->end = static_cast<std::size_t>(end - frame.list->tokens.data());
  go_past(end);
  m_in.symbols.declare_global(macro->name).reset({});
  m_in.symbols.find(macro->name)->edit_extras().macro = std::move(macro);
}

std::vector<MacroParameter> Directives::macro_parameters() {
  std::vector<MacroParameter> parameters;
  m_in.tokens.expect(Punct::kLeftParen);
  const bool before = m_in.tokens.plain_names;
  m_in.tokens.plain_names = true;
  while (!m_in.tokens.at(Punct::kRightParen)) {
    MacroParameter parameter;
    Token name = m_in.tokens.read_name("the name of a macro parameter");
    m_in.tokens.skip();
    // `optional` is a word of 3.8, where it marks a parameter that may be left out.
    if (m_in.names.text(name.name) == "optional" &&
        m_in.tokens.peek().kind == TokenKind::kIdentifier) {
      parameter.optional = true;
      name = m_in.tokens.next();
    }
    parameter.name = name.name;
    parameters.push_back(parameter);
    if (!m_in.tokens.accept(Punct::kComma) && !m_in.tokens.at(Punct::kRightParen) &&
        m_in.tokens.peek().kind != TokenKind::kIdentifier) {
      m_in.tokens.fail_expected("',' or ')' in the parameters of a macro");
    }
  }
  m_in.tokens.plain_names = before;
  m_in.tokens.expect(Punct::kRightParen);
  return parameters;
}

// Most of them: the name alone of something with a value of its own, which is passed by reference,
// and numbers. Null for all others, elements of arrays among them; nothing is read then.
SymbolPtr Directives::plain_argument() {
  const Token* first = m_in.tokens.raw();
  if (!first) return nullptr;
  SymbolPtr made;
  if (first->kind == TokenKind::kIdentifier) {
    const bool alone = first[1].is(Punct::kComma) || first[1].is(Punct::kRightParen);
    if (first[1].is(Punct::kLeftSquare)) return nullptr;
    if (alone) {
      Symbol* visible = m_in.symbols.find(first->name);
      if (!visible || visible->target().extras) return nullptr;
      made = make_symbol();
      made->alias = &visible->target();
      m_in.tokens.go_on_at(first + 1);
      return made;
    }
  }
  if (Number n; m_in.expressions.read_plain(first, n, Precedence::kSum)) {
    made = make_symbol();
    made->value = stored(n);
  }
  return made;
}

SymbolPtr Directives::argument(const Macro& macro, std::size_t index) {
  if (SymbolPtr plain = plain_argument()) return plain;
  TokenReader& tokens = m_in.tokens;
  const auto wrong_number = [&] {
    m_in.fail(tokens.location(), "macro " + std::string(m_in.names.text(macro.name)) + " takes " +
                                     std::to_string(macro.parameters.size()) +
                                     " arguments, found " + std::to_string(index));
  };
  const Token first = tokens.peek_operand();
  if (first.is(Punct::kRightParen) || first.is(Punct::kComma)) {
    if (!macro.parameters[index].optional) wrong_number();
    return nullptr;
  }
  auto made = make_symbol();
  const Token* after = tokens.following();
  const bool alone = after && (after->is(Punct::kComma) || after->is(Punct::kRightParen));
  if (first.kind == TokenKind::kIdentifier && alone) {
    Symbol* symbol = tokens.symbol();
    if (!symbol) {
      // Stock refuses these; a macro that only asks whether it is set, or sets it, can have it.
      if (macro.parameters[index].optional) {
        tokens.skip();
        return nullptr;
      }
      m_in.symbols.declare_global(first.name);
      symbol = m_in.symbols.find(first.name);
    }
    if (tokens.element_array()) {
      made->edit_extras().alias_array = tokens.element_array();
      made->extras->alias_index = tokens.element_index();
    } else if (symbol->alias_array()) {
      made->edit_extras().alias_array = symbol->extras->alias_array;
      made->extras->alias_index = symbol->extras->alias_index;
    } else {
      made->alias = symbol;
    }
    tokens.skip();
    return made;
  }
  made->value = parse_rvalue();
  return made;
}

void Directives::invoke(const Macro& macro, const Token& name) {
  const Location where = name.where;  // the token may be gone after the arguments
  const std::size_t deepest = m_in.options.limits.nesting;
  if (m_in.stream.depth() >= deepest) {
    m_in.fail(where, "macro " + std::string(m_in.names.text(macro.name)) + " goes " +
                         std::to_string(deepest) + " levels deep: endless recursion?");
  }
  m_in.guard_stack();
  m_in.count_turn();
  const bool plain = m_in.tokens.plain_names;
  m_in.tokens.plain_names = false;
  const std::size_t first = m_arguments.size();
  m_in.tokens.expect(Punct::kLeftParen);
  for (std::size_t i = 0; i < macro.parameters.size(); ++i) {
    m_arguments.push_back(argument(macro, i));
    m_in.tokens.comma();
  }
  if (!m_in.tokens.at(Punct::kRightParen)) {
    m_in.tokens.fail_expected("')' after the " + std::to_string(macro.parameters.size()) +
                              " arguments of macro " + std::string(m_in.names.text(macro.name)));
  }
  m_in.tokens.skip();
  m_in.tokens.plain_names = plain;
  m_in.symbols.push_scope();
  for (std::size_t i = 0; i < macro.parameters.size(); ++i) {
    m_in.symbols.bind_local(macro.parameters[i].name, std::move(m_arguments[first + i]));
  }
  m_arguments.resize(first);
  Frame& frame = m_in.stream.push();
  frame.kind = FrameKind::kMacro;
  frame.list = macro.list;
  frame.cursor = macro.list->tokens.data() + macro.begin;
  frame.end = macro.list->tokens.data() + macro.end;
  frame.name = macro.name;
  frame.call = where;
  frame.blocks = m_blocks.size();
}

}  // namespace lentray::parser
