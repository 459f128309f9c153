// Blobs, with textures of their components.
// Source: reference manual 3.7, "Blob".
#include <memory>

#include "core/base/tiny.h"
#include "parser/grammar/helpers.h"
#include "parser/grammar/object.h"
#include "parser/grammar/object_shapes.h"
#include "parser/grammar/transform.h"

namespace lentray::parser {
namespace {

using core::kTiny;

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
    if (length(e.b - e.a) < kTiny)
      parser.fail("Degenerate cylinder in a blob: both ends are one point.");
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
  parse_values(parser, e.strength, e.radius, e.a);
  parser.parse_comma();
  return e;
}

}  // namespace

ShapeDesc parse_blob(Parser& parser, Context& context) {
  auto s = std::make_shared<BlobShape>();
  while (true) {
    if (parser.accept(Keyword::kThreshold, s->threshold)) continue;
    if (parser.accept(Keyword::kSphere)) {
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

}  // namespace lentray::parser
