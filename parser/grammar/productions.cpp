#include "parser/grammar/productions.h"

#include "parser/compile/object_query.h"
#include "parser/grammar/atmosphere.h"
#include "parser/grammar/camera.h"
#include "parser/grammar/object.h"
#include "parser/grammar/object_modifiers.h"
#include "parser/source/build_error.h"
#include "parser/stock/stock_box.h"

namespace lentray::parser {

Grammar::Grammar() {
  m_context.materials.parse_object = [this](Parser& parser) {
    return expect_object(parser, m_context);
  };
}

std::optional<Value> Grammar::rvalue(Parser& parser) {
  if (at_object(parser)) return Value(accept_object(parser, m_context));
  if (parser.accept(Keyword::kCamera)) {
    return Value(Ref<CameraDesc>(
        std::make_shared<CameraDesc>(parse_camera(parser, m_context, m_context.default_camera))));
  }
  if (parser.accept(Keyword::kFog)) {
    return Value(Ref<FogDesc>(std::make_shared<FogDesc>(parse_fog(parser, m_context))));
  }
  if (parser.accept(Keyword::kRainbow)) {
    return Value(Ref<RainbowDesc>(std::make_shared<RainbowDesc>(parse_rainbow(parser, m_context))));
  }
  if (parser.accept(Keyword::kSkySphere)) {
    return Value(
        Ref<SkySphereDesc>(std::make_shared<SkySphereDesc>(parse_sky_sphere(parser, m_context))));
  }
  return accept_material_value(parser, m_context.materials);
}

void Grammar::set_default(Parser& parser) {
  parser.expect(Punct::kLeftCurly);
  while (!parser.accept(Punct::kRightCurly)) {
    if (parser.accept(Keyword::kCamera)) {
      m_context.default_camera = parse_camera(parser, m_context, m_context.default_camera);
    } else if (parser.accept(Keyword::kRadiosity)) {
      parser.expect(Punct::kLeftCurly);
      while (parser.accept(Keyword::kImportance))
        m_context.default_importance = parse_importance(parser);
      parser.expect(Punct::kRightCurly);
    } else if (!accept_material_default(parser, m_context.materials)) {
      parser.fail_expected("one of texture, pigment, normal, finish, camera, radiosity or }");
    }
  }
}

bool Grammar::inside(const ObjectDesc& object, const core::Vec3& point) {
  return ObjectQuery(object).inside(point);
}

bool Grammar::trace(const ObjectDesc& object, const core::Vec3& origin, const core::Vec3& direction,
                    core::Vec3& point, core::Vec3& normal) {
  return ObjectQuery(object).trace(origin, direction, point, normal);
}

void Grammar::extent(const ObjectDesc& object, core::Vec3& lo, core::Vec3& hi) {
  bool is_whole = true;
  const core::Bounds box = stock_box(object, is_whole);
  lo = box.lo;
  hi = box.hi;
}

Ref<FunctionDesc> Grammar::pattern_function(Parser& parser) {
  try {
    return parse_pattern_function(parser, m_context.materials);
  } catch (const BuildError& error) {  // of a picture
    parser.fail_at(error.where(), error.what());
  }
}

}  // namespace lentray::parser
