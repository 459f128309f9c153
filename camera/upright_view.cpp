#include "camera/upright_view.h"

namespace lentray::camera {

Projection on_its_side(const Projection& upright) {
  Projection out = upright;
  out.right = upright.up * -1.0;
  out.up = upright.right;
  return out;
}

UprightView::UprightView(std::shared_ptr<const Camera> view)
    : CameraOfOthers(*view, view->name(), view->height(), view->width()), m_view(std::move(view)) {}

UprightView::Found UprightView::find(const core::PixelPlace& place) const {
  core::PixelPlace out = place;
  out.column = place.row;
  out.across = place.down;
  out.row = static_cast<std::int32_t>(width()) - 1 - place.column;
  out.down = -place.across;
  return {*m_view, out};
}

}  // namespace lentray::camera
