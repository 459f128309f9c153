#include "core/image/image_module.h"

#include <dlfcn.h>

#include <string>

namespace lentray::core {
namespace {

constexpr const char* kFile = "lentray_openimageio.so";  // found by the program's run path
constexpr const char* kEntry = "lentray_image_module";

const ImageModule& loaded() {
  void* module = dlopen(kFile, RTLD_LAZY | RTLD_LOCAL);
  void* entry = module ? dlsym(module, kEntry) : nullptr;
  if (!entry) {
    const char* why = dlerror();
    throw ImageError(std::string("cannot load OpenImageIO: ") + (why ? why : kFile));
  }
  return *reinterpret_cast<const ImageModule* (*)()>(entry)();
}

}  // namespace

const ImageModule& image_module() {
  static const ImageModule& module = loaded();
  return module;
}

}  // namespace lentray::core
