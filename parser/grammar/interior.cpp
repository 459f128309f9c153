#include "parser/descriptions/interior.h"

#include "parser/grammar/helpers.h"
#include "parser/grammar/material.h"
#include "parser/grammar/pattern.h"

namespace lentray::parser {
namespace {

bool accept_interior_word(Parser& parser, MaterialContext& context, InteriorDesc& interior) {
  if (parser.accept(Keyword::kDispersion, interior.dispersion) ||
      parser.accept(Keyword::kCaustics, interior.caustics) ||
      parser.accept(Keyword::kFadeDistance, interior.fade_distance) ||
      parser.accept(Keyword::kFadePower, interior.fade_power) ||
      accept_rgb(parser, Keyword::kFadeColor, interior.fade_colour))
    return true;
  if (parser.accept(Keyword::kIor)) {
    interior.ior = parser.parse_float();
    interior.ior_given = true;
  } else if (parser.accept(Keyword::kDispersionSamples)) {
    interior.dispersion_samples = parser.parse_int();
    if (interior.dispersion_samples < 2) parser.fail("dispersion_samples must be at least 2");
  } else if (parser.accept(Keyword::kMedia)) {
    interior.media.push_back(parse_media(parser, context));
  } else if (parser.accept(Keyword::kRefraction)) {
    parser.parse_float();
    parser.warn("refraction has no effect any more: what is transparent refracts");
  } else {
    return false;
  }
  return true;
}

}  // namespace

Ref<InteriorDesc> parse_interior(Parser& parser, MaterialContext& context,
                                 const Ref<InteriorDesc>& below) {
  const Location where = parser.location();
  parser.expect(Punct::kLeftCurly);
  auto interior = start_of(parser, below);
  interior->where = where;
  while (accept_interior_word(parser, context, *interior)) {
  }
  end_block(parser,
            "one of ior, dispersion, dispersion_samples, caustics, fade_color, "
            "fade_distance, fade_power, media");
  return interior;
}

}  // namespace lentray::parser
