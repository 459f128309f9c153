#include "tools/lentray-merge/png_head.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string_view>

#include "core/image/photo_tags.h"
#include "core/image/stream_bytes.h"
#include "core/image/writer.h"

namespace lentray::merge {
namespace {

using core::ImageError;

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n", kRowsText = "lentray:rows";
constexpr std::size_t kHeaderSize = 13, kPhysicalSize = 9;
constexpr std::uint32_t kMostChunk = 1u << 20;  ///< of what lentray writes before the pixels

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& why) {
  throw ImageError("cannot read '" + path.string() + "': " + why);
}

std::uint32_t big(std::string_view bytes) {
  return static_cast<std::uint32_t>(core::big_endian(bytes.substr(0, 4)));
}

const PngHead::Chunk* find(const PngHead& head, std::string_view type) {
  const auto row = std::ranges::find(head.chunks, type, &PngHead::Chunk::type);
  return row == head.chunks.end() ? nullptr : &*row;
}

/// Keyword and text of a tEXt chunk.
std::pair<std::string, std::string> text_of(const std::string& data) {
  const std::size_t end = std::min(data.find('\0'), data.size());
  return {data.substr(0, end), data.substr(std::min(end + 1, data.size()))};
}

/// What the user knows a chunk by.
std::string name_of(const PngHead::Chunk& chunk) {
  if (chunk.type == "tEXt") return "text '" + text_of(chunk.data).first + "'";
  if (chunk.type == "gAMA" || chunk.type == "sRGB") return "gamma";
  if (chunk.type == "pHYs") return "resolution";
  if (chunk.type == "sBIT") return "bits that carry information";
  return "chunk " + chunk.type;
}

std::string size_of(std::string_view header) {
  return std::to_string(big(header)) + " x " + std::to_string(big(header.substr(4)));
}

std::string samples_of(std::string_view header) {
  const char* const kinds[] = {
      "grey", "", "colour", "", "grey with alpha", "", "colour with alpha"};
  const auto kind = static_cast<std::size_t>(header[9]);
  return std::to_string(int{header[8]}) + " bits of " +
         (kind < std::size(kinds) ? kinds[kind] : "palette");
}

/// The next chunk; its pixels' come without data.
PngHead::Chunk next_chunk(std::istream& file, const std::filesystem::path& path) {
  std::array<char, 8> head{};
  if (!file.read(head.data(), head.size())) fail(path, "it ends before the pixels");
  PngHead::Chunk chunk{std::string(head.data() + 4, 4), {}};
  if (chunk.type == "IDAT") return chunk;
  const std::uint32_t length = big({head.data(), 4});
  if (length > kMostChunk) fail(path, "lentray writes no " + chunk.type + " of that size");
  chunk.data.resize(length);
  std::array<char, 4> checksum{};
  if (!file.read(chunk.data.data(), length) || !file.read(checksum.data(), checksum.size())) {
    fail(path, "it ends before the pixels");
  }
  return chunk;
}

}  // namespace

PngHead read_head(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) fail(path, "it is a folder");
  std::ifstream file(path, std::ios::binary);
  if (!file) fail(path, std::strerror(errno));
  std::array<char, 8> signature{};
  if (!file.read(signature.data(), signature.size()) ||
      std::string_view(signature.data(), signature.size()) != kSignature) {
    fail(path, "it is no PNG file, and only these are joined");
  }
  PngHead head;
  for (PngHead::Chunk chunk = next_chunk(file, path); chunk.type != "IDAT";
       chunk = next_chunk(file, path)) {
    if (head.chunks.empty() && (chunk.type != "IHDR" || chunk.data.size() != kHeaderSize)) {
      fail(path, "it has no header");
    }
    const auto [name, text] = text_of(chunk.data);
    if (chunk.type != "tEXt" || name != kRowsText) {
      head.chunks.push_back(std::move(chunk));
      continue;
    }
    try {
      head.rows = rows_of(text);
    } catch (const std::invalid_argument& e) {
      fail(path, "its text lentray:rows: " + std::string(e.what()));
    }
  }
  if (head.chunks.empty()) fail(path, "it has no header");
  return head;
}

core::PictureSpec spec_of(const PngHead& head, const std::filesystem::path& path) {
  constexpr double kWhole = 100000.0, kInch = 0.0254;
  const std::string& header = head.chunks[0].data;
  core::PictureSpec spec{
      .width = big(header), .height = big(std::string_view(header).substr(4)), .bits = header[8]};
  constexpr int kChannels[] = {1, 0, 3, 0, 2, 0, 4};  // by PNG's kind of colour
  const auto kind = static_cast<std::size_t>(header[9]);
  spec.channels = kind < std::size(kChannels) ? kChannels[kind] : 0;
  if (spec.channels == 0 || (spec.bits != 8 && spec.bits != 16) || header[12] != 0) {
    fail(path, "lentray writes no palettes, no " + std::to_string(spec.bits) +
                   " bits and no interlaced rows");
  }
  if (const PngHead::Chunk* gamma = find(head, "gAMA");
      gamma && gamma->data.size() == 4 && big(gamma->data) > 0) {
    spec.tagged = true;
    spec.srgb = find(head, "sRGB") != nullptr;
    spec.file_gamma = kWhole / big(gamma->data);
  }
  if (const PngHead::Chunk* bits = find(head, "sBIT"); bits && !bits->data.empty())
    spec.levels = bits->data[0];
  if (const PngHead::Chunk* dots = find(head, "pHYs"); dots && dots->data.size() == kPhysicalSize) {
    spec.metadata.dpi_x = big(dots->data) * kInch;
    spec.metadata.dpi_y = big(std::string_view(dots->data).substr(4)) * kInch;
  }
  if (find(head, "eXIf")) spec.metadata.orientation = core::photo_tags(path).orientation;
  for (const PngHead::Chunk& chunk : head.chunks) {
    if (chunk.type == "tEXt") spec.metadata.fields.push_back(text_of(chunk.data));
  }
  return spec;
}

std::string difference(const PngHead& a, const PngHead& b) {
  const std::string &of_a = a.chunks[0].data, &of_b = b.chunks[0].data;
  if (of_a.substr(0, 8) != of_b.substr(0, 8))
    return "size: " + size_of(of_a) + " and " + size_of(of_b);
  if (of_a != of_b) return "samples: " + samples_of(of_a) + " and " + samples_of(of_b);
  for (std::size_t i = 0; i < std::max(a.chunks.size(), b.chunks.size()); ++i) {
    if (i >= a.chunks.size()) return name_of(b.chunks[i]);
    if (i >= b.chunks.size() || !(a.chunks[i] == b.chunks[i])) return name_of(a.chunks[i]);
  }
  return {};
}

}  // namespace lentray::merge
