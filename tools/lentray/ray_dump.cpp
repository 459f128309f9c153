#include "tools/lentray/ray_dump.h"

#include <cstdio>
#include <memory>
#include <optional>

#include "core/image/file_swap.h"
#include "core/image/writer.h"

namespace lentray::tool {

void dump_rays(const camera::Camera& camera, const std::string& path) {
  std::optional<core::FileSwap> swap;
  std::FILE* out = stdout;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> owned(nullptr, &std::fclose);
  if (path != "-") {
    swap.emplace(path);
    owned.reset(std::fopen(swap->temporary().c_str(), "w"));
    if (!owned) throw core::ImageError("cannot write '" + path + "'");
    out = owned.get();
  }
  std::fprintf(out,
               "# lentray rays, camera %s, %u x %u pixels\n"
               "# column row  origin x y z  unit direction x y z | column row dark\n",
               std::string(camera.name()).c_str(), camera.width(), camera.height());
  for (std::uint32_t row = 0; row < camera.height(); ++row) {
    for (std::uint32_t column = 0; column < camera.width(); ++column) {
      core::Ray r;
      if (!camera.ray(column + 0.5, row + 0.5, r)) {
        std::fprintf(out, "%u %u dark\n", column, row);
        continue;
      }
      std::fprintf(out, "%u %u %.17g %.17g %.17g %.17g %.17g %.17g\n", column, row, r.origin.x,
                   r.origin.y, r.origin.z, r.direction.x, r.direction.y, r.direction.z);
    }
  }
  const bool failed = std::fflush(out) != 0 || std::ferror(out) != 0;
  if (failed) throw core::ImageError("cannot write '" + path + "': no space, or the disk failed");
  owned.reset();
  if (swap) swap->commit();
}

}  // namespace lentray::tool
