#include "tools/lentray-views/wiggle.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "tools/lentray-views/join.h"

namespace lentray::views {
namespace {

bool is_loop(const Arguments& a, const Facts& facts) {
  if (a.is_loop) return *a.is_loop;
  const auto said = facts.find("views.motion");
  return said != facts.end() && said->second == "loop";
}

/// Width by height of what is looked at; of a sheet that does not say it, its pixels are square.
double aspect_of(const Arguments& a, const Source& source, const core::StoredImage& frame) {
  if (const double known = source.aspect(); known > 0.0) return known;
  const double pixels = a.sheet.pixels.value_or(tool::number_of(source.facts(), "lens.pixels"));
  if (a.pictures.size() != 1 || !(pixels >= 1.0)) return 0.0;
  const bool is_across = a.sheet.across || tool::lies_across(source.facts());
  return is_across ? frame.width / (frame.height * pixels) : frame.width * pixels / frame.height;
}

}  // namespace

std::vector<std::uint32_t> order_of_frames(const Range& range, bool is_loop) {
  std::vector<std::uint32_t> out;
  for (std::uint32_t view = range.first; view <= range.last; ++view) out.push_back(view);
  if (is_loop) return out;
  for (std::uint32_t view = range.last; view-- > range.first + 1;) out.push_back(view);
  return out;
}

Size size_of_frame(std::uint32_t width, std::uint32_t height, double aspect) {
  constexpr double kMost = 640.0;
  // A pixel a lens is few along one side.
  const double high = aspect > 0.0 ? std::max<double>(height, width / aspect) : height;
  const double wide = aspect > 0.0 ? high * aspect : width;
  const double scale = std::min(1.0, kMost / std::max(wide, high));
  const auto whole = [scale](double side) {
    return static_cast<std::uint32_t>(std::max(1.0, std::round(side * scale)));
  };
  return {whole(wide), whole(high)};
}

std::vector<core::StoredImage> frames_of(const Arguments& a, const Source& source,
                                         const Range& range) {
  std::map<std::uint32_t, core::StoredImage> views;
  for (std::uint32_t i = range.first; i <= range.last; ++i) {
    core::StoredImage view = source.view(i);
    if (!a.size && !a.square) {
      const Size size = size_of_frame(view.width, view.height, aspect_of(a, source, view));
      view = resized(view, size.width, size.height, a.filter);
    }
    const auto& kept = views.emplace(i, std::move(view)).first->second;
    check_alike(views.begin()->second, kept);
  }
  std::vector<core::StoredImage> out;
  for (const std::uint32_t i : order_of_frames(range, is_loop(a, source.facts())))
    out.push_back(views[i]);
  return out;
}

}  // namespace lentray::views
