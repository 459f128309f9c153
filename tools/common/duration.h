// Times for readers, and from users. Pure functions.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lentray::tool {

/// As exact as it helps: 7.4 s, 52 s, 12 min 30 s, 3 h 5 min.
std::string duration_text(double seconds);

/// What time it is (UTC), in a form of strftime().
std::string utc_text(const char* form);

/// Seconds of "500ms", "30s", "2min" or "2m", "1.5h"; a number alone is seconds. Nothing for any other text, and for
/// what is not above 0.
std::optional<double> duration_of(std::string_view text);

}  // namespace lentray::tool
