#include "core/image/exr_head.h"

#include <stdexcept>

#include "core/image/file_bytes.h"

namespace lentray::core {
namespace {

/// Corners of a box of integers, both within.
ExrWindow window_of(const Bytes& file, std::size_t at) {
  const auto span = [&](std::size_t low) {
    return std::int64_t{file.number(low + 8)} - std::int64_t{file.number(low)} + 1;
  };
  if (span(at) <= 0 || span(at + 4) <= 0) throw std::runtime_error("the picture is empty");
  return {static_cast<std::uint64_t>(span(at)), static_cast<std::uint64_t>(span(at + 4))};
}

}  // namespace

ExrWindow exr_window(std::string_view begin, std::uint64_t bytes) {
  constexpr std::size_t kFirst = 8;  // behind the mark and the version
  const Bytes file(begin);
  std::size_t at = kFirst;
  ExrWindow window;
  const auto word = [&] {
    const std::size_t end = begin.find('\0', at);
    if (end == std::string_view::npos) return std::string_view();
    const std::string_view text = begin.substr(at, end - at);
    at = end + 1;
    return text;
  };
  while (at < begin.size()) {
    const std::string_view name = word(), type = word();
    if (name.empty() || type.empty() || at + 4 > begin.size()) break;
    const auto size = static_cast<std::uint32_t>(file.number(at));
    at += 4;
    if (size > bytes) throw std::runtime_error("the file ends early");
    if (name == "dataWindow" && at + 16 <= begin.size()) window = window_of(file, at);
    at += size;
  }
  return window;
}

}  // namespace lentray::core
