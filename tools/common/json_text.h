// JSON of values whose strings may be any bytes, such as names of files: as text they are written
// as parser/base/utf8.h says, and read back as they were. Pure functions.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace lentray::tool {

/// `indent` as in nlohmann::json::dump(), but what nests more than 1,000 deep is one line; `ascii`: characters beyond ASCII are escaped.
std::string json_text(nlohmann::json value, int indent = -1, bool ascii = false);

/// Throws nlohmann::json::exception.
nlohmann::json parse_json(std::string_view text);
/// Discarded where the text is no JSON.
nlohmann::json json_if_any(std::string_view text);

}  // namespace lentray::tool
