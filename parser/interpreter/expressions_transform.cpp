// translate, rotate, scale, matrix, transform {...}: degrees, row vectors, left to right.
#include "parser/interpreter/interpreter.h"

namespace lentray::parser {

std::optional<core::Transform> Expressions::accept_transform() {
  TokenReader& tokens = m_in.tokens;
  if (tokens.peek().kind != TokenKind::kKeyword) return std::nullopt;
  switch (tokens.peek().keyword) {
    case Keyword::kTranslate: tokens.skip(); return core::Transform::translation(parse_vector());
    case Keyword::kRotate: tokens.skip(); return core::Transform::rotation(parse_vector());
    case Keyword::kScale: {
      tokens.skip();
      const Location where = tokens.peek_operand().where;
      core::Vec3 by = parse_vector();
      for (int axis = 0; axis < 3; ++axis) {
        if (by[axis] != 0.0) continue;
        by[axis] = 1.0;
        m_in.warn(where, std::string("scale by 0 along ") + "xyz"[axis] + ", changed to 1");
      }
      return core::Transform::scaling(by);
    }
    case Keyword::kMatrix: {
      const Location where = tokens.peek().where;
      tokens.skip();
      const core::Transform t = core::Transform::matrix(matrix_rows());
      if (t.is_singular()) m_in.warn(where, "matrix without an inverse");
      return t;
    }
    case Keyword::kTransform: return parse_transform_statement();
    default: return std::nullopt;
  }
}

core::Matrix Expressions::matrix_rows() {
  TokenReader& tokens = m_in.tokens;
  core::Matrix rows{};
  if (tokens.accept_literal_matrix(rows)) return rows;
  tokens.expect(Punct::kLess);
  tokens.enter();
  for (auto& row : rows) {
    for (double& x : row) {
      x = parse_float();
      tokens.comma();
    }
  }
  tokens.leave();
  if (!tokens.accept(Punct::kGreater)) tokens.fail_expected("'>' after the 12 numbers of a matrix");
  return rows;
}

// `transform NAME` or `transform { ... }`.
core::Transform Expressions::parse_transform_statement() {
  TokenReader& tokens = m_in.tokens;
  tokens.expect(Keyword::kTransform);
  m_in.guard_stack();
  if (tokens.peek_operand().kind == TokenKind::kIdentifier) {
    const Value* value = tokens.value();
    const auto* named = value ? std::get_if<Ref<core::Transform>>(value) : nullptr;
    if (!named) tokens.fail_expected("a transform or '{'");
    const core::Transform copy = **named;
    tokens.skip();
    return copy;
  }
  tokens.expect(Punct::kLeftCurly);
  const core::Transform t = transform_block();
  tokens.expect(Punct::kRightCurly);
  return t;
}

core::Transform Expressions::transform_block() {
  TokenReader& tokens = m_in.tokens;
  core::Transform all;
  bool inverse = false;
  for (;;) {
    if (tokens.accept(Keyword::kInverse)) {
      inverse = true;
    } else if (const auto next = accept_transform()) {
      all = all.then(*next);
    } else if (tokens.peek().kind == TokenKind::kIdentifier) {
      const Value* value = tokens.value();
      const auto* named = value ? std::get_if<Ref<core::Transform>>(value) : nullptr;
      if (!named) tokens.fail_expected("translate, rotate, scale, matrix, transform or inverse");
      all = all.then(**named);
      tokens.skip();
    } else {
      break;
    }
  }
  return inverse ? all.inverse() : all;
}

}  // namespace lentray::parser
