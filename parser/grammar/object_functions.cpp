// Shapes that functions give.
// Source: reference manual 3.7, "Isosurface", "Parametric".
#include "parser/grammar/helpers.h"
#include "parser/grammar/object.h"
#include "parser/grammar/object_shapes.h"

namespace lentray::parser {
namespace {

/// Behind `function` comes the body; stock also takes the bare name of one.
Ref<FunctionDesc> parse_function_argument(Parser& parser) {
  parser.expect(Keyword::kFunction);
  return parser.parse_function_body();
}

ContainerShape parse_container(Parser& parser) {
  ContainerShape c;
  parser.expect(Punct::kLeftCurly);
  c.sphere = parser.at(Keyword::kSphere);
  if (!c.sphere && !parser.at(Keyword::kBox)) parser.fail_expected("sphere or box");
  parser.next();
  parser.expect(Punct::kLeftCurly);
  c.a = parser.parse_vector();
  parser.parse_comma();
  if (c.sphere) {
    c.radius = parser.parse_float();
  } else {
    c.b = parser.parse_vector();
  }
  parser.expect(Punct::kRightCurly);
  parser.expect(Punct::kRightCurly);
  return c;
}

}  // namespace

ShapeDesc parse_isosurface(Parser& parser, Context&) {
  IsosurfaceShape s;
  s.function = parse_function_argument(parser);
  while (true) {
    if (parser.accept(Keyword::kContainedBy)) {
      s.container = parse_container(parser);
    } else if (parser.accept(Keyword::kAllIntersections)) {
      s.all_intersections = true;
    } else if (parser.accept(Keyword::kOpen)) {
      s.open = true;
    } else if (parser.accept(Keyword::kEvaluate)) {
      s.evaluate.emplace();
      for (double& value : *s.evaluate) {
        value = parser.parse_float();
        parser.parse_comma();
      }
    } else if (!parser.accept(Keyword::kThreshold, s.threshold) &&
               !parser.accept(Keyword::kAccuracy, s.accuracy) &&
               !parser.accept(Keyword::kMaxGradient, s.max_gradient) &&
               !parser.accept(Keyword::kMaxTrace, s.max_trace)) {
      return s;
    }
    parser.parse_comma();
  }
}

ShapeDesc parse_parametric(Parser& parser, Context&) {
  ParametricShape s;
  for (Ref<FunctionDesc>& f : s.functions) {
    f = parse_function_argument(parser);
    parser.parse_comma();
  }
  s.lo = parse_uv(parser);
  parser.parse_comma();
  s.hi = parse_uv(parser);
  while (true) {
    if (parser.accept(Keyword::kContainedBy)) {
      s.container = parse_container(parser);
    } else if (parser.accept(Keyword::kPrecompute)) {
      s.precompute_depth = parser.parse_int();
      if (s.precompute_depth < 1 || s.precompute_depth > 20) {
        parser.fail("The depth of precompute goes from 1 to 20.");
      }
      static constexpr std::array kAxes{Keyword::kX, Keyword::kY, Keyword::kZ};
      for (bool found = true; found;) {
        parser.parse_comma();
        found = false;
        for (int axis = 0; axis < 3; ++axis) {
          if (parser.accept(kAxes[axis])) s.precompute[axis] = found = true;
        }
      }
    } else if (!parser.accept(Keyword::kAccuracy, s.accuracy) &&
               !parser.accept(Keyword::kMaxGradient, s.max_gradient)) {
      return s;
    }
  }
}

}  // namespace lentray::parser
