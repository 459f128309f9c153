#include "parser/values/value.h"

namespace lentray::parser {
namespace {

const char* number_name(const Number& n) {
  switch (n.size) {
    case 1: return "float";
    case 2: return "vector of 2 components";
    case 3: return "vector";
    case 4: return "vector of 4 components";
    default: return "color";
  }
}

}  // namespace

const char* kind_name(const Value& value) {
  static constexpr const char* kNames[] = {
      "uninitialised", "float",      "string",    "array",       "transform",  "function",
      "spline",        "pigment",    "normal",    "finish",      "texture",    "interior",
      "material",      "media",      "density",   "object",      "camera",     "fog",
      "rainbow",       "sky_sphere", "color_map", "pigment_map", "normal_map", "slope_map",
      "texture_map",   "density_map"};
  static_assert(std::size(kNames) == std::variant_size_v<Value>);
  if (const Number* n = std::get_if<Number>(&value)) return number_name(*n);
  return kNames[value.index()];
}

}  // namespace lentray::parser
