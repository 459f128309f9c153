#include "core/image/reader.h"

#include "core/image/image_module.h"
#include "core/image/png_chunks.h"

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
  // Files of floats hold linear light; PNG says what it holds, if it is one.
  if (image.bits == 32) {
    image.gamma = 1.0;
    image.premultiplied = image.channels == 2 || image.channels == 4;
  } else if (is_png(path)) {
    image.gamma = png_gamma(path);
  }
  return image;
}

}  // namespace lentray::core
