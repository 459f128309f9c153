// Shapes that polynomials give.
// Source: reference manual 3.7, "Poly, Cubic and Quartic", "Polynomial".
#include "parser/grammar/helpers.h"
#include "parser/grammar/object.h"
#include "parser/grammar/object_shapes.h"

namespace lentray::parser {
namespace {

std::size_t coefficient_count(int order) {
  return static_cast<std::size_t>(order + 1) * (order + 2) * (order + 3) / 6;
}

int parse_poly_order(Parser& parser) {
  const int order = parser.parse_int();
  parser.parse_comma();
  if (order < 2 || order > 35) parser.fail("The order of a poly must be 2 to 35.");
  return order;
}

/// Place of x^a y^b z^c among the coefficients of a poly: powers of x fall first, then of y.
std::size_t coefficient_index(int order, int a, int b, int c) {
  std::size_t index = 0;
  for (int i = order; i > a; --i)
    index += static_cast<std::size_t>(order - i + 1) * (order - i + 2) / 2;
  const int rest = order - a;
  for (int j = rest; j > b; --j) index += static_cast<std::size_t>(rest - j + 1);
  return index + (rest - b - c);
}

ShapeDesc parse_coefficients(Parser& parser, int order) {
  PolyShape s;
  s.order = order;
  const std::size_t count = coefficient_count(s.order);
  parser.expect(Punct::kLess);
  while (s.coefficients.size() < count) {
    s.coefficients.push_back(parser.parse_float());
    parser.parse_comma();
  }
  parser.expect(Punct::kGreater);
  return s;
}

}  // namespace

ShapeDesc parse_poly(Parser& parser, Context&) {
  return parse_coefficients(parser, parse_poly_order(parser));
}
ShapeDesc parse_cubic(Parser& parser, Context&) { return parse_coefficients(parser, 3); }
ShapeDesc parse_quartic(Parser& parser, Context&) { return parse_coefficients(parser, 4); }

ShapeDesc parse_polynomial(Parser& parser, Context&) {
  PolyShape s;
  s.order = parse_poly_order(parser);
  s.coefficients.assign(coefficient_count(s.order), 0.0);
  while (parser.accept(Keyword::kXyz)) {
    parser.expect(Punct::kLeftParen);
    std::array<int, 3> power{};
    for (int& p : power) {
      p = parser.parse_int();
      parser.parse_comma();
    }
    parser.expect(Punct::kRightParen);
    parser.expect(Punct::kColon);
    const int total = power[0] + power[1] + power[2];
    if (power[0] < 0 || power[1] < 0 || power[2] < 0 || total > s.order) {
      parser.fail("The powers of a polynomial must be 0 or more, their sum at most its order.");
    }
    s.coefficients[coefficient_index(s.order, power[0], power[1], power[2])] = parser.parse_float();
    parser.parse_comma();
  }
  return s;
}

}  // namespace lentray::parser
