// Pages into files: TIFF and PNG as pixels with the resolution that makes them print at their size, PDF at exact size.
// Errors: core::ImageError, with the path and the reason. All files appear when all pages are through; what stood there
// before stays until then. One thread.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tools/lentray-print/page.h"

namespace lentray::print {

/// A page of several, made when it is written: only one is in memory.
struct PageSource {
  std::string
      suffix;  ///< of its file's name before the extension, where pages are files of their own
  std::function<Page()> make;  ///< called once
};

/// Throws core::ImageError for any but .pdf, .tif, .tiff and .png.
void check_page_file(const std::filesystem::path& path);
/// "a.png" with the suffix "-1" is "a-1.png"; a PDF file holds all pages.
std::filesystem::path file_of(const std::filesystem::path& path, const std::string& suffix);

/// `bits`: 8 or 16, of TIFF and PNG. Returns warnings.
std::vector<std::string> write_pages(const std::vector<PageSource>& pages,
                                     const std::filesystem::path& path, int bits);

}  // namespace lentray::print
