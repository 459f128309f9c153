#include "tools/lentray-diff/mean.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/image/srgb.h"
#include "core/image/writer.h"
#include "parser/options/options.h"

namespace lentray::diff {

using core::StoredImage;
using Working = ColourSpaces::Working;

ColourSpaces colour_spaces_of(const nlohmann::json& statistics,
                              const parser::RenderOptions& options) {
  ColourSpaces out;
  out.file_srgb = options.srgb;
  out.file_gamma = options.file_gamma;
  out.alpha = options.alpha;
  const auto image = statistics.find("image");
  if (image == statistics.end() || !image->contains("working_gamma")) {
    throw std::runtime_error("lentray's statistics have no \"image.working_gamma\"");
  }
  const nlohmann::json& gamma = (*image)["working_gamma"];
  if (gamma.is_number()) {
    out.working_gamma = gamma.get<double>();
  } else {
    out.working = gamma.is_null() ? Working::unchanged : Working::srgb;
  }
  return out;
}

Mean::Mean(std::uint32_t width, std::uint32_t height, const ColourSpaces& spaces)
    : m_width(width), m_height(height), m_spaces(spaces),
      m_sums(std::size_t{4} * width * height, 0.0) {}

double Mean::working(float light) const {
  if (m_spaces.working != Working::power) return core::srgb_of_linear(light);
  if (m_spaces.working_gamma == 1.0) return light;
  return std::copysign(std::pow(std::fabs(double{light}), 1.0 / m_spaces.working_gamma), light);
}

void Mean::add(std::uint32_t column, std::uint32_t row, const StoredImage& light,
               std::uint32_t light_column, std::uint32_t light_row) {
  const bool has_alpha = light.has_alpha();
  const float alpha = has_alpha ? light.at(light_column, light_row, light.channels - 1) : 1.0f;
  double* sum = &m_sums[(std::size_t{row} * m_width + column) * 4];
  for (int c = 0; c < 3; ++c) {
    const int channel = light.channels < 3 ? 0 : c;
    sum[c] += working(light.at(light_column, light_row, channel));
  }
  sum[3] += alpha;
}

StoredImage Mean::picture(int samples, int bits) const {
  core::ImageFormat format;
  format.bits = bits;
  format.srgb = m_spaces.file_srgb;
  format.file_gamma = m_spaces.file_gamma;
  format.working_gamma = m_spaces.working_gamma;
  format.working_srgb = m_spaces.working == Working::srgb;
  if (m_spaces.working == Working::unchanged) {
    format.srgb = false;
    format.file_gamma = 1.0;
  }
  StoredImage out = core::black_rgb(m_width, m_height, bits);
  std::size_t to = 0;
  for (std::size_t i = 0; i < m_sums.size(); i += 4) {
    const double weight = m_spaces.alpha ? std::max(m_sums[i + 3], 1e-30) : samples;
    for (int c = 0; c < 3; ++c) {
      out.samples[to++] =
          static_cast<float>(core::quantised(static_cast<float>(m_sums[i + c] / weight), format));
    }
  }
  return out;
}

}  // namespace lentray::diff
