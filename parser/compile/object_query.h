// inside() and trace() of SDL: one object compiled alone, geometry only.
// The compiled form is kept with the description, so asking often costs little. One thread.
// Source: reference manual 3.7, "Float Functions", "Vector Functions"; answers as stock's.
#pragma once

#include <memory>

#include "core/object/object.h"
#include "parser/descriptions/object.h"

namespace lentray::parser {

class ObjectQuery {
 public:
  explicit ObjectQuery(const ObjectDesc& object);
  bool inside(const core::Vec3& point) const;
  /// The nearest hit and its normal; false, with point and normal null, if there is none.
  bool trace(const core::Vec3& origin, const core::Vec3& direction, core::Vec3& point,
             core::Vec3& normal) const;

 private:
  std::shared_ptr<const core::Object> m_object;  ///< null: nothing of it is rendered
  double m_farthest = core::kFarthest;
};

}  // namespace lentray::parser
