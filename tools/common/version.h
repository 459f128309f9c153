// The program's version; CMakeLists.txt has the same one.
#pragma once

namespace lentray::tool {

inline constexpr const char* kVersion = "0.1.0";
/// Whose scenes and options are read.
inline constexpr const char* kPovRayVersion = "3.7.0";

}  // namespace lentray::tool
