// #if, #switch, #while, #for and their parts. Every part knows its successor (the lexer linked
// them), so skipping is a jump and a loop is a cursor moved back.
#include <cmath>

#include "parser/interpreter/interpreter.h"

namespace lentray::parser {
namespace {

constexpr double kEpsilon = kCompareEpsilon;

}  // namespace

// Of the innermost frame; what was opened outside a file or macro cannot be continued within.
Directives::Block* Directives::open_block() {
  return m_blocks.size() > m_in.stream.top().blocks ? &m_blocks.back() : nullptr;
}

const Token* Directives::part_after(const Token& part) const {
  const Frame& frame = m_in.stream.top();
  return part.jump < frame.list->size() ? frame.token(part.jump) : nullptr;
}

const Token* Directives::end_of(const Token& opener) const {
  const Token* part = &opener;
  do {
    part = part_after(*part);
  } while (part && part->keyword != Keyword::kEnd);
  return part;
}

void Directives::go_to(const Token* token) {
  m_in.stream.top().cursor = token;
  m_in.tokens.drop();
}

void Directives::go_past(const Token* token) { go_to(token + 1); }

void Directives::missing_end(const Token& opener) {
  m_in.fail(opener.where, "#" + std::string(m_in.names.text(opener.name)) + " without its #end");
}

bool Directives::condition() {
  if (double x = 0.0; m_in.expressions.read_plain_condition(x)) return is_true(x);
  m_in.tokens.expect(Punct::kLeftParen);
  const Number n = m_in.expressions.parse_expression();
  if (n.size > 1) m_in.tokens.fail_expected("a float");
  m_in.tokens.expect(Punct::kRightParen);
  return is_true(n.v[0]);
}

void Directives::if_directive(const Token& directive) {
  bool chosen = false;
  switch (directive.keyword) {
    case Keyword::kIf: chosen = condition(); break;
    case Keyword::kIfdef: chosen = parse_defined(); break;
    default: chosen = !parse_defined(); break;
  }
  const Token* part = &directive;
  while (!chosen) {
    part = part_after(*part);
    if (!part) missing_end(directive);
    go_past(part);
    if (part->keyword == Keyword::kEnd) return;
    if (part->keyword != Keyword::kElse && part->keyword != Keyword::kElseif) {
      m_in.fail(part->where, "#" + std::string(m_in.names.text(part->name)) + " inside #if");
    }
    chosen = part->keyword == Keyword::kElse || condition();
  }
  m_blocks.push_back({BlockKind::kIf, &directive});
}

// Reached from the part before it, so that part has been read: on to the end.
void Directives::else_part(const Token& directive) {
  Block* block = open_block();
  if (block && block->kind == BlockKind::kSwitch && directive.keyword == Keyword::kElse) return;
  if (!block || block->kind != BlockKind::kIf) {
    m_in.fail(directive.where, "#" + std::string(m_in.names.text(directive.name)) + " without #if");
  }
  const Token* end = end_of(directive);
  if (!end) missing_end(*block->opener);
  m_blocks.pop_back();
  go_past(end);
}

void Directives::end_part(const Token& directive) {
  Block* block = open_block();
  if (!block) m_in.fail(directive.where, "#end without #if, #while, #for, #switch or #macro");
  if (block->kind == BlockKind::kWhile) {
    m_in.count_turn();
    go_past(block->opener);
    if (condition()) return;
    go_past(&directive);
  } else if (block->kind == BlockKind::kFor) {
    const std::size_t depth = m_blocks.size();
    advance_for(*block);
    if (m_blocks.size() == depth) return;
    go_past(&directive);
    return;
  }
  m_blocks.pop_back();
}

bool Directives::choose_case(const Token& part, double value) {
  m_in.tokens.expect(Punct::kLeftParen);
  const double first = m_in.expressions.parse_scalar_expression();
  double last = first;
  if (part.keyword == Keyword::kRange) {
    m_in.tokens.comma();
    last = m_in.expressions.parse_scalar_expression();
  }
  m_in.tokens.expect(Punct::kRightParen);
  return part.keyword == Keyword::kCase ? std::fabs(first - value) < kEpsilon
                                        : value >= first && value <= last;
}

void Directives::switch_directive(const Token& directive) {
  m_in.tokens.expect(Punct::kLeftParen);
  const double value = m_in.expressions.parse_scalar_expression();
  m_in.tokens.expect(Punct::kRightParen);
  const Token* part = m_in.stream.look();
  if (!part || part->kind != TokenKind::kDirective ||
      (part->keyword != Keyword::kCase && part->keyword != Keyword::kRange)) {
    m_in.fail(part ? part->where : directive.where, "expected #case or #range after #switch");
  }
  for (;; part = part_after(*part)) {
    if (!part) missing_end(directive);
    go_past(part);
    if (part->keyword == Keyword::kEnd) return;
    if (part->keyword == Keyword::kElseif) m_in.fail(part->where, "#elseif inside #switch");
    if (part->keyword == Keyword::kElse || choose_case(*part, value)) break;
    if (part->jump == 0) missing_end(directive);
  }
  m_blocks.push_back({BlockKind::kSwitch, &directive});
}

// Reached by running on from the case before: the values no longer matter.
void Directives::case_part(const Token& directive) {
  Block* block = open_block();
  if (!block || block->kind != BlockKind::kSwitch) {
    m_in.fail(directive.where,
              "#" + std::string(m_in.names.text(directive.name)) + " without #switch");
  }
  choose_case(directive, 0.0);
}

void Directives::while_directive(const Token& directive) {
  const bool enter = condition();
  if (enter) {
    m_blocks.push_back({BlockKind::kWhile, &directive});
    return;
  }
  const Token* end = end_of(directive);
  if (!end) missing_end(directive);
  go_past(end);
}

bool Directives::for_is_over(const Block& block, double value) const {
  return (block.step > 0 && value > block.last + kEpsilon) ||
         (block.step < 0 && value < block.last - kEpsilon);
}

void Directives::for_directive(const Token& directive) {
  Block block{BlockKind::kFor, &directive};
  m_in.tokens.expect(Punct::kLeftParen);
  const Token variable = m_in.tokens.read_name("the name of the loop variable");
  if (m_in.tokens.element_array()) {
    m_in.fail(variable.where, "the variable of #for cannot be an element of an array");
  }
  block.variable = variable.name;
  m_in.tokens.skip();
  m_in.tokens.comma();
  const double first = m_in.expressions.parse_float();
  m_in.tokens.comma();
  block.last = m_in.expressions.parse_float();
  m_in.tokens.comma();
  const Location where = m_in.tokens.peek().where;
  if (!m_in.tokens.at(Punct::kRightParen)) block.step = m_in.expressions.parse_float();
  if (std::fabs(block.step) < kEpsilon) m_in.fail(where, "#for with a step of zero never ends");
  m_in.tokens.expect(Punct::kRightParen);
  m_in.symbols.declare_local(block.variable).reset(Number::scalar(first));
  if (for_is_over(block, first)) {
    const Token* end = end_of(directive);
    if (!end) missing_end(directive);
    go_past(end);
    return;
  }
  block.body = m_in.stream.top().cursor;
  m_blocks.push_back(block);
}

void Directives::advance_for(Block& block) {
  m_in.count_turn();
  Symbol* symbol = m_in.symbols.find(block.variable);
  Number* number = symbol ? std::get_if<Number>(&symbol->resolve()) : nullptr;
  if (!number || number->size != 1) {
    m_in.fail(block.opener->where, "the variable of #for must stay a float: '" +
                                       std::string(m_in.names.text(block.variable)) + "'");
  }
  number->v[0] += block.step;
  if (for_is_over(block, number->v[0])) {
    m_blocks.pop_back();
  } else {
    go_to(block.body);
  }
}

void Directives::break_directive(const Token& directive) {
  while (Block* block = open_block()) {
    const BlockKind kind = block->kind;
    const Token* end = end_of(*block->opener);
    if (!end) missing_end(*block->opener);
    m_blocks.pop_back();
    if (kind == BlockKind::kIf) continue;
    go_past(end);
    return;
  }
  // In a macro it ends the macro, as in stock.
  Frame& frame = m_in.stream.top();
  if (frame.kind == FrameKind::kMacro) return go_to(frame.end);
  m_in.fail(directive.where, "#break without #while, #for or #switch");
}

}  // namespace lentray::parser
