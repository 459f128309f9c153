// Colour profiles of pictures (ICC), by LittleCMS. Colours are converted to sRGB relative to white, black to black, in
// floats: samples are rounded once. What sRGB does not hold is cut, channel by channel.
// Errors: ProfileError with the reason alone. Threads: any number; all functions are pure.
#pragma once

#include <stdexcept>
#include <string>

#include "core/image/photo_tags.h"
#include "core/image/reader.h"

namespace lentray::tool {

class ProfileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Of colours by a power law.
std::string profile_of(const core::Chromaticities& chromaticities, double gamma);
/// Adobe RGB (1998), which cameras mean that store no profile.
std::string adobe_rgb_profile();

/// The profile is one of a press: four inks.
bool is_of_inks(const std::string& profile);
/// Throws if a picture of so many channels cannot have the profile.
void check_profile(const std::string& profile, int channels);
/// Within half a level of 8 bits.
bool is_srgb(const std::string& profile, int channels);

/// The samples become sRGB's, or linear light of sRGB's primaries where they are floats. Alpha stays.
void convert_to_srgb(core::StoredImage& image, const std::string& profile);
/// Of four channels of inks, 0 is paper: three of sRGB.
core::StoredImage srgb_of_inks(const core::StoredImage& inks, const std::string& profile);

}  // namespace lentray::tool
