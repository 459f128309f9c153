// The members of a Seen, listed once for all JSON that holds one. Errors, threads: as tools/common/json_fields.h.
#pragma once

#include "tools/common/json_fields.h"
#include "tools/session/seen.h"

namespace lentray::tool {

void json_members(auto& io, Of<Seen> auto& seen) {
  io.always("files", seen.files);
  io.given("missing", seen.missing);
  io.given("there", seen.there);
  io.given("input_file_name", seen.name);
  io.given("now", seen.now);
}

}  // namespace lentray::tool
