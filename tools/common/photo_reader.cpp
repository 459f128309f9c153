#include "tools/common/photo_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "core/image/jpeg_inks.h"
#include "core/image/orientation.h"
#include "core/image/srgb.h"
#include "parser/options/own_option.h"
#include "tools/common/colour_profile.h"

namespace lentray::tool {
namespace {

using core::PhotoTags;
using core::StoredImage;

constexpr double kUsualGamma = 2.2;

bool are_of_srgb(const core::Chromaticities& c) {
  constexpr double kSame = 0.002;
  const core::Chromaticities srgb;
  const double differences[] = {c.white_x - srgb.white_x, c.white_y - srgb.white_y,
                                c.red_x - srgb.red_x,     c.red_y - srgb.red_y,
                                c.green_x - srgb.green_x, c.green_y - srgb.green_y,
                                c.blue_x - srgb.blue_x,   c.blue_y - srgb.blue_y};
  return std::ranges::all_of(differences, [](double d) { return std::fabs(d) <= kSame; });
}

/// Of files that have no profile but say in other words which colours they are of; else empty.
std::string profile_in_words(const PhotoTags& tags, const StoredImage& image) {
  if (image.channels < 3 || image.bits == 32) return {};
  if (tags.chromaticities && !are_of_srgb(*tags.chromaticities)) {
    return profile_of(*tags.chromaticities, image.gamma > 0.0 ? image.gamma : kUsualGamma);
  }
  return tags.is_adobe_rgb && image.gamma >= 0.0 ? adobe_rgb_profile() : std::string();
}

void add_words(const PhotoTags& tags, StoredImage& image) {
  if (!tags.description.empty()) image.attributes.try_emplace("ImageDescription", tags.description);
  if (!(tags.dpi_x > 0.0) || !(tags.dpi_y > 0.0)) return;
  image.attributes.try_emplace("XResolution", std::to_string(tags.dpi_x));
  image.attributes.try_emplace("YResolution", std::to_string(tags.dpi_y));
}

/// OpenEXR files have it among their attributes.
int orientation_of(const PhotoTags& tags, const StoredImage& image) {
  const auto said = image.attributes.find("Orientation");
  if (tags.orientation != 1 || said == image.attributes.end()) return tags.orientation;
  return std::atoi(said->second.c_str());
}

}  // namespace

Profiles profiles_in(const parser::GivenOption& given) {
  return parser::is_second(given, "srgb", "keep") ? Profiles::kKeep : Profiles::kSrgb;
}

StoredImage PhotoReader::read(const std::filesystem::path& path) {
  const std::string name = path.string();
  const PhotoTags tags = core::photo_tags(path);
  if (tags.pages > 1) {
    throw core::ImageError("'" + name + "' has " + std::to_string(tags.pages) +
                           " pages, where one picture is expected: save each page as a file of its "
                           "own, and name those");
  }
  StoredImage image = core::read_image(path);
  try {
    const std::string profile = tags.profile.empty() ? profile_in_words(tags, image) : tags.profile;
    if (!profile.empty() && image.channels == 3 && image.bits == 8 && tags.is_jpeg &&
        is_of_inks(profile)) {
      image = read_inks(path, profile);
    } else if (!profile.empty()) {
      use_profile(image, profile, name);
    }
  } catch (const ProfileError& e) {
    warn("'" + name + "': its colour profile is not used, for " + e.what() +
         "; colours are taken for sRGB");
  }
  if (tags.is_jpeg) add_words(tags, image);
  const int orientation = orientation_of(tags, image);
  return core::upright(std::move(image), orientation);
}

void PhotoReader::use_profile(StoredImage& image, const std::string& profile,
                              const std::string& name) {
  check_profile(profile, image.channels);
  if (m_profiles == Profiles::kKeep) {
    if (image.bits != 32) {
      image.profile = profile;
      return;
    }
    warn("'" + name + "' has floats: they are converted to sRGB's colours, not kept");
  }
  if (is_srgb(profile, image.channels)) {
    if (image.bits != 32) image.gamma = -1.0;
    return;
  }
  convert_to_srgb(image, profile);
}

StoredImage PhotoReader::read_inks(const std::filesystem::path& path, const std::string& profile) {
  if (m_profiles == Profiles::kKeep) {
    warn("'" + path.string() + "' is made of inks: they are converted to sRGB, not kept");
  }
  return srgb_of_inks(core::read_jpeg_inks(path), profile);
}

void PhotoReader::warn(const std::string& text) {
  if (std::ranges::find(m_warnings, text) == m_warnings.end()) m_warnings.push_back(text);
}

void use_srgb_curve(StoredImage& image) {
  constexpr double kAsUsual = 0.05;
  const bool is_usual = image.gamma <= 0.0 || std::fabs(image.gamma - kUsualGamma) <= kAsUsual;
  if (image.bits == 32 || is_usual || !image.profile.empty()) return;
  const float most = image.most();
  std::vector<float> table;
  for (std::uint32_t i = 0; i < 1u << image.bits; ++i) {
    const double light = std::pow(static_cast<double>(i) / most, image.gamma);
    table.push_back(std::floor(core::srgb_of_linear(static_cast<float>(light)) * most + 0.5f));
  }
  const auto channels = static_cast<std::size_t>(image.channels);
  const std::size_t colours = channels - (channels % 2 == 0 ? 1 : 0);
  for (std::size_t i = 0; i < image.samples.size(); ++i) {
    if (i % channels >= colours) continue;
    image.samples.set(i, table[static_cast<std::size_t>(image.samples[i])]);
  }
  image.gamma = -1.0;
  image.entries.clear();
}

}  // namespace lentray::tool
