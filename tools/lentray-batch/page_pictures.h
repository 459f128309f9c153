// The small pictures of the page: how large they may be, and they themselves as JPEG in base64.
//
// Sizes in bytes and pixels. Errors: none; a picture that cannot be made says why. Threads: one page of a folder
// at a time.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "tools/lentray-batch/page_cards.h"
#include "tools/lentray-batch/row.h"

namespace lentray::batch {

/// Of one row.
struct RowPictures {
  std::string picture;  ///< of an integral image the middle view
  std::string tilt;     ///< views, one below the other, from the left eye's to the right eye's
  int tilt_views = 0;
  std::string stock, difference;  ///< of the comparison
  std::string problem;            ///< why there is no picture
};

/// Limits of one kind of page. None of its pictures is larger than that.
struct PictureStep {
  std::uint32_t side = 0;  ///< longer side of a picture, in pixels; 0: there are none
  std::size_t bytes = 0;   ///< of its JPEG
  int views = 0;           ///< of an integral image, for looking at it tilted; odd
  std::uint32_t tilt_side = 0;
  std::size_t tilt_bytes = 0;
};
const std::vector<PictureStep>& picture_steps();

/// Of an animation, evenly chosen frames that have pictures.
inline constexpr std::size_t kMostFrames = 60;
std::vector<std::size_t> shown_frames(const std::vector<Row>& rows, const Card& card);

/// The index of the largest step whose pictures take no more than `room` in the page, in base64.
/// `expected_rows`: as if there were so many.
std::size_t step_that_fits(const std::vector<Row>& rows, const std::vector<Card>& cards,
                           std::size_t expected_rows, std::size_t room);

/// A row's pictures each, empty where it has none.
std::vector<RowPictures> pictures_of(const std::vector<Row>& rows, const std::vector<Card>& cards,
                                     const std::filesystem::path& folder, const PictureStep& step);

}  // namespace lentray::batch
