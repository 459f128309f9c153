// The heights of a height_field from its picture or function.
// Source: reference manual 3.7, "Height Field"; rounding compared with stock by tests/image/shapes_test.cpp.
#pragma once

#include <memory>

#include "core/shape/height_field.h"
#include "parser/base/sparse.h"
#include "parser/descriptions/object.h"

namespace lentray::parser {

/// Throws std::runtime_error if the picture cannot be read or is smaller than 2 x 2. As long as a grid lives, copies
/// of the same description share it: objects made of it again, and questions for its bounds, cost nothing. Any thread.
std::shared_ptr<const core::HeightGrid> build_height_grid(const Sparse<HeightFieldShape>& field);

}  // namespace lentray::parser
