// Images of descriptions -> the kernel's pictures: files are decoded to the scene's working space,
// functions are evaluated. Internal to parser/compile.
// Source: reference manual 3.7, "Image Map", "Gamma"; compared with stock by tests/image/pictures_test.cpp.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "core/image/reader.h"
#include "core/material/picture.h"
#include "parser/descriptions/pattern.h"

namespace lentray::parser {

/// Reads each file once. Pictures that cannot be had are named in `not_yet` and are one grey pixel.
class PictureReader {
 public:
  explicit PictureReader(std::set<std::string>& not_yet) : m_not_yet(not_yet) {}
  /// `colours`: decoded to the working space; heights and patterns are taken as stored.
  core::MappedPicturePtr get(const ImageDesc& image, bool colours);
  std::uint64_t bytes() const { return m_bytes; }  ///< of all that it gave

 private:
  std::shared_ptr<const core::Picture> read(const ImageDesc& image, bool colours);
  std::shared_ptr<const core::Picture> read_file(const ImageDesc& image, bool colours);
  std::shared_ptr<const core::Picture> evaluate(const ImageDesc& image);
  std::shared_ptr<const core::Picture> missing(const std::string& name);

  std::set<std::string>& m_not_yet;
  std::map<std::string, std::shared_ptr<const core::Picture>> m_files;  ///< by path and decoding
  std::set<std::shared_ptr<const core::Picture>> m_given;
  std::uint64_t m_bytes = 0;
};

}  // namespace lentray::parser
