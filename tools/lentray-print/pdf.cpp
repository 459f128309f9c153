#include "tools/lentray-print/pdf.h"

#include <zlib.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/base/formed.h"
#include "core/image/byte_file.h"
#include "core/image/file_swap.h"
#include "core/image/writer.h"
#include "tools/common/version.h"
#include "tools/lentray-print/report_text.h"

namespace lentray::print {
namespace {

/// With six digits behind the point: a fraction of a micrometre in points, and no exponents, which PDF has not.
std::string number(double value) {
  const std::string out = short_number(value, 6);
  return out == "-0" ? "0" : out;
}

double points(double mm) { return mm * 72.0 / kInch; }

std::string colour(const Colour& c) {
  return number(c.red) + " " + number(c.green) + " " + number(c.blue);
}

/// A text between parentheses; bytes beyond ASCII are not shown.
std::string literal(const std::string& text) {
  std::string out = "(";
  for (const char c : text) {
    if (c == '(' || c == ')' || c == '\\') out += '\\';
    out += c >= ' ' && c <= '~' ? c : '?';
  }
  return out + ")";
}

/// A box in PDF's coordinates, which begin at the lower left.
std::string rectangle(const Box& box, double page_height) {
  return "[" + number(points(box.left)) + " " + number(points(page_height - box.bottom())) + " " +
         number(points(box.right())) + " " + number(points(page_height - box.top)) + "]";
}

/// Pixels by which a picture ends within its place on either side. Renderers widen a picture to all pixels of theirs that
/// it touches: were it a hair too large, they would draw it a pixel wider, and resample it for that.
constexpr double kInset = 0.002;

/// The operators that draw a page, pictures by their number.
std::string operators(const Page& page) {
  const auto y = [&page](double mm) { return number(points(page.height - mm)); };
  std::string out;
  if (!(page.background == kWhite)) {
    out += colour(page.background) + " rg 0 0 " + number(points(page.width)) + " " +
           number(points(page.height)) + " re f\n";
  }
  for (std::size_t i = 0; i < page.pictures.size(); ++i) {
    const Picture& p = page.pictures[i];
    const double width = (p.image.width - 2.0 * kInset) * page.pixel_width();
    const double height = (p.image.height - 2.0 * kInset) * page.pixel_height();
    const double left = (static_cast<double>(p.column) + kInset) * page.pixel_width();
    const double bottom = (static_cast<double>(p.row) + kInset) * page.pixel_height() + height;
    out += "q " + number(points(width)) + " 0 0 " + number(points(height)) + " " +
           number(points(left)) + " " + y(bottom) + " cm /P" + std::to_string(i) + " Do Q\n";
  }
  out += colour(page.ink) + " rg " + colour(page.ink) + " RG 1 J 1 j\n";
  for (const Box& bar : page.bars) {
    out += number(points(bar.left)) + " " + y(bar.bottom()) + " " + number(points(bar.width)) +
           " " + number(points(bar.height)) + " re f\n";
  }
  for (const Stroke& stroke : page.strokes) {
    out += number(points(stroke.width)) + " w";
    const char* how = " m";
    for (const Point& p : stroke.points) {
      out += " " + number(points(p.x)) + " " + y(p.y) + how;
      how = " l";
    }
    out += " S\n";
  }
  return out;
}

/// Rows of a picture as the predictor "up" has them: each byte less the one above, and the most significant byte of 16
/// bits first.
class PictureRows {
 public:
  explicit PictureRows(const core::StoredImage& image)
      : m_image(image),
        m_values(std::size_t{image.width} * static_cast<std::size_t>(image.channels)),
        m_row(m_values * static_cast<std::size_t>(image.bits / 8)), m_above(m_row.size()),
        m_coded(m_row.size() + 1) {}

  const std::vector<std::uint8_t>& next(std::uint32_t row) {
    constexpr std::uint8_t kUp = 2;
    for (std::size_t i = 0; i < m_values; ++i) {
      const auto value = static_cast<unsigned>(m_image.samples[row * m_values + i]);
      if (m_image.bits == 8) {
        m_row[i] = static_cast<std::uint8_t>(value);
      } else {
        m_row[2 * i] = static_cast<std::uint8_t>(value >> 8);
        m_row[2 * i + 1] = static_cast<std::uint8_t>(value & 0xffu);
      }
    }
    m_coded[0] = kUp;
    for (std::size_t i = 0; i < m_row.size(); ++i)
      m_coded[i + 1] = static_cast<std::uint8_t>(m_row[i] - m_above[i]);
    m_above = m_row;
    return m_coded;
  }

 private:
  const core::StoredImage& m_image;
  const std::size_t m_values;
  std::vector<std::uint8_t> m_row, m_above, m_coded;
};

/// zlib's stream, part by part.
class Deflater {
 public:
  Deflater() {
    if (deflateInit(&m_stream, Z_DEFAULT_COMPRESSION) != Z_OK)
      throw std::runtime_error("no memory");
  }
  ~Deflater() { deflateEnd(&m_stream); }
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;

  /// Calls `write` with what has come out.
  template <class Write>
  void put(const std::vector<std::uint8_t>& bytes, bool is_last, const Write& write) {
    m_stream.next_in = const_cast<Bytef*>(bytes.data());
    m_stream.avail_in = static_cast<uInt>(bytes.size());
    do {
      m_stream.next_out = m_buffer.data();
      m_stream.avail_out = static_cast<uInt>(m_buffer.size());
      deflate(&m_stream, is_last ? Z_FINISH : Z_NO_FLUSH);
      write(m_buffer.data(), m_buffer.size() - m_stream.avail_out);
    } while (m_stream.avail_out == 0);
  }

 private:
  z_stream m_stream{};
  std::vector<std::uint8_t> m_buffer = std::vector<std::uint8_t>(std::size_t{1} << 16);
};

}  // namespace

struct PdfFile::Parts {
  explicit Parts(const std::filesystem::path& place)
      : path(place), swap(place), file(swap.temporary()) {}

  void write(const std::string& text) {
    file.write(text);
    offset += text.size();
  }
  int new_number() {
    offsets.push_back(0);
    return static_cast<int>(offsets.size());
  }
  void begin(int object) {
    offsets[static_cast<std::size_t>(object) - 1] = offset;
    write(std::to_string(object) + " 0 obj\n");
  }
  void put(int object, const std::string& text) {
    begin(object);
    write(text + "\nendobj\n");
  }

  int put_profile(const core::StoredImage& image) {
    const int object = new_number();
    put(object, "<</N " + std::to_string(image.channels) + "/Length " +
                    std::to_string(image.profile.size()) + ">>\nstream\n" + image.profile +
                    "\nendstream");
    return object;
  }

  int put_picture(const core::StoredImage& image) {
    const std::string channels = std::to_string(image.channels);
    const std::string colours =
        image.profile.empty() ? std::string("/Device") + (image.channels == 1 ? "Gray" : "RGB")
                              : "[/ICCBased " + std::to_string(put_profile(image)) + " 0 R]";
    const int object = new_number(), length = new_number();
    begin(object);
    write("<</Type/XObject/Subtype/Image/Width " + std::to_string(image.width) + "/Height " +
          std::to_string(image.height) + "/BitsPerComponent " + std::to_string(image.bits) +
          "/ColorSpace" + colours + "/Filter/FlateDecode/DecodeParms<</Predictor 12/Colors " +
          channels + "/BitsPerComponent " + std::to_string(image.bits) + "/Columns " +
          std::to_string(image.width) + ">>/Length " + std::to_string(length) + " 0 R>>\nstream\n");
    const std::uint64_t start = offset;
    PictureRows rows(image);
    Deflater deflater;
    for (std::uint32_t row = 0; row < image.height; ++row) {
      deflater.put(rows.next(row), row + 1 == image.height,
                   [this](const std::uint8_t* bytes, std::size_t size) {
                     file.write(bytes, size);
                     offset += size;
                   });
    }
    const std::uint64_t size = offset - start;
    write("\nendstream\nendobj\n");
    put(length, std::to_string(size));
    return object;
  }

  void put_page(const Page& page) {
    std::string pictures;
    for (std::size_t i = 0; i < page.pictures.size(); ++i) {
      pictures += "/P" + std::to_string(i) + " " +
                  std::to_string(put_picture(page.pictures[i].image)) + " 0 R";
    }
    const int content = new_number(), object = new_number();
    const std::string drawing = operators(page);
    put(content,
        "<</Length " + std::to_string(drawing.size()) + ">>\nstream\n" + drawing + "endstream");
    std::string text = "<</Type/Page/Parent 2 0 R/MediaBox[0 0 " + number(points(page.width)) +
                       " " + number(points(page.height)) + "]";
    if (page.trim.width > 0.0) text += "/TrimBox" + rectangle(page.trim, page.height);
    if (page.bleed.width > 0.0) text += "/BleedBox" + rectangle(page.bleed, page.height);
    put(object, text + "/Resources<</XObject<<" + pictures + ">>>>/Contents " +
                    std::to_string(content) + " 0 R>>");
    pages.push_back(object);
    if (title.empty()) title = page.title;
  }

  void put_end() {
    std::string kids;
    for (const int page : pages) kids += std::to_string(page) + " 0 R ";
    put(1, "<</Type/Catalog/Pages 2 0 R/ViewerPreferences<</PrintScaling/None>>>>");
    put(2, "<</Type/Pages/Count " + std::to_string(pages.size()) + "/Kids[" + kids + "]>>");
    const int information = new_number();
    put(information, "<</Title" + literal(title) + "/Producer" +
                         literal(std::string("Lentray ") + tool::kVersion) + ">>");
    const std::uint64_t table = offset;
    write("xref\n0 " + std::to_string(offsets.size() + 1) + "\n0000000000 65535 f \n");
    for (const std::uint64_t at : offsets) {
      write(core::formed("%010llu 00000 n \n", static_cast<unsigned long long>(at)));
    }
    write("trailer\n<</Size " + std::to_string(offsets.size() + 1) + "/Root 1 0 R/Info " +
          std::to_string(information) + " 0 R>>\nstartxref\n" + std::to_string(table) +
          "\n%%EOF\n");
  }

  const std::filesystem::path path;
  core::FileSwap swap;
  core::ByteFile file;
  std::uint64_t offset = 0;
  std::vector<std::uint64_t> offsets{
      0, 0};  ///< of objects 1, 2, ...; these two are the catalogue and the pages
  std::vector<int> pages{};
  std::string title{};
};

namespace {

template <class Work>
void guard_pdf(const std::filesystem::path& path, const Work& work) {
  try {
    work();
  } catch (const core::ImageError&) {
    throw;
  } catch (const std::runtime_error& e) {
    throw core::ImageError("cannot write " + core::shown_place(path) + ": " + e.what());
  }
}

}  // namespace

PdfFile::PdfFile(const std::filesystem::path& path) {
  guard_pdf(path, [&] {
    m_parts = std::make_unique<Parts>(path);
    m_parts->write("%PDF-1.6\n%\xE2\xE3\xCF\xD3\n");
  });
}

PdfFile::~PdfFile() = default;

void PdfFile::add(const Page& page) {
  if (page.width > kLongestPdfSide || page.height > kLongestPdfSide) {
    throw core::ImageError("cannot write " + core::shown_place(m_parts->path) +
                           ": a page of PDF is 5080 mm long at most; TIFF files may be longer, and "
                           "--paper with --tiles cuts the sheet");
  }
  guard_pdf(m_parts->path, [&] { m_parts->put_page(page); });
}

void PdfFile::finish() {
  guard_pdf(m_parts->path, [&] {
    m_parts->put_end();
    m_parts->file.close();
    m_parts->swap.commit();
  });
}

}  // namespace lentray::print
