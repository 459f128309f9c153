// Ready pictures to an integral image: column k, behind lens i at the place c = (k + 1/2)/N - i of
// its cell, is column i of view floor(c M) in the size of one pixel a lens. So each of M views has
// N/M pixels of a lens, up to one; a flip print has two views. Behind slanted lenses i is the place of
// the row that is nearest to the lens's axis, and c its own for each row.
// Errors: core::ImageError, worded for the user. One thread an object.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "camera/slanted_sheet.h"
#include "core/image/reader.h"
#include "tools/lentray-views/resize.h"

namespace lentray::views {

struct InterlacePlan {
  double pixels = 0.0;  ///< N
  std::uint32_t width = 0, height = 0;
  std::uint32_t views = 0;  ///< M
  Filter filter = Filter::kLanczos3;
  std::optional<camera::SlantedSheet> slanted{};  ///< of that width and height
};

class Interlacer {
 public:
  /// Throws if a lens is wider than the picture or has fewer pixels than there are views.
  explicit Interlacer(const InterlacePlan& plan);
  /// All pictures have one size and kind. A picture of the sheet's height that has a pixel a lens
  /// is taken as it is; others are resized. `name` is for messages.
  void put(std::uint32_t view, const core::StoredImage& picture, const std::string& name);
  const core::StoredImage& result() const { return m_result; }

 private:
  void put_slanted(std::uint32_t view, const core::StoredImage& strip);

  const InterlacePlan m_plan;
  std::uint32_t m_lenses;                             ///< that own a pixel
  std::vector<std::vector<std::uint32_t>> m_columns;  ///< of each view
  std::vector<std::uint32_t> m_lens;                  ///< of each column
  core::StoredImage m_result, m_first;
  std::string m_first_name;
};

}  // namespace lentray::views
