// The upright picture of a camera that looks at a lens sheet lying on its side, as sheets whose lenses lie across the
// picture do: the sheet's left is the picture's top. Immutable, any number of threads.
#pragma once

#include <memory>

#include "camera/camera_of_others.h"
#include "camera/lenticular.h"
#include "camera/projection.h"

namespace lentray::camera {

/// The frame of the same camera on its side: its right is what was down. The sheet of it has lenses that lie across the
/// upright picture, and its eyes stand one above the other: view 0 is the lowest one's, the last view the highest one's.
Projection on_its_side(const Projection& upright);

/// A quarter turn clockwise of `view`.
class UprightView final : public CameraOfOthers {
 public:
  explicit UprightView(std::shared_ptr<const Camera> view);
  Properties describe() const override { return m_view->describe(); }

 private:
  Found find(const core::PixelPlace& place) const override;

  std::shared_ptr<const Camera> m_view;
};

}  // namespace lentray::camera
