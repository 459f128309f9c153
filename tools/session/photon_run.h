// Photons of a scene's pictures: shot before the first of them or loaded, and what is told of them. One map serves all pictures of a session. One thread.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "core/pass/photon_pass.h"

namespace lentray::tool {

class PhotonRun {
 public:
  /// Of a scene with photons, which outlives it as `light` does, which gets them: now those that were loaded,
  /// from the pass those that are shot.
  PhotonRun(const core::Scene& scene, core::Illumination& light);
  /// Null: they were loaded.
  core::PhotonPass* pass() { return m_pass ? &*m_pass : nullptr; }
  /// The scene's save_file; empty: it wants none.
  const std::string& file() const;
  /// Writes that file, if there is one. Returns what went wrong; empty: nothing.
  std::string save() const;

  /// What a user may want to know of them, each in a line; empty: nothing.
  std::string warning() const;
  /// How many there are, as a table.
  std::string text() const;
  nlohmann::json json() const;
  /// Of the photons that are kept.
  std::uint64_t bytes() const;

 private:
  const core::Scene& m_scene;
  const core::Illumination& m_light;
  std::optional<core::PhotonPass> m_pass;
};

}  // namespace lentray::tool
