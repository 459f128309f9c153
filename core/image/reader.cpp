#include "core/image/reader.h"

#include "core/image/image_module.h"

namespace lentray::core {

StoredImage read_image(const std::filesystem::path& path, const std::filesystem::path& named) {
  const auto fail = [&](const std::string& why) {
    throw ImageError("cannot read '" + (named.empty() ? path : named).string() + "': " + why);
  };
  if (!std::filesystem::is_regular_file(path)) fail("there is no such file");
  const ImageModule& module = image_module();
  StoredImage image;
  try {
    image = module.read(path, named == path ? std::filesystem::path() : named);
  } catch (const std::exception& e) {
    fail(e.what());
  }
  return image;
}

}  // namespace lentray::core
