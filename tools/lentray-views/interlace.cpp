#include "tools/lentray-views/interlace.h"

#include <algorithm>
#include <cmath>

#include "camera/text.h"
#include "core/image/writer.h"
#include "core/numeric/lens_columns.h"
#include "tools/lentray-views/picture.h"

namespace lentray::views {

using core::ImageError;

Interlacer::Interlacer(const InterlacePlan& plan)
    : m_plan(plan), m_lenses(0), m_columns(plan.views) {
  if (!(plan.pixels >= 1.0) || plan.pixels > plan.width) {
    throw ImageError("an integral image of " + std::to_string(plan.width) +
                     " columns has no lens of " + camera::format(plan.pixels) + " pixels");
  }
  if (plan.views > plan.pixels) {
    throw ImageError("a lens of " + camera::format(plan.pixels) + " pixels has no room for " +
                     std::to_string(plan.views) + " views");
  }
  for (std::uint32_t k = 0; k < plan.width; ++k) {
    const auto lens = static_cast<double>(core::LensColumns{plan.pixels}.lens_of(k));
    const auto view = static_cast<std::uint32_t>(((k + 0.5) / plan.pixels - lens) * plan.views);
    m_columns[std::min(view, plan.views - 1)].push_back(k);
    m_lens.push_back(static_cast<std::uint32_t>(lens));
  }
  m_lenses = m_lens.back() + 1;
  if (plan.slanted) {
    m_lenses = static_cast<std::uint32_t>(std::max(1.0, std::floor(plan.slanted->lenses() + 0.5)));
  }
}

void Interlacer::put_slanted(std::uint32_t view, const core::StoredImage& strip) {
  const camera::SlantedSheet& sheet = *m_plan.slanted;
  constexpr double kRounding = 1e-9;  // of a place between two views
  for (std::uint32_t y = 0; y < m_plan.height; ++y) {
    const auto row = static_cast<std::int32_t>(y);
    for (std::uint32_t k = 0; k < m_plan.width; ++k) {
      const auto own =
          static_cast<std::uint32_t>(sheet.part_of_cell(k, row) * m_plan.views + kRounding);
      if (std::min(own, m_plan.views - 1) != view) continue;
      const std::int64_t place = sheet.nearest_place(sheet.lens_of(k, row), row);
      const auto from = std::clamp<std::int64_t>(place, 0, std::int64_t{strip.width} - 1);
      copy_pixels(strip, {static_cast<std::uint32_t>(from), y, 1, 1}, m_result, k, y);
    }
  }
}

void Interlacer::put(std::uint32_t view, const core::StoredImage& picture,
                     const std::string& name) {
  if (m_first.width == 0) {
    m_first = blank_like(picture, 0, 0);
    m_first.width = picture.width;
    m_first.height = picture.height;
    m_first_name = name;
    m_result = blank_like(picture, m_plan.width, m_plan.height);
  } else if (const std::string how = other_kind(m_first, picture); !how.empty()) {
    // A view of a last lens that is cut is a pixel narrower.
    const bool is_cut = picture.height == m_first.height && picture.channels == m_first.channels &&
                        picture.bits == m_first.bits && m_first.width == m_lenses &&
                        picture.width + 1 == m_lenses;
    if (!is_cut) {
      throw ImageError("'" + m_first_name + "' and '" + name +
                       "' are not views of one sheet: they have " + how);
    }
  }
  const bool is_strip = picture.height == m_plan.height &&
                        (picture.width == m_lenses || picture.width + 1 == m_lenses);
  const core::StoredImage strip = is_strip ? picture
                                           : resized(picture, m_lenses, m_plan.height,
                                                     m_plan.filter, m_plan.width / m_plan.pixels);
  if (m_plan.slanted) {
    put_slanted(view, strip);
    return;
  }
  for (const std::uint32_t k : m_columns[view]) {
    const std::uint32_t column = std::min(m_lens[k], strip.width - 1);
    copy_pixels(strip, {column, 0, 1, m_plan.height}, m_result, k, 0);
  }
}

}  // namespace lentray::views
