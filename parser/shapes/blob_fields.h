// The elements of a blob -> the kernel's fields.
#pragma once

#include <vector>

#include "core/shape/blob.h"
#include "parser/descriptions/object.h"

namespace lentray::parser {

/// One a element, in order; `to_blob` leads to the space of the blob's statement.
std::vector<core::BlobField> blob_fields(const BlobShape& blob);

}  // namespace lentray::parser
