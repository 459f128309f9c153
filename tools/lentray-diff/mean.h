// The mean of many pictures of stock's, as the one picture that stock would write if it took all
// their samples itself: summed in the space in which the scene computes its colours, and unclipped.
// The pictures are OpenEXR, which hold linear light.
// Errors: none. One thread at a time.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "core/image/reader.h"

namespace lentray::parser {
struct RenderOptions;
}

namespace lentray::diff {

/// The spaces of a scene's colours: that in which they are computed, and the file's.
struct ColourSpaces {
  enum class Working {
    power,  ///< linear light to the power of 1/working_gamma
    srgb,
    unchanged  ///< colours go to the file as they are; stock takes them for sRGB
  };
  Working working = Working::power;
  double working_gamma = 1.0;
  bool file_srgb = true;
  double file_gamma = 1.0;  ///< unless file_srgb
  bool alpha = false;       ///< the file has alpha, by which its colours are not multiplied
};

/// From lentray's statistics and options. Throws std::runtime_error if they do not say.
ColourSpaces colour_spaces_of(const nlohmann::json& statistics,
                              const parser::RenderOptions& options);

class Mean {
 public:
  Mean(std::uint32_t width, std::uint32_t height, const ColourSpaces& spaces);
  /// A sample of a pixel, found at a place of a picture.
  void add(std::uint32_t column, std::uint32_t row, const core::StoredImage& light,
           std::uint32_t light_column, std::uint32_t light_row);
  /// Of `samples` a pixel; those that were not added are black. RGB of `bits` 8 or 16.
  core::StoredImage picture(int samples, int bits) const;

 private:
  double working(float light) const;

  std::uint32_t m_width, m_height;
  ColourSpaces m_spaces;
  std::vector<double> m_sums;  ///< premultiplied R, G, B and alpha of each pixel
};

}  // namespace lentray::diff
