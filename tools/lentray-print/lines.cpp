#include "tools/lentray-print/lines.h"

#include <algorithm>
#include <cmath>

namespace lentray::print {
namespace {

/// Ink between 0 and u, in periods.
double ink_before(const Lines& lines, double u) {
  const double whole = std::floor(u);
  return whole * (lines.to - lines.from) +
         (std::clamp(u - whole, lines.from, lines.to) - lines.from);
}

std::uint8_t level(double background, double ink, double share) {
  return static_cast<std::uint8_t>(std::lround(255.0 * (background + share * (ink - background))));
}

}  // namespace

double inked_share(const Lines& lines, double left, double right) {
  const double a = (left - lines.origin) / lines.period, b = (right - lines.origin) / lines.period;
  return (ink_before(lines, b) - ink_before(lines, a)) / (b - a);
}

Picture grating(const Grating& grating, std::int64_t row, std::uint32_t rows, const Page& page) {
  const auto first = static_cast<std::int64_t>(std::floor(grating.left));
  const auto end = static_cast<std::int64_t>(std::ceil(grating.right));
  const bool is_grey = page.background == kWhite && page.ink == Colour{};
  Picture picture{.image = {}, .column = first, .row = row};
  core::StoredImage& image = picture.image;
  image.width = static_cast<std::uint32_t>(std::max<std::int64_t>(0, end - first));
  image.height = rows;
  image.channels = is_grey ? 1 : 3;
  std::vector<std::uint8_t> line;
  for (std::int64_t column = first; column < end; ++column) {
    const auto pixel = static_cast<double>(column);
    const double left = std::max(pixel, grating.left), right = std::min(pixel + 1.0, grating.right);
    double share = right > left ? inked_share(grating.lines, left, right) * (right - left) : 0.0;
    if (grating.is_hard) share = share >= 0.5 ? 1.0 : 0.0;
    line.push_back(level(page.background.red, page.ink.red, share));
    if (is_grey) continue;
    line.push_back(level(page.background.green, page.ink.green, share));
    line.push_back(level(page.background.blue, page.ink.blue, share));
  }
  std::vector<std::uint8_t>& samples = image.samples.store<std::uint8_t>(0);
  samples.reserve(line.size() * rows);
  for (std::uint32_t i = 0; i < rows; ++i) samples.insert(samples.end(), line.begin(), line.end());
  return picture;
}

}  // namespace lentray::print
