#include "core/image/image_module.h"

#include <dlfcn.h>

#include <filesystem>
#include <string>
#include <system_error>

namespace lentray::core {
namespace {

constexpr const char* kFile = "lentray_openimageio.so";
constexpr const char* kEntry = "lentray_image_module";

const ImageModule& loaded() {
  // Beside the program; else where the system looks.
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  void* module = dlopen((program.parent_path() / kFile).c_str(), RTLD_LAZY | RTLD_LOCAL);
  if (!module) module = dlopen(kFile, RTLD_LAZY | RTLD_LOCAL);
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
