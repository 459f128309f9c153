// The question the light loop asks: what of a light reaches a point. World space.
// One tester a thread; the plain one searches, shadow/ decorates it with caches. Every tester
// must give the same answer to the same query, whatever was asked before.
#pragma once

#include <cstdint>
#include <memory>

#include "core/accel/light_buffer.h"
#include "core/base/color.h"
#include "core/object/object.h"
#include "core/trace/area_shaft.h"
#include "core/trace/interiors_id.h"

namespace lentray::core {

class PlainShadowTester;
struct ThreadContext;

inline constexpr std::uint32_t kTreePlaces = 64;

struct ShadowQuery {
  Ray ray;                   ///< from the shaded point towards the light, unit direction
  double distance = 0.0;     ///< to the light (or its plane, if parallel)
  std::uint32_t light = 0;   ///< index into Scene::lights()
  std::uint32_t sample = 0;  ///< of an area light, 0 otherwise
  bool from_air = false;     ///< the ray starts at no surface: opaque ones count from its start on
  bool collects = true;      ///< what is lit there may be lit by photons
  bool volumes = true;       ///< fog and media dim the light
  int level = 1;             ///< trace level of the ray that is shaded, 1: camera ray
  /// Way from the camera: 1, then 2p behind a reflection at p and 2p + 1 behind a refraction; the
  /// far ends of the tree share kTreePlaces - 1.
  std::uint32_t tree_place = 1;
  std::uint32_t column = 0, row = 0;  ///< of the pixel, for caches that follow the image
  /// Of the ray's origin in the light's buffer where that is known; null: to be found.
  const LightBuffer::Spot* spot = nullptr;
  /// Of all opaque objects, where that is known: what the ray meets if it meets any.
  OnlyObject only;
  InteriorsId inside = InteriorsId::kOpen;  ///< of the ray that is shaded, of the thread's table
  std::uint64_t key = 0;                    ///< of the random numbers of the ray's origin
};

struct Visibility {
  Rgb filter{1.0f, 1.0f, 1.0f};     ///< 0 when blocked, else the product of the filters passed
  const Object* blocker = nullptr;  ///< the opaque blocker, if that is what ended the search
};

class ShadowTester {
 public:
  virtual ~ShadowTester() = default;
  virtual Visibility visibility(const ShadowQuery& query) = 0;
  /// The plain tester if this one only passes it the queries: then rays may be asked for in any other way that
  /// gives its answers (core/trace/block_lights.h). Null: this one wants to be asked for each ray.
  virtual PlainShadowTester* plain() { return nullptr; }
};

/// Makes one tester a thread (const: called from many threads).
class ShadowTesterFactory {
 public:
  virtual ~ShadowTesterFactory() = default;
  /// The context outlives the tester.
  virtual std::unique_ptr<ShadowTester> make(ThreadContext& context) const = 0;
};

/// Of testers that are made of the thread's context alone.
template <class Tester>
class ShadowTestersOf final : public ShadowTesterFactory {
 public:
  std::unique_ptr<ShadowTester> make(ThreadContext& context) const override {
    return std::make_unique<Tester>(context);
  }
};

}  // namespace lentray::core
