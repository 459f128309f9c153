#include "tools/common/text_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>

#include "core/image/file_swap.h"
#include "core/image/writer.h"

namespace lentray::tool {

void write_text_file(const std::string& path, const std::string& text) {
  core::FileSwap swap(path);
  std::ofstream out(swap.temporary(), std::ios::binary);
  out << text;
  out.close();
  if (!out) throw core::ImageError("cannot write '" + path + "': " + std::strerror(errno));
  swap.commit();
}

}  // namespace lentray::tool
