// Where views come from: an integral image, or ready pictures. In every case view 0 is the
// rightmost camera's. Errors: core::ImageError, worded for the user. One thread.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tools/common/photo_reader.h"
#include "tools/lentray-views/arguments.h"
#include "tools/lentray-views/picture.h"

namespace lentray::views {

class Source {
 public:
  virtual ~Source() = default;
  virtual std::uint32_t count() const = 0;
  /// In the size that is asked for.
  virtual core::StoredImage view(std::uint32_t view) const = 0;
  /// What the left and the right eye see.
  struct Pair {
    core::StoredImage left, right;
  };
  virtual Pair pair() const = 0;
  /// Width by height of what is shown; 0: unknown.
  virtual double aspect() const = 0;
  /// What is known of the sheet.
  virtual const Facts& facts() const = 0;
  /// What a user should know of the pair.
  virtual std::vector<std::string> warnings() const = 0;
};

/// By the arguments' pictures: one is an integral image, or a quilt that moves, several are views. `count`: views it shall
/// have; 0: the usual ones.
/// Arguments and reader must outlive it.
std::unique_ptr<Source> open_source(const Arguments& arguments, std::uint32_t count,
                                    tool::PhotoReader& reader);

/// An integral image whose sheet is known. Where lenses lie across, it is on its side, so that strips are columns.
struct Integral {
  core::StoredImage image;
  Sheet sheet;
  Facts facts;
  std::string name;
  bool is_across = false;
};
/// `image`: upright.
Integral integral_of(core::StoredImage image, const std::filesystem::path& path,
                     const SheetOptions& options, tool::PhotoReader& reader);
Integral open_integral(const std::filesystem::path& path, const SheetOptions& options,
                       tool::PhotoReader& reader);

/// A strip of a pixel a lens, upright and in the size that is asked for: --size, --square, or as it is.
core::StoredImage in_size(const core::StoredImage& strip, const Arguments& arguments,
                          const Integral& integral);
/// The eye of the arguments, before a sheet on its side to the right of it if it is below; without a distance of its own at the sheet's viewing distance.
Eye eye_of(const Arguments& arguments, const Integral& integral);

}  // namespace lentray::views
