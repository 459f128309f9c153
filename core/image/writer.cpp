#include "core/image/writer.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <memory>
#include <mutex>

#include "core/image/checked_file.h"
#include "core/image/file_swap.h"
#include "core/image/quantiser.h"
#include "core/image/reader.h"

namespace lentray::core {

namespace fs = std::filesystem;

namespace {

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
  spec.attribute("oiio:UnassociatedAlpha", 1);
  // There it would become an Exif directory, for which OpenImageIO reads back what it writes
  // through a proxy, and cannot.
  if (format.type == FileType::tiff) return;
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
}

// Rows that are encoded at a time: few, so that they stay in the processor's cache, and whole
// chunks of OpenEXR's.
constexpr std::uint32_t kRowsAtATime = 32;

void put_compression(OIIO::ImageSpec& spec, FileType type) {
  if (type != FileType::png) return;
  // Measured on integral images: the difference from the row above, in runs, takes a third of the
  // time of zlib's default and gives files of the same size.
  constexpr int kFilterUp = 0x20;
  spec.attribute("png:filter", kFilterUp);
  spec.attribute("compression", "rle");
}

void check_size(std::uint32_t width, std::uint32_t height, std::size_t values, std::size_t expected,
                const fs::path& path) {
  if (width == 0 || height == 0 || values != expected) {
    throw ImageError("cannot write '" + path.string() + "': a picture of " +
                     std::to_string(width) + " x " + std::to_string(height) + " pixels is empty");
  }
}

/// A picture on its way into a file, in the file's own samples.
class OpenPicture {
 public:
  OpenPicture(const fs::path& path, FileType type, const OIIO::ImageSpec& spec)
      : m_path(path), m_swap(path), m_file(m_swap.temporary()), m_spec(spec) {
    m_output = OIIO::ImageOutput::create(plugin_name(type));
    if (!m_output) fail(OIIO::geterror());
    OIIO::Filesystem::IOProxy* proxy = &m_file;
    m_output->set_ioproxy(proxy);
    check(m_output->open(m_swap.temporary().string(), m_spec));
  }

  ~OpenPicture() {
    // Given up half way. The encoder is not asked to close: libpng complains on standard error.
    static auto& given_up = *new std::vector<std::unique_ptr<OIIO::ImageOutput>>;
    static std::mutex mutex;
    if (!m_output) return;
    const std::lock_guard lock(mutex);
    given_up.push_back(std::move(m_output));
  }
  OpenPicture(const OpenPicture&) = delete;
  OpenPicture& operator=(const OpenPicture&) = delete;

  template <class Sample>
  void put(const std::vector<Sample>& samples, std::uint32_t rows) {
    const int first = static_cast<int>(m_next), end = static_cast<int>(m_next + rows);
    check(m_output->write_scanlines(first, end, 0, m_spec.format, samples.data()));
    m_next += rows;
  }

  void finish() {
    if (m_next != static_cast<std::uint32_t>(m_spec.height)) fail("rows are missing");
    check(m_output->close());
    m_output.reset();
    m_file.close();
    check(true);
    m_swap.commit();
  }

  [[noreturn]] void fail(const std::string& why) const {
    throw ImageError("cannot write " + shown_place(m_path) + ": " + why);
  }

 private:
  /// The file's own complaint tells more than the encoder's, which may not even notice.
  void check(bool done) {
    if (!m_file.complaint().empty()) fail(m_file.complaint());
    if (!done) fail(m_output->geterror());
  }

  const fs::path m_path;
  FileSwap m_swap;
  CheckedFile m_file;
  const OIIO::ImageSpec m_spec;
  std::unique_ptr<OIIO::ImageOutput> m_output;
  std::uint32_t m_next = 0;
};

/// Rows of a band as a file's integers.
template <class Sample>
void encode(const Image& band, std::uint32_t first, std::uint32_t rows, const Quantiser& quantise,
            const ImageFormat& format, std::vector<Sample>& samples) {
  const std::size_t channels = format.alpha ? 4 : 3, count = std::size_t{band.width} * rows;
  samples.resize(count * channels);
  const float* from = band.pixel(0, first);
  Sample* to = samples.data();
  for (std::size_t p = 0; p < count; ++p, from += 4, to += channels) {
    for (int c = 0; c < 3; ++c) to[c] = static_cast<Sample>(quantise(from[c]));
    // Alpha is a share, not light: no gamma.
    if (format.alpha) to[3] = static_cast<Sample>(scaled_to_integer(from[3], format.bits));
  }
}

/// The same for OpenEXR: linear light, premultiplied.
void encode(const Image& band, std::uint32_t first, std::uint32_t rows, const Quantiser&,
            const ImageFormat& format, std::vector<float>& samples) {
  const std::size_t channels = format.alpha ? 4 : 3, count = std::size_t{band.width} * rows;
  samples.resize(count * channels);
  const float* from = band.pixel(0, first);
  float* to = samples.data();
  for (std::size_t p = 0; p < count; ++p, from += 4, to += channels) {
    const float alpha = format.alpha ? from[3] : 1.0f;
    for (int c = 0; c < 3; ++c) to[c] = linear_of(from[c], format) * alpha;
    if (format.alpha) to[3] = alpha;
  }
}

OIIO::ImageSpec spec_of(std::uint32_t width, std::uint32_t height, const ImageFormat& format,
                        const ImageMetadata& metadata, const fs::path& path) {
  check_size(width, height, 1, 1, path);
  if (format.type != FileType::exr && format.bits != 8 && format.bits != 16) {
    throw ImageError("cannot write '" + path.string() + "': " + std::to_string(format.bits) +
                     " bits a colour; there are 8 and 16");
  }
  const OIIO::TypeDesc type = format.type == FileType::exr ? OIIO::TypeDesc::FLOAT
                              : format.bits == 8           ? OIIO::TypeDesc::UINT8
                                                           : OIIO::TypeDesc::UINT16;
  OIIO::ImageSpec spec(static_cast<int>(width), static_cast<int>(height), format.alpha ? 4 : 3,
                       type);
  put_colour_space(spec, format);
  put_metadata(spec, format.type, metadata);
  put_compression(spec, format.type);
  return spec;
}

template <class Sample>
void write_samples(const fs::path& path, FileType type, const OIIO::ImageSpec& spec,
                   const std::vector<Sample>& samples) {
  OpenPicture picture(path, type, spec);
  picture.put(samples, static_cast<std::uint32_t>(spec.height));
  picture.finish();
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

struct PictureWriter::Parts {
  const std::uint32_t width;
  const ImageFormat format;
  const Quantiser quantise;
  OpenPicture picture;
  std::vector<std::uint8_t> bytes{};
  std::vector<std::uint16_t> words{};
  std::vector<float> floats{};
};

PictureWriter::PictureWriter(const fs::path& path, std::uint32_t width, std::uint32_t height,
                             const ImageFormat& format, const ImageMetadata& metadata)
    : m_parts(new Parts{width, format, Quantiser(format),
                        OpenPicture(path, format.type,
                                    spec_of(width, height, format, metadata, path))}) {}

PictureWriter::~PictureWriter() = default;

void PictureWriter::put(const Image& band) {
  Parts& p = *m_parts;
  if (band.width != p.width) p.picture.fail("a band has another width");
  for (std::uint32_t first = 0; first < band.height; first += kRowsAtATime) {
    const std::uint32_t rows = std::min(kRowsAtATime, band.height - first);
    const auto put = [&](auto& samples) {
      encode(band, first, rows, p.quantise, p.format, samples);
      p.picture.put(samples, rows);
    };
    if (p.format.type == FileType::exr) {
      put(p.floats);
    } else if (p.format.bits == 8) {
      put(p.bytes);
    } else {
      put(p.words);
    }
  }
}

void PictureWriter::finish() { m_parts->picture.finish(); }

void write_image(const Image& image, const fs::path& path, const ImageFormat& format,
                 const ImageMetadata& metadata) {
  check_size(image.width, image.height, image.rgba.size(),
             std::size_t{4} * image.width * image.height, path);
  PictureWriter writer(path, image.width, image.height, format, metadata);
  writer.put(image);
  writer.finish();
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
  put_compression(spec, type);
  if (floats) {
    write_samples(path, type, spec, image.samples);
  } else if (image.bits == 8) {
    write_samples(path, type, spec,
                  std::vector<std::uint8_t>(image.samples.begin(), image.samples.end()));
  } else {
    write_samples(path, type, spec,
                  std::vector<std::uint16_t>(image.samples.begin(), image.samples.end()));
  }
}

}  // namespace lentray::core
