#include "parser/grammar/object.h"

#include "parser/base/edit.h"
#include "parser/grammar/helpers.h"
#include "parser/grammar/light.h"
#include "parser/grammar/nesting.h"
#include "parser/grammar/object_modifiers.h"
#include "parser/grammar/object_shapes.h"

namespace lentray::parser {
namespace {

struct ShapeEntry {
  Keyword keyword;
  ShapeDesc (*read)(Parser&, Context&) = nullptr;
  std::optional<CsgOperation> csg = std::nullopt;  ///< instead of `read`
};

constexpr std::array kShapes{
#define LENTRAY_SHAPE(keyword, production) ShapeEntry{Keyword::keyword, production},
#define LENTRAY_CSG(keyword, operation) \
  ShapeEntry{Keyword::keyword, nullptr, CsgOperation::operation},
#include "parser/grammar/shapes.def"
#undef LENTRAY_SHAPE
#undef LENTRAY_CSG
};

/// `{ shape modifiers }` or `{ identifier modifiers }`, the keyword consumed.
Ref<ObjectDesc> parse_shape_block(Parser& parser, Context& context, const ShapeEntry& entry,
                                  const Location& where) {
  parser.expect(Punct::kLeftCurly);
  auto object = make_recycled<ObjectDesc>();
  if (const auto named = parser.accept_value<Ref<ObjectDesc>>()) {
    if (entry.csg && at_object(parser)) {
      parser.fail_expected(
          "a modifier or } behind an identifier that comes first (as a part it is written "
          "object { Name })");
    }
    *object = **named;
    object->copied = true;
  } else {
    object->keyword = spelling(entry.keyword);
    object->shape =
        entry.csg ? parse_csg(parser, context, *entry.csg) : entry.read(parser, context);
  }
  object->where = where;
  parse_object_modifiers(parser, context, *object);
  measure(parser, *object);
  return object;
}

/// `{ object modifiers }` behind `object`.
Ref<ObjectDesc> parse_object_block(Parser& parser, Context& context, const Location& where) {
  parser.expect(Punct::kLeftCurly);
  const auto named = parser.accept_value<Ref<ObjectDesc>>();
  Ref<ObjectDesc> whole = named ? *named : expect_object(parser, context);
  ObjectDesc& object = edit(whole);
  object.compiled.made.reset();
  if (named) object.copied = true;
  object.reopened = true;
  object.where = where;
  parse_object_modifiers(parser, context, object);
  measure(parser, object);
  return whole;
}

}  // namespace

bool at_object(Parser& parser) {
  if (parser.at(Keyword::kObject) || parser.at(Keyword::kLightSource) ||
      parser.at(Keyword::kLightGroup) || find_entry<kShapes>(parser.peek())) {
    return true;
  }
  const Value* value = parser.peek_value();
  return value && std::holds_alternative<Ref<ObjectDesc>>(*value);
}

std::string object_words() { return "object, light_source, light_group, " + word_list(kShapes); }

Ref<ObjectDesc> accept_object(Parser& parser, Context& context) {
  const Location where = parser.location();
  if (const ShapeEntry* entry = find_entry<kShapes>(parser.peek())) {
    parser.next();
    if (entry->keyword == Keyword::kComposite && parser.language_version() >= 150) {
      parser.warn_at(where, "composite is union now");
    }
    return parse_shape_block(parser, context, *entry, where);
  }
  if (parser.accept(Keyword::kObject)) return parse_object_block(parser, context, where);
  if (parser.accept(Keyword::kLightSource)) return parse_light_source(parser, context, where);
  if (parser.accept(Keyword::kLightGroup)) return parse_light_group(parser, context, where);
  if (auto named = parser.accept_value<Ref<ObjectDesc>>()) {
    if ((*named)->csg() && !(*named)->copied) edit(*named).copied = true;
    return *named;
  }
  return nullptr;
}

Ref<ObjectDesc> expect_object(Parser& parser, Context& context) {
  Ref<ObjectDesc> object = accept_object(parser, context);
  if (!object)
    parser.fail_expected("an object: one of " + object_words() + " or an object identifier");
  return object;
}

}  // namespace lentray::parser
