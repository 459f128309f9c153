// What a scene has asked for of the picture that it is read for, and of the moment. Where another picture differs in
// none of it, its scene is the same. Plain data.
#pragma once

#include <optional>

namespace lentray::parser {

struct PictureReads {
  bool clock = false;           ///< clock, clock_on, clock_delta, initial_clock, final_clock
  bool frames = false;          ///< frame_number, initial_frame, final_frame
  bool width = false;           ///< image_width
  bool height = false;          ///< image_height
  bool name = false;            ///< input_file_name
  std::optional<double> now{};  ///< what `now` said first
};

}  // namespace lentray::parser
