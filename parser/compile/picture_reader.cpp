#include "parser/compile/picture_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

#include "core/base/color.h"
#include "core/base/memory_limit.h"
#include "core/image/png_chunks.h"
#include "core/image/reader.h"
#include "parser/base/gamma.h"
#include "parser/files/tiff_bytes.h"
#include "parser/source/build_error.h"

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
  if (!colours || image.decoding == ImageDesc::Decoding::kNone || is_raw_format(image.type))
    return std::nullopt;
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
  layout.premultiplied =
      colours && image.premultiplied.value_or(is_tiff(image.type) || image.type == "exr");
  return layout;
}

/// filter and transmit of the whole or of palette entries.
std::shared_ptr<const core::Picture> made_clearer(const core::Picture& picture,
                                                  const ImageDesc& image) {
  auto clearer = std::make_shared<core::Picture>(picture);
  clearer->clear_all(image.filter_all, image.transmit_all);
  if (!clearer->has_palette()) return clearer;
  const auto is_entry = [](int entry) { return entry >= 0 && entry < 256; };
  for (const auto& [entry, value] : image.filters) {
    if (is_entry(entry)) clearer->set_filter(entry, value);
  }
  for (const auto& [entry, value] : image.transmits) {
    if (is_entry(entry)) clearer->set_transmit(entry, value);
  }
  return clearer;
}

/// Values of a function are kept in 16 bits, as in stock.
float sixteen_bits(double value) {
  return static_cast<float>(std::floor(std::clamp(value, 0.0, 1.0) * 65535.0 + 0.5) / 65535.0);
}

using Decode = std::function<float(float)>;

/// What each sample of 8 bits stands for.
std::vector<float> byte_values(const core::StoredImage& stored, const std::string& type,
                               const Decode& decode) {
  // Stock's greys of PNG files go through the weights of a colour and are cut to the 8 bits they came in,
  // which takes some one lower; greys of palettes and other files are as decoded.
  const bool cut = stored.channels == 1 && stored.entries.empty() && type == "png";
  std::vector<float> values;
  for (int v = 0; v < 256; ++v) {
    const float value = decode(static_cast<float>(v) / 255.0f);
    values.push_back(cut ? std::floor(core::grey({value, value, value}) * 255.0f) / 255.0f : value);
  }
  return values;
}

/// Of any samples, a colour a pixel.
class Colours {
 public:
  Colours(const core::StoredImage& stored, const Decode& decode, std::vector<float> byte_values)
      : m_stored(stored), m_decode(decode), m_values(std::move(byte_values)),
        m_most(stored.bits == 8    ? 255.0f
               : stored.bits == 16 ? 65535.0f
                                   : 1.0f) {}
  core::Colour operator()(std::size_t pixel) const {
    const auto channels = static_cast<std::size_t>(m_stored.channels);
    const std::size_t from = pixel * channels;
    const float red = value(from);
    core::Colour c{
        {red, channels > 2 ? value(from + 1) : red, channels > 2 ? value(from + 2) : red},
        0.0f,
        0.0f};
    if (channels % 2 == 0) c.transmit = 1.0f - m_stored.samples[from + channels - 1] / m_most;
    return c;
  }

 private:
  float value(std::size_t i) const {
    const float v = m_stored.samples[i];
    return m_values.empty() ? m_decode(v / m_most) : m_values[static_cast<std::size_t>(v)];
  }
  const core::StoredImage& m_stored;
  const Decode& m_decode;
  const std::vector<float> m_values;
  const float m_most;
};

/// As small as the file has it: bytes stay bytes, entries entries.
core::Picture decoded(core::StoredImage stored, const ImageDesc& image, bool colours) {
  const Decode decode = decoder(image, colours);
  const int width = static_cast<int>(stored.width), height = static_cast<int>(stored.height);
  const std::size_t pixels = std::size_t{stored.width} * stored.height;
  std::vector<float> values;
  if (stored.bits == 8) values = byte_values(stored, image.type, decode);
  if (!stored.entries.empty()) {
    const Colours colour(stored, decode, values);
    std::array<core::Colour, 256> palette{};
    std::array<bool, 256> is_known{};
    for (std::size_t i = 0; i < pixels; ++i) {
      const std::uint8_t entry = stored.entries[i];
      if (!std::exchange(is_known[entry], true)) palette[entry] = colour(i);
    }
    return {width, height, std::move(stored.entries), palette};
  }
  if (stored.samples.is_stored_as<std::uint8_t>() && stored.bits == 8) {
    return {width, height, stored.channels, stored.samples.take<std::uint8_t>(), std::move(values)};
  }
  constexpr std::size_t kWords = 65536;
  if (stored.samples.is_stored_as<std::uint16_t>() && stored.bits == 16 && pixels > kWords) {
    for (std::size_t v = 0; v < kWords; ++v)
      values.push_back(decode(static_cast<float>(v) / 65535.0f));
    return {width, height, stored.channels, stored.samples.take<std::uint16_t>(),
            std::move(values)};
  }
  const Colours colour(stored, decode, std::move(values));
  std::vector<core::Colour> all(pixels);
  for (std::size_t i = 0; i < pixels; ++i) all[i] = colour(i);
  return {width, height, std::move(all)};
}

}  // namespace

core::MappedPicturePtr PictureReader::get(const ImageDesc& image, bool colours) {
  std::shared_ptr<const core::Picture> picture = read(image, colours);
  if (image.filter_all || image.transmit_all || !image.filters.empty() ||
      !image.transmits.empty()) {
    picture = made_clearer(*picture, image);
  }
  if (m_given.insert(picture).second) m_bytes += picture->bytes();
  return std::make_shared<core::MappedPicture>(picture, layout_of(image, colours));
}

std::shared_ptr<const core::Picture> PictureReader::read(const ImageDesc& image, bool colours) {
  if (image.function) return evaluate(image);
  if (image.path.path.empty()) return missing(image.name);
  const std::string key = image.path.path + (colours ? "|c|" : "|h|") + image.type + "|" +
                          std::to_string(image.gamma) + "|" + std::to_string(image.working_gamma) +
                          "|" + std::to_string(static_cast<int>(image.decoding));
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
    stored = core::read_image(
        {.path = image.path.handle, .name = image.path.path, .is_targa = image.type == "tga"});
  } catch (const core::ImageError& error) {
    throw BuildError(image.where, error.what());
  }
  if (is_tiff(image.type)) make_tiff_bytes(stored, image.path.handle);
  const bool has_palette = !stored.entries.empty();
  const bool stored_alpha = stored.channels == 2 || stored.channels == 4;
  // Stock's pictures of these have transparencies, though it be none.
  const bool clear_colours =
      is_linear_format(image.type) || (is_tiff(image.type) && !has_tiff_palette(stored));
  const bool clear_palette = has_palette && (image.type == "png" || image.type == "tga");
  auto picture = std::make_shared<core::Picture>(decoded(std::move(stored), image, colours));
  picture->set_alpha(stored_alpha || clear_colours || clear_palette);
  return picture;
}

std::shared_ptr<const core::Picture> PictureReader::evaluate(const ImageDesc& image) {
  const auto& function = image.function->function;
  const std::string not_yet = function->not_yet();
  if (!not_yet.empty() || function->parameters() != 3 || image.function_width < 1 ||
      image.function_height < 1) {
    return missing(not_yet.empty() ? "function" : not_yet);
  }
  const int width = image.function_width, height = image.function_height;
  try {
    core::check_room(static_cast<double>(width) * height * sizeof(core::Colour));
  } catch (const core::NoRoom& error) {
    throw BuildError(image.where, error.what());
  }
  const auto step = [](int i, int count) { return static_cast<double>(i) / (count - 1); };
  std::array<double, core::kMostResults> result{};
  const bool coloured = function->results() == 5;
  std::vector<core::Colour> pixels;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const std::array<double, 3> at = {step(column, width), step(row, height), 0.0};
      function->evaluate_all(at, result);
      const float red = sixteen_bits(result[0]);
      pixels.push_back(coloured
                           ? core::Colour{{red, sixteen_bits(result[1]), sixteen_bits(result[2])},
                                          0.0f,
                                          sixteen_bits(result[4])}
                           : core::Colour{{red, red, red}, 0.0f, 0.0f});
    }
  }
  auto picture = std::make_shared<core::Picture>(width, height, std::move(pixels));
  picture->set_alpha(coloured);
  return picture;
}

std::shared_ptr<const core::Picture> PictureReader::missing(const std::string& name) {
  m_not_yet.insert("image '" + name + "' (it cannot be read)");
  return std::make_shared<core::Picture>(
      1, 1, std::vector<core::Colour>{{{0.5f, 0.5f, 0.5f}, 0.0f, 0.0f}});
}

}  // namespace lentray::parser
