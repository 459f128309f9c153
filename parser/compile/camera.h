// A camera statement -> what camera/ makes cameras of. The statement's vectors are final.
// Errors: camera::CameraError for what is not rendered yet.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "camera/lens_request.h"
#include "camera/mesh_camera.h"
#include "camera/projected.h"
#include "camera/projection.h"
#include "camera/thin_lens.h"
#include "parser/compile/texture_compiler.h"
#include "parser/descriptions/camera.h"

namespace lentray::parser {

struct CameraRequest {
  std::string kind;  ///< SDL's word
  camera::Projection projection;
  camera::ProjectedAngles angles;               ///< of the kinds whose picture is not flat
  int cylinder_type = 0;                        ///< 1..4
  camera::LensRequest lens;                     ///< of `lenticular`, empty otherwise
  std::optional<camera::MeshCameraSetup> mesh;  ///< of `mesh_camera`
  std::shared_ptr<const core::NormalPerturbation> normal;  ///< that bends the rays, or null
  std::optional<camera::BlurRequest> blur;                 ///< focal blur, if there is any
};

/// A scene without a camera has stock's default one: pass a default CameraDesc.
CameraRequest camera_request(const CameraDesc& camera, const TextureSettings& settings);

}  // namespace lentray::parser
