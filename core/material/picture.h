// A picture laid over space: image_map, image_pattern, bump_map and material_map share it.
// Pixels count from the upper left; the picture fills the unit square of x and y, y upwards, or is
// wrapped about the y axis. Immutable.
// Source: reference manual 3.7, "Image Map"; compared with stock by image.pictures.
#pragma once

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

/// Colours in the scene's working space.
struct Picture {
  int width = 0, height = 0;
  std::vector<Colour> pixels;
  std::vector<std::uint8_t> indices;  ///< palette entries of the pixels; empty: it has no palette
  bool has_alpha = false;
};

enum class PictureShape { kPlanar = 0, kSpherical = 1, kCylindrical = 2, kTorus = 5 };
enum class Interpolation { kNone = 0, kBilinear = 2, kBicubic = 3, kNormalizedDistance = 4 };

struct PictureLayout {
  PictureShape shape = PictureShape::kPlanar;
  Interpolation interpolation = Interpolation::kNone;
  bool once = false;
  bool premultiplied = false;  ///< colours are by their alpha, of which filter and transmit given for the map are part
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
                             std::vector<TexturePtr> textures);

}  // namespace lentray::core
