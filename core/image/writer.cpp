#include "core/image/writer.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <memory>

#include "core/image/file_swap.h"
#include "core/image/image_module.h"
#include "core/image/picture_encoder.h"
#include "core/image/quantiser.h"
#include "core/image/reader.h"

namespace lentray::core {

namespace fs = std::filesystem;

namespace {

// Rows that are encoded at a time: few, so that they stay in the processor's cache, and whole
// chunks of OpenEXR's.
constexpr std::uint32_t kRowsAtATime = 32;

void check_size(std::uint32_t width, std::uint32_t height, std::size_t values, std::size_t expected,
                const fs::path& path) {
  if (width == 0 || height == 0 || values != expected) {
    throw ImageError("cannot write '" + path.string() + "': a picture of " +
                     std::to_string(width) + " x " + std::to_string(height) + " pixels is empty");
  }
}

std::unique_ptr<PictureEncoder> make_encoder(const fs::path& path, const PictureSpec& spec) {
  if (spec.type == FileType::png && spec.bits != 32) return make_png_encoder(path, spec);
  return image_module().encoder(path, spec);
}

/// A picture on its way to its place.
class OpenPicture {
 public:
  OpenPicture(const fs::path& path, const PictureSpec& spec)
      : m_path(path), m_height(spec.height), m_swap(path) {
    guard([&] { m_encoder = make_encoder(m_swap.temporary(), spec); });
  }

  template <class Sample>
  void put(const std::vector<Sample>& samples, std::uint32_t rows) {
    guard([&] { m_encoder->put(samples.data(), rows); });
    m_next += rows;
  }

  void finish() {
    if (m_next != m_height) fail("rows are missing");
    guard([&] { m_encoder->close(); });
    m_swap.commit();
  }

  [[noreturn]] void fail(const std::string& why) const {
    throw ImageError("cannot write " + shown_place(m_path) + ": " + why);
  }

 private:
  template <class Work>
  void guard(Work&& work) {
    try {
      work();
    } catch (const std::exception& e) {
      fail(e.what());
    }
  }

  const fs::path m_path;
  const std::uint32_t m_height;
  FileSwap m_swap;
  std::unique_ptr<PictureEncoder> m_encoder;
  std::uint32_t m_next = 0;
};

template <class Sample, class Quantise>
void encode_by(const Quantise quantise, const Image& band, std::uint32_t first,
               std::uint32_t rows, const ImageFormat& format, std::vector<Sample>& samples) {
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

/// Rows of a band as a file's integers.
template <class Sample>
void encode(const Image& band, std::uint32_t first, std::uint32_t rows, const Quantiser& quantise,
            const ImageFormat& format, std::vector<Sample>& samples) {
  if (quantise.has_table()) {
    encode_by(quantise.table(), band, first, rows, format, samples);
  } else {
    encode_by(std::cref(quantise), band, first, rows, format, samples);
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

PictureSpec spec_of(std::uint32_t width, std::uint32_t height, const ImageFormat& format,
                    const ImageMetadata& metadata, const fs::path& path) {
  check_size(width, height, 1, 1, path);
  if (format.type != FileType::exr && format.bits != 8 && format.bits != 16) {
    throw ImageError("cannot write '" + path.string() + "': " + std::to_string(format.bits) +
                     " bits a colour; there are 8 and 16");
  }
  return {.type = format.type,
          .width = width,
          .height = height,
          .channels = format.alpha ? 4 : 3,
          .bits = format.type == FileType::exr ? 32 : format.bits,
          .tagged = true,
          .srgb = format.srgb,
          .file_gamma = format.file_gamma,
          .metadata = metadata};
}

template <class Sample>
void write_samples(const fs::path& path, const PictureSpec& spec,
                   const std::vector<Sample>& samples) {
  OpenPicture picture(path, spec);
  picture.put(samples, spec.height);
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
                        OpenPicture(path, spec_of(width, height, format, metadata, path))}) {}

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
  const PictureSpec spec{.type = type,
                         .width = image.width,
                         .height = image.height,
                         .channels = image.channels,
                         .bits = floats ? 32 : image.bits};
  if (floats) {
    write_samples(path, spec, image.samples);
  } else if (image.bits == 8) {
    write_samples(path, spec,
                  std::vector<std::uint8_t>(image.samples.begin(), image.samples.end()));
  } else {
    write_samples(path, spec,
                  std::vector<std::uint16_t>(image.samples.begin(), image.samples.end()));
  }
}

}  // namespace lentray::core
