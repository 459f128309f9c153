// A value of SDL: what an identifier, an array element or a macro argument can hold.
// Descriptions are shared and never changed once made; a modifier copies first.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "core/base/transform.h"
#include "core/base/vec3.h"
#include "core/function/function.h"

namespace lentray::parser {

struct PigmentDesc;
struct NormalDesc;
struct FinishDesc;
struct TextureDesc;
struct InteriorDesc;
struct MaterialDesc;
struct MediaDesc;
struct DensityDesc;
struct ObjectDesc;  // light sources too
struct CameraDesc;
struct FogDesc;
struct RainbowDesc;
struct SkySphereDesc;
struct SplineDesc;
struct ColourMapDesc;
struct PigmentMapDesc;
struct NormalMapDesc;
struct SlopeMapDesc;
struct TextureMapDesc;
struct DensityMapDesc;
struct FunctionDesc;
struct ArrayValue;

/// A vector of 1 to 5 components, or a colour (r, g, b, filter, transmit: always 5).
/// A float is a Number of size 1. Promotion rules are those of the manual, "Vector Expressions".
struct Number {
  std::array<double, 5> v{};
  int size = 1;
  bool is_colour = false;
  /// A component of a vector (V.x): v[1] and v[2] are still the vector's. Until it is stored.
  bool keeps_rest = false;

  Number() = default;
  Number(const std::array<double, 5>& components, int count) : v(components), size(count) {}
  // One member after the other and no more than are meant: most are copied as soon as they are
  // written, and then a wide load of what narrow stores wrote must wait for them (10 ns each).
  Number(const Number& from) { *this = from; }
  Number& operator=(const Number& from) {
    size = from.size;
    is_colour = from.is_colour;
    keeps_rest = from.keeps_rest;
    v[0] = from.v[0];
    if (size == 1 && !keeps_rest) return *this;
    v[1] = from.v[1];
    v[2] = from.v[2];
    if (size <= 3) return *this;
    v[3] = from.v[3];
    v[4] = from.v[4];
    return *this;
  }

  static Number scalar(double x) {
    Number n;
    n.v[0] = x;
    return n;
  }
  static Number vector(const core::Vec3& p) {
    Number n;
    n.v[0] = p.x;
    n.v[1] = p.y;
    n.v[2] = p.z;
    n.size = 3;
    return n;
  }
  core::Vec3 xyz() const { return size == 1 ? core::Vec3(v[0]) : core::Vec3(v[0], v[1], v[2]); }
};

template <typename Desc>
using Ref = std::shared_ptr<const Desc>;

using Value =
    std::variant<std::monostate,  // declared, not set (array element)
                 Number, std::string, std::shared_ptr<ArrayValue>, Ref<core::Transform>,
                 Ref<FunctionDesc>, Ref<SplineDesc>, Ref<PigmentDesc>, Ref<NormalDesc>,
                 Ref<FinishDesc>, Ref<TextureDesc>, Ref<InteriorDesc>, Ref<MaterialDesc>,
                 Ref<MediaDesc>, Ref<DensityDesc>, Ref<ObjectDesc>, Ref<CameraDesc>, Ref<FogDesc>,
                 Ref<RainbowDesc>, Ref<SkySphereDesc>, Ref<ColourMapDesc>, Ref<PigmentMapDesc>,
                 Ref<NormalMapDesc>, Ref<SlopeMapDesc>, Ref<TextureMapDesc>, Ref<DensityMapDesc>>;

/// What a value is, in the words of a message ("float", "pigment").
const char* kind_name(const Value& value);

struct ArrayValue {
  std::vector<int> sizes;       ///< one a dimension
  std::vector<Value> elements;  ///< row major
};

/// A function as declared: its compiled form, its text's place, and its name for messages.
struct FunctionDesc {
  std::string name;
  std::shared_ptr<const core::Function> function;  ///< never null
  Ref<PigmentDesc> pigment;  ///< of `function { pigment {...} }`: what is evaluated, else null
  std::size_t depth = 1;     ///< functions that call functions, this one included
  double calls = 1.0;        ///< functions evaluated for one value, at most
};

}  // namespace lentray::parser
