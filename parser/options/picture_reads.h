// What a scene has asked for of the picture that it is read for. Where another picture differs in none
// of it, its scene is the same. Plain data.
#pragma once

namespace lentray::parser {

struct PictureReads {
  bool clock = false;   ///< clock, clock_on, clock_delta, initial_clock, final_clock
  bool frames = false;  ///< frame_number, initial_frame, final_frame
  bool width = false;   ///< image_width
  bool height = false;  ///< image_height
};

}  // namespace lentray::parser
