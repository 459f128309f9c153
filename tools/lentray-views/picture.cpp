#include "tools/lentray-views/picture.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "core/image/picture_encoder.h"
#include "core/image/srgb.h"
#include "core/image/writer.h"
#include "tools/common/version.h"

namespace lentray::views {
namespace {

using core::FileType;
using core::ImageError;
using core::StoredImage;

constexpr std::string_view kOurs = "lentray:";

float decoded_sample(float value, double gamma) {
  if (gamma == 1.0 || value <= 0.0f) return value;
  if (gamma <= 0.0) return core::linear_of_srgb(value);
  return static_cast<float>(std::pow(double{value}, gamma));
}
float encoded_sample(float light, double gamma) {
  if (gamma == 1.0 || light <= 0.0f) return light;
  if (gamma <= 0.0) return core::srgb_of_linear(light);
  return static_cast<float>(std::pow(double{light}, 1.0 / gamma));
}

/// The same picture in what a file of that type holds.
StoredImage fit_for(FileType type, const StoredImage& image) {
  StoredImage like = blank_like(image, 0, 0);
  like.bits = type == FileType::exr ? 32 : type == FileType::jpeg ? 8 : std::min(image.bits, 16);
  if (image.bits == 32 && like.bits != 32) like.bits = 8;
  if (like.bits == image.bits && !(type == FileType::jpeg && image.has_alpha())) return image;
  if (like.bits == 32 || image.bits == 32) like.gamma = like.bits == 32 ? 1.0 : -1.0;
  like.premultiplied = like.bits == 32 && like.has_alpha();
  Light light = light_of(image);
  if (type == FileType::jpeg && image.has_alpha()) {
    // Over black, which premultiplied light is already.
    like.channels = image.channels - 1;
    Light opaque{light.width, light.height, like.channels, {}};
    for (std::size_t i = 0; i < light.values.size(); ++i) {
      if (static_cast<int>(i % static_cast<std::size_t>(light.channels)) < like.channels)
        opaque.values.push_back(light.values[i]);
    }
    light = std::move(opaque);
  }
  return stored(light, like);
}

core::PictureSpec spec_for(FileType type, const StoredImage& image, const About& about) {
  core::PictureSpec spec;
  spec.type = type;
  spec.width = image.width;
  spec.height = image.height;
  spec.channels = image.channels;
  spec.bits = image.bits;
  spec.tagged = image.gamma != 0.0;
  spec.srgb = image.gamma < 0.0;
  spec.file_gamma = image.gamma > 0.0 ? image.gamma : 1.0;
  spec.quality = 92;
  spec.metadata.software = std::string("Lentray ") + tool::kVersion;
  spec.metadata.description = about.description;
  spec.metadata.dpi_x = about.dpi_x;
  spec.metadata.dpi_y = about.dpi_y;
  spec.metadata.orientation = about.orientation;
  spec.metadata.profile = image.profile;
  for (const auto& [name, value] : about.facts) {
    spec.metadata.fields.emplace_back(std::string(kOurs) + name, value);
  }
  return spec;
}

std::string kind_text(const StoredImage& image) {
  return std::to_string(image.channels) + " channels of " + std::to_string(image.bits) + " bits";
}

}  // namespace

double number_in(const Facts& facts, const std::string& name, const std::string& about) {
  const auto found = facts.find(name);
  if (found == facts.end()) return 0.0;
  char* end = nullptr;
  const double value = std::strtod(found->second.c_str(), &end);
  if (found->second.empty() || *end != '\0' || !std::isfinite(value)) {
    throw ImageError(about + " says '" + found->second + "' of its " + name +
                     ", which is no number");
  }
  return value;
}

StoredImage blank_like(const StoredImage& like, std::uint32_t width, std::uint32_t height) {
  StoredImage out;
  out.width = width;
  out.height = height;
  out.channels = like.channels;
  out.bits = like.bits;
  out.gamma = like.gamma;
  out.premultiplied = like.premultiplied;
  out.profile = like.profile;
  out.samples.store_bits(like.bits,
                         std::size_t{width} * height * static_cast<std::size_t>(like.channels));
  return out;
}

void copy_pixels(const StoredImage& from, const Rectangle& what, StoredImage& to,
                 std::uint32_t left, std::uint32_t top) {
  const std::size_t count = std::size_t{what.width} * static_cast<std::size_t>(from.channels);
  for (std::uint32_t y = 0; y < what.height; ++y) {
    const std::size_t a = from.place(what.left, what.top + y, 0), b = to.place(left, top + y, 0);
    for (std::size_t i = 0; i < count; ++i) to.samples.set(b + i, from.samples[a + i]);
  }
}

std::string other_kind(const StoredImage& a, const StoredImage& b) {
  const auto size = [](const StoredImage& image) {
    return std::to_string(image.width) + " x " + std::to_string(image.height);
  };
  if (a.width != b.width || a.height != b.height) return size(a) + " and " + size(b) + " pixels";
  if (a.channels != b.channels || a.bits != b.bits) return kind_text(a) + " and " + kind_text(b);
  if (a.profile != b.profile) return "different colour profiles; --profile srgb converts them";
  return {};
}

Light light_of(const StoredImage& image) {
  Light out{image.width, image.height, image.channels, {}};
  out.values.resize(image.samples.size());
  const auto channels = static_cast<std::size_t>(image.channels);
  const float most = image.most();
  std::vector<float> table;
  if (image.bits != 32) {
    for (std::uint32_t i = 0; i < 1u << image.bits; ++i)
      table.push_back(decoded_sample(static_cast<float>(i) / most, image.gamma));
  }
  const std::size_t colours = channels - (image.has_alpha() ? 1 : 0);
  for (std::size_t i = 0; i < out.values.size(); i += channels) {
    float alpha = 1.0f;
    if (colours < channels) {
      alpha = image.samples[i + colours] / most;
      out.values[i + colours] = alpha;
    }
    if (image.premultiplied) alpha = 1.0f;
    for (std::size_t c = 0; c < colours; ++c) {
      const float value = image.samples[i + c];
      out.values[i + c] = (table.empty() ? decoded_sample(value, image.gamma)
                                         : table[static_cast<std::size_t>(value)]) *
                          alpha;
    }
  }
  return out;
}

StoredImage stored(const Light& light, const StoredImage& like) {
  StoredImage kind = like;
  kind.channels = light.channels;
  StoredImage out = blank_like(kind, light.width, light.height);
  const auto channels = static_cast<std::size_t>(light.channels);
  const std::size_t colours = channels - (out.has_alpha() ? 1 : 0);
  const float most = out.most();
  const auto put = [&](std::size_t at, float value) {
    if (out.bits != 32) value = std::floor(std::clamp(value, 0.0f, 1.0f) * most + 0.5f);
    out.samples.set(at, value);
  };
  for (std::size_t i = 0; i < light.values.size(); i += channels) {
    float alpha = 1.0f;
    if (colours < channels) {
      put(i + colours, light.values[i + colours]);
      if (!out.premultiplied) alpha = light.values[i + colours];
    }
    for (std::size_t c = 0; c < colours; ++c) {
      const float value = alpha > 0.0f ? light.values[i + c] / alpha : 0.0f;
      put(i + c, encoded_sample(value, out.gamma));
    }
  }
  return out;
}

StoredImage for_viewers(const Light& light) {
  StoredImage like;
  like.bits = 8;
  like.gamma = -1.0;
  return stored(light, like);
}

StoredImage for_viewers(const StoredImage& image) {
  return image.bits == 8 && image.gamma <= 0.0 ? image : for_viewers(light_of(image));
}

void write_picture(const StoredImage& image, const std::filesystem::path& path,
                   const About& about) {
  const FileType type = core::file_type_of(path);
  if (type != FileType::png && type != FileType::tiff && type != FileType::exr &&
      type != FileType::jpeg) {
    throw ImageError("cannot write '" + path.string() + "': there are .png, .tif, .exr and .jpg");
  }
  if (type == FileType::exr && !image.profile.empty()) {
    throw ImageError("cannot write '" + path.string() +
                     "': OpenEXR holds no colour profile; .png, .tif and .jpg do");
  }
  const StoredImage fitting = fit_for(type, image);
  core::write_stored(fitting, path, spec_for(type, fitting, about));
}

}  // namespace lentray::views
