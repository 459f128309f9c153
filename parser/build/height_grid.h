// The heights of a height_field from its picture or function.
// Source: reference manual 3.7, "Height Field"; rounding compared with stock by image.shapes.
#pragma once

#include <memory>

#include "core/geometry/height_field.h"
#include "parser/descriptions/object.h"

namespace lentray::parser {

/// Throws std::runtime_error if the picture cannot be read or is smaller than 2 x 2.
std::shared_ptr<const core::HeightGrid> build_height_grid(const HeightFieldShape& field);

}  // namespace lentray::parser
