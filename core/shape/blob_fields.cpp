#include "core/shape/blob_fields.h"

#include "core/numeric/bounds_help.h"

namespace lentray::core {
namespace {

constexpr std::size_t kMany = 9;  // fields from which a hierarchy over them pays

}  // namespace

double BlobField::at(const Vec3& local) const {
  const double along = std::clamp(local.z, 0.0, length);
  const double z = local.z - along;
  const double share = (local.x * local.x + local.y * local.y + z * z) / (radius * radius);
  return share < 1.0 ? strength * (1.0 - share) * (1.0 - share) : 0.0;
}

BlobFields::BlobFields(std::vector<BlobField> fields) : m_fields(std::move(fields)) {
  m_boxes.reserve(m_fields.size());
  for (const BlobField& f : m_fields) {
    const Vec3 end{0.0, 0.0, f.length};
    m_boxes.push_back(widened(support_bounds(f.to_blob, [&](const Vec3& d) {
      return std::max(0.0, dot(d, end)) + f.radius * length(d);
    })));
    m_reach.include(m_boxes.back());
  }
  if (m_fields.size() < kMany || !m_reach.is_finite()) return;
  WideBvh::Options options;
  options.max_leaf = 1;  // its box is tested then
  m_search = WideBvh(m_boxes, options);
}

}  // namespace lentray::core
