#include "parser/files/tiff_bytes.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/image/palette_tiff.h"

namespace lentray::parser {
namespace {

/// Greys are cut, colours rounded.
std::uint8_t eight_bits(float sixteen, bool is_grey) {
  const int value = static_cast<int>(sixteen);
  return static_cast<std::uint8_t>(is_grey ? value >> 8 : (value + 128) / 257);
}

float multiplied(float value, float alpha) {
  return static_cast<float>((static_cast<int>(value) * static_cast<int>(alpha) + 127) / 255);
}

/// Deep greys are never transparent.
void drop_alpha(core::StoredImage& image) {
  for (std::size_t i = 0; i < image.samples.size() / 2; ++i)
    image.samples[i] = image.samples[2 * i];
  image.samples.resize(image.samples.size() / 2);
  image.channels = 1;
}

bool is_tiff_of(const core::StoredImage& image, const std::string& interpretation) {
  const auto found = image.attributes.find("tiff:PhotometricInterpretation");
  return found != image.attributes.end() && found->second == interpretation;
}

}  // namespace

void make_tiff_bytes(core::StoredImage& image, const std::filesystem::path& path) {
  if (has_tiff_palette(image)) {
    core::restore_palette_colours(image, path);
    return;
  }
  if (image.bits == 16) {
    // OpenImageIO turns those of 8 bits round, not these.
    if (is_tiff_of(image, "0")) {
      for (std::size_t i = 0; i < image.samples.size(); ++i)
        image.samples[i] = 65535.0f - image.samples[i];
    }
    std::vector<std::uint8_t> bytes(image.samples.size());
    for (std::size_t i = 0; i < bytes.size(); ++i)
      bytes[i] = eight_bits(image.samples[i], image.channels < 3);
    image.samples.store(std::move(bytes));
    image.bits = 8;
    if (image.channels == 2) drop_alpha(image);
  }
  const bool is_multiplied =
      image.attributes.find("oiio:UnassociatedAlpha") == image.attributes.end();
  if (is_multiplied || image.channels != 4 || image.bits != 8) return;
  for (std::size_t i = 0; i < image.samples.size(); i += 4) {
    for (std::size_t c = i; c < i + 3; ++c)
      image.samples[c] = multiplied(image.samples[c], image.samples[i + 3]);
  }
}

bool has_tiff_palette(const core::StoredImage& image) { return is_tiff_of(image, "3"); }

}  // namespace lentray::parser
