#include "core/image/writer.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <string_view>

#include "core/base/lower_case.h"
#include "core/image/file_swap.h"
#include "core/image/image_module.h"
#include "core/image/picture_encoder.h"
#include "core/image/reader.h"
#include "core/image/sample_rows.h"

namespace lentray::core {

namespace fs = std::filesystem;

namespace {

// Rows that are encoded at a time: few, so that they stay in the processor's cache, and whole
// chunks of OpenEXR's.
constexpr std::uint32_t kRowsAtATime = 32;

void check_size(std::uint32_t width, std::uint32_t height, std::size_t values, std::size_t expected,
                const fs::path& path) {
  if (width == 0 || height == 0 || values != expected) {
    throw ImageError("cannot write '" + path.string() + "': a picture of " + std::to_string(width) +
                     " x " + std::to_string(height) + " pixels is empty");
  }
}

/// Why a file of that kind does not hold the picture; empty: it does.
std::string over_limit(const PictureSpec& spec) {
  const auto beyond_side = [&](const char* kind, std::uint32_t most) {
    if (spec.width <= most && spec.height <= most) return std::string();
    return std::string(kind) + " file has at most " + std::to_string(most) + " pixels a side";
  };
  constexpr std::uint32_t kMostJpeg = 65500;  // of libjpeg, which ends the program beyond
  constexpr std::uint32_t kMostTarga = 65535;
  constexpr std::uint64_t kMostBmp = UINT32_MAX, kBmpHead = 14 + 40;
  switch (spec.type) {
    case FileType::jpeg: return beyond_side("a JPEG", kMostJpeg);
    case FileType::targa:
    case FileType::compressed_targa: return beyond_side("a Targa", kMostTarga);
    case FileType::bmp: {
      const std::uint64_t row =
          (std::uint64_t{spec.width} * static_cast<std::uint64_t>(spec.channels) + 3) / 4 * 4;
      if (row * spec.height <= kMostBmp - kBmpHead) return {};
      return "a BMP file has less than 4 GB of pixels";
    }
    case FileType::png:
    case FileType::tiff:
    case FileType::exr:
    case FileType::ppm:
    case FileType::radiance: break;
  }
  return {};
}

void check_fits(const fs::path& path, const PictureSpec& spec) {
  const std::string why = over_limit(spec);
  if (why.empty()) return;
  throw ImageError("cannot write " + shown_place(path) + ": " + why + ", and the picture has " +
                   std::to_string(spec.width) + " x " + std::to_string(spec.height) +
                   "; PNG, TIFF and PPM files hold larger ones");
}

std::unique_ptr<PictureEncoder> make_encoder(const fs::path& path, const PictureSpec& spec) {
  switch (spec.type) {
    case FileType::png:
      if (spec.bits != 32) return make_png_encoder(path, spec);
      break;
    case FileType::targa:
    case FileType::compressed_targa: return make_targa_encoder(path, spec);
    case FileType::ppm: return make_ppm_encoder(path, spec);
    case FileType::bmp: return make_bmp_encoder(path, spec);
    case FileType::radiance: return make_radiance_encoder(path, spec);
    case FileType::tiff:
    case FileType::exr:
    case FileType::jpeg: break;
  }
  return image_module().encoder(path, spec);
}

/// A picture on its way to its place.
class OpenPicture {
 public:
  OpenPicture(const fs::path& path, const PictureSpec& spec)
      : m_path(path), m_height(spec.height), m_swap(path) {
    check_fits(path, spec);
    guard([&] { m_encoder = make_encoder(m_swap.temporary(), spec); });
  }

  void put(const void* samples, std::uint32_t rows) {
    guard([&] { m_encoder->put(samples, rows); });
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

PictureSpec spec_of(std::uint32_t width, std::uint32_t height, const ImageFormat& format,
                    const ImageMetadata& metadata, const fs::path& path, SpareRoom* spare) {
  check_size(width, height, 1, 1, path);
  const StoredAs stored = stored_as(format);
  return {.type = format.type,
          .width = width,
          .height = height,
          .channels = (stored.grey ? 1 : 3) + (stored.alpha ? 1 : 0),
          .bits = stored.bits,
          .levels = stored.levels,
          .half = stored.bits == 32 && format.bits < 32,
          .quality = format.quality,
          .tagged = true,
          .srgb = format.srgb,
          .file_gamma = format.file_gamma,
          .metadata = metadata,
          .spare = spare,
          .count = &count_written};
}

/// In pieces that stay in the processor's cache.
template <class Sample>
void put_samples(const StoredImage& image, OpenPicture& picture) {
  const std::size_t row = std::size_t{image.width} * static_cast<std::size_t>(image.channels);
  std::vector<Sample> piece;
  for (std::uint32_t first = 0; first < image.height; first += kRowsAtATime) {
    const std::uint32_t rows = std::min(kRowsAtATime, image.height - first);
    piece.clear();
    for (std::size_t i = first * row; i < (first + rows) * row; ++i)
      piece.push_back(static_cast<Sample>(image.samples[i]));
    picture.put(piece.data(), rows);
  }
}

}  // namespace

StoredAs stored_as(const ImageFormat& format) {
  const int levels = std::clamp(format.bits, 5, 16);
  const StoredAs fine{levels <= 8 ? 8 : 16, levels, format.alpha, false};
  switch (format.type) {
    case FileType::png: return format.grey ? StoredAs{16, 16, format.alpha, true} : fine;
    case FileType::ppm:
      return format.grey ? StoredAs{16, 16, false, true}
                         : StoredAs{fine.bits, levels, false, false};
    case FileType::tiff:
      if (format.grey) return {16, 16, format.alpha, true};
      return {fine.bits, fine.bits, format.alpha, false};
    case FileType::exr: return {32, 32, format.alpha, false};
    case FileType::targa:
    case FileType::compressed_targa:
    case FileType::bmp: return {8, 8, format.alpha, false};
    case FileType::jpeg:
    case FileType::radiance: break;
  }
  return {};
}

namespace {

struct Extension {
  std::string_view text;
  FileType type;
};
/// The usual one of a type first.
constexpr Extension kExtensions[] = {
    {".png", FileType::png},  {".tif", FileType::tiff},    {".tiff", FileType::tiff},
    {".exr", FileType::exr},  {".tga", FileType::targa},   {".tga", FileType::compressed_targa},
    {".jpg", FileType::jpeg}, {".jpeg", FileType::jpeg},   {".ppm", FileType::ppm},
    {".bmp", FileType::bmp},  {".hdr", FileType::radiance}};

}  // namespace

FileType file_type_of(const fs::path& path) {
  const std::string extension = lower_case(path.extension().string());
  std::string known;
  for (const Extension& row : kExtensions) {
    if (extension == row.text) return row.type;
    if (row.type != FileType::compressed_targa)
      known += (known.empty() ? "" : ", ") + std::string(row.text);
  }
  throw ImageError("cannot write '" + path.string() + "': unknown kind of picture '" + extension +
                   "'; there are " + known);
}

std::string extension_of(FileType type) {
  const auto* row = std::find_if(std::begin(kExtensions), std::end(kExtensions),
                                 [&](const Extension& e) { return e.type == type; });
  return std::string(row->text);
}

void check_fits(const fs::path& path, const ImageFormat& format, std::uint32_t width,
                std::uint32_t height) {
  check_fits(path, spec_of(width, height, format, {}, path, nullptr));
}

struct PictureWriter::Parts {
  const std::uint32_t width;
  SampleRows samples;
  OpenPicture picture;
};

PictureWriter::PictureWriter(const fs::path& path, std::uint32_t width, std::uint32_t height,
                             const ImageFormat& format, const ImageMetadata& metadata,
                             SpareRoom* spare)
    : m_parts(new Parts{width, SampleRows(format, width),
                        OpenPicture(path, spec_of(width, height, format, metadata, path, spare))}) {
}

PictureWriter::~PictureWriter() = default;

void PictureWriter::put(const Image& band) {
  Parts& p = *m_parts;
  if (band.width != p.width) p.picture.fail("a band has another width");
  if (band.rgba.size() != std::size_t{4} * band.width * band.height)
    p.picture.fail("a band has pixels too few or too many");
  for (std::uint32_t first = 0; first < band.height; first += kRowsAtATime) {
    const std::uint32_t rows = std::min(kRowsAtATime, band.height - first);
    p.picture.put(p.samples.next(band, first, rows), rows);
  }
}

void PictureWriter::finish() { m_parts->picture.finish(); }

void write_stored(const StoredImage& image, const fs::path& path) {
  check_size(image.width, image.height, image.samples.size(),
             std::size_t{image.width} * image.height * image.channels, path);
  const FileType type = file_type_of(path);
  const bool floats = type == FileType::exr || image.bits == 32;
  if (type != FileType::png && type != FileType::tiff && type != FileType::exr) {
    throw ImageError("cannot write '" + path.string() +
                     "' as it is stored: there are .png, .tif, .exr");
  }
  write_stored(image, path,
               {.type = type,
                .width = image.width,
                .height = image.height,
                .channels = image.channels,
                .bits = floats ? 32 : image.bits});
}

void write_stored(const StoredImage& image, const fs::path& path, const PictureSpec& spec) {
  OpenPicture picture(path, spec);
  if (spec.bits == 32) {
    put_samples<float>(image, picture);
  } else if (spec.bits == 8) {
    put_samples<std::uint8_t>(image, picture);
  } else {
    put_samples<std::uint16_t>(image, picture);
  }
  picture.finish();
}

}  // namespace lentray::core
