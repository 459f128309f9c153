// The small pictures of a chart's page: each file once, as JPEG in base64, all within the room that there is.
//
// Sizes in bytes and pixels. Errors: none; a picture that cannot be made says why. Threads: one page of a folder at a
// time.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/lentray-chart/chart.h"

namespace lentray::chart {

/// Of one setting: places in PagePictures::jpegs.
struct PointPictures {
  std::optional<std::size_t> picture{}, difference{}, stock{};
  std::string problem{};  ///< why there is no picture
};

struct PagePictures {
  std::vector<std::string> jpegs{};
  std::vector<PointPictures> points{};  ///< one a point of the chart
  std::optional<std::size_t> reference{}, lens_reference{};
  std::string reference_problem{};
  std::uint32_t side = 0;  ///< none of the pictures is longer; 0: there was no room for any
};

/// `room`: of the page, in base64. Settings that are to come have theirs kept free.
PagePictures pictures_of(const Chart& chart, const std::filesystem::path& folder, std::size_t room);

}  // namespace lentray::chart
