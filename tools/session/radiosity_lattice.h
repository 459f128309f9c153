// The places that a radiosity pass samples before a picture: those of the picture, or of the lens sheet that
// it is a view of. Pure functions.
#pragma once

#include <string>

#include "core/base/vec3.h"
#include "core/scene/scene.h"
#include "parser/compile/camera.h"
#include "tools/session/camera_setup.h"

namespace lentray::tool {

struct RadiosityLattice {
  const camera::Camera& camera;
  bool is_sheet;          ///< that all that looks at one lens sheet shares
  bool sees_every_pixel;  ///< on the last level; else it has some 250,000 places
};
/// The setup outlives it.
RadiosityLattice lattice_of(const CameraSetup& setup);

/// From where the lengths of reuse are measured: the camera's location; of a sheet that the scene has itself,
/// its width before its middle.
core::Vec3 radiosity_eye(const parser::CameraRequest& request);

/// What a pass over it depends on besides files and options, as lines of an identity
/// (tools/session/identity.h).
std::string identity_lines(const RadiosityLattice& lattice, const core::Vec3& eye);

/// Of a scene with radiosity: its settings, and what the pass will do. As --explain gives it.
std::string radiosity_plan(const core::Scene& scene, const RadiosityLattice& lattice);

}  // namespace lentray::tool
