// Shapes that are read and kept; rendered later.
// Source: reference manual 3.7, "Blob", "Bicubic Patch", "Height Field", "Isosurface",
// "Julia Fractal", "Lathe", "Ovus", "Parametric", "Poly, Cubic and Quartic", "Polynomial",
// "Prism", "Surface of Revolution", "Sphere Sweep", "Superquadric Ellipsoid", "Text".
#include <algorithm>

#include "parser/grammar/helpers.h"
#include "parser/grammar/object.h"
#include "parser/grammar/object_shapes.h"
#include "parser/grammar/transform.h"

namespace lentray::parser {
namespace {

constexpr double kTiny = 1e-10;  ///< stock's measure of "nothing" in lengths

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

std::optional<CurveKind> accept_curve_kind(Parser& parser) {
  if (parser.accept(Keyword::kLinearSpline)) return CurveKind::kLinear;
  if (parser.accept(Keyword::kQuadraticSpline)) return CurveKind::kQuadratic;
  if (parser.accept(Keyword::kCubicSpline)) return CurveKind::kCubic;
  if (parser.accept(Keyword::kBezierSpline)) return CurveKind::kBezier;
  if (parser.accept(Keyword::kBSpline)) return CurveKind::kB;
  if (parser.accept(Keyword::kNaturalSpline)) return CurveKind::kNatural;
  return std::nullopt;
}

std::vector<Vec2> parse_points(Parser& parser, int count) {
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i) {
    parser.parse_comma();
    points.push_back(parse_uv(parser));
  }
  return points;
}

void parse_blob_element_modifiers(Parser& parser, Context& context, BlobElement& element) {
  Looks looks;
  while (!parser.accept(Punct::kRightCurly)) {
    if (const auto transform = parser.accept_transforms()) {
      element.transform = element.transform.then(*transform);
      transform_looks(looks, *transform);
    } else if (!accept_looks(parser, context.materials, looks)) {
      parser.fail_expected("a transform, texture, pigment, normal, finish or }");
    }
  }
  element.texture = looks.texture;
}

double parse_strength(Parser& parser) {
  parser.parse_comma();
  parser.accept(Keyword::kStrength);
  return parser.parse_float();
}

BlobElement parse_blob_element(Parser& parser, Context& context, BlobElement::Kind kind) {
  BlobElement e;
  e.kind = kind;
  parser.expect(Punct::kLeftCurly);
  e.a = parser.parse_vector();
  parser.parse_comma();
  if (kind == BlobElement::Kind::kCylinder) {
    e.b = parser.parse_vector();
    if (length(e.b - e.a) < kTiny) parser.fail("Degenerate cylinder in a blob: both ends are one point.");
    parser.parse_comma();
  }
  e.radius = parser.parse_float();
  e.strength = parse_strength(parser);
  parse_blob_element_modifiers(parser, context, e);
  return e;
}

/// `component strength, radius, centre`, the syntax of old scenes.
BlobElement parse_blob_component(Parser& parser) {
  BlobElement e;
  e.strength = parser.parse_float();
  parser.parse_comma();
  e.radius = parser.parse_float();
  parser.parse_comma();
  e.a = parser.parse_vector();
  parser.parse_comma();
  return e;
}

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
  for (int i = order; i > a; --i) index += static_cast<std::size_t>(order - i + 1) * (order - i + 2) / 2;
  const int rest = order - a;
  for (int j = rest; j > b; --j) index += static_cast<std::size_t>(rest - j + 1);
  return index + (rest - b - c);
}

bool is_julia_function(Keyword k) {
  static constexpr std::array kFunctions{
      Keyword::kSqr,  Keyword::kCube, Keyword::kExp,   Keyword::kReciprocal, Keyword::kSin,
      Keyword::kAsin, Keyword::kSinh, Keyword::kAsinh, Keyword::kCos,        Keyword::kAcos,
      Keyword::kCosh, Keyword::kAcosh, Keyword::kTan,  Keyword::kAtan,       Keyword::kTanh,
      Keyword::kAtanh, Keyword::kLn,  Keyword::kPwr};
  return std::find(kFunctions.begin(), kFunctions.end(), k) != kFunctions.end();
}

/// Points that a piece of an outline spans, and which of them it starts and ends at.
struct OutlineStep {
  std::size_t span, start, end;
};

/// The outlines of a prism must close: stock closes the last one if it is of straight lines, and
/// leaves out others.
void check_outline(Parser& parser, const Location& where, PrismShape& s) {
  std::vector<Vec2>& p = s.points;
  if (s.spline == CurveKind::kBezier) {
    if (p.size() % 4 != 0) {
      parser.fail_at(where, "A prism of a Bezier spline needs four points a segment.");
    }
    return;
  }
  const OutlineStep step = s.spline == CurveKind::kLinear      ? OutlineStep{1, 0, 1}
                           : s.spline == CurveKind::kQuadratic ? OutlineStep{2, 1, 2}
                                                               : OutlineStep{3, 1, 2};
  std::size_t first = 0;
  bool open = true;
  for (std::size_t i = 0; i + step.span < p.size(); ++i) {
    open = !(p[i + step.end] == p[first + step.start]);
    if (open) continue;
    i += step.span;
    first = i + 1;
  }
  if (!open) return;
  if (s.spline == CurveKind::kLinear) {
    parser.warn_at(where, "This prism is not closed: closing it.");
    p.push_back(p[first]);
  } else if (first == 0) {
    parser.fail_at(where, "This prism is not closed: its outline must come back to its first point.");
  } else {
    parser.warn_at(where, "An outline of this prism is not closed: it is left out.");
    p.resize(first);
  }
}

constexpr double kLeastExponent = 1e-10;

}  // namespace

ShapeDesc parse_bicubic_patch(Parser& parser, Context&) {
  auto s = std::make_shared<BicubicPatchShape>();
  while (true) {
    if (parser.accept(Keyword::kType)) {
      const Location where = parser.location();
      s->type = parser.parse_int();
      if (s->type == 2 || s->type == 3) {
        parser.warn_at(where, "types 2 and 3 of a bicubic_patch are gone: type 1 is used");
        s->type = 1;
      }
      if (s->type != 0 && s->type != 1) {
        parser.fail_at(where, "The type of a bicubic_patch must be 0 or 1.");
      }
    } else if (parser.accept(Keyword::kFlatness)) {
      s->flatness = parser.parse_float();
    } else if (parser.accept(Keyword::kUSteps)) {
      s->u_steps = parser.parse_int();
    } else if (parser.accept(Keyword::kVSteps)) {
      s->v_steps = parser.parse_int();
    } else if (parser.accept(Keyword::kAccuracy)) {
      (void)parser.parse_float();
    } else if (parser.accept(Keyword::kUvVectors)) {
      s->uv.emplace();
      for (Vec2& uv : *s->uv) {
        uv = parse_uv(parser);
        parser.parse_comma();
      }
    } else {
      break;
    }
    parser.parse_comma();
  }
  if (at_float(parser)) {  // the bare numbers of old scenes: type, flatness, steps
    s->type = parser.parse_int();
    parser.parse_comma();
    if (at_float(parser)) s->flatness = parser.parse_float();
    parser.parse_comma();
    if (at_float(parser)) s->u_steps = parser.parse_int();
    parser.parse_comma();
    if (at_float(parser)) s->v_steps = parser.parse_int();
    parser.parse_comma();
  }
  for (Vec3& p : s->points) {
    parser.parse_comma();
    p = parser.parse_vector();
  }
  return std::shared_ptr<const BicubicPatchShape>(std::move(s));
}

ShapeDesc parse_blob(Parser& parser, Context& context) {
  auto s = std::make_shared<BlobShape>();
  while (true) {
    if (parser.accept(Keyword::kThreshold)) {
      s->threshold = parser.parse_float();
    } else if (parser.accept(Keyword::kSphere)) {
      s->elements.push_back(parse_blob_element(parser, context, BlobElement::Kind::kSphere));
    } else if (parser.accept(Keyword::kCylinder)) {
      s->elements.push_back(parse_blob_element(parser, context, BlobElement::Kind::kCylinder));
    } else if (parser.accept(Keyword::kComponent)) {
      s->elements.push_back(parse_blob_component(parser));
    } else {
      break;
    }
  }
  if (s->elements.empty()) parser.fail_expected("one of sphere, cylinder, component or threshold");
  return std::shared_ptr<const BlobShape>(std::move(s));
}

ShapeDesc parse_height_field(Parser& parser, Context&) {
  HeightFieldShape s;
  if (parser.accept(Keyword::kFunction)) {
    const Location where = parser.location();
    s.width = parser.parse_int();
    parser.parse_comma();
    s.height = parser.parse_int();
    check_points(parser, where, s.width, s.height);
    s.function = parser.parse_function_body();
  } else {
    static constexpr std::array kTypes{Keyword::kGif, Keyword::kTga,  Keyword::kPot, Keyword::kPng,
                                       Keyword::kPgm, Keyword::kPpm,  Keyword::kSys, Keyword::kJpeg,
                                       Keyword::kTiff, Keyword::kExr, Keyword::kHdr, Keyword::kBmp};
    for (const Keyword type : kTypes) {
      if (parser.accept(type)) {
        s.file_type = spelling(type);
        break;
      }
    }
    const Location where = parser.location();
    s.file = parser.parse_string();
    auto path = parser.find_file(s.file);
    if (!path && !s.file_type.empty()) path = parser.find_file(s.file + "." + s.file_type);
    if (!path) parser.fail_at(where, "Cannot find the height_field's file \"" + s.file + "\".");
    s.file = *path;
  }
  while (true) {
    if (parser.accept(Keyword::kGamma)) {
      s.file_gamma = parser.accept(Keyword::kSrgb) ? -1.0 : parser.parse_float();
    } else if (parser.accept(Keyword::kPremultiplied)) {
      (void)optional_switch(parser);
    } else if (parser.accept(Keyword::kWaterLevel)) {
      s.water_level = parser.parse_float();
    } else if (parser.accept(Keyword::kSmooth)) {
      s.smooth = optional_switch(parser);
    } else {
      return s;
    }
  }
}

ShapeDesc parse_isosurface(Parser& parser, Context&) {
  IsosurfaceShape s;
  s.function = parse_function_argument(parser);
  while (true) {
    if (parser.accept(Keyword::kContainedBy)) {
      s.container = parse_container(parser);
    } else if (parser.accept(Keyword::kThreshold)) {
      s.threshold = parser.parse_float();
    } else if (parser.accept(Keyword::kAccuracy)) {
      s.accuracy = parser.parse_float();
    } else if (parser.accept(Keyword::kMaxGradient)) {
      s.max_gradient = parser.parse_float();
    } else if (parser.accept(Keyword::kMaxTrace)) {
      s.max_trace = parser.parse_int();
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
    } else {
      return s;
    }
    parser.parse_comma();
  }
}

ShapeDesc parse_julia_fractal(Parser& parser, Context&) {
  JuliaFractalShape s;
  s.parameter = parse_vector4(parser);
  while (true) {
    const Token token = parser.peek();
    if (parser.accept(Keyword::kQuaternion)) {
      s.hypercomplex = false;
    } else if (parser.accept(Keyword::kHypercomplex)) {
      s.hypercomplex = true;
    } else if (parser.accept(Keyword::kMaxIteration)) {
      s.max_iteration = parser.parse_int();
    } else if (parser.accept(Keyword::kPrecision)) {
      s.precision = parser.parse_float();
      if (s.precision < 1.0) parser.fail("precision must be at least 1.");
    } else if (parser.accept(Keyword::kSlice)) {
      const Location where = parser.location();
      s.slice = parse_vector4(parser);
      if (s.slice[3] == 0.0) parser.fail_at(where, "The fourth component of a slice must not be 0.");
      parser.parse_comma();
      s.slice_distance = parser.parse_float();
    } else if (token.kind == TokenKind::kKeyword && is_julia_function(token.keyword)) {
      parser.next();
      s.function = spelling(token.keyword);
      if (token.keyword == Keyword::kPwr) {
        parser.accept(Punct::kLeftParen);
        const Number n = parser.parse_number(1, 2);
        parser.parse_comma();
        s.exponent = n.size == 1 ? Vec2{n.v[0], parser.at(Punct::kRightParen) ? 0.0 : parser.parse_float()}
                                 : Vec2{n.v[0], n.v[1]};
        parser.accept(Punct::kRightParen);
      }
    } else {
      break;
    }
  }
  if (!s.hypercomplex && s.function != "sqr" && s.function != "cube") {
    parser.fail("quaternion fractals have the functions sqr and cube only");
  }
  return s;
}

ShapeDesc parse_lathe(Parser& parser, Context&) {
  LatheShape s;
  if (const auto kind = accept_curve_kind(parser)) s.spline = *kind;
  const int count = parser.parse_int();
  const int least = s.spline == CurveKind::kLinear ? 2 : s.spline == CurveKind::kQuadratic ? 3 : 4;
  if (count < least) {
    parser.fail("A lathe of this spline needs at least " + std::to_string(least) + " points.");
  }
  s.points = parse_points(parser, count);
  return s;
}

ShapeDesc parse_ovus(Parser& parser, Context&) {
  OvusShape s;
  s.bottom = parser.parse_float();
  parser.parse_comma();
  s.top = parser.parse_float();
  if (s.bottom < 0.0 || s.top < 0.0) parser.fail("The radii of an ovus must be positive.");
  if (s.top >= 2.0 * s.bottom) {
    parser.warn("the upper radius of this ovus is at least twice the lower one: it is a sphere");
  }
  return s;
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
    if (parser.accept(Keyword::kAccuracy)) {
      s.accuracy = parser.parse_float();
    } else if (parser.accept(Keyword::kMaxGradient)) {
      s.max_gradient = parser.parse_float();
    } else if (parser.accept(Keyword::kContainedBy)) {
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
    } else {
      return s;
    }
  }
}

ShapeDesc parse_poly(Parser& parser, Context&, int order) {
  PolyShape s;
  s.order = order > 0 ? order : parse_poly_order(parser);
  const std::size_t count = coefficient_count(s.order);
  parser.expect(Punct::kLess);
  while (s.coefficients.size() < count) {
    s.coefficients.push_back(parser.parse_float());
    parser.parse_comma();
  }
  parser.expect(Punct::kGreater);
  return s;
}

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

ShapeDesc parse_prism(Parser& parser, Context&) {
  PrismShape s;
  while (true) {
    if (const auto kind = accept_curve_kind(parser)) {
      s.spline = *kind;
    } else if (parser.accept(Keyword::kLinearSweep)) {
      s.conic_sweep = false;
    } else if (parser.accept(Keyword::kConicSweep)) {
      s.conic_sweep = true;
    } else {
      break;
    }
  }
  s.height1 = parser.parse_float();
  parser.parse_comma();
  s.height2 = parser.parse_float();
  parser.parse_comma();
  const int count = parser.parse_int();
  if (count < 3) parser.fail("A prism must have at least three points.");
  const Location where = parser.location();
  s.points = parse_points(parser, count);
  check_outline(parser, where, s);
  s.open = parser.accept(Keyword::kOpen);
  return s;
}

/// No distance below 0, and heights that rise; those of the ends only from their neighbour's
/// neighbour.
void check_sor(Parser& parser, const std::vector<Vec2>& points) {
  constexpr double kLeast = 1e-10;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const bool falls = i > 1 && i + 1 < n && points[i].v <= points[i - 1].v;
    const bool flat = i > 1 && std::fabs(points[i].v - points[i - 2].v) < kLeast;
    if (points[i].u < 0.0 || falls || flat) {
      parser.fail("Incorrect point in surface of revolution.");
    }
  }
}

ShapeDesc parse_sor(Parser& parser, Context&) {
  SorShape s;
  const int count = parser.parse_int();
  if (count < 4) parser.fail("A surface of revolution must have at least four points.");
  s.points = parse_points(parser, count);
  check_sor(parser, s.points);
  s.open = parser.accept(Keyword::kOpen);
  return s;
}

ShapeDesc parse_sphere_sweep(Parser& parser, Context&) {
  SphereSweepShape s;
  const Location where = parser.location();
  const auto kind = accept_curve_kind(parser);
  if (!kind || (*kind != CurveKind::kLinear && *kind != CurveKind::kCubic && *kind != CurveKind::kB)) {
    parser.fail_at(where, "A sphere_sweep begins with linear_spline, cubic_spline or b_spline.");
  }
  s.spline = *kind;
  const int count = parser.parse_int();
  const int least = s.spline == CurveKind::kLinear ? 2 : 4;
  if (count < least) {
    parser.fail("A sphere_sweep of this spline needs at least " + std::to_string(least) + " spheres.");
  }
  for (int i = 0; i < count; ++i) {
    parser.parse_comma();
    s.centres.push_back(parser.parse_vector());
    parser.parse_comma();
    s.radii.push_back(parser.parse_float());
  }
  parser.parse_comma();
  if (parser.accept(Keyword::kTolerance)) s.tolerance = parser.parse_float();
  return s;
}

ShapeDesc parse_superellipsoid(Parser& parser, Context&) {
  const Vec2 v = parse_uv(parser);
  // Stock takes the exponents as they are; the smallest that it tells from 0.
  return SuperellipsoidShape{std::max(v.u, kLeastExponent), std::max(v.v, kLeastExponent)};
}

ShapeDesc parse_text(Parser& parser, Context&) {
  TextShape s;
  const Location where = parser.location();
  if (parser.accept(Keyword::kInternal)) {
    static constexpr std::array kFonts{"povlogo.ttf", "timrom.ttf", "cyrvetic.ttf", "crystal.ttf"};
    const int number = parser.parse_int();
    s.font = kFonts[number >= 0 && number < 4 ? static_cast<std::size_t>(number) : 0];
  } else {
    if (!parser.accept(Keyword::kTtf)) parser.fail_expected("ttf or internal");
    s.font = parser.parse_string();
  }
  auto path = parser.find_file(s.font);
  if (!path) path = parser.find_file(s.font + ".ttf");
  if (!path) parser.fail_at(where, "Cannot find the font file \"" + s.font + "\".");
  s.font = *path;
  parser.parse_comma();
  s.text = parser.parse_string();
  parser.parse_comma();
  s.thickness = parser.parse_float();
  parser.parse_comma();
  s.offset = parser.parse_vector();
  return s;
}

}  // namespace lentray::parser
