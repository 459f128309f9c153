#include "tools/lentray/output.h"

#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>
#include <variant>

#include "core/image/file_swap.h"
#include "core/image/writer.h"

namespace lentray::tool {
nlohmann::json lens_json(const camera::Camera& camera) {
  nlohmann::json out = nlohmann::json::object();
  constexpr std::string_view kPrefix = "lens.";
  for (const camera::Property& property : camera.describe()) {
    if (property.first.rfind(kPrefix, 0) != 0) continue;
    nlohmann::json& value = out[property.first.substr(kPrefix.size())];
    if (const auto* text = std::get_if<std::string>(&property.second)) {
      value = *text;
    } else if (const auto* v = std::get_if<core::Vec3>(&property.second)) {
      value = {v->x, v->y, v->z};
    } else {
      const double number = std::get<double>(property.second);
      constexpr double kExact = 9007199254740992.0;  // 2^53
      if (number == std::floor(number) && std::fabs(number) < kExact) {
        value = static_cast<std::int64_t>(number);
      } else {
        value = number;
      }
    }
  }
  return out;
}

void write_text_file(const std::string& path, const std::string& text) {
  core::FileSwap swap(path);
  std::ofstream out(swap.temporary(), std::ios::binary);
  out << text;
  out.close();
  if (!out) throw core::ImageError("cannot write '" + path + "': " + std::strerror(errno));
  swap.commit();
}

}  // namespace lentray::tool
