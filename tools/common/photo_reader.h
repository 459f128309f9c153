// Pictures as they are meant to be looked at: upright, and in sRGB. For pictures that are put together or printed; the
// pictures of a scene are read by core/image/reader.h as they are stored, as in POV-Ray.
// Errors: core::ImageError, worded for the user. One thread an object.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/image/photo_tags.h"
#include "core/image/reader.h"
#include "parser/options/option_values.h"

namespace lentray::tool {

/// What becomes of the colour profile of a picture.
enum class Profiles {
  kSrgb,  ///< colours are converted to sRGB
  kKeep   ///< samples stay, and the profile goes with them (core::StoredImage::profile)
};
/// Of the words srgb and keep. Throws parser::OptionError.
Profiles profiles_in(const parser::GivenOption& given);

class PhotoReader {
 public:
  explicit PhotoReader(Profiles profiles = Profiles::kSrgb) : m_profiles(profiles) {}

  /// Refuses a file of several pages: one of them would be used, and the others be missing.
  /// JPEG files get the attributes that those of other formats have: their description and resolution.
  core::StoredImage read(const std::filesystem::path& path);
  /// For whoever looks at the pictures besides.
  void warn(const std::string& text);
  /// What a user should know, each once.
  const std::vector<std::string>& warnings() const { return m_warnings; }

 private:
  void use_profile(core::StoredImage& image, const std::string& profile, const std::string& name);
  core::StoredImage read_inks(const std::filesystem::path& path, const std::string& profile);
  const Profiles m_profiles;
  std::vector<std::string> m_warnings;
};

/// Integers of a power law, which files may hold, become those of sRGB's curve: for what shows samples as they are.
void use_srgb_curve(core::StoredImage& image);

}  // namespace lentray::tool
