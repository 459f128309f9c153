// The views of a lens sheet as cameras that other programs can have: where the eye of a view is, and the window that it
// looks through, which lies in the sheet. World space.
// Errors: none. Pure. Source: docs/views.md, "Cameras for other programs"; tests/image/view_cameras_test.cpp renders
// them with stock.
#pragma once

#include "camera/lenticular.h"

namespace lentray::camera {

/// The rays of one view, seen as those of a camera.
struct ViewCamera {
  bool is_dark = false;        ///< none of its rays leaves the sheet
  bool is_perspective = true;  ///< else rays are parallel
  core::Vec3 eye;              ///< of parallel rays: where they start that pass the window's middle
  core::Vec3 towards;  ///< to the window's middle: all the way, or of parallel rays their direction
  core::Vec3 right, up;   ///< as wide and high as the window
  core::Vec3 normal;      ///< of the sheet, away from the eye; unit
  double distance = 0.0;  ///< of the eye, or of where rays start, from the sheet
  double start = 0.0;     ///< where rays start, along the normal from the eye; 0: in it
  /// How far a ray of the view is from this camera's, at most, as a slope. 0 but for rounding if the camera is exact.
  double miss = 0.0;
};

/// `view`: one that make_view() or SheetView has made of the sheet. `lenses`: how many its picture is as wide as, from the
/// left; LensSheet::lenses() of a picture of the whole sheet.
ViewCamera view_camera(const Lenticular& sheet, const Camera& view, double lenses);

}  // namespace lentray::camera
