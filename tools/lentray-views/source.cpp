#include "tools/lentray-views/source.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "camera/lenticular.h"
#include "core/image/orientation.h"
#include "core/image/writer.h"
#include "tools/lentray-views/quilt_source.h"
#include "tools/lentray-views/slanted.h"
#include "tools/lentray-views/zones.h"

namespace lentray::views {
namespace {

using core::ImageError;
using core::StoredImage;

constexpr double kArmsLength = 400.0;  // mm: of two eyes before a sheet for infinitely distant ones

class IntegralSource final : public Source {
 public:
  IntegralSource(const Arguments& arguments, std::uint32_t count, Integral integral)
      : m_arguments(arguments), m_integral(std::move(integral)) {
    const camera::LensSheet& lenses = m_integral.sheet.lenses;
    m_count = count > 0 ? count : camera::usual_views(lenses);
    // What becomes one picture has one width: without a last lens that lacks some views.
    if (arguments.task != Task::kViews) m_width = camera::view_width(lenses, m_count - 1, m_count);
  }
  std::uint32_t count() const override { return m_count; }
  StoredImage view(std::uint32_t view) const override {
    StoredImage strip = view_of(m_integral.image, m_integral.sheet, view, m_count);
    if (m_width > 0 && strip.width > m_width) {
      StoredImage part = blank_like(strip, m_width, strip.height);
      copy_pixels(strip, {0, 0, m_width, strip.height}, part, 0, 0);
      strip = std::move(part);
    }
    return in_size(strip, m_arguments, m_integral);
  }
  Pair pair() const override {
    if (m_arguments.pair) {
      return {view(m_arguments.pair->first), view(m_arguments.pair->last)};
    }
    const EyePair eyes = eyes_of_pair();
    return {seen(eyes.left), seen(eyes.right)};
  }
  std::vector<std::string> warnings() const override {
    if (m_integral.is_across) {
      return {"the lenses of '" + m_integral.name +
              "' lie across: two eyes beside each other see the same view, and no depth"};
    }
    if (m_arguments.pair) return warnings_of_views(*m_arguments.pair);
    return warnings_of_eyes(m_integral.sheet, eyes_of_pair());
  }
  double aspect() const override {
    const double aspect = m_integral.sheet.aspect;
    return m_integral.is_across && aspect > 0.0 ? 1.0 / aspect : aspect;
  }
  const Facts& facts() const override { return m_integral.facts; }

 private:
  EyePair eyes_of_pair() const {
    need_optics(m_integral.sheet, m_integral.name);
    Eye middle = eye_of(m_arguments, m_integral);
    if (middle.distance <= 0.0) middle.distance = kArmsLength;
    if (m_integral.is_across) return {middle, middle};
    return m_arguments.one_zone ? eyes_in_one_zone(m_integral.sheet, middle, m_arguments.eyes)
                                : eyes_beside(middle, m_arguments.eyes);
  }
  StoredImage seen(const Eye& eye) const {
    return in_size(seen_by(m_integral.image, m_integral.sheet, eye, m_arguments.between),
                   m_arguments, m_integral);
  }

  const Arguments& m_arguments;
  Integral m_integral;
  std::uint32_t m_count = 0, m_width = 0;  ///< 0: as each view has it
};

class PictureSource final : public Source {
 public:
  PictureSource(const Arguments& arguments, tool::PhotoReader& reader)
      : m_arguments(arguments), m_reader(reader), m_paths(arguments.pictures) {
    if (arguments.square) {
      throw ImageError(
          "--square is of integral images: these pictures have a size, --size another");
    }
    if (arguments.from_left) std::ranges::reverse(m_paths);
    m_facts = facts_of(m_reader.read(m_paths[0]));
    for (const char* one : {"lens.view", "lens.view_offset_mm"}) m_facts.erase(one);
  }
  std::uint32_t count() const override { return static_cast<std::uint32_t>(m_paths.size()); }
  StoredImage view(std::uint32_t view) const override {
    if (view >= count()) refuse_view(view, count());
    StoredImage image = m_reader.read(m_paths[view]);
    if (!m_arguments.size) return image;
    return resized(image, m_arguments.size->width, m_arguments.size->height, m_arguments.filter);
  }
  Pair pair() const override {
    if (m_arguments.pair) return {view(m_arguments.pair->first), view(m_arguments.pair->last)};
    if (count() != 2) {
      throw ImageError("of these " + std::to_string(count()) +
                       " pictures --pair L,R gives the left and the right eye's");
    }
    // As they were named: the left eye's first.
    const bool turned = m_arguments.from_left;
    return {view(turned ? 1 : 0), view(turned ? 0 : 1)};
  }
  std::vector<std::string> warnings() const override {
    return m_arguments.pair ? warnings_of_views(*m_arguments.pair) : std::vector<std::string>();
  }
  double aspect() const override {
    if (m_arguments.sheet.aspect) return *m_arguments.sheet.aspect;
    const double width = number_in(m_facts, "lens.sheet_width_mm", m_paths[0].string()),
                 height = number_in(m_facts, "lens.sheet_height_mm", m_paths[0].string());
    if (!(width > 0.0) || !(height > 0.0)) return 0.0;
    return tool::lies_across(m_facts) ? height / width : width / height;
  }
  const Facts& facts() const override { return m_facts; }

 private:
  const Arguments& m_arguments;
  tool::PhotoReader& m_reader;
  std::vector<std::filesystem::path> m_paths;  ///< by view
  Facts m_facts;
};

}  // namespace

Integral open_integral(const std::filesystem::path& path, const SheetOptions& options,
                       tool::PhotoReader& reader) {
  return integral_of(reader.read(path), path, options, reader);
}

Integral integral_of(StoredImage image, const std::filesystem::path& path,
                     const SheetOptions& options, tool::PhotoReader& reader) {
  Facts facts = facts_of(image);
  const bool is_across = options.across || tool::lies_across(facts);
  if (is_across) image = core::upright(std::move(image), core::kTurnedBack);
  Sheet sheet = sheet_of(image, options, path.string());
  if (const std::string change = tool::height_change_of(image, facts, path.string());
      !change.empty() && !options.pixels) {
    reader.warn(change);
  }
  return {std::move(image), std::move(sheet), std::move(facts), path.string(), is_across};
}

namespace {

/// Of a sheet on its side: on its side too.
StoredImage in_size_of_sheet(const StoredImage& strip, const Arguments& arguments,
                             const Integral& integral) {
  if (arguments.size) {
    const auto [width, height] = *arguments.size;
    return integral.is_across ? resized(strip, height, width, arguments.filter)
                              : resized(strip, width, height, arguments.filter);
  }
  if (!arguments.square) return strip;
  // A last lens that is cut counts as a whole one, or not at all.
  const double width = strip.height * need_aspect(integral.sheet, integral.name) * strip.width /
                       integral.sheet.lenses.lenses();
  return resized(strip, static_cast<std::uint32_t>(std::max(1.0, std::round(width))), strip.height,
                 arguments.filter);
}

}  // namespace

StoredImage in_size(const StoredImage& strip, const Arguments& arguments,
                    const Integral& integral) {
  StoredImage sized = in_size_of_sheet(strip, arguments, integral);
  return integral.is_across ? core::upright(std::move(sized), core::kTurned) : sized;
}

Eye eye_of(const Arguments& arguments, const Integral& integral) {
  Eye eye = arguments.eye.value_or(Eye{});
  if (integral.is_across) eye.angle = -eye.angle;
  const camera::LensParameters& lens = integral.sheet.lenses.lens();
  if (eye.distance <= 0.0 && lens.is_finite()) eye.distance = lens.view_distance;
  return eye;
}

std::unique_ptr<Source> open_source(const Arguments& arguments, std::uint32_t count,
                                    tool::PhotoReader& reader) {
  if (arguments.pictures.size() > 1) return std::make_unique<PictureSource>(arguments, reader);
  const std::filesystem::path& path = arguments.pictures[0];
  StoredImage image = reader.read(path);
  if (arguments.task == Task::kWiggle) {
    if (const auto tiles = quilt_tiles(path, facts_of(image))) {
      return quilt_source(arguments, std::move(image), *tiles);
    }
  }
  return std::make_unique<IntegralSource>(
      arguments, count, integral_of(std::move(image), path, arguments.sheet, reader));
}

}  // namespace lentray::views
