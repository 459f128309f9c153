// The module's one entry, and reading.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/base/lower_case.h"
#include "core/image/image_module.h"
#include "core/image/openimageio/encoder.h"

namespace lentray::core {
namespace {

/// Radiance's mantissas of 8 bits stand for the middles of their steps, as in Radiance itself and in stock. The largest
/// of the three has its upper bit set, so that it identifies the step.
void lift_to_middles(StoredImage& image) {
  for (std::size_t i = 0; i + 2 < image.samples.size(); i += 3) {
    const float largest = std::max({image.samples[i], image.samples[i + 1], image.samples[i + 2]});
    if (largest <= 0.0f) continue;
    const float half_step = std::ldexp(0.5f, std::ilogb(largest) - 7);
    for (std::size_t c = i; c < i + 3; ++c) image.samples[c] += half_step;
  }
}

using Input = std::unique_ptr<OIIO::ImageInput>;

struct PlainFormat {
  const char* name;
  const char* extensions;  ///< each between blanks
};

/// The formats of scenes that are not read without OpenImageIO, those that are known by their first bytes first.
/// JPEG: of four colours. OpenImageIO knows others, some of which are lists of further files to open.
constexpr std::array kPlainFormats = {
    PlainFormat{"jpeg", " .jpg .jpeg "}, PlainFormat{"tiff", " .tif .tiff "},
    PlainFormat{"openexr", " .exr "},    PlainFormat{"hdr", " .hdr .rgbe "},
    PlainFormat{"bmp", " .bmp "},        PlainFormat{"pnm", " .ppm .pgm .pbm .pnm "}};

/// The file's name says what it is likely to be, its bytes what it is. OpenImageIO is never told the name, which
/// it would open.
Input open_file(const std::filesystem::path& path, const std::filesystem::path& named,
                const OIIO::ImageSpec& as_stored) {
  const std::string extension = lower_case(" " + named.extension().string() + " ");
  for (const bool is_likely : {true, false}) {
    for (const PlainFormat& format : kPlainFormats) {
      const bool fits =
          std::string_view(format.extensions).find(extension) != std::string_view::npos;
      if (fits != is_likely) continue;
      Input input = OIIO::ImageInput::create(format.name);
      OIIO::ImageSpec spec;
      if (input && input->open(path.string(), spec, as_stored)) return input;
    }
  }
  throw std::runtime_error("it is no picture in a format of scenes");
}

/// OpenImageIO holds as many besides the picture, which may be wide and low.
constexpr int kRowsAtOnce = 16;

template <typename Value>
bool read_samples(OIIO::ImageInput& input, OIIO::TypeDesc type, CheckPictureRoom check_room,
                  StoredImage& image) {
  check_room(image.width, std::uint64_t{image.height} + kRowsAtOnce, image.channels, sizeof(Value));
  const std::size_t count =
      std::size_t{image.width} * image.height * static_cast<std::size_t>(image.channels);
  return input.read_image(0, 0, 0, image.channels, type, image.samples.store<Value>(count).data());
}

StoredImage read_picture(const Input& input, CheckPictureRoom check_room) {
  const OIIO::ImageSpec& spec = input->spec();
  StoredImage image;
  image.width = static_cast<std::uint32_t>(spec.width);
  image.height = static_cast<std::uint32_t>(spec.height);
  image.channels = spec.nchannels;
  image.bits = spec.format == OIIO::TypeDesc::UINT8    ? 8
               : spec.format == OIIO::TypeDesc::UINT16 ? 16
                                                       : 32;
  const auto read_all = [&](auto sample, OIIO::TypeDesc type) {
    return read_samples<decltype(sample)>(*input, type, check_room, image);
  };
  const bool is_read = image.bits == 8    ? read_all(std::uint8_t{}, OIIO::TypeDesc::UINT8)
                       : image.bits == 16 ? read_all(std::uint16_t{}, OIIO::TypeDesc::UINT16)
                                          : read_all(0.0f, OIIO::TypeDesc::FLOAT);
  if (!is_read) throw std::runtime_error(input->geterror());
  if (image.channels == 3 && std::string(input->format_name()) == "hdr") lift_to_middles(image);
  for (const OIIO::ParamValue& value : spec.extra_attribs) {
    image.attributes[value.name().string()] = value.get_string();
  }
  return image;
}

OIIO::ImageSpec as_stored() {
  OIIO::ImageSpec spec;
  spec.attribute("oiio:UnassociatedAlpha", 1);
  return spec;
}

class Module final : public ImageModule {
 public:
  // Threads are the frame's (+WT): none of OpenImageIO's own.
  Module() {
    OIIO::attribute("threads", 1);
    OIIO::attribute("exr_threads", -1);
    OIIO::attribute("read_chunk", kRowsAtOnce);
  }
  std::unique_ptr<PictureEncoder> encoder(const std::filesystem::path& path,
                                          const PictureSpec& spec) const override {
    return make_openimageio_encoder(path, spec);
  }
  StoredImage read(const std::filesystem::path& path, const std::filesystem::path& named,
                   CheckPictureRoom check_room) const override {
    return read_picture(open_file(path, named, as_stored()), check_room);
  }
  StoredImage read_tiff(const std::string& file, CheckPictureRoom check_room) const override {
    OIIO::Filesystem::IOMemReader memory(file.data(), file.size());
    OIIO::Filesystem::IOProxy* proxy = &memory;
    OIIO::ImageSpec from_memory = as_stored();
    from_memory.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    const Input input = OIIO::ImageInput::open("memory.tif", &from_memory);
    if (!input) throw std::runtime_error(OIIO::geterror());
    return read_picture(input, check_room);
  }
};

}  // namespace
}  // namespace lentray::core

extern "C" __attribute__((visibility("default"))) const lentray::core::ImageModule*
lentray_image_module() {
  static const lentray::core::Module module;
  return &module;
}
