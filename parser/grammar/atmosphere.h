// fog, rainbow, sky_sphere, background. The keyword is consumed; each reads its block.
// Source: reference manual 3.7, "Atmospheric Effects".
#pragma once

#include "parser/descriptions/atmosphere.h"
#include "parser/grammar/context.h"
#include "parser/interpreter/parser.h"

namespace lentray::parser {

FogDesc parse_fog(Parser& parser, Context& context);
RainbowDesc parse_rainbow(Parser& parser, Context& context);
SkySphereDesc parse_sky_sphere(Parser& parser, Context& context);
core::Colour parse_background(Parser& parser, Context& context);

}  // namespace lentray::parser
