// Pages as a PDF file: pictures as they are, deflated, at their exact size; bars and strokes as outlines. Viewers are
// told to print without scaling.
//
// Source: ISO 32000-1: 7.4.4 (Flate and its predictors), 8.9 (images), 14.11.2 (boxes); version 1.6 for pictures of 16
// bits and PrintScaling. Errors: core::ImageError, with the path and the reason; the file appears when it is whole, and
// what stood there before stays until then. One thread.
#pragma once

#include <filesystem>
#include <memory>

#include "tools/lentray-print/page.h"

namespace lentray::print {

/// The longest side of a page, in mm: 14400 units of 1/72 inch, where readers end (ISO 32000-1, annex C).
inline constexpr double kLongestPdfSide = 14400.0 / 72.0 * kInch;

/// A file of several pages that come one after another.
class PdfFile {
 public:
  explicit PdfFile(const std::filesystem::path& path);
  ~PdfFile();
  void add(const Page& page);
  void finish();

 private:
  struct Parts;
  std::unique_ptr<Parts> m_parts;
};

}  // namespace lentray::print
