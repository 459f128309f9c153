// Pictures to files: POV-Ray's output types, and TIFF; which library writes which is told in
// core/image/picture_encoder.h.
//
// Units: the picture holds light in its working space; integer files hold clip(floor(v * max + 0.5))
// of the encoded value, and alpha by which it is not multiplied; OpenEXR and Radiance hold linear
// light, premultiplied. Files without alpha hold colours over black. dpi is pixels an inch.
// Errors: ImageError, with the path and the reason; the file that stood at the path before is
// then still whole, for a picture is written beside its place and renamed. The path "-" is
// standard output, which gets the picture when it is whole.
// Threads: any number, on different paths. Source: measured on stock, tests/unit/image/*
// and tests/image/file_types_test.cpp.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/image/image.h"
#include "core/image/spare_room.h"

namespace lentray::core {

class ImageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum class FileType { png, tiff, exr, targa, compressed_targa, jpeg, ppm, bmp, radiance };

/// Light of any strength, where others end at 1.
constexpr bool holds_any_light(FileType type) {
  return type == FileType::exr || type == FileType::radiance;
}

/// Dither_Method: B2, B3, B4; D1, D2; FS.
enum class DitherMethod { none, bayer2, bayer3, bayer4, line, plane, floyd_steinberg };

struct ImageFormat {
  FileType type = FileType::png;
  int bits = 8;      ///< a channel, 5 to 16: PNG and PPM as they are, TIFF 8 or 16, OpenEXR half;
                     ///< 32: OpenEXR float. The other types have 8
  bool srgb = true;  ///< File_Gamma=sRGB, the default
  double file_gamma = 1.0;     ///< power law, used unless srgb; 1 stores linear values
  double working_gamma = 1.0;  ///< the picture's own gamma (assumed_gamma if rendered in it)
  bool working_srgb = false;   ///< the picture holds sRGB-encoded values (instead)
  bool alpha = false;          ///< store the alpha channel, in types that have one
  bool grey = false;           ///< of 16 bits, in PNG, PPM and TIFF
  DitherMethod dither = DitherMethod::none;  ///< not of JPEG and OpenEXR
  int quality = 85;                          ///< of JPEG, 2 to 100
};

struct ImageMetadata {
  double dpi_x = 0.0, dpi_y = 0.0;  ///< 0: unknown, nothing is stored
  std::string software, description;
  /// Name and value of what is to be found in the file later, such as "lentray:lens_pitch".
  /// PNG: text chunks; OpenEXR: attributes; TIFF: lines "name=value" of the description.
  std::vector<std::pair<std::string, std::string>> fields;
  /// 1 to 8: where the stored rows and columns begin to the eye (core/image/orientation.h). PNG, TIFF, JPEG, OpenEXR.
  int orientation = 1;
  /// An ICC profile, which says alone what colours the samples are of. PNG, TIFF and JPEG.
  std::string profile{};
};

/// What a file of that format holds.
struct StoredAs {
  int bits = 8;    ///< a channel takes: 8 or 16, 32 for float
  int levels = 8;  ///< bits that carry information: what is stored has 2^levels values
  bool alpha = false, grey = false;
};
StoredAs stored_as(const ImageFormat& format);

/// By the extension, letter case ignored. Throws ImageError that lists what there is.
FileType file_type_of(const std::filesystem::path& path);

/// With its dot: ".png".
std::string extension_of(FileType type);

/// Throws ImageError if a picture of that size could not be put there: no folder, no
/// permission, a folder of that name, or a size of 0. To be asked before rendering.
void check_writable(const std::filesystem::path& path);
/// What check_writable() says of it; empty: nothing.
std::string why_not_writable(const std::filesystem::path& path);

/// Throws ImageError if a file of that format holds no picture of that size: JPEG and Targa have a limit for each
/// side, BMP for the bytes of all. To be asked before rendering.
void check_fits(const std::filesystem::path& path, const ImageFormat& format, std::uint32_t width,
                std::uint32_t height);

/// A picture that comes in bands of rows, from the top. Little more than a band is in memory.
/// Destroyed before finish() it leaves nothing behind. One call at a time, from any thread.
class PictureWriter {
 public:
  /// `spare`, or null, is given up where the picture would find no room otherwise.
  PictureWriter(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
                const ImageFormat& format, const ImageMetadata& metadata = {},
                SpareRoom* spare = nullptr);
  ~PictureWriter();
  void put(const Image& band);
  /// The picture is in its place. Throws if rows are missing.
  void finish();

 private:
  struct Parts;
  std::unique_ptr<Parts> m_parts;
};

/// A value of the picture as the file's integer: encoded, scaled to 2^bits - 1, rounded, clipped.
/// A NaN becomes 0.
unsigned quantised(float value, const ImageFormat& format);

}  // namespace lentray::core
