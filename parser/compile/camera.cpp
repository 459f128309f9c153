#include "parser/compile/camera.h"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "core/base/color.h"
#include "core/pattern/single.h"
#include "parser/descriptions/object.h"

namespace lentray::parser {
namespace {

using core::single;

/// Stock keeps corners and normals in single precision; far points of the scene show it.
core::Vec3 rounded(const core::Vec3& p) { return {single(p.x), single(p.y), single(p.z)}; }

/// Of a mesh the normals are those of the corners as written; mesh2 rounds these before.
camera::MeshCameraFaces camera_faces(const MeshShape& mesh, bool rounds_first) {
  auto faces = std::make_shared<std::vector<camera::MeshCameraFace>>();
  faces->reserve(mesh.faces.size());
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    camera::MeshCameraFace face;
    const core::MeshTriple &vertices = mesh.faces[i], normals = mesh.face_normals[i],
                           uvs = mesh.face_uvs[i];
    for (std::size_t k = 0; k < 3; ++k) {
      face.corner[k] = rounded(mesh.vertices[vertices[k]]);
      if (normals[k] != core::kNoIndex)
        face.normals[k] = rounded(normalized(mesh.normals[normals[k]]));
      if (uvs[k] != core::kNoIndex) face.uv[k] = mesh.uvs[uvs[k]];
    }
    const auto corner = [&](std::size_t k) {
      return rounds_first ? face.corner[k] : mesh.vertices[vertices[k]];
    };
    face.normal = rounded(normalized(cross(corner(2) - corner(0), corner(1) - corner(0))));
    if (face.normal != core::Vec3{}) faces->push_back(face);
  }
  return faces;
}

camera::MeshCameraSetup mesh_setup(const CameraDesc& camera) {
  camera::MeshCameraSetup setup;
  setup.distribution = camera.distribution;
  setup.rays = static_cast<std::uint32_t>(camera.rays_per_pixel);
  setup.smooth = camera.smooth;
  setup.forward = camera.location.z;
  setup.backwards = camera.direction.z < -1e-10;
  std::map<const MeshShape*, camera::MeshCameraFaces> shared;
  for (const Ref<ObjectDesc>& object : camera.meshes) {
    const auto* mesh = &std::get<std::shared_ptr<const MeshShape>>(object->shape);
    camera::MeshCameraFaces& faces = shared[mesh->get()];
    if (!faces) faces = camera_faces(**mesh, object->keyword == "mesh2");
    setup.parts.push_back({faces, *object->transform});
  }
  return setup;
}

/// As in stock, both an aperture and a number of samples make focal blur.
std::optional<camera::BlurRequest> blur_request(const CameraDesc& camera,
                                                const TextureSettings& settings) {
  if (camera.aperture == 0.0 || camera.blur_samples <= 0) return std::nullopt;
  camera::BlurRequest request;
  request.aperture = camera.aperture;
  request.focal_distance = camera.focal_distance;
  if (camera.has_focal_point) request.focal_point = camera.focal_point;
  request.samples = {
      camera.blur_samples, camera.blur_samples_min, camera.confidence, camera.variance, {}};
  if (camera.bokeh) {
    const auto pigment = TextureCompiler(settings).pigment(camera.bokeh);
    request.samples.weight = [pigment](double x, double y) {
      return static_cast<double>(core::grey(pigment->colour({x, y, 0.0}).rgb));
    };
  }
  return request;
}

}  // namespace

CameraRequest camera_request(const CameraDesc& camera, const TextureSettings& settings) {
  CameraRequest request;
  request.kind = camera_kind_name(camera.kind);
  request.projection = {camera.location, camera.direction, camera.right, camera.up, std::nullopt};
  if (camera.has_look_at) request.projection.look_at_distance = camera.look_at_distance();
  request.cylinder_type = camera.cylinder_type;
  request.angles = {camera.angle, camera.horizontal_angle, camera.vertical_angle};
  if (camera.normal) request.normal = TextureCompiler(settings).normal(camera.normal);
  request.blur = blur_request(camera, settings);
  if (camera.kind == CameraKind::kMesh) request.mesh = mesh_setup(camera);
  if (camera.kind != CameraKind::kLenticular) return request;
  const LensDesc& lens = camera.lens;
  request.lens.pitch = lens.pitch;
  request.lens.lpi = lens.lpi;
  request.lens.focal_length = lens.focal_length;
  request.lens.ior = lens.ior;
  request.lens.pixels = lens.pixels;
  request.lens.print_dpi = lens.print_dpi;
  request.lens.front = lens.front;
  request.lens.view_distance = lens.view_distance;
  request.lens.model = lens.model;
  if (lens.slant) request.lens.slant = std::tan(*lens.slant * std::numbers::pi / 180.0);
  if (lens.rays) request.lens.rays = static_cast<std::uint32_t>(*lens.rays);
  return request;
}

}  // namespace lentray::parser
