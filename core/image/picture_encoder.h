// One kind of file on its way to disk, in the file's own samples. PNG is written by libpng at
// once, and what is little more than rows of bytes (Targa, PPM, BMP, Radiance) here; the other
// kinds by OpenImageIO, which is loaded when it is needed first: its libraries take longer to
// start than a small picture takes to render.
// Errors: std::runtime_error with the reason alone. One thread at a time.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "core/image/writer.h"
#include "core/image/written_bytes.h"

namespace lentray::core {

struct PictureSpec {
  FileType type = FileType::png;
  std::uint32_t width = 0, height = 0;
  int channels = 3;     ///< 1 grey, 2 with alpha, 3 RGB, 4 RGBA; alpha not premultiplied
  int bits = 8;         ///< 8 or 16: integers; 32: float
  int levels = 0;       ///< bits that carry information; 0: all
  bool half = false;    ///< OpenEXR keeps 16 of the float's bits
  int quality = 85;     ///< of JPEG
  bool tagged = false;  ///< what follows is known and goes into the file
  bool srgb = true;
  double file_gamma = 1.0;  ///< unless srgb
  ImageMetadata metadata{};
  SpareRoom* spare = nullptr;  ///< that gives way to the file; null: there is none
  CountBytes count = nullptr;  ///< is asked before bytes are written
};

class PictureEncoder {
 public:
  virtual ~PictureEncoder() = default;  ///< without close() the file is left as it is
  /// The next rows from the top, samples side by side as the spec says.
  virtual void put(const void* samples, std::uint32_t rows) = 0;
  /// All rows are there: the file is complete and closed.
  virtual void close() = 0;
};

using MakeEncoder = std::unique_ptr<PictureEncoder>(const std::filesystem::path& path,
                                                    const PictureSpec& spec);
template <class Encoder>
std::unique_ptr<PictureEncoder> encoder_of(const std::filesystem::path& path,
                                           const PictureSpec& spec) {
  return std::make_unique<Encoder>(path, spec);
}
extern MakeEncoder *const make_png_encoder, *const make_targa_encoder, *const make_ppm_encoder,
                                                                           *const make_bmp_encoder;
/// Samples are Radiance's four bytes a pixel.
extern MakeEncoder* const make_radiance_encoder;

}  // namespace lentray::core
