#include "core/image/openimageio/encoder.h"

#include <OpenImageIO/imageio.h>

#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/image/openimageio/checked_file.h"

namespace lentray::core {
namespace {

const char* plugin_name(FileType type) {
  switch (type) {
    case FileType::png: return "png";
    case FileType::tiff: return "tiff";
    case FileType::exr: return "openexr";
    case FileType::jpeg: return "jpeg";
    case FileType::targa:
    case FileType::compressed_targa: return "targa";
    case FileType::ppm: return "pnm";
    case FileType::bmp: return "bmp";
    case FileType::radiance: break;
  }
  return "hdr";
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
  const bool has_lines = type == FileType::tiff || type == FileType::jpeg;
  const std::string description = has_lines ? field_lines(metadata) : metadata.description;
  if (!description.empty()) spec.attribute("ImageDescription", description);
  if (!has_lines) {
    for (const auto& [name, value] : metadata.fields) spec.attribute(name, value);
  }
  if (metadata.orientation != 1) spec.attribute("Orientation", metadata.orientation);
  if (metadata.dpi_x > 0.0 && metadata.dpi_y > 0.0) {
    spec.attribute("XResolution", static_cast<float>(metadata.dpi_x));
    spec.attribute("YResolution", static_cast<float>(metadata.dpi_y));
    spec.attribute("ResolutionUnit", "in");
    spec.attribute("PixelAspectRatio", static_cast<float>(metadata.dpi_y / metadata.dpi_x));
  }
}

void put_colour_space(OIIO::ImageSpec& spec, const PictureSpec& picture) {
  spec.attribute("oiio:UnassociatedAlpha", 1);
  // In TIFF it would become an Exif directory, for which OpenImageIO reads back what it writes
  // through a proxy, and cannot.
  if (picture.tagged && picture.type == FileType::exr) {
    spec.attribute("oiio:ColorSpace", "Linear");
  }
}

/// Of the samples in memory.
OIIO::TypeDesc sample_type(const PictureSpec& picture) {
  if (picture.bits == 32) return OIIO::TypeDesc::FLOAT;
  return picture.bits == 8 ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::UINT16;
}

OIIO::ImageSpec spec_of(const PictureSpec& picture) {
  OIIO::ImageSpec spec(static_cast<int>(picture.width), static_cast<int>(picture.height),
                       picture.channels,
                       picture.half ? OIIO::TypeDesc(OIIO::TypeDesc::HALF) : sample_type(picture));
  if (picture.type == FileType::jpeg) {
    spec.attribute("Compression", "jpeg:" + std::to_string(picture.quality));
    spec.attribute("jpeg:subsampling", "4:4:4");
  }
  put_colour_space(spec, picture);
  put_metadata(spec, picture.type, picture.metadata);
  if (const std::string& profile = picture.metadata.profile; !profile.empty()) {
    spec.attribute("ICCProfile",
                   OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(profile.size())),
                   profile.data());
  }
  return spec;
}

class Encoder final : public PictureEncoder {
 public:
  Encoder(const std::filesystem::path& path, const PictureSpec& picture)
      : m_file(path, picture.spare, picture.count), m_spec(spec_of(picture)),
        m_samples(sample_type(picture)) {
    m_output = OIIO::ImageOutput::create(plugin_name(picture.type));
    if (!m_output) throw std::runtime_error(OIIO::geterror());
    m_output->set_ioproxy(&m_file);
    check(m_output->open(path.string(), m_spec));
  }

  ~Encoder() override {
    // Given up half way. Closing or destroying the encoder would complain on standard error, so the process keeps
    // it to its end.
    static auto& given_up = *new std::vector<std::unique_ptr<OIIO::ImageOutput>>;
    static std::mutex mutex;
    if (!m_output) return;
    const std::lock_guard lock(mutex);
    given_up.push_back(std::move(m_output));
  }

  void put(const void* samples, std::uint32_t rows) override {
    const int first = static_cast<int>(m_next), end = static_cast<int>(m_next + rows);
    check(m_output->write_scanlines(first, end, 0, m_samples, samples));
    m_next += rows;
  }

  void close() override {
    check(m_output->close());
    m_output.reset();
    m_file.close();
    check(true);
  }

 private:
  /// The file's own complaint says more than the encoder's, which may not even notice.
  void check(bool done) {
    if (!m_file.complaint().empty()) throw std::runtime_error(m_file.complaint());
    if (!done) throw std::runtime_error(m_output->geterror());
  }

  CheckedFile m_file;
  const OIIO::ImageSpec m_spec;
  const OIIO::TypeDesc m_samples;
  std::unique_ptr<OIIO::ImageOutput> m_output;
  std::uint32_t m_next = 0;
};

}  // namespace

std::unique_ptr<PictureEncoder> make_openimageio_encoder(const std::filesystem::path& path,
                                                         const PictureSpec& spec) {
  return std::make_unique<Encoder>(path, spec);
}

}  // namespace lentray::core
