#include "tools/lentray-print/repitch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/formed.h"
#include "core/base/memory_limit.h"
#include "tools/lentray-print/page.h"
#include "tools/lentray-print/page_error.h"

namespace lentray::print {

using core::StoredImage;

namespace {

/// Where a column's colour comes from: (1 - share) of `left`, `share` of `right`.
struct Mix {
  std::uint32_t left = 0, right = 0;
  double share = 0.0;
  double offset = 0.0;  ///< from the nearer of the two, pixels
};

std::vector<Mix> mixes(std::uint32_t width, const core::LensColumns& from,
                       const core::LensColumns& to) {
  const std::int64_t lenses = from.lens_of(std::int64_t{width} - 1) + 1;
  std::vector<Mix> all;
  for (std::int64_t lens = 0; lens < lenses; ++lens) {
    const double first = static_cast<double>(from.first_column(lens));
    const double last =
        std::min<double>(width, static_cast<double>(from.first_column(lens + 1))) - 1.0;
    const std::int64_t end = to.first_column(lens + 1);
    for (std::int64_t k = to.first_column(lens); k < end; ++k) {
      const double place =
          (static_cast<double>(k) + 0.5 - to.origin) / to.pixels * from.pixels - 0.5;
      const double within = std::clamp(place, first, last);
      const double left = std::floor(within);
      const double share = within - left;
      all.push_back({static_cast<std::uint32_t>(left),
                     static_cast<std::uint32_t>(std::min(left + 1.0, last)), share,
                     std::min(share, 1.0 - share) + std::fabs(place - within)});
    }
  }
  return all;
}

/// The mean square of what a pixel differs from the mean of its neighbours under the same lens, values 0 to 1.
double neighbour_error(const StoredImage& image, double pixels) {
  constexpr std::uint32_t kRows = 97;  // of which it is taken, evenly
  const double most = static_cast<double>((1u << image.bits) - 1u);
  const std::uint32_t step = std::max(1u, image.height / kRows);
  const core::LensColumns lenses{pixels};
  double sum = 0.0;
  std::size_t count = 0;
  for (std::uint32_t row = 0; row < image.height; row += step) {
    for (std::uint32_t k = 1; k + 1 < image.width; ++k) {
      if (lenses.lens_of(k - 1) != lenses.lens_of(k + 1)) continue;
      for (int c = 0; c < image.channels; ++c) {
        const double mean = (double{image.at(k - 1, row, c)} + image.at(k + 1, row, c)) / 2.0;
        const double error = (image.at(k, row, c) - mean) / most;
        sum += error * error;
        ++count;
      }
    }
  }
  return count == 0 ? 0.0 : sum / static_cast<double>(count);
}

double decibels(double mean_square) {
  return mean_square > 0.0 ? -10.0 * std::log10(mean_square)
                           : std::numeric_limits<double>::infinity();
}

}  // namespace

Repitched repitched(const StoredImage& image, double from, const core::LensColumns& to) {
  if (!(to.pixels >= 1.0)) {
    throw PageError("at that pitch a lens is less than one pixel of the print wide");
  }
  const std::vector<Mix> all = mixes(image.width, {from}, to);
  Repitched out;
  StoredImage& result = out.image;
  result.width = static_cast<std::uint32_t>(all.size());
  result.height = image.height;
  result.channels = image.channels;
  result.bits = image.bits;
  result.attributes = image.attributes;
  result.profile = image.profile;
  const std::size_t count = all.size() * image.height * static_cast<std::size_t>(image.channels);
  core::check_room(static_cast<double>(count) * image.bits / 8);
  result.samples.store_bits(image.bits, count);
  result.samples.visit([&](auto& samples) {
    std::size_t to_sample = 0;
    for (std::uint32_t row = 0; row < image.height; ++row) {
      for (const Mix& mix : all) {
        for (int c = 0; c < image.channels; ++c) {
          const double value = (1.0 - mix.share) * image.at(mix.left, row, c) +
                               mix.share * image.at(mix.right, row, c);
          samples[to_sample++] =
              static_cast<std::decay_t<decltype(samples[0])>>(std::lround(value));
        }
      }
    }
  });
  // Linear interpolation at a share t between two columns, beside the same from twice as far at 1/2: t (1 - t) of the
  // error where values bend, 2 t (1 - t) of its square where they jump.
  double smooth = 0.0, step = 0.0;
  for (const Mix& mix : all) {
    const double t = mix.share * (1.0 - mix.share);
    smooth += t * t;
    step += 2.0 * t;
    out.largest_offset = std::max(out.largest_offset, mix.offset);
  }
  const double error = neighbour_error(image, from);
  const auto columns = static_cast<double>(std::max<std::size_t>(1, all.size()));
  out.smooth_psnr = decibels(error * smooth / columns);
  out.step_psnr = decibels(error * step / columns);
  return out;
}

std::string render_options(const LensData& data, double print_pitch, double lenses,
                           std::uint32_t height, bool is_across) {
  if (!data.lens) return {};
  const LensOfPicture& lens = *data.lens;
  const double pixels = print_pitch * data.dpi_x / kInch;
  const double pitch = print_pitch / (1.0 + lens.widening());
  const long long across = std::llround(lenses * pixels), along = height;
  std::string out = core::formed(
      "+W%lld +H%lld Lenticular=On %sLens_Pitch=%.15g Lens_Pixels=%.15g "
      "Lens_Focal_Length=%.15g Lens_IOR=%.15g Lens_Model=%s View_Distance=",
      is_across ? along : across, is_across ? across : along,
      is_across ? "Lens_Direction=across " : "", pitch, pixels, lens.focal_length, lens.ior,
      lens.model.c_str());
  out += lens.view_distance > 0.0 ? core::formed("%.15g", lens.view_distance) : "inf";
  return lens.has_scenes_eye ? out + " Depth=print" : out;
}

}  // namespace lentray::print
