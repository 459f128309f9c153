#include "tools/lentray-views/resize.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "tools/lentray-views/picture.h"

namespace lentray::views {
namespace {

constexpr std::pair<std::string_view, Filter> kFilters[] = {{"box", Filter::kBox},
                                                            {"triangle", Filter::kTriangle},
                                                            {"mitchell", Filter::kMitchell},
                                                            {"lanczos3", Filter::kLanczos3}};

double radius_of(Filter filter) {
  switch (filter) {
    case Filter::kBox: return 0.5;
    case Filter::kTriangle: return 1.0;
    case Filter::kMitchell: return 2.0;
    case Filter::kLanczos3: break;
  }
  return 3.0;
}

double sinc(double x) {
  const double a = std::numbers::pi * x;
  return x == 0.0 ? 1.0 : std::sin(a) / a;
}

double weight_at(Filter filter, double x) {
  x = std::fabs(x);
  if (x > radius_of(filter)) return 0.0;
  switch (filter) {
    case Filter::kBox: return x < 0.5 ? 1.0 : 0.5;  // half at the edge, which two share
    case Filter::kTriangle: return 1.0 - x;
    case Filter::kMitchell:
      return x < 1.0 ? ((7.0 * x - 12.0) * x * x + 16.0 / 3.0) / 6.0
                     : ((-7.0 / 3.0 * x + 12.0) * x * x - 20.0 * x + 32.0 / 3.0) / 6.0;
    case Filter::kLanczos3: break;
  }
  return sinc(x) * sinc(x / 3.0);
}

/// The pixels that one pixel of the other size is made of.
struct Taps {
  std::uint32_t first = 0;
  std::vector<float> weights;
};

/// `step`: pixels of the picture for one of the other size.
std::vector<Taps> taps_of(std::uint32_t from, std::uint32_t to, double step, Filter filter) {
  const double stretch = std::max(step, 1.0), radius = radius_of(filter) * stretch;
  std::vector<Taps> out(to);
  for (std::uint32_t i = 0; i < to; ++i) {
    const double centre = (i + 0.5) * step - 0.5;
    const auto first = static_cast<std::int64_t>(std::ceil(centre - radius - 1e-9)),
               last = static_cast<std::int64_t>(std::floor(centre + radius + 1e-9));
    const std::int64_t most = std::int64_t{from} - 1;
    const std::int64_t low = std::clamp<std::int64_t>(first, 0, most),
                       high = std::clamp<std::int64_t>(last, 0, most);
    std::vector<double> weights(static_cast<std::size_t>(high - low + 1), 0.0);
    double sum = 0.0;
    for (std::int64_t k = first; k <= last; ++k) {
      const double weight = weight_at(filter, (static_cast<double>(k) - centre) / stretch);
      weights[static_cast<std::size_t>(std::clamp(k, low, high) - low)] += weight;
      sum += weight;
    }
    out[i].first = static_cast<std::uint32_t>(low);
    for (const double weight : weights) out[i].weights.push_back(static_cast<float>(weight / sum));
  }
  return out;
}

Light across(const Light& from, const std::vector<Taps>& taps) {
  Light to{static_cast<std::uint32_t>(taps.size()), from.height, from.channels, {}};
  to.values.resize(taps.size() * from.height * static_cast<std::size_t>(from.channels));
  for (std::uint32_t row = 0; row < from.height; ++row) {
    for (std::uint32_t i = 0; i < to.width; ++i) {
      float* const out = to.pixel(i, row);
      for (std::uint32_t k = 0; k < taps[i].weights.size(); ++k) {
        const float* const in = from.pixel(taps[i].first + k, row);
        for (int c = 0; c < from.channels; ++c) out[c] += taps[i].weights[k] * in[c];
      }
    }
  }
  return to;
}

Light down(const Light& from, const std::vector<Taps>& taps) {
  Light to{from.width, static_cast<std::uint32_t>(taps.size()), from.channels, {}};
  const std::size_t count = std::size_t{from.width} * static_cast<std::size_t>(from.channels);
  to.values.resize(taps.size() * count);
  for (std::uint32_t row = 0; row < to.height; ++row) {
    float* const out = to.pixel(0, row);
    for (std::uint32_t k = 0; k < taps[row].weights.size(); ++k) {
      const float* const in = from.pixel(0, taps[row].first + k);
      for (std::size_t i = 0; i < count; ++i) out[i] += taps[row].weights[k] * in[i];
    }
  }
  return to;
}

}  // namespace

std::optional<Filter> filter_named(std::string_view name) {
  for (const auto& [word, filter] : kFilters) {
    if (word == name) return filter;
  }
  return std::nullopt;
}

core::StoredImage resized(const core::StoredImage& image, std::uint32_t width, std::uint32_t height,
                          Filter filter, double span) {
  if (span <= 0.0) span = width;
  const bool is_same_width = span == image.width && width == image.width;
  if (is_same_width && height == image.height) return image;
  Light light = light_of(image);
  if (!is_same_width) {
    light = across(light, taps_of(image.width, width, image.width / span, filter));
  }
  if (height != image.height) {
    light = down(light, taps_of(image.height, height, double(image.height) / height, filter));
  }
  return stored(light, image);
}

}  // namespace lentray::views
