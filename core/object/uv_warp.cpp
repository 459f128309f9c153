#include "core/object/uv_warp.h"

#include <memory>

#include "core/object/leaf.h"

namespace lentray::core {
namespace {

class UvWarp final : public Warp {
 public:
  Vec3 inwards(const Vec3&, const SurfaceContext& surface) const override {
    if (!surface.hit) return {};
    const Vec2 uv = surface.hit->leaf->uv(surface.point, surface.hit->shape);
    return {uv.u, uv.v, 0.0};
  }
};

}  // namespace

WarpPtr make_uv_warp() { return std::make_shared<UvWarp>(); }

}  // namespace lentray::core
