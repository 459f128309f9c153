// A picture laid over space: image_map, image_pattern, bump_map and material_map share it.
// Pixels count from the upper left; the picture fills the unit square of x and y, y upwards, or is
// wrapped about the y axis. Immutable.
// Source: reference manual 3.7, "Image Map"; compared with stock by tests/image/pictures_test.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/color.h"
#include "core/base/vec3.h"
#include "core/material/normals.h"
#include "core/material/pigment.h"
#include "core/material/textures.h"
#include "core/pattern/pattern.h"
#include "core/pattern/placement.h"

namespace lentray::core {

/// A picture's colours in the scene's working space.
class Picture {
 public:
  /// Pixels count along rows, row 0 on top.
  Picture(int width, int height, std::vector<Colour> pixels);
  /// By palette: `entries` of the pixels.
  Picture(int width, int height, std::vector<std::uint8_t> entries,
          const std::array<Colour, 256>& palette);
  /// `samples` as in the file: 1 to 4 channels, grey or RGB, with alpha last. `values`: what each sample of a colour
  /// stands for; alpha is linear from 0 to the last.
  Picture(int width, int height, int channels, std::vector<std::uint8_t> samples,
          std::vector<float> values);
  Picture(int width, int height, int channels, std::vector<std::uint16_t> samples,
          std::vector<float> values);

  int width() const { return m_width; }
  int height() const { return m_height; }
  std::size_t pixels() const {
    return static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_height);
  }
  Colour colour(std::size_t pixel) const;
  bool has_palette() const { return !m_entries.empty(); }
  int entry(std::size_t pixel) const { return m_entries[pixel]; }
  bool has_alpha() const { return m_has_alpha; }
  void set_alpha(bool has_alpha) { m_has_alpha = has_alpha; }
  /// Whether all pixels are as clear as each other: samples without an alpha channel.
  bool is_evenly_clear() const { return m_colours.empty() && m_channels % 2 == 1; }

  std::size_t bytes() const;

  /// filter and transmit that a scene gives to all: entries of a palette are set, others added to.
  void clear_all(std::optional<double> filter, std::optional<double> transmit);
  /// To one entry of the palette.
  void set_filter(int entry, double filter);
  void set_transmit(int entry, double transmit);

 private:
  template <typename Value>
  Colour of_samples(const std::vector<Value>& samples, std::size_t pixel) const;

  int m_width, m_height, m_channels = 0;
  bool m_has_alpha = false;
  std::vector<Colour> m_colours;  ///< of pixels, or of the palette
  std::vector<std::uint8_t> m_entries, m_bytes;
  std::vector<std::uint16_t> m_words;
  std::vector<float> m_values;
  float m_filter = 0.0f, m_transmit = 0.0f;  ///< added to all
};

enum class PictureShape { kPlanar = 0, kSpherical = 1, kCylindrical = 2, kTorus = 5 };
enum class Interpolation { kNone = 0, kBilinear = 2, kBicubic = 3, kNormalizedDistance = 4 };

struct PictureLayout {
  PictureShape shape = PictureShape::kPlanar;
  Interpolation interpolation = Interpolation::kNone;
  bool once = false;
  bool premultiplied =
      false;  ///< colours are by their alpha, of which filter and transmit given for the map are part
  Vec2 repeat{1, 1}, offset;
};

class MappedPicture {
 public:
  MappedPicture(std::shared_ptr<const Picture> picture, const PictureLayout& layout);

  /// Place in pixels; nullopt outside a picture that is there once.
  std::optional<Vec2> place(const Vec3& point) const;
  Colour colour(const Vec2& place) const;
  /// The palette entry, interpolated as colours are; nullopt without a palette.
  std::optional<int> index(const Vec2& place) const;
  const Picture& picture() const { return *m_picture; }
  bool once() const { return m_layout.once; }

 private:
  /// As stored, several pixels where they are mixed.
  Colour mixed(const Vec2& place) const;
  bool on_shape(const Vec3& point, Vec2& place) const;
  std::size_t pixel(int column, int row) const;
  /// Calls visit(pixel, weight) for all that count at a place.
  template <typename Visit>
  void for_pixels(const Vec2& place, Visit visit) const;

  std::shared_ptr<const Picture> m_picture;
  PictureLayout m_layout;
  double m_width, m_height;  ///< of one repetition, in pixels
};
using MappedPicturePtr = std::shared_ptr<const MappedPicture>;

std::shared_ptr<const Pigment> make_picture_pigment(Placement placement, MappedPicturePtr picture);
/// Grey, or with `alpha` the transparency, as a pattern.
PatternPtr make_picture_pattern(MappedPicturePtr picture, bool alpha);
/// Grey, or with `by_index` the palette's number, as height.
DisplacementPtr make_picture_displacement(MappedPicturePtr picture, double amount, bool by_index);
/// Textures by the palette's number, or the red of the pixel, 0..255; counted round.
TexturePtr make_material_map(Placement placement, MappedPicturePtr picture,
                             const BlendMap<TexturePtr>& textures);

}  // namespace lentray::core
