#include <zlib.h>

#include <cstdint>

#include "core/image/writer.h"
#include "tools/lentray-views/moving.h"
#include "tools/lentray-views/picture.h"

namespace lentray::views {
namespace {

using core::StoredImage;

/// Numbers of PNG files, the highest byte first.
std::string big_bytes(std::uint32_t value, int size = 4) {
  std::string out;
  for (int i = size - 1; i >= 0; --i) out += static_cast<char>(value >> (8 * i) & 0xffu);
  return out;
}

std::string chunk(const std::string& type, const std::string& data) {
  const std::string body = type + data;
  const auto sum =
      crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
  return big_bytes(static_cast<std::uint32_t>(data.size())) + body +
         big_bytes(static_cast<std::uint32_t>(sum));
}

/// All rows, each as the difference from the one above (filter 2), packed.
std::string packed(const StoredImage& frame) {
  const std::size_t count = std::size_t{frame.width} * static_cast<std::size_t>(frame.channels);
  std::string rows;
  for (std::uint32_t y = 0; y < frame.height; ++y) {
    rows += '\2';
    for (std::size_t i = 0; i < count; ++i) {
      const auto here = static_cast<unsigned>(frame.samples[y * count + i]),
                 above = y > 0 ? static_cast<unsigned>(frame.samples[(y - 1) * count + i]) : 0u;
      rows += static_cast<char>(here - above);
    }
  }
  uLongf size = compressBound(static_cast<uLong>(rows.size()));
  std::string out(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(out.data()), &size,
                reinterpret_cast<const Bytef*>(rows.data()), static_cast<uLong>(rows.size()),
                Z_DEFAULT_COMPRESSION) != Z_OK) {
    throw core::ImageError("a frame of the moving picture could not be packed");
  }
  out.resize(size);
  return out;
}

std::string header(const StoredImage& frame) {
  constexpr char kKinds[] = {0, 4, 2, 6};  // by channels: grey, with alpha, colours, with alpha
  return big_bytes(frame.width) + big_bytes(frame.height) + '\x08' + kKinds[frame.channels - 1] +
         std::string(3, '\0');
}

/// Shown for so long over nothing: the frame covers the picture.
std::string frame_control(std::uint32_t sequence, const StoredImage& frame, int delay) {
  return big_bytes(sequence) + big_bytes(frame.width) + big_bytes(frame.height) + big_bytes(0) +
         big_bytes(0) + big_bytes(static_cast<std::uint32_t>(delay), 2) + big_bytes(1000, 2) +
         std::string(2, '\0');
}

/// What a PNG file of such pictures begins with.
std::string beginning(const StoredImage& first) {
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header(first)) + chunk("sRGB", std::string(1, '\0')) +
         chunk("gAMA", big_bytes(45455));
}

}  // namespace

std::string png_of(const StoredImage& image) {
  return beginning(image) + chunk("IDAT", packed(image)) + chunk("IEND", "");
}

std::string apng_of(const std::vector<StoredImage>& frames, int delay) {
  const StoredImage first = for_viewers(frames[0]);
  std::string out =
      beginning(first) +
      chunk("acTL", big_bytes(static_cast<std::uint32_t>(frames.size())) + big_bytes(0));
  std::uint32_t sequence = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const StoredImage frame = for_viewers(frames[i]);
    out += chunk("fcTL", frame_control(sequence++, frame, delay));
    // The first frame is the picture of viewers that know of no others.
    out += i == 0 ? chunk("IDAT", packed(frame))
                  : chunk("fdAT", big_bytes(sequence++) + packed(frame));
  }
  return out + chunk("IEND", "");
}

}  // namespace lentray::views
