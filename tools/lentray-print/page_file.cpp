#include "tools/lentray-print/page_file.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "camera/text.h"
#include "core/image/writer.h"
#include "parser/options/ini.h"
#include "tools/common/version.h"
#include "tools/lentray-print/page_raster.h"
#include "tools/lentray-print/pdf.h"

namespace lentray::print {

namespace fs = std::filesystem;

namespace {

constexpr std::uint32_t kRowsAtOnce = 64;
constexpr std::uint32_t kMostPixels = 300000;  ///< a side: a row of them is drawn in floats

bool is_pdf(const fs::path& path) { return parser::same_word(path.extension().string(), ".pdf"); }

void check_pixels(const Page& page, const fs::path& path) {
  const double longest =
      std::max(page.width / page.pixel_width(), page.height / page.pixel_height());
  if (longest <= kMostPixels) return;
  throw core::ImageError("cannot write '" + path.string() + "': a page of " +
                         camera::format(std::ceil(longest)) +
                         " pixels a side is too large; 300000 are possible");
}

/// PNG gives whole pixels a metre: what that changes of the page, in mm.
double png_error(double length, double dpi) {
  const double metric = dpi / kInch * 1000.0;
  return std::fabs(length * (metric / std::round(metric) - 1.0));
}

void warn_of_png(const Page& page, const fs::path& path, std::vector<std::string>& warnings) {
  constexpr double kTolerated = 0.01;  // mm
  const double error =
      std::max(png_error(page.width, page.dpi_x), png_error(page.height, page.dpi_y));
  if (error <= kTolerated) return;
  warnings.push_back("'" + path.string() +
                     "': PNG holds whole pixels a metre only, which makes the page " +
                     camera::format(error) + " mm too long or short; TIFF and PDF are exact");
}

std::unique_ptr<core::PictureWriter> write_pixels(const Page& page, const fs::path& path,
                                                  int bits) {
  core::ImageFormat format;
  format.type = core::file_type_of(path);
  format.bits = bits;
  format.working_srgb = true;  // values go into the file as they are
  core::ImageMetadata metadata;
  metadata.dpi_x = page.dpi_x;
  metadata.dpi_y = page.dpi_y;
  metadata.software = std::string("Lentray ") + tool::kVersion;
  metadata.description = page.title;
  metadata.profile = page.profile();
  if (!metadata.profile.empty() && page.pictures[0].image.channels == 1) {
    throw core::ImageError(
        "cannot write '" + path.string() +
        "': pixels of a page are colours, and the picture's profile is of greys: "
        "--profile srgb converts it, and a .pdf keeps it");
  }
  const std::uint32_t width = page.columns(), height = page.rows();
  auto writer = std::make_unique<core::PictureWriter>(path, width, height, format, metadata);
  for (std::uint32_t row = 0; row < height; row += kRowsAtOnce)
    writer->put(drawn(page, {0, row, width, std::min(kRowsAtOnce, height - row)}));
  return writer;
}

}  // namespace

void check_page_file(const fs::path& path) {
  if (!is_pdf(path)) {
    const auto extension = path.extension();
    bool is_known = true;
    try {
      const core::FileType type = core::file_type_of(path);
      is_known = type == core::FileType::png || type == core::FileType::tiff;
    } catch (const core::ImageError&) {
      is_known = false;
    }
    if (!is_known) {
      throw core::ImageError("cannot write '" + path.string() +
                             "': pages are .pdf, .tif or .png, not '" + extension.string() + "'");
    }
  }
}

fs::path file_of(const fs::path& path, const std::string& suffix) {
  if (is_pdf(path)) return path;
  fs::path out = path;
  out.replace_filename(path.stem().string() + suffix + path.extension().string());
  return out;
}

std::vector<std::string> write_pages(const std::vector<PageSource>& pages, const fs::path& path,
                                     int bits) {
  check_page_file(path);
  std::vector<std::string> warnings;
  if (is_pdf(path)) {
    PdfFile file(path);
    for (const PageSource& source : pages) file.add(source.make());
    file.finish();
    return warnings;
  }
  const bool is_png = core::file_type_of(path) == core::FileType::png;
  std::vector<std::unique_ptr<core::PictureWriter>> writers;
  for (const PageSource& source : pages) {
    const Page page = source.make();
    const fs::path place = file_of(path, source.suffix);
    check_pixels(page, place);
    if (is_png) warn_of_png(page, place, warnings);
    writers.push_back(write_pixels(page, place, bits));
  }
  for (const auto& writer : writers) writer->finish();
  return warnings;
}

}  // namespace lentray::print
