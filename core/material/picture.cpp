#include "core/material/picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/tiny.h"
#include "core/base/whole.h"
#include "core/pattern/single.h"

namespace lentray::core {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

double wrap(double value, double size) {
  const double rest = std::fmod(value, size);
  if (rest < 0.0) return rest + size;
  return rest >= 0.0 ? rest : 0.0;  // of what is no number
}

int wrap(int value, int size) {
  const int rest = value % size;
  return rest < 0 ? rest + size : rest;
}

/// Angle about the y axis from +x towards +z, in turns 0..1.
double turn(double x, double z, double across) {
  if (z == 0.0) return x > 0.0 ? 0.0 : 0.5;
  const double angle = std::acos(std::clamp(x / across, -1.0, 1.0));
  return (z < 0.0 ? kTwoPi - angle : angle) / kTwoPi;
}

/// Sums in double: rounding must not lift a mean of 1 above 1.
class Mixer {
 public:
  void add(const Colour& c, double weight) {
    const float parts[5] = {c.rgb.r, c.rgb.g, c.rgb.b, c.filter, c.transmit};
    for (std::size_t i = 0; i < 5; ++i) m_sums[i] += parts[i] * weight;
  }
  Colour mixed() const {
    const auto part = [&](std::size_t i) { return static_cast<float>(m_sums[i]); };
    return {{part(0), part(1), part(2)}, part(3), part(4)};
  }

 private:
  std::array<double, 5> m_sums{};
};

std::array<double, 4> cubic_weights(double p) {
  const double q = 1.0 - p;
  return {-0.5 * p * q * q, 0.5 * q * (q * (3.0 * p + 1.0) + 1.0),
          0.5 * p * (p * (3.0 * q + 1.0) + 1.0), -0.5 * q * p * p};
}

bool has_only_opaque(const Picture& picture) {
  const std::size_t pixels =
      picture.is_evenly_clear() ? std::min<std::size_t>(1, picture.pixels()) : picture.pixels();
  for (std::size_t i = 0; i < pixels; ++i) {
    if (!picture.colour(i).is_opaque()) return false;
  }
  return true;
}

/// The picture's grey as heights one pixel apart.
class PictureDisplacement final : public Displacement {
 public:
  PictureDisplacement(MappedPicturePtr picture, double amount, bool by_index)
      : m_picture(std::move(picture)), m_amount(amount), m_by_index(by_index) {}
  Vec3 displaced(const Vec3& point, const Vec3& normal) const override {
    const auto place = m_picture->place(point);
    if (!place) return normal;
    const double here = height(*place), left = height({place->u - 1.0, place->v + 1.0}),
                 right = height({place->u + 1.0, place->v + 1.0});
    const Vec3 back = Vec3{0, here, 0} - Vec3{-1, left, 1};
    const Vec3 along = Vec3{1, right, 1} - Vec3{-1, left, 1};
    const Vec3 bump = normalized(cross(along, back));
    // The picture's axes as seen from the surface: up is the normal.
    Vec3 up = normal;
    Vec3 across = cross(up, {0, 1, 0});
    if (length(across) < kTiny) {
      up = {0, std::fabs(normal.y - 1.0) < kTiny ? 1.0 : -1.0, 0};
      across = {1, 0, 0};
    }
    across = normalized(across);
    const Vec3 deep = normalized(cross(across, up));
    return across * bump.x + up * bump.y - deep * bump.z;
  }

 private:
  double height(Vec2 place) const {
    const double width = m_picture->picture().width(), rows = m_picture->picture().height();
    if (place.u < 0.0) place.u += width;
    if (place.u >= width) place.u -= width;
    if (place.v >= rows) place.v -= rows;
    if (m_by_index) {
      if (const auto number = m_picture->index(place)) return m_amount * *number;
    }
    return m_amount * grey(m_picture->colour(place).rgb);
  }
  MappedPicturePtr m_picture;
  double m_amount;
  bool m_by_index;
};

class MaterialMap final : public CompositeTexture {
 public:
  MaterialMap(Placement placement, MappedPicturePtr picture, const BlendMap<TexturePtr>& textures)
      : m_placement(std::move(placement)), m_picture(std::move(picture)), m_textures(textures) {}
  void resolve(const Vec3& point, const SurfaceContext& surface, double weight,
               WeightedTextures& out) const override {
    const Vec3 local = m_placement.inwards(point, surface);
    const auto place = m_picture->place(local);
    std::size_t number = 0;
    if (place) {
      const auto entry = m_picture->index(*place);
      number = static_cast<std::size_t>(entry ? *entry
                                              : whole_of(m_picture->colour(*place).rgb.r * 255.0f));
    }
    // Counts round only beyond the number of textures, and stops at the last.
    const std::size_t count = parts().size();
    if (number > count) number %= count;
    const std::uint32_t around = out.enter(m_placement);
    parts()[std::min(number, count - 1)]->resolve(local, surface, weight, out);
    out.leave(around);
  }

 private:
  std::span<const TexturePtr> parts() const override { return m_textures.items(); }

  Placement m_placement;
  MappedPicturePtr m_picture;
  BlendMap<TexturePtr> m_textures;  ///< numbered, whatever the values
};

}  // namespace

std::size_t Picture::bytes() const {
  return m_colours.capacity() * sizeof(Colour) + m_entries.capacity() + m_bytes.capacity() +
         m_words.capacity() * sizeof(std::uint16_t) + m_values.capacity() * sizeof(float);
}

Picture::Picture(int width, int height, std::vector<Colour> pixels)
    : m_width(width), m_height(height), m_colours(std::move(pixels)) {}

Picture::Picture(int width, int height, std::vector<std::uint8_t> entries,
                 const std::array<Colour, 256>& palette)
    : m_width(width), m_height(height), m_colours(palette.begin(), palette.end()),
      m_entries(std::move(entries)) {}

Picture::Picture(int width, int height, int channels, std::vector<std::uint8_t> samples,
                 std::vector<float> values)
    : m_width(width), m_height(height), m_channels(channels), m_bytes(std::move(samples)),
      m_values(std::move(values)) {}

Picture::Picture(int width, int height, int channels, std::vector<std::uint16_t> samples,
                 std::vector<float> values)
    : m_width(width), m_height(height), m_channels(channels), m_words(std::move(samples)),
      m_values(std::move(values)) {}

template <typename Value>
Colour Picture::of_samples(const std::vector<Value>& samples, std::size_t pixel) const {
  const auto channels = static_cast<std::size_t>(m_channels);
  const Value* const from = samples.data() + pixel * channels;
  Colour colour{};
  if (channels < 3) {
    const float grey = m_values[from[0]];
    colour.rgb = {grey, grey, grey};
  } else {
    colour.rgb = {m_values[from[0]], m_values[from[1]], m_values[from[2]]};
  }
  constexpr float kMost = std::numeric_limits<Value>::max();
  const float transmit =
      channels % 2 == 0 ? 1.0f - static_cast<float>(from[channels - 1]) / kMost : 0.0f;
  colour.filter = m_filter;
  colour.transmit = m_transmit + transmit;
  return colour;
}

Colour Picture::colour(std::size_t pixel) const {
  if (!m_bytes.empty()) return of_samples(m_bytes, pixel);
  if (!m_words.empty()) return of_samples(m_words, pixel);
  return m_colours[m_entries.empty() ? pixel : m_entries[pixel]];
}

void Picture::clear_all(std::optional<double> filter, std::optional<double> transmit) {
  if (m_colours.empty()) {
    m_filter = static_cast<float>(filter.value_or(0.0));
    m_transmit = static_cast<float>(transmit.value_or(0.0));
    return;
  }
  const bool replaces = has_palette();
  const auto clear = [&](float& part, const std::optional<double>& all) {
    if (all) part = static_cast<float>(*all) + (replaces ? 0.0f : part);
  };
  for (Colour& colour : m_colours) {
    clear(colour.filter, filter);
    clear(colour.transmit, transmit);
  }
}

void Picture::set_filter(int entry, double filter) {
  m_colours[static_cast<std::size_t>(entry)].filter = static_cast<float>(filter);
}
void Picture::set_transmit(int entry, double transmit) {
  m_colours[static_cast<std::size_t>(entry)].transmit = static_cast<float>(transmit);
}

MappedPicture::MappedPicture(std::shared_ptr<const Picture> picture, const PictureLayout& layout)
    : m_picture(std::move(picture)), m_layout(layout),
      m_width(single(m_picture->width() * layout.repeat.u)),
      m_height(single(m_picture->height() * layout.repeat.v)) {}

bool MappedPicture::on_shape(const Vec3& p, Vec2& place) const {
  const auto outside = [](double v) { return v < 0.0 || v > 1.0; };
  const double across = std::sqrt(p.x * p.x + p.z * p.z);
  switch (m_layout.shape) {
    case PictureShape::kSpherical: {
      const double distance = length(p);
      if (distance == 0.0) return false;
      const double lift = std::asin(std::clamp(p.y / distance, -1.0, 1.0));
      place = {across == 0.0 ? 0.0 : turn(p.x, p.z, across) * m_width,
               (0.5 + lift / std::numbers::pi) * m_height};
      return true;
    }
    case PictureShape::kCylindrical:
      if ((m_layout.once && outside(p.y)) || across == 0.0) return false;
      place = {turn(p.x, p.z, across) * m_width, std::fmod(p.y * m_height, m_height)};
      return true;
    case PictureShape::kTorus: {
      if (across == 0.0) return false;
      const double x = across - 1.0, distance = std::sqrt(x * x + p.y * p.y);
      double around = std::acos(-x / distance);
      if (p.y > 0.0) around = kTwoPi - around;
      place = {turn(p.x, p.z, across) * m_width, around / kTwoPi * m_height};
      return true;
    }
    case PictureShape::kPlanar: break;
  }
  if (m_layout.once && (outside(p.x) || outside(p.y))) return false;
  place = {std::fmod(p.x * m_width, m_width), std::fmod(p.y * m_height, m_height)};
  return true;
}

std::optional<Vec2> MappedPicture::place(const Vec3& point) const {
  const double width = m_picture->width(), height = m_picture->height();
  Vec2 place;
  if (!on_shape(point, place)) return std::nullopt;
  place.u += kTiny - m_layout.offset.u * width;
  place.v += kTiny - m_layout.offset.v * height;
  if (m_layout.once && (place.u >= width || place.v >= height || place.u < 0.0 || place.v < 0.0)) {
    return std::nullopt;
  }
  return Vec2{wrap(place.u, width), wrap(-place.v, height)};  // row 0 is on top
}

std::size_t MappedPicture::pixel(int column, int row) const {
  const int width = m_picture->width(), height = m_picture->height();
  const int x = m_layout.once ? std::clamp(column, 0, width - 1) : wrap(column, width);
  const int y = m_layout.once ? std::clamp(row, 0, height - 1) : wrap(row, height);
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
         static_cast<std::size_t>(x);
}

template <typename Visit>
void MappedPicture::for_pixels(const Vec2& place, Visit visit) const {
  if (m_layout.interpolation == Interpolation::kNone) {
    visit(pixel(static_cast<int>(place.u), static_cast<int>(place.v)), 1.0);
    return;
  }
  // Interpolation is between the middles of pixels.
  const double u = place.u + 0.5, v = place.v + 0.5;
  const int column = static_cast<int>(u), row = static_cast<int>(v);
  const double p = u - column, q = v - row;
  if (m_layout.interpolation == Interpolation::kBicubic) {
    const auto across = cubic_weights(p), down = cubic_weights(q);
    for (std::size_t i = 0; i < 16; ++i) {
      const int right = static_cast<int>(i / 4) - 2, below = static_cast<int>(i % 4) - 2;
      visit(pixel(column + right, row + below), across[i / 4] * down[i % 4]);
    }
    return;
  }
  std::array<double, 4> weights = {p * q, (1 - p) * q, p * (1 - q), (1 - p) * (1 - q)};
  if (m_layout.interpolation == Interpolation::kNormalizedDistance) {
    const auto inverse = [](double x, double y) { return 1.0 / (x * x + y * y); };
    weights = {inverse(1 - p, 1 - q), inverse(p, 1 - q), inverse(1 - p, q), inverse(p, q)};
    const double sum = weights[0] + weights[1] + weights[2] + weights[3];
    for (double& weight : weights) weight /= sum;
  }
  for (int i = 0; i < 4; ++i) {
    visit(pixel(column - (i & 1), row - (i >> 1)), weights[static_cast<std::size_t>(i)]);
  }
}

Colour MappedPicture::colour(const Vec2& place) const {
  Colour colour = mixed(place);
  const float alpha = 1.0f - colour.transmit;
  if (m_layout.premultiplied && alpha > 0.0f && alpha != 1.0f) {
    colour.rgb = {colour.rgb.r / alpha, colour.rgb.g / alpha, colour.rgb.b / alpha};
  }
  return colour;
}

Colour MappedPicture::mixed(const Vec2& place) const {
  if (m_layout.interpolation == Interpolation::kNone) {
    return m_picture->colour(pixel(static_cast<int>(place.u), static_cast<int>(place.v)));
  }
  Mixer mixer;
  for_pixels(place, [&](std::size_t i, double weight) { mixer.add(m_picture->colour(i), weight); });
  return mixer.mixed();
}

std::optional<int> MappedPicture::index(const Vec2& place) const {
  if (!m_picture->has_palette()) return std::nullopt;
  double sum = 0.0;
  for_pixels(place, [&](std::size_t i, double weight) { sum += m_picture->entry(i) * weight; });
  return static_cast<int>(sum);
}

std::shared_ptr<const Pigment> make_picture_pigment(Placement placement, MappedPicturePtr picture) {
  const bool is_opaque = !picture->once() && has_only_opaque(picture->picture());
  return pigment_of(is_opaque, [placement = std::move(placement), picture = std::move(picture)](
                                   const Vec3& point, const SurfaceContext& surface) {
    const auto place = picture->place(placement.inwards(point, surface));
    return place ? picture->colour(*place) : Colour{{1, 1, 1}, 0, 1};
  });
}
PatternPtr make_picture_pattern(MappedPicturePtr picture, bool alpha) {
  return pattern_of([picture = std::move(picture), alpha](const Vec3& point) {
    const auto place = picture->place(point);
    if (!place) return 0.0;
    const Colour c = picture->colour(*place);
    double value = grey(c.rgb);
    if (alpha) value = picture->picture().has_alpha() ? c.transmit : c.rgb.r;
    return std::clamp(value, 0.0, 1.0);
  });
}
DisplacementPtr make_picture_displacement(MappedPicturePtr picture, double amount, bool by_index) {
  return std::make_unique<PictureDisplacement>(std::move(picture), amount, by_index);
}
TexturePtr make_material_map(Placement placement, MappedPicturePtr picture,
                             const BlendMap<TexturePtr>& textures) {
  return std::make_shared<MaterialMap>(std::move(placement), std::move(picture), textures);
}

}  // namespace lentray::core
