// The module's one entry, and reading.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/image/image_module.h"
#include "core/image/openimageio/encoder.h"

namespace lentray::core {
namespace {

/// Whether a TARGA file has five bits a colour, in its pixels or its palette.
bool has_five_bits(const std::filesystem::path& path) {
  std::array<unsigned char, 18> head{};
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(head.data()), static_cast<std::streamsize>(head.size()));
  const int bits = head[1] == 1 && head[16] == 8 ? head[7] : head[16];
  return bits == 15 || bits == 16;
}

/// As stock: the five bits are the upper ones of eight, the others 0.
void drop_low_bits(StoredImage& image) {
  const int channels = image.channels;
  for (std::size_t i = 0; i < image.samples.size(); ++i) {
    if (channels >= 3 && static_cast<int>(i % static_cast<std::size_t>(channels)) == 3) continue;
    image.samples[i] = static_cast<float>(static_cast<int>(image.samples[i]) & 0xf8);
  }
}

/// Radiance's mantissas of 8 bits stand for the middles of their steps, as in Radiance itself and in stock. The largest
/// of the three has its upper bit set, so that it tells the step.
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
  const char* extensions;   ///< each between blanks
};

/// The formats of scenes, those that are known by their first bytes first.
constexpr std::array kPlainFormats = {
    PlainFormat{"png", " .png "}, PlainFormat{"jpeg", " .jpg .jpeg "}, PlainFormat{"tiff", " .tif .tiff "},
    PlainFormat{"openexr", " .exr "}, PlainFormat{"hdr", " .hdr .rgbe "}, PlainFormat{"bmp", " .bmp "},
    PlainFormat{"gif", " .gif "}, PlainFormat{"pnm", " .ppm .pgm .pbm .pnm "}, PlainFormat{"targa", " .tga "}};

/// A handle says nothing of the format: the file's name does, else its bytes do. OpenImageIO is never told
/// the name, which it would open.
Input open_handle(const std::filesystem::path& path, const std::filesystem::path& named,
                  const OIIO::ImageSpec& as_stored) {
  std::string extension = " " + named.extension().string() + " ";
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const bool is_likely : {true, false}) {
    for (const PlainFormat& format : kPlainFormats) {
      const bool fits = std::string_view(format.extensions).find(extension) != std::string_view::npos;
      if (fits != is_likely) continue;
      Input input = OIIO::ImageInput::create(format.name);
      OIIO::ImageSpec spec;
      if (input && input->open(path.string(), spec, as_stored)) return input;
    }
  }
  throw std::runtime_error("it is no picture in a format of scenes");
}

/// `named`: see ImageModule::read(). `memory`: in place of the file.
StoredImage read_picture(const std::filesystem::path& path, const std::filesystem::path& named,
                         OIIO::Filesystem::IOProxy* memory = nullptr) {
  OIIO::ImageSpec as_stored;
  as_stored.attribute("oiio:UnassociatedAlpha", 1);
  if (memory) as_stored.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &memory);
  const Input input = named.empty() ? OIIO::ImageInput::open(path.string(), &as_stored)
                                    : open_handle(path, named, as_stored);
  if (!input) throw std::runtime_error(OIIO::geterror());
  const OIIO::ImageSpec& spec = input->spec();
  StoredImage image;
  image.width = static_cast<std::uint32_t>(spec.width);
  image.height = static_cast<std::uint32_t>(spec.height);
  image.channels = spec.nchannels;
  image.bits = spec.format == OIIO::TypeDesc::UINT8    ? 8
               : spec.format == OIIO::TypeDesc::UINT16 ? 16
                                                       : 32;
  image.samples.resize(std::size_t{image.width} * image.height * image.channels);
  bool read = false;
  const auto read_integers = [&](auto sample, OIIO::TypeDesc type) {
    std::vector<decltype(sample)> values(image.samples.size());
    read = input->read_image(0, 0, 0, spec.nchannels, type, values.data());
    image.samples.assign(values.begin(), values.end());
  };
  if (image.bits == 8) {
    read_integers(std::uint8_t{}, OIIO::TypeDesc::UINT8);
  } else if (image.bits == 16) {
    read_integers(std::uint16_t{}, OIIO::TypeDesc::UINT16);
  } else {
    read = input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, image.samples.data());
  }
  if (!read) throw std::runtime_error(input->geterror());
  if (image.bits == 8 && std::string(input->format_name()) == "targa" && has_five_bits(path)) {
    drop_low_bits(image);
  }
  if (image.channels == 3 && std::string(input->format_name()) == "hdr") lift_to_middles(image);
  for (const OIIO::ParamValue& value : spec.extra_attribs) {
    image.attributes[value.name().string()] = value.get_string();
  }
  return image;
}

class Module final : public ImageModule {
 public:
  // Threads are the frame's (+WT): none of OpenImageIO's own.
  Module() {
    OIIO::attribute("threads", 1);
    OIIO::attribute("exr_threads", -1);
  }
  std::unique_ptr<PictureEncoder> encoder(const std::filesystem::path& path,
                                          const PictureSpec& spec) const override {
    return make_openimageio_encoder(path, spec);
  }
  StoredImage read(const std::filesystem::path& path, const std::filesystem::path& named) const override {
    return read_picture(path, named);
  }
  StoredImage read_tiff(const std::string& file) const override {
    OIIO::Filesystem::IOMemReader memory(file.data(), file.size());
    return read_picture("memory.tif", {}, &memory);
  }
};

}  // namespace
}  // namespace lentray::core

extern "C" __attribute__((visibility("default"))) const lentray::core::ImageModule*
lentray_image_module() {
  static const lentray::core::Module module;
  return &module;
}
