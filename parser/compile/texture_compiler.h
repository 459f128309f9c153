// Descriptions of materials -> what the kernel evaluates. One compiler a scene; the same Ref gives the
// same compiled object. Not thread-safe; what it makes is immutable and shared by all threads.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/material/interior.h"
#include "core/material/pigment.h"
#include "core/material/texture.h"
#include "parser/descriptions/interior.h"
#include "parser/descriptions/texture.h"
#include "parser/options/scene_overrides.h"

namespace lentray::parser {

struct TextureSettings {
  int quality = 9;           ///< +Q; 5 and below use quick_color
  int noise_generator = 2;   ///< global_settings; 3.7's default is 2
  int number_of_waves = 10;  ///< global_settings
  int language_version = 370;
  std::optional<double> least_translucency;  ///< mm; none: no subsurface light
  MediaSettings media;                       ///< what holds instead of the scene's own
};

class TextureCompiler {
 public:
  explicit TextureCompiler(const TextureSettings& settings);
  ~TextureCompiler();

  /// Null gives the `fallback`, which then must not be null.
  std::shared_ptr<const core::Texture> texture(const Ref<TextureDesc>& texture,
                                               const Ref<TextureDesc>& fallback);
  /// The owners of all textures that were made so far.
  std::vector<std::shared_ptr<const core::Texture>> take_textures();
  std::shared_ptr<const core::Pigment> pigment(const Ref<PigmentDesc>& pigment);
  /// Null where there is nothing to perturb, or below the quality that shows it.
  std::shared_ptr<const core::NormalPerturbation> normal(const Ref<NormalDesc>& normal);
  /// Null gives null, unless the texture bears an old scene's `ior`.
  std::shared_ptr<const core::Interior> interior(const Ref<InteriorDesc>& interior,
                                                 const Ref<TextureDesc>& texture = nullptr);

  /// Null below the quality that shows media.
  std::shared_ptr<const core::Medium> medium(const Ref<MediaDesc>& medium);

  /// To be called now and then: lets go of descriptions that nobody else refers to any more.
  void forget_unused();

  /// Of all pictures that were read so far.
  std::uint64_t picture_bytes() const;
  /// Of all textures that were asked for so far, with their maps and without pictures; of many about.
  std::uint64_t texture_bytes() const;
  /// Names of what was asked for and is not rendered yet.
  const std::set<std::string>& not_yet() const;
  /// Whether a finish so far has crand.
  bool has_crand() const;
  /// Whether one has subsurface light.
  bool has_subsurface() const;
  /// The first finish so far whose translucency is too little to be had; null: none.
  const FinishDesc* too_opaque() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

}  // namespace lentray::parser
