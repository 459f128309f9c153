#include "tests/support/dense_depth.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <thread>
#include <vector>

#include "core/accel/hierarchy.h"
#include "core/base/deep_threads.h"
#include "core/scene/tolerances.h"
#include "parser/compile/camera.h"
#include "parser/read_scene.h"

namespace lentray::test {

using core::Vec3;

/// The sheet in the world.
struct DenseScene::Frame {
  Vec3 middle, right, up, normal, eye;
  bool is_perspective;
  double lenses;
  /// For a mm beside the middle of its cell, how far to the left the eye is; of parallel rays, how much their slope
  /// grows.
  double eye_a_mm;

  core::Ray ray(double offset, double lens, double height) const {
    const Vec3 target = middle + right * ((lens + 0.5) / lenses - 0.5) + up * height;
    const Vec3 across = core::normalized(right);
    if (is_perspective) {
      const Vec3 from = eye - across * (offset * eye_a_mm);
      return {from, target - from};
    }
    const Vec3 along = middle - eye + across * (offset * eye_a_mm * core::length(middle - eye));
    return {target - along, along};
  }
  /// Where the plane is passed by the line to a point from the eye of an offset, in lenses.
  double seen_at(double offset, const Vec3& point) const {
    const Vec3 across = core::normalized(right);
    Vec3 way = normal + across * (offset * eye_a_mm);
    if (is_perspective) way = point - (eye - across * (offset * eye_a_mm));
    const Vec3 there = point + way * (core::dot(middle - point, normal) / core::dot(way, normal));
    return core::dot(there - middle, right) / core::length_squared(right) * lenses;
  }
};

DenseScene::DenseScene(const std::string& path, int width, int height) {
  parser::SourceManager sources;
  parser::Diagnostics diagnostics(sources);
  for (const auto s : {parser::Stream::kDebug, parser::Stream::kRender, parser::Stream::kStatistics,
                       parser::Stream::kWarning}) {
    diagnostics.connect(s, [](std::string_view) {});
  }
  parser::ParserOptions options;
  options.image_width = width;
  options.image_height = height;
  options.library_paths = {std::filesystem::path(path).parent_path().string(),
                           "/usr/share/povray-3.7/include", "/usr/share/povray/include"};
  parser::SceneDesc description = parser::read_descriptions(path, sources, diagnostics, options);
  m_scene = std::make_unique<core::Scene>(parser::build_scene(description, diagnostics),
                                          core::CompileOptions{});
  const parser::CameraRequest camera =
      parser::camera_request(description.camera.value_or(parser::CameraDesc{}), {});
  m_camera = camera.projection;
  m_is_perspective = camera.kind == "perspective";
  m_normal = core::normalized(core::cross(m_camera.right, m_camera.up));
  if (core::dot(m_normal, m_camera.direction) < 0.0) m_normal = -m_normal;
}

double DenseScene::look_at_distance() const {
  return m_camera.look_at_distance.value_or(0.0) *
         core::dot(core::normalized(m_camera.direction), m_normal);
}

double DenseScene::look_at_millimetres(const DenseSheet& sheet) const {
  const double far = look_at_distance() / core::dot(m_camera.direction, m_normal);
  return look_at_distance() * sheet.width / sheet.pixels * sheet.pitch /
         (core::length(m_camera.right) * far);
}

DenseDepth DenseScene::look(const DenseSheet& sheet) const {
  Frame frame;
  const double far = sheet.distance / core::dot(m_camera.direction, m_normal);
  frame.is_perspective = m_is_perspective;
  frame.eye = m_camera.location;
  frame.middle = frame.eye + m_camera.direction * far;
  frame.right = m_camera.right * (m_is_perspective ? far : 1.0);
  frame.up = m_camera.up * (m_is_perspective ? far : 1.0);
  frame.normal = m_normal;
  frame.lenses = sheet.width / sheet.pixels;
  frame.eye_a_mm =
      sheet.index / sheet.focal_length * sheet.factor * (m_is_perspective ? sheet.distance : 1.0);
  // What lies between two neighbouring views, seen from both of their eyes.
  const double half = 0.5 * sheet.print_pitch / sheet.pixels;
  const auto moves = [&](const Vec3& point) {
    return frame.seen_at(-half, point) - frame.seen_at(half, point);
  };
  std::vector<std::vector<float>> rows(static_cast<std::size_t>(sheet.height));
  std::atomic<int> next{0};
  core::run_on_threads(std::max(1u, std::thread::hardware_concurrency()), m_scene->deepest(), [&] {
    core::HitLists lists;
    for (int row = next++; row < sheet.height; row = next++) {
      std::vector<float>& steps = rows[static_cast<std::size_t>(row)];
      for (int k = 0; k < sheet.width; ++k) {
        const double lens = std::floor((k + 0.5) / sheet.pixels);
        const double offset = ((k + 0.5) / sheet.pixels - lens - 0.5) * sheet.print_pitch;
        core::Ray ray = frame.ray(offset, lens, 0.5 - (row + 0.5) / sheet.height);
        ray.direction = core::normalized(ray.direction);
        core::Hit hit;
        if (m_scene->hierarchy().nearest(ray, core::kMinHitDistance * m_scene->tolerance_scale(),
                                         1e300, core::RayKind::kCamera, hit, lists, nullptr))
          steps.push_back(static_cast<float>(moves(ray.at(hit.t))));
      }
    }
  });
  DenseDepth out;
  std::vector<float> all;
  for (const auto& steps : rows) all.insert(all.end(), steps.begin(), steps.end());
  out.rays = static_cast<std::uint64_t>(sheet.width) * static_cast<std::uint64_t>(sheet.height);
  out.background = out.rays - all.size();
  if (m_is_perspective) out.sky = moves(frame.middle + m_camera.direction * (1e12 * far));
  if (all.empty()) return out;
  std::ranges::sort(all);
  out.least = all.front();
  out.most = all.back();
  out.low = all[all.size() / 20];
  out.high = all[all.size() - 1 - all.size() / 20];
  return out;
}

}  // namespace lentray::test
