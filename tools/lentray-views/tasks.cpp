#include "tools/lentray-views/tasks.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

#include "camera/lenticular.h"
#include "camera/text.h"
#include "core/image/orientation.h"
#include "core/image/run_files.h"
#include "core/image/writer.h"
#include "parser/options/ini.h"
#include "parser/options/lens_sheets.h"
#include "tools/common/natural_order.h"
#include "tools/common/own_folder.h"
#include "tools/common/photo_reader.h"
#include "tools/common/process.h"
#include "tools/lentray-views/interlace_plan.h"
#include "tools/lentray-views/lens_words.h"
#include "tools/lentray-views/moving.h"
#include "tools/lentray-views/preview.h"
#include "tools/lentray-views/slanted.h"
#include "tools/lentray-views/source.h"
#include "tools/lentray-views/wiggle.h"

namespace lentray::views {
namespace {

namespace fs = std::filesystem;
using core::ImageError;
using core::StoredImage;

std::string number_text(std::uint32_t number, std::size_t digits) {
  std::string text = std::to_string(number);
  if (text.size() < digits) text.insert(0, digits - text.size(), '0');
  return text;
}

/// The name that is asked for, or the first picture's with that end, in the current folder.
fs::path out_or(const Arguments& a, const std::string& end) {
  if (!a.out.empty()) return a.out;
  return a.pictures[0].stem().string() + end + ".png";
}

/// Files are asked for before anything is computed, and no picture takes the place of its source.
void check_place(const Arguments& a, const fs::path& out) {
  for (const fs::path& source : a.pictures) core::note_input(source);
  if (!a.like.empty()) core::note_input(a.like);
  core::check_writable(out);
}

/// Of one of several views: # becomes the number, or it stands before the extension.
fs::path numbered(const fs::path& pattern, std::uint32_t view, std::uint32_t count) {
  std::string name = pattern.filename().string();
  const std::size_t digits = std::to_string(count - 1).size(), first = name.find('#');
  if (first != std::string::npos) {
    const std::size_t end = std::min(name.find_first_not_of('#', first), name.size());
    name.replace(first, end - first, number_text(view, std::max(digits, end - first)));
    return pattern.parent_path() / name;
  }
  return pattern.parent_path() /
         (pattern.stem().string() + number_text(view, digits) + pattern.extension().string());
}

/// The views that are asked for, of `count`.
Range range_of(const Arguments& a, std::uint32_t count) {
  const Range range = a.range.value_or(Range{0, count - 1});
  if (range.last >= count) refuse_view(range.last, count);
  return range;
}

/// Its size as it is seen.
std::string wrote(const fs::path& path, const StoredImage& image, bool is_on_its_side = false) {
  return path.string() + ": " + std::to_string(is_on_its_side ? image.height : image.width) +
         " x " + std::to_string(is_on_its_side ? image.width : image.height) + " pixels\n";
}

std::string describe(const Arguments& a, tool::PhotoReader& reader) {
  const Integral integral = open_integral(a.pictures[0], a.sheet, reader);
  const camera::LensSheet& sheet = integral.sheet.lenses;
  const camera::LensParameters& lens = sheet.lens();
  const std::uint32_t width = integral.image.width, height = integral.image.height;
  std::string out = integral.name + ": " + std::to_string(integral.is_across ? height : width) +
                    " x " + std::to_string(integral.is_across ? width : height) + " pixels, " +
                    camera::format(sheet.counted_lenses()) + " lenses of " +
                    camera::format(lens.pixels) + " pixels" +
                    (integral.is_across ? ", which lie across: view 0 is seen from below\n" : "\n");
  out += "Views 0 to " + std::to_string(camera::usual_views(sheet) - 1) + ", lenses 0 to " +
         std::to_string(sheet.lens_count() - 1) + "\n";
  if (!integral.sheet.missing.empty()) {
    return out + "Nothing is known of " + integral.sheet.missing + "\n";
  }
  return out + "Lens pitch " + camera::format(lens.pitch) + " mm, focal length " +
         camera::format(lens.focal_length) + " mm, index " + camera::format(lens.ior) + ", model " +
         camera::name_of(lens.model) + ", viewing distance " +
         (lens.is_finite() ? camera::format(lens.view_distance) + " mm" : "infinite") +
         slant_text(integral.sheet) + "\n";
}

About about_view(const Facts& facts, std::uint32_t view, std::uint32_t count) {
  About about{facts, {}};
  about.facts["lens.view"] = std::to_string(view);
  about.facts["lens.view_count"] = std::to_string(count);
  return about;
}

std::string write_views(const Arguments& a, tool::PhotoReader& reader) {
  const auto source = open_source(a, a.count.value_or(0), reader);
  const std::uint32_t count = source->count();
  const Range range = range_of(a, count);
  const bool is_one = range.first == range.last && !a.out.empty() &&
                      a.out.filename().string().find('#') == std::string::npos;
  const auto path_of = [&](std::uint32_t view) {
    return is_one ? a.out : numbered(out_or(a, "_view"), view, count);
  };
  for (std::uint32_t view = range.first; view <= range.last; ++view) check_place(a, path_of(view));
  std::string said;
  for (std::uint32_t view = range.first; view <= range.last; ++view) {
    const fs::path path = path_of(view);
    const StoredImage image = source->view(view);
    write_picture(image, path, about_view(source->facts(), view, count));
    said += wrote(path, image);
  }
  return said;
}

std::string write_one(const Arguments& a, const StoredImage& image, const fs::path& path,
                      const About& about) {
  check_place(a, path);
  write_picture(image, path, about);
  return wrote(path, image, about.orientation != 1);
}

std::string write_lens(const Arguments& a, tool::PhotoReader& reader) {
  const Integral integral = open_integral(a.pictures[0], a.sheet, reader);
  refuse_slanted(integral.sheet, integral.name, "no columns lie behind one of them alone");
  About about{integral.facts, {}};
  about.facts["lens.lens"] = std::to_string(a.lens);
  StoredImage behind = lens_of(integral.image, integral.sheet.lenses, a.lens);
  if (integral.is_across) behind = core::upright(std::move(behind), core::kTurned);
  return write_one(a, behind, out_or(a, "_lens" + std::to_string(a.lens)), about);
}

void add_eye(const Eye& eye, Facts& facts) {
  facts["eye.angle_degrees"] = exact(eye.angle);
  facts["eye.distance_mm"] = exact(eye.distance);
}

std::string write_eye(const Arguments& a, tool::PhotoReader& reader) {
  const Integral integral = open_integral(a.pictures[0], a.sheet, reader);
  need_optics(integral.sheet, integral.name);
  const Eye eye = eye_of(a, integral);
  const StoredImage seen = seen_by(integral.image, integral.sheet, eye, a.between);
  About about{integral.facts, {}};
  add_eye({integral.is_across ? -eye.angle : eye.angle, eye.distance}, about.facts);
  return write_one(a, in_size(seen, a, integral), out_or(a, "_eye"), about);
}

std::string write_quilt(const Arguments& a, tool::PhotoReader& reader) {
  const std::uint32_t count = a.columns * a.rows;
  if (a.count && *a.count != count) {
    throw ImageError("--count " + std::to_string(*a.count) + " and a quilt of " +
                     std::to_string(count) + " views contradict each other");
  }
  const auto source = open_source(a, count, reader);
  if (source->count() != count) {
    throw ImageError("a quilt of " + std::to_string(a.columns) + " x " + std::to_string(a.rows) +
                     " views wants as many pictures, not " + std::to_string(source->count()));
  }
  if (a.pictures.size() == 1 && (a.sheet.across || tool::lies_across(source->facts()))) {
    throw ImageError("the lenses of '" + a.pictures[0].string() +
                     "' lie across: its views are seen from below to above, and a quilt is for "
                     "displays whose views lie beside each other");
  }
  std::vector<StoredImage> tiles;
  for (std::uint32_t i = 0; i < count; ++i) tiles.push_back(source->view(count - 1 - i));
  const double known = source->aspect();
  const double aspect = known > 0.0 ? known : double(tiles[0].width) / tiles[0].height;
  About about{source->facts(), {}};
  about.facts["lens.view_count"] = std::to_string(count);
  about.facts["quilt.columns"] = std::to_string(a.columns);
  about.facts["quilt.rows"] = std::to_string(a.rows);
  about.facts["quilt.aspect"] = camera::format(aspect);
  return write_one(a, quilt_of(tiles, a.columns),
                   out_or(a, quilt_suffix(a.columns, a.rows, aspect)), about);
}

std::string write_pair(const Arguments& a, tool::PhotoReader& reader) {
  const auto source = open_source(a, a.count.value_or(0), reader);
  const Source::Pair pair = source->pair();
  for (const std::string& warning : source->warnings()) reader.warn(warning);
  About about{source->facts(), {}};
  if (a.task == Task::kStereo) {
    about.facts["stereo"] = "left, right";
    return write_one(a, side_by_side(pair.left, pair.right), out_or(a, "_stereo"), about);
  }
  about.facts["stereo"] = "red-cyan anaglyph";
  return write_one(a, anaglyph(pair.left, pair.right, a.anaglyph), out_or(a, "_anaglyph"), about);
}

std::string write_wiggle(const Arguments& a, tool::PhotoReader& reader) {
  const std::string end = a.out.extension().string();
  const bool is_gif = parser::same_word(end, ".gif");
  if (!is_gif && !parser::same_word(end, ".png")) {
    throw ImageError("cannot write '" + a.out.string() +
                     "': moving pictures are .gif and .png files");
  }
  check_place(a, a.out);
  const auto source = open_source(a, a.count.value_or(0), reader);
  const Range range = range_of(a, source->count());
  const std::vector<StoredImage> frames = frames_of(a, *source, range);
  tool::write_whole(a.out, is_gif ? gif_of(frames, a.delay) : apng_of(frames, a.delay));
  return a.out.string() + ": " + std::to_string(frames.size()) + " frames of " +
         std::to_string(frames[0].width) + " x " + std::to_string(frames[0].height) + " pixels\n";
}

std::string write_preview(const Arguments& a, tool::PhotoReader& reader) {
  const std::string end = a.out.extension().string();
  if (!parser::same_word(end, ".html") && !parser::same_word(end, ".htm")) {
    throw ImageError("cannot write '" + a.out.string() + "': a preview is a .html file");
  }
  check_place(a, a.out);
  tool::refuse_foreign_page(a.out, "lentray-views");
  const Preview preview = preview_of(open_integral(a.pictures[0], a.sheet, reader), a);
  tool::write_whole(a.out, preview.page);
  return a.out.string() + ": " + preview.told + "\n";
}

std::string write_interlaced(const Arguments& a, tool::PhotoReader& reader) {
  const fs::path out = out_or(a, "_sheet");
  check_place(a, out);
  const PlannedSheet sheet = planned_sheet(a, reader);
  const std::uint32_t views = sheet.plan.views;
  Interlacer interlacer(sheet.plan);
  warn_of_stretch(a, sheet, reader);
  for (std::uint32_t i = 0; i < views; ++i) {
    const std::string name = a.pictures[i].string();
    StoredImage picture = reader.read(a.pictures[i]);
    if (!a.takes_any) check_no_integral(picture, name);
    if (sheet.is_across) picture = core::upright(std::move(picture), core::kTurnedBack);
    interlacer.put(a.from_left ? views - 1 - i : i, picture, name);
  }
  std::string said = write_one(a, interlacer.result(), out, sheet.about);
  for (const std::string& line : sheet.lines) said += line + "\n";
  return said;
}

std::string run_task(const Arguments& arguments, tool::PhotoReader& reader) {
  switch (arguments.task) {
    case Task::kDescribe: break;
    case Task::kViews: return write_views(arguments, reader);
    case Task::kLens: return write_lens(arguments, reader);
    case Task::kQuilt: return write_quilt(arguments, reader);
    case Task::kEye: return write_eye(arguments, reader);
    case Task::kStereo:
    case Task::kAnaglyph: return write_pair(arguments, reader);
    case Task::kWiggle: return write_wiggle(arguments, reader);
    case Task::kPreview: return write_preview(arguments, reader);
    case Task::kInterlace: return write_interlaced(arguments, reader);
    case Task::kListSheets: break;
  }
  return describe(arguments, reader);
}

}  // namespace

Report do_task(const Arguments& given) {
  Arguments arguments = given;
  Report report;
  if (given.task == Task::kListSheets) {
    report.said = parser::lens_sheet_list(given.lens_words, parser::installed_lens_sheet_files());
    return report;
  }
  complete_lens(arguments.lens_words, arguments.sheet, arguments.size_mm.has_value());
  if (!given.given_order) {
    if (auto files = tool::natural_order_instead(given.pictures)) {
      arguments.pictures = std::move(*files);
      report.said = tool::natural_order_line(arguments.pictures) + "\n";
    }
  }
  tool::PhotoReader reader(arguments.profiles);
  report.said += run_task(arguments, reader);
  report.warnings = reader.warnings();
  return report;
}

}  // namespace lentray::views
