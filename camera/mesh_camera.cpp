#include "camera/mesh_camera.h"

#include <algorithm>

#include "camera/lens_request.h"

namespace lentray::camera {

/// Faces by the cells of the unit square that their texture coordinates may touch.
class MeshCamera::UvIndex {
 public:
  explicit UvIndex(const std::vector<MeshCameraFace>& faces) : m_cells(kSide * kSide) {
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const auto& uv = faces[i].uv;
      const auto [u0, u1] = std::minmax({uv[0].u, uv[1].u, uv[2].u});
      const auto [v0, v1] = std::minmax({uv[0].v, uv[1].v, uv[2].v});
      for (std::size_t row = cell(v0); row <= cell(v1); ++row) {
        for (std::size_t column = cell(u0); column <= cell(u1); ++column) {
          m_cells[row * kSide + column].push_back(static_cast<std::uint32_t>(i));
        }
      }
    }
  }
  /// In the scene's order.
  const std::vector<std::uint32_t>& near(const core::Vec2& uv) const {
    return m_cells[cell(uv.v) * kSide + cell(uv.u)];
  }

 private:
  static constexpr std::size_t kSide = 128;
  static std::size_t cell(double coordinate) {
    const double scaled = std::clamp(coordinate, 0.0, 1.0) * kSide;
    return std::min(static_cast<std::size_t>(scaled), kSide - 1);
  }
  std::vector<std::vector<std::uint32_t>> m_cells;
};

namespace {

/// Shares of the corners at a place of the texture; false outside the face.
bool shares_at(const MeshCameraFace& face, const core::Vec2& at, std::array<double, 3>& share) {
  const auto& p = face.uv;
  const auto twice_area = [](const core::Vec2& a, const core::Vec2& b, const core::Vec2& c) {
    return (a.u - c.u) * (b.v - c.v) - (b.u - c.u) * (a.v - c.v);
  };
  const double whole = twice_area(p[1], p[2], p[0]);
  share = {twice_area(p[1], p[2], at) / whole, twice_area(p[2], p[0], at) / whole,
           twice_area(p[0], p[1], at) / whole};
  return share[0] >= 0.0 && share[1] >= 0.0 && share[2] >= 0.0;
}

}  // namespace

MeshCamera::MeshCamera(MeshCameraSetup setup, std::uint32_t width, std::uint32_t height)
    : Camera("mesh_camera", width, height), m_setup(std::move(setup)) {
  std::size_t faces = 0;
  for (const MeshCameraPart& part : m_setup.parts) {
    m_before.push_back(faces);
    faces += part.faces->size();
  }
  if (faces == 0) throw CameraError("the meshes of the mesh_camera have no faces");
  if (m_setup.distribution == 3) {
    m_index = std::make_unique<UvIndex>(*m_setup.parts.front().faces);
  }
}

MeshCamera::~MeshCamera() = default;

void MeshCamera::start(const MeshCameraPart& part, core::Vec3 origin, core::Vec3 direction,
                       core::Ray& ray) const {
  origin += direction * m_setup.forward;
  if (m_setup.backwards) direction = -direction;
  ray = {part.to_world.point(origin), normalized(part.to_world.normal(direction))};
}

bool MeshCamera::from_face(const MeshCameraPart& part, std::size_t face, core::Ray& ray) const {
  if (face >= part.faces->size()) return false;
  const MeshCameraFace& f = (*part.faces)[face];
  start(part, (f.corner[0] + f.corner[1] + f.corner[2]) / 3.0, f.normal, ray);
  return true;
}

bool MeshCamera::by_place(double x, double y, core::Ray& ray) const {
  const MeshCameraPart& part = m_setup.parts.front();
  const core::Vec2 at{(x - 0.5) / width(), 1.0 - (y + 0.5) / height()};
  for (const std::uint32_t i : m_index->near(at)) {
    const MeshCameraFace& f = (*part.faces)[i];
    std::array<double, 3> share;
    if (!shares_at(f, at, share)) continue;
    core::Vec3 origin, normal;
    for (std::size_t k = 0; k < 3; ++k) {
      origin += f.corner[k] * share[k];
      normal += f.normals[k] * share[k];
    }
    const bool blended = m_setup.smooth && length(normal) > 0.0;
    start(part, origin, blended ? normalized(normal) : f.normal, ray);
    return true;
  }
  return false;
}

bool MeshCamera::from_part(const MeshCameraPart& part, double column, double row,
                           core::Ray& ray) const {
  const double x = std::clamp(column, 0.0, width() - 1.0);
  const double y = std::clamp(row - 1.0, 0.0, height() - 1.0);
  return from_face(part, static_cast<std::size_t>(y) * width() + static_cast<std::size_t>(x), ray);
}

std::uint32_t MeshCamera::rays_a_place() const {
  if (m_setup.distribution != 0) return 1;
  return std::min(m_setup.rays, static_cast<std::uint32_t>(m_setup.parts.size()));
}

bool MeshCamera::one_ray_at(const core::PixelPlace& place, const core::PlaceRay& which,
                            core::Ray& ray) const {
  return from_part(m_setup.parts[which.number], place.column + 0.5 + place.across,
                   place.row + 0.5 + place.down, ray);
}

bool MeshCamera::ray(double column, double row, core::Ray& ray) const {
  const double x = std::clamp(column, 0.0, width() - 1.0);
  const double y = std::clamp(row - 1.0, 0.0, height() - 1.0);
  const auto across = static_cast<std::size_t>(x), down = static_cast<std::size_t>(y);
  const auto& parts = m_setup.parts;
  switch (m_setup.distribution) {
    case 0: return from_part(parts.front(), column, row, ray);
    case 1: {
      const std::size_t face = down * width() + across;
      const auto after = std::upper_bound(m_before.begin(), m_before.end(), face);
      const auto part = static_cast<std::size_t>(after - m_before.begin()) - 1;
      return from_face(parts[part], face - m_before[part], ray);
    }
    case 2: {
      // Pictures of the meshes side by side; faces are counted from the left of the whole.
      const double each = static_cast<double>(width()) / static_cast<double>(parts.size());
      const auto part = std::min(static_cast<std::size_t>(x / each), parts.size() - 1);
      return from_face(parts[part], down * (width() / parts.size()) + across, ray);
    }
    default: return by_place(x, y, ray);
  }
}

}  // namespace lentray::camera
