#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "core/base/owned.h"
#include "core/image/writer.h"
#include "tools/lentray-views/moving.h"
#include "tools/lentray-views/picture.h"

namespace lentray::views {
namespace {

using core::StoredImage;

constexpr int kBits = 5, kColours = 256;  // a channel of the table of colours
constexpr std::size_t kCells = std::size_t{1} << (3 * kBits);

using Colour = std::array<std::uint8_t, 3>;

/// Red, green and blue of 8 bits, pixel after pixel.
std::vector<Colour> colours_of(const StoredImage& image) {
  const StoredImage frame = for_viewers(image);
  std::vector<Colour> out(std::size_t{frame.width} * frame.height);
  for (std::size_t i = 0; i < out.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t channel = frame.channels < 3 ? 0 : c;
      out[i][c] = static_cast<std::uint8_t>(
          frame.samples[i * static_cast<std::size_t>(frame.channels) + channel]);
    }
  }
  return out;
}

std::size_t cell_of(const Colour& colour) {
  return std::size_t{colour[0]} >> 3 << 10 | std::size_t{colour[1]} >> 3 << 5 | colour[2] >> 3;
}

/// A box of cells of colours, and how many pixels have them: median cut.
struct Box {
  std::vector<std::size_t> cells;
  std::uint64_t pixels = 0;
  int axis = 0;    ///< the channel that it is longest along
  int length = 0;  ///< in cells
};

int part_of(std::size_t cell, int axis) {
  return static_cast<int>(cell >> (kBits * (2 - axis)) & 31u);
}

Box box_of(std::vector<std::size_t> cells, const std::vector<std::uint64_t>& pixels) {
  Box out{std::move(cells), 0, 0, -1};
  for (const std::size_t cell : out.cells) out.pixels += pixels[cell];
  for (int axis = 0; axis < 3; ++axis) {
    int low = 31, high = 0;
    for (const std::size_t cell : out.cells) {
      low = std::min(low, part_of(cell, axis));
      high = std::max(high, part_of(cell, axis));
    }
    if (high - low > out.length) {
      out.length = high - low;
      out.axis = axis;
    }
  }
  return out;
}

/// Along its longest side, so that each half has about as many pixels.
void split(std::vector<Box>& boxes, std::size_t which, const std::vector<std::uint64_t>& pixels) {
  Box box = std::move(boxes[which]);
  std::ranges::sort(box.cells, {}, [&](std::size_t cell) { return part_of(cell, box.axis); });
  std::uint64_t before = 0;
  std::size_t at = 0;
  while (at + 1 < box.cells.size() && (at == 0 || before + pixels[box.cells[at]] <= box.pixels / 2))
    before += pixels[box.cells[at++]];
  const auto middle = box.cells.begin() + static_cast<std::ptrdiff_t>(at);
  boxes[which] = box_of({box.cells.begin(), middle}, pixels);
  boxes.push_back(box_of({middle, box.cells.end()}, pixels));
}

/// The colours of all frames in at most 256.
class ColourTable {
 public:
  explicit ColourTable(const std::vector<std::vector<Colour>>& frames) : m_pixels(kCells) {
    std::vector<std::array<std::uint64_t, 3>> sums(kCells);
    for (const auto& frame : frames) {
      for (const Colour& colour : frame) {
        const std::size_t cell = cell_of(colour);
        ++m_pixels[cell];
        for (std::size_t c = 0; c < 3; ++c) sums[cell][c] += colour[c];
      }
    }
    for (const Box& box : boxes()) {
      std::array<std::uint64_t, 3> sum{};
      for (const std::size_t cell : box.cells) {
        for (std::size_t c = 0; c < 3; ++c) sum[c] += sums[cell][c];
      }
      m_colours.push_back({});
      for (std::size_t c = 0; c < 3; ++c) {
        m_colours.back()[c] = static_cast<std::uint8_t>((sum[c] + box.pixels / 2) / box.pixels);
      }
    }
    m_nearest.assign(kCells, -1);
  }

  const std::vector<Colour>& colours() const { return m_colours; }

  /// The same for all colours of a cell.
  std::uint8_t entry(const Colour& colour) {
    int& found = m_nearest[cell_of(colour)];
    if (found >= 0) return static_cast<std::uint8_t>(found);
    int least = std::numeric_limits<int>::max();
    for (std::size_t i = 0; i < m_colours.size(); ++i) {
      int distance = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        const int middle = (colour[c] & 0xf8) + 4, off = middle - m_colours[i][c];
        distance += off * off;
      }
      if (distance >= least) continue;
      least = distance;
      found = static_cast<int>(i);
    }
    return static_cast<std::uint8_t>(found);
  }

 private:
  std::vector<Box> boxes() const {
    std::vector<std::size_t> used;
    for (std::size_t cell = 0; cell < kCells; ++cell) {
      if (m_pixels[cell] > 0) used.push_back(cell);
    }
    std::vector<Box> out{box_of(std::move(used), m_pixels)};
    while (out.size() < kColours) {
      const auto longest = std::ranges::max_element(out, {}, [](const Box& box) {
        return static_cast<std::uint64_t>(box.length) * box.pixels;
      });
      if (longest->length == 0) break;
      split(out, static_cast<std::size_t>(longest - out.begin()), m_pixels);
    }
    return out;
  }

  std::vector<std::uint64_t> m_pixels;  ///< by cell
  std::vector<Colour> m_colours;
  std::vector<int> m_nearest;  ///< by cell: an entry, or -1
};

int append(GifFileType* gif, const GifByteType* bytes, int size) {
  static_cast<std::string*>(gif->UserData)
      ->append(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
  return size;
}

void close_gif(GifFileType* gif) { EGifCloseFile(gif, nullptr); }

void gif_check(int result) {
  if (result != GIF_OK) throw core::ImageError("a frame of the GIF could not be packed");
}

void put_loop(GifFileType* gif) {
  constexpr GifByteType kForEver[] = {1, 0, 0};
  gif_check(EGifPutExtensionLeader(gif, APPLICATION_EXT_FUNC_CODE));
  gif_check(EGifPutExtensionBlock(gif, 11, "NETSCAPE2.0"));
  gif_check(EGifPutExtensionBlock(gif, sizeof kForEver, kForEver));
  gif_check(EGifPutExtensionTrailer(gif));
}

}  // namespace

std::string gif_of(const std::vector<StoredImage>& images, int delay) {
  constexpr std::uint32_t kMostSide = 65535;
  const auto width = static_cast<int>(images[0].width), height = static_cast<int>(images[0].height);
  if (std::max(images[0].width, images[0].height) > kMostSide) {
    throw core::ImageError("a GIF is 65535 pixels wide and high at most");
  }
  std::vector<std::vector<Colour>> frames;
  for (const StoredImage& image : images) frames.push_back(colours_of(image));
  ColourTable table(frames);
  std::vector<GifColorType> entries(kColours);
  for (std::size_t i = 0; i < table.colours().size(); ++i) {
    const Colour& c = table.colours()[i];
    entries[i] = {c[0], c[1], c[2]};
  }
  std::string out;
  const core::Owned<ColorMapObject, GifFreeMapObject> map(
      GifMakeMapObject(kColours, entries.data()));
  core::Owned<GifFileType, close_gif> gif(EGifOpen(&out, append, nullptr));
  if (!map || !gif) throw core::ImageError("there is not enough memory for the GIF");
  EGifSetGifVersion(gif.get(), true);
  gif_check(EGifPutScreenDesc(gif.get(), width, height, 8, 0, map.get()));
  put_loop(gif.get());
  for (const auto& frame : frames) {
    GraphicsControlBlock control{DISPOSE_DO_NOT, false, std::max(2, (delay + 5) / 10),
                                 NO_TRANSPARENT_COLOR};
    GifByteType bytes[4];
    EGifGCBToExtension(&control, bytes);
    gif_check(EGifPutExtension(gif.get(), GRAPHICS_EXT_FUNC_CODE, sizeof bytes, bytes));
    gif_check(EGifPutImageDesc(gif.get(), 0, 0, width, height, false, nullptr));
    std::vector<GifPixelType> row(images[0].width);
    for (std::size_t y = 0; y < images[0].height; ++y) {
      for (std::size_t x = 0; x < row.size(); ++x) row[x] = table.entry(frame[y * row.size() + x]);
      gif_check(EGifPutLine(gif.get(), row.data(), width));
    }
  }
  gif_check(EGifCloseFile(gif.release(), nullptr));
  return out;
}

}  // namespace lentray::views
