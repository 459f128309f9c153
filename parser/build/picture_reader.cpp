#include "parser/build/picture_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <functional>
#include <optional>
#include <utility>

#include "core/base/color.h"
#include "core/image/gif_picture.h"
#include "core/image/palette_indices.h"
#include "core/image/png_chunks.h"
#include "core/image/reader.h"
#include "parser/build/build_error.h"
#include "parser/build/tiff_bytes.h"
#include "parser/gamma.h"

namespace lentray::parser {
namespace {

bool is_tiff(const std::string& type) { return type == "tif" || type == "tiff"; }
bool is_linear_format(const std::string& type) { return type == "exr" || type == "hdr"; }

/// What is stored in the working gamma, whatever that is.
bool is_raw_format(const std::string& type) {
  return type == "ppm" || type == "pgm" || is_tiff(type);
}

/// What the scene or the file says of its values, or the format; nothing: they stay as they are.
std::optional<Gamma> file_gamma(const ImageDesc& image, bool colours) {
  if (image.gamma != 0.0) return Gamma::of(image.gamma);
  if (!colours || image.decoding == ImageDesc::Decoding::kNone || is_raw_format(image.type)) return std::nullopt;
  if (is_linear_format(image.type)) return Gamma::linear();
  const double marked = image.type == "png" ? core::png_gamma(image.path.handle) : 0.0;
  if (marked != 0.0) return Gamma::of(marked);
  if (image.decoding == ImageDesc::Decoding::kMarked) return std::nullopt;
  return Gamma::srgb();
}

/// From the file to the working space, heights and patterns to linear values.
std::function<float(float)> decoder(const ImageDesc& image, bool colours) {
  const std::optional<Gamma> stored = file_gamma(image, colours);
  if (!stored) return [](float v) { return v; };
  const Gamma working = colours ? Gamma::of(image.working_gamma) : Gamma::linear();
  return [from = *stored, working](float v) { return from.recoded(v, working); };
}

core::PictureLayout layout_of(const ImageDesc& image, bool colours) {
  core::PictureLayout layout;
  switch (image.map_type) {
    case 1: layout.shape = core::PictureShape::kSpherical; break;
    case 2: layout.shape = core::PictureShape::kCylindrical; break;
    case 5: layout.shape = core::PictureShape::kTorus; break;
    default: break;
  }
  switch (image.interpolate) {
    case 2: layout.interpolation = core::Interpolation::kBilinear; break;
    case 3: layout.interpolation = core::Interpolation::kBicubic; break;
    case 4: layout.interpolation = core::Interpolation::kNormalizedDistance; break;
    default: break;
  }
  layout.once = image.once;
  layout.repeat = image.repeat;
  layout.offset = image.offset;
  // Patterns take such colours as they are.
  layout.premultiplied = colours && image.premultiplied.value_or(is_tiff(image.type) || image.type == "exr");
  return layout;
}

/// filter and transmit of the whole or of palette entries.
std::shared_ptr<const core::Picture> made_clearer(const core::Picture& picture,
                                                  const ImageDesc& image) {
  auto clearer = std::make_shared<core::Picture>(picture);
  const bool replaces = !clearer->indices.empty();  // as entries of a palette are set, not added to
  const auto clear = [&](float& part, const std::optional<double>& all) {
    if (all) part = static_cast<float>(*all) + (replaces ? 0.0f : part);
  };
  for (core::Colour& pixel : clearer->pixels) {
    clear(pixel.filter, image.filter_all);
    clear(pixel.transmit, image.transmit_all);
  }
  for (std::size_t i = 0; i < clearer->indices.size(); ++i) {
    for (const auto& [entry, value] : image.filters) {
      if (clearer->indices[i] == entry) clearer->pixels[i].filter = static_cast<float>(value);
    }
    for (const auto& [entry, value] : image.transmits) {
      if (clearer->indices[i] == entry) clearer->pixels[i].transmit = static_cast<float>(value);
    }
  }
  return clearer;
}

/// Values of a function are kept in 16 bits, as in stock.
float sixteen_bits(double value) {
  return static_cast<float>(std::floor(std::clamp(value, 0.0, 1.0) * 65535.0 + 0.5) / 65535.0);
}

}  // namespace

core::MappedPicturePtr PictureReader::get(const ImageDesc& image, bool colours) {
  std::shared_ptr<const core::Picture> picture = read(image, colours);
  if (image.filter_all || image.transmit_all || !image.filters.empty() || !image.transmits.empty()) {
    picture = made_clearer(*picture, image);
  }
  return std::make_shared<core::MappedPicture>(picture, layout_of(image, colours));
}

std::shared_ptr<const core::Picture> PictureReader::read(const ImageDesc& image, bool colours) {
  if (image.function) return evaluate(image);
  if (image.path.path.empty()) return missing(image.name);
  const std::string key = image.path.path + (colours ? "|c|" : "|h|") + image.type + "|" + std::to_string(image.gamma) + "|" +
                          std::to_string(image.working_gamma) + "|" + std::to_string(static_cast<int>(image.decoding));
  const auto known = m_files.find(key);
  if (known != m_files.end()) return known->second;
  auto picture = read_file(image, colours);
  m_files.emplace(key, picture);
  return picture;
}

std::shared_ptr<const core::Picture> PictureReader::read_file(const ImageDesc& image,
                                                              bool colours) {
  core::StoredImage stored;
  try {
    stored = core::read_image(image.path.handle, image.path.path);
  } catch (const core::ImageError& error) {
    throw BuildError(image.where, error.what());
  }
  if (is_tiff(image.type)) make_tiff_bytes(stored, image.path.handle);
  core::restore_clear_colours(stored, image.path.handle);
  const std::function<float(float)> decode = decoder(image, colours);
  const float most = stored.bits == 8 ? 255.0f : stored.bits == 16 ? 65535.0f : 1.0f;
  const bool rgb = stored.channels >= 3;
  std::vector<std::uint8_t> indices = core::palette_entries(stored, image.path.handle, image.type == "tga");
  std::vector<float> table;
  if (stored.bits == 8) {
    for (int v = 0; v < 256; ++v) {
      const float decoded = decode(static_cast<float>(v) / 255.0f);
      // Stock's greys of PNG files go through the weights of a colour and are cut to the 8 bits they came in,
      // which takes some one lower; greys of palettes and other files are as decoded.
      const bool cut = stored.channels == 1 && indices.empty() && image.type == "png";
      table.push_back(cut ? std::floor(core::grey({decoded, decoded, decoded}) * 255.0f) / 255.0f : decoded);
    }
  }
  const auto value = [&](std::uint32_t column, std::uint32_t row, int channel) {
    const float v = stored.at(column, row, channel);
    return table.empty() ? decode(v / most) : table[static_cast<std::size_t>(v)];
  };
  auto picture = std::make_shared<core::Picture>();
  picture->width = static_cast<int>(stored.width);
  picture->height = static_cast<int>(stored.height);
  const bool stored_alpha = stored.channels == 2 || stored.channels == 4;
  // Stock's pictures of these have transparencies, though it be none.
  const bool clear_colours = is_linear_format(image.type) || (is_tiff(image.type) && !has_tiff_palette(stored));
  const bool clear_palette = !indices.empty() && (image.type == "png" || image.type == "tga");
  picture->has_alpha = stored_alpha || clear_colours || clear_palette;
  picture->indices = std::move(indices);
  picture->pixels.reserve(std::size_t{stored.width} * stored.height);
  for (std::uint32_t row = 0; row < stored.height; ++row) {
    for (std::uint32_t column = 0; column < stored.width; ++column) {
      const float red = value(column, row, 0);
      core::Colour c{{red, rgb ? value(column, row, 1) : red, rgb ? value(column, row, 2) : red},
                     0.0f, 0.0f};
      if (stored_alpha) {
        c.transmit = 1.0f - stored.at(column, row, stored.channels - 1) / most;
      }
      picture->pixels.push_back(c);
    }
  }
  return picture;
}

std::shared_ptr<const core::Picture> PictureReader::evaluate(const ImageDesc& image) {
  const auto& function = image.function->function;
  const std::string not_yet = function->not_yet();
  if (!not_yet.empty() || function->parameters() != 3 || image.function_width < 1 ||
      image.function_height < 1) {
    return missing(not_yet.empty() ? "function" : not_yet);
  }
  auto picture = std::make_shared<core::Picture>();
  picture->width = image.function_width;
  picture->height = image.function_height;
  const auto step = [](int i, int count) { return static_cast<double>(i) / (count - 1); };
  std::array<double, core::kMostResults> result{};
  const bool coloured = function->results() == 5;
  for (int row = 0; row < picture->height; ++row) {
    for (int column = 0; column < picture->width; ++column) {
      const std::array<double, 3> at = {step(column, picture->width), step(row, picture->height), 0.0};
      function->evaluate_all(at, result);
      const float red = sixteen_bits(result[0]);
      picture->pixels.push_back(
          coloured ? core::Colour{{red, sixteen_bits(result[1]), sixteen_bits(result[2])}, 0.0f,
                                  sixteen_bits(result[4])}
                   : core::Colour{{red, red, red}, 0.0f, 0.0f});
    }
  }
  picture->has_alpha = coloured;
  return picture;
}

std::shared_ptr<const core::Picture> PictureReader::missing(const std::string& name) {
  m_not_yet.insert("image '" + name + "' (it cannot be read)");
  auto picture = std::make_shared<core::Picture>();
  picture->width = picture->height = 1;
  picture->pixels.push_back({{0.5f, 0.5f, 0.5f}, 0.0f, 0.0f});
  return picture;
}

}  // namespace lentray::parser
