#include "core/image/writer.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <memory>

#include "core/image/file_swap.h"
#include "core/image/reader.h"

namespace lentray::core {

namespace fs = std::filesystem;

namespace {

/// IEC 61966-2-1, as stock's default file gamma.
float srgb_encoded(float linear) {
  if (linear <= 0.0031308f) return linear * 12.92f;
  return 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

float power(float value, double exponent) {
  return value <= 0.0f ? value : static_cast<float>(std::pow(double{value}, exponent));
}

float linear_of(float value, const ImageFormat& format) {
  return format.working_gamma == 1.0 ? value : power(value, format.working_gamma);
}

unsigned scaled_to_integer(float encoded, int bits) {
  const float max = static_cast<float>((1u << bits) - 1u);
  const float level = std::floor(encoded * max + 0.5f);
  if (!(level > 0.0f)) return 0u;  // NaN too
  return static_cast<unsigned>(std::min(level, max));
}

const char* plugin_name(FileType type) {
  switch (type) {
    case FileType::png: return "png";
    case FileType::tiff: return "tiff";
    case FileType::exr: break;
  }
  return "openexr";
}

std::string field_lines(const ImageMetadata& metadata) {
  std::string text = metadata.description;
  for (const auto& [name, value] : metadata.fields) {
    if (!text.empty()) text += '\n';
    text += name + "=" + value;
  }
  return text;
}

void put_metadata(OIIO::ImageSpec& spec, FileType type, const ImageMetadata& metadata) {
  if (!metadata.software.empty()) spec.attribute("Software", metadata.software);
  const std::string description =
      type == FileType::tiff ? field_lines(metadata) : metadata.description;
  if (!description.empty()) spec.attribute("ImageDescription", description);
  if (type != FileType::tiff) {
    for (const auto& [name, value] : metadata.fields) spec.attribute(name, value);
  }
  if (metadata.dpi_x > 0.0 && metadata.dpi_y > 0.0) {
    // PNG knows pixels a metre only: rounding inches to whole numbers would be coarser.
    const bool metric = type == FileType::png;
    const double scale = metric ? 1.0 / 2.54 : 1.0;
    spec.attribute("XResolution", static_cast<float>(metadata.dpi_x * scale));
    spec.attribute("YResolution", static_cast<float>(metadata.dpi_y * scale));
    spec.attribute("ResolutionUnit", metric ? "cm" : "in");
    spec.attribute("PixelAspectRatio", static_cast<float>(metadata.dpi_y / metadata.dpi_x));
  }
}

void put_colour_space(OIIO::ImageSpec& spec, const ImageFormat& format) {
  if (format.type == FileType::exr) {
    spec.attribute("oiio:ColorSpace", "Linear");
  } else if (format.srgb) {
    spec.attribute("oiio:ColorSpace", "sRGB");
  } else if (format.file_gamma == 1.0) {
    spec.attribute("oiio:ColorSpace", "Linear");
    spec.attribute("oiio:Gamma", 1.0f);
  } else {
    spec.attribute("oiio:ColorSpace", "GammaCorrected");
    spec.attribute("oiio:Gamma", static_cast<float>(format.file_gamma));
  }
  spec.attribute("oiio:UnassociatedAlpha", 1);
}

template <class Sample>
void write_samples(const fs::path& path, const char* plugin, const OIIO::ImageSpec& spec,
                   const std::vector<Sample>& samples) {
  FileSwap swap(path);
  const auto fail = [&](const std::string& why) {
    throw ImageError("cannot write '" + path.string() + "': " + why);
  };
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(plugin);
  if (!output) fail(OIIO::geterror());
  const std::string temporary = swap.temporary().string();
  if (!output->open(temporary, spec)) fail(output->geterror());
  if (!output->write_image(spec.format, samples.data())) fail(output->geterror());
  if (!output->close()) fail(output->geterror());
  swap.commit();
}

template <class Sample>
std::vector<Sample> encoded_samples(const Image& image, const ImageFormat& format, int channels) {
  std::vector<Sample> samples(std::size_t{image.width} * image.height * channels);
  std::size_t next = 0;
  for (std::size_t p = 0; p < std::size_t{image.width} * image.height; ++p) {
    for (int c = 0; c < 3; ++c) {
      samples[next++] = static_cast<Sample>(quantised(image.rgba[4 * p + c], format));
    }
    // Alpha is a share, not light: no gamma.
    if (channels == 4) {
      samples[next++] =
          static_cast<Sample>(scaled_to_integer(image.rgba[4 * p + 3], format.bits));
    }
  }
  return samples;
}

std::vector<float> float_samples(const Image& image, const ImageFormat& format, int channels) {
  std::vector<float> samples;
  samples.reserve(std::size_t{image.width} * image.height * channels);
  for (std::size_t p = 0; p < std::size_t{image.width} * image.height; ++p) {
    const float alpha = channels == 4 ? image.rgba[4 * p + 3] : 1.0f;
    for (int c = 0; c < 3; ++c) {
      samples.push_back(linear_of(image.rgba[4 * p + c], format) * alpha);
    }
    if (channels == 4) samples.push_back(alpha);
  }
  return samples;
}

void check_size(std::uint32_t width, std::uint32_t height, std::size_t values, std::size_t expected,
                const fs::path& path) {
  if (width == 0 || height == 0 || values != expected) {
    throw ImageError("cannot write '" + path.string() + "': a picture of " +
                     std::to_string(width) + " x " + std::to_string(height) + " pixels is empty");
  }
}

}  // namespace

FileType file_type_of(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".png") return FileType::png;
  if (extension == ".tif" || extension == ".tiff") return FileType::tiff;
  if (extension == ".exr") return FileType::exr;
  throw ImageError("cannot write '" + path.string() + "': unknown kind of picture '" + extension +
                   "'; there are .png, .tif, .tiff, .exr");
}

std::string extension_of(FileType type) {
  switch (type) {
    case FileType::png: return ".png";
    case FileType::tiff: return ".tif";
    case FileType::exr: break;
  }
  return ".exr";
}

unsigned quantised(float linear, const ImageFormat& format) {
  float value = linear_of(linear, format);
  if (format.srgb) {
    value = srgb_encoded(value);
  } else if (format.file_gamma != 1.0) {
    value = power(value, 1.0 / format.file_gamma);
  }
  return scaled_to_integer(value, format.bits);
}

void write_image(const Image& image, const fs::path& path, const ImageFormat& format,
                 const ImageMetadata& metadata) {
  check_size(image.width, image.height, image.rgba.size(),
             std::size_t{4} * image.width * image.height, path);
  if (format.type != FileType::exr && format.bits != 8 && format.bits != 16) {
    throw ImageError("cannot write '" + path.string() + "': " + std::to_string(format.bits) +
                     " bits a colour; there are 8 and 16");
  }
  const int channels = format.alpha ? 4 : 3;
  const OIIO::TypeDesc type = format.type == FileType::exr ? OIIO::TypeDesc::FLOAT
                              : format.bits == 8           ? OIIO::TypeDesc::UINT8
                                                           : OIIO::TypeDesc::UINT16;
  OIIO::ImageSpec spec(static_cast<int>(image.width), static_cast<int>(image.height), channels,
                       type);
  put_colour_space(spec, format);
  put_metadata(spec, format.type, metadata);
  const char* plugin = plugin_name(format.type);
  if (format.type == FileType::exr) {
    write_samples(path, plugin, spec, float_samples(image, format, channels));
  } else if (format.bits == 8) {
    write_samples(path, plugin, spec, encoded_samples<std::uint8_t>(image, format, channels));
  } else {
    write_samples(path, plugin, spec, encoded_samples<std::uint16_t>(image, format, channels));
  }
}

void write_stored(const StoredImage& image, const fs::path& path) {
  check_size(image.width, image.height, image.samples.size(),
             std::size_t{image.width} * image.height * image.channels, path);
  const FileType type = file_type_of(path);
  const bool floats = type == FileType::exr || image.bits == 32;
  OIIO::ImageSpec spec(static_cast<int>(image.width), static_cast<int>(image.height),
                       image.channels,
                       floats            ? OIIO::TypeDesc::FLOAT
                       : image.bits == 8 ? OIIO::TypeDesc::UINT8
                                         : OIIO::TypeDesc::UINT16);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  if (floats) {
    write_samples(path, plugin_name(type), spec, image.samples);
  } else if (image.bits == 8) {
    write_samples(path, plugin_name(type), spec,
                  std::vector<std::uint8_t>(image.samples.begin(), image.samples.end()));
  } else {
    write_samples(path, plugin_name(type), spec,
                  std::vector<std::uint16_t>(image.samples.begin(), image.samples.end()));
  }
}

}  // namespace lentray::core
