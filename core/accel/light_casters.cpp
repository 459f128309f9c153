#include "core/accel/light_casters.h"

namespace lentray::core {

LightCasters::LightCasters(const std::vector<std::unique_ptr<Object>>& objects) {
  m_list.reserve(objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const Object& object = *objects[i];
    if (object.attributes().no_shadow) continue;
    const Bounds bounds = object.bounds();
    if (bounds.is_empty()) continue;
    const Shape* shape = plain_shape(object);
    const bool opaque = object.is_opaque();
    const std::size_t place = bounds.is_finite() ? i + objects.size() : i;  // as the hierarchy's
    m_list.push_back({&object, shape, opaque ? plain_plane(object) : nullptr, bounds,
                      static_cast<std::uint32_t>(place), caster_kind(shape), opaque});
  }
}

}  // namespace lentray::core
