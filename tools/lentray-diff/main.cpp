// lentray-diff: the same scene by lentray and by stock POV-Ray, compared lens by lens.
#include <algorithm>
#include <chrono>
#include <iostream>
#include <nlohmann/json.hpp>

#include "core/base/formed.h"
#include "core/image/compare.h"
#include "core/image/display.h"
#include "core/image/orientation.h"
#include "core/image/reader.h"
#include "core/image/run_files.h"
#include "core/numeric/lens_columns.h"
#include "parser/options/options.h"
#include "parser/restrictions/run_rules.h"
#include "tools/common/json_text.h"
#include "tools/common/machine.h"
#include "tools/common/own_folder.h"
#include "tools/common/process.h"
#include "tools/common/sheet_facts.h"
#include "tools/common/shell_words.h"
#include "tools/common/tool_main.h"
#include "tools/lentray-diff/arguments.h"
#include "tools/lentray-diff/noise.h"
#include "tools/lentray-diff/report.h"
#include "tools/lentray-diff/sampling.h"
#include "tools/lentray-diff/seen_mode.h"
#include "tools/lentray-diff/sheet.h"
#include "tools/lentray-diff/stock.h"

namespace lentray::diff {
namespace {

namespace fs = std::filesystem;
using core::LensComparison;
using core::StoredImage;
using nlohmann::json;

constexpr int kStocksBlock = 32;  ///< where nothing else is asked for
constexpr int kReached = 0, kBelow = 1, kError = 2;

struct Pair {
  StoredImage ours, stock;
  double lens_pixels = 0.0;  ///< 0: no integral image
  json about;
  StockRender render_stock;  ///< once more, where its noise counts; else empty
  StockOptions options;
};

struct Ours {
  StoredImage picture;
  json statistics;
  double seconds = 0.0;
};

fs::path program_beside_us(const char* name) {
  return fs::read_symlink("/proc/self/exe").parent_path() / name;
}

/// No output takes their place.
void note_what_was_read(const json& dependencies) {
  for (const auto& [path, sum] : dependencies.at("read").items()) core::note_input(path);
}

Ours render_ours(const Arguments& a) {
  if (!a.ours.empty()) {
    const json statistics = tool::parse_json(tool::read_text(a.statistics));
    return {core::read_image(a.ours), statistics, statistics.at("time").at("wall_s").get<double>()};
  }
  const tool::TemporaryFolder folder;
  const fs::path picture = folder / "ours.png", statistics = folder / "statistics.json",
                 read = folder / "read.json";
  std::vector<std::string> command{
      (a.lentray.empty() ? program_beside_us("lentray") : a.lentray).string()};
  tool::append(command, a.for_lentray);
  tool::append(
      command,
      {"+I" + a.scene.string(), "+O" + picture.string(), a.stock.bits == 16 ? "+FN16" : "+FN8",
       "-V", "+WT" + std::to_string(a.stock.processes), "Statistics_File=" + statistics.string(),
       "Dependencies_File=" + read.string()});
  tool::append(command, words(a.stock.antialiasing));
  const auto start = std::chrono::steady_clock::now();
  const tool::RunResult result = tool::run_program(command);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  std::cerr << result.output;  // its warnings are the user's to see
  if (result.status != 0) {
    throw std::runtime_error("lentray ended with status " + std::to_string(result.status));
  }
  note_what_was_read(tool::parse_json(tool::read_text(read)));
  return {core::read_image(picture), tool::parse_json(tool::read_text(statistics)), taken.count()};
}

/// How stock makes the reference.
std::string reference(Way way, const StockOptions& stock) {
  const int angles = stock.antialiasing.angles, samples = samples_a_pixel(way, stock);
  std::string text = name_of(way);
  if (samples == 1) return text;
  text += ", the mean of ";
  if (samples > angles) {
    text += std::to_string(stock.samples) + " x " + std::to_string(stock.samples) + " samples";
    if (angles > 1) text += " at ";
  }
  if (angles > 1) text += std::to_string(angles) + " directions";
  return text + " a pixel";
}

std::string describe(const Sheet& s, Way way, const StockOptions& stock) {
  const std::string distance =
      s.is_finite() ? core::formed("V = %.6g mm", s.view_distance) : "V infinite";
  return core::formed("integral image %u x %u: %.6g lenses of %.6g pixels, %s, %s; stock by ",
                      s.columns, s.rows, core::LensColumns{s.pixels}.counted(s.columns), s.pixels,
                      distance.c_str(), s.paraxial ? "paraxial" : "pinhole") +
         reference(way, stock);
}

/// `sampled`: stock takes single samples where it cannot antialias.
void say_what_to_expect(const StockOptions& stock, bool sampled) {
  if (is_random(stock.antialiasing)) {
    std::cout
        << "jitter is on, and its random numbers differ from stock's: pixels cannot be expected "
           "to be equal (-J turns it off)\n";
  }
  if (sampled && stock.antialiasing.on) {
    std::cout
        << "stock cannot antialias a mesh_camera, and takes other samples than lentray: no more "
           "than close can be expected\n";
  }
}

/// Stock's picture, and what it took.
StoredImage timed(const StockRender& render, const StockOptions& options, json& about) {
  const auto start = std::chrono::steady_clock::now();
  const double cpu_before = tool::cpu_seconds_of_children();
  StoredImage picture = render(options);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  about["stock_wall_s"] = taken.count();
  about["stock_cpu_s"] = tool::cpu_seconds_of_children() - cpu_before;
  return picture;
}

Pair render_both(const Arguments& given) {
  Arguments a = given;
  a.stock.antialiasing = antialiasing_of(a.options);
  Ours ours = render_ours(a);
  a.stock.colours = colour_spaces_of(ours.statistics, a.options);
  Pair pair;
  pair.about = {{"scene", a.scene.string()},
                {"antialiased", a.stock.antialiasing.on},
                {"width", ours.picture.width},
                {"height", ours.picture.height},
                {"lentray_wall_s", ours.seconds}};
  const bool noisy = has_noise(a.noise, ours.statistics);
  if (has_noise(AskNoise::where_it_is, ours.statistics)) a.stock.block = kStocksBlock;
  const std::optional<Sheet> sheet = sheet_of(ours.statistics);
  StockRender render;
  if (!sheet) {
    a.stock.antialiasing.angles = 1;
    say_what_to_expect(a.stock, false);
    const std::uint32_t width = ours.picture.width, height = ours.picture.height;
    std::cout << a.scene.string() << ": " << width << " x " << height << ", in its own camera\n";
    render = [scene = a.scene, width, height](const StockOptions& how) {
      return stock_picture(scene, width, height, how);
    };
    pair.about["way"] = "the scene's own camera";
  } else {
    const Way way = best_way(*sheet);
    std::cout << a.scene.string() << ": " << describe(*sheet, way, a.stock) << "\n";
    say_what_to_expect(a.stock, way == Way::mesh_camera);
    pair.about["samples_a_pixel"] = samples_a_pixel(way, a.stock);
    pair.about["way"] = name_of(way);
    pair.about["lens"] = ours.statistics["lens"];
    const std::optional<std::uint32_t> view = a.options.view;
    if (view) std::cout << "view " << *view << " alone\n";
    render = [scene = a.scene, sheet = *sheet, way, view](const StockOptions& how) {
      if (!view) return stock_integral(scene, sheet, way, how);
      StoredImage picture = stock_view(scene, sheet, *view, how);
      return sheet.turned_views ? core::upright(std::move(picture), core::kTurned) : picture;
    };
    if (!view) pair.lens_pixels = sheet->pixels;
  }
  pair.stock = timed(render, a.stock, pair.about);
  if (noisy) pair.render_stock = render;
  pair.options = a.stock;
  pair.ours = std::move(ours.picture);
  return pair;
}

/// Pixels a lens, as lentray wrote it into the file; 0 if it did not, or the picture is one view.
double lens_pixels_in(const StoredImage& image) {
  if (image.attributes.contains("lentray:lens.view")) return 0.0;
  const double pixels = tool::number_of(image.attributes, "lentray:lens.pixels");
  return pixels >= 1.0 ? pixels : 0.0;
}

Pair read_both(const Arguments& a) {
  Pair pair;
  pair.ours = core::read_image(a.pictures[0]);
  pair.stock = core::read_image(a.pictures[1]);
  pair.lens_pixels = a.options.lens.pixels.value_or(
      std::max(lens_pixels_in(pair.ours), lens_pixels_in(pair.stock)));
  pair.about = {{"pictures", {a.pictures[0].string(), a.pictures[1].string()}},
                {"width", pair.ours.width},
                {"height", pair.ours.height}};
  return pair;
}

/// Both as viewers show them. Where in a comparison of renderers one of them has no alpha because it was put together of views, that of the
/// other is left out.
Pair shown(Pair pair, bool are_files) {
  if (!are_files) {
    if (pair.stock.gamma == 0.0) pair.stock.gamma = pair.ours.gamma;
    if (pair.ours.channels != pair.stock.channels) {
      if (pair.ours.channels == 4) pair.ours = core::without_alpha(pair.ours);
      if (pair.stock.channels == 4) pair.stock = core::without_alpha(pair.stock);
    }
  }
  if (!core::is_shown_as_stored(pair.ours) || !core::is_shown_as_stored(pair.stock)) {
    pair.ours = core::displayed(pair.ours);
    pair.stock = core::displayed(pair.stock);
  }
  return pair;
}

/// Where noise counts and the pictures do not match, stock's noise grades them.
void grade_by_stocks_noise(const Pair& pair, const Pair& seen, LensComparison& result,
                           json& about) {
  if (!pair.render_stock || core::reaches(result, core::Grade::match)) return;
  const double cpu_before = tool::cpu_seconds_of_children();
  std::vector<StoredImage> others = in_other_orders(pair.render_stock, pair.options);
  for (StoredImage& other : others) {
    Pair with_other;
    with_other.ours = pair.ours;
    with_other.stock = std::move(other);
    other = shown(std::move(with_other), false).stock;
  }
  core::grade_by_noise(result, seen.stock, others);
  const double cpu = tool::cpu_seconds_of_children() - cpu_before;
  about["noise_pictures"] = others.size();
  about["noise_cpu_s"] = cpu;
  std::cout << "stock rendered " << others.size() << " times more for its noise, " << cpu
            << " s of processors\n";
}

LensComparison compare_pair(const Pair& pair) {
  if (pair.lens_pixels > 0.0) return core::compare_lenses(pair.ours, pair.stock, pair.lens_pixels);
  LensComparison result;
  result.whole = core::compare(pair.ours, pair.stock, core::Columns::all(pair.ours.width));
  return result;
}

/// The pictures that are written, by the end of their names.
std::vector<std::string> kinds_of_pictures(const Arguments& a) {
  if (a.stock_alone) return {"stock"};
  if (!a.write_pictures) return {};
  std::vector<std::string> kinds{"heat"};
  if (a.pictures.empty()) kinds.emplace_back("stock");
  if (a.pictures.empty() && a.ours.empty()) kinds.emplace_back("ours");
  if (a.ours.empty()) kinds.emplace_back("side");
  return kinds;
}

std::string picture_path(const Arguments& a, const std::string& kind) {
  return a.prefix.string() + "-" + kind + ".png";
}

void write_pictures(const Arguments& a, const Pair& pair, const Pair& seen) {
  const auto put = [&](const char* kind, const StoredImage& image) {
    const fs::path path = picture_path(a, kind);
    core::write_stored(image, path);
    std::cout << "  " << path.string() << "\n";
  };
  std::cout << "pictures:\n";
  const std::vector<std::string> kinds = kinds_of_pictures(a);
  const auto has = [&](const char* kind) { return std::ranges::find(kinds, kind) != kinds.end(); };
  if (has("ours")) put("ours", pair.ours);
  if (has("stock")) put("stock", pair.stock);
  put("heat", heat_map(seen.ours, seen.stock));
  if (has("side")) put("side", side_by_side(seen.ours, seen.stock));
}

/// With Restrict_IO=On no output goes through a link that may have come with the scene.
void judge_outputs(const Arguments& a) {
  if (!a.options.restrict_io) return;
  for (const std::string& kind : kinds_of_pictures(a)) parser::judge_output(picture_path(a, kind));
  parser::judge_output(a.json);
  for (const fs::path& folder : {a.stock.keep, a.wrappers}) {
    parser::judge_output(folder);
    if (!folder.empty()) tool::refuse_links(folder);
  }
}

/// Files are asked for before anything is rendered, and none is an input.
void check_outputs(const Arguments& a) {
  for (const fs::path& input : a.pictures) core::note_input(input);
  for (const fs::path& input : {a.scene, a.ours, a.statistics}) core::note_input(input);
  core::claim_writable(a.json, "--json");
  for (const std::string& kind : kinds_of_pictures(a)) {
    core::claim_writable(picture_path(a, kind), "the picture " + kind);
  }
}

/// Stock's picture, and what it took.
int render_stock_alone(const Arguments& a) {
  StockOptions stock = a.stock;
  stock.antialiasing = antialiasing_of(a.options);
  stock.antialiasing.angles = 1;
  json about{{"scene", a.scene.string()}};
  const auto render = [&](const StockOptions& how) {
    return stock_picture(a.scene, static_cast<std::uint32_t>(a.options.width),
                         static_cast<std::uint32_t>(a.options.height), how);
  };
  const StoredImage picture = timed(render, stock, about);
  check_outputs(a);
  const fs::path place = picture_path(a, "stock");
  core::write_stored(picture, place);
  std::cout << place.string() << std::endl;
  if (!a.json.empty()) tool::write_whole(a.json, tool::json_text(about, 2) + "\n");
  return kReached;
}

int compare_and_report(const Arguments& a) {
  check_outputs(a);
  const Pair pair = a.pictures.empty() ? render_both(a) : read_both(a);
  const Pair seen = shown(pair, !a.pictures.empty());
  LensComparison result = compare_pair(seen);
  json about = pair.about;
  grade_by_stocks_noise(pair, seen, result, about);
  const bool reached = reaches(result, a.asked);
  check_outputs(a);  // now that all inputs are known
  std::cout << table(result, a.all_lenses);
  if (a.write_pictures) write_pictures(a, pair, seen);
  if (!a.json.empty()) {
    json all = to_json(result);
    all.update(about);
    all["asked"] = std::string(core::name_of(a.asked));
    all["reached"] = reached;
    tool::write_whole(a.json, tool::json_text(all, 2) + "\n");
  }
  std::cout << "grade " << core::name_of(result.whole.grade) << "; " << core::name_of(a.asked)
            << (reached ? " reached" : " NOT reached") << std::endl;
  return reached ? kReached : kBelow;
}

int only_write_wrappers(const Arguments& a) {
  const std::optional<Sheet> sheet = sheet_of(render_ours(a).statistics);
  if (!sheet) throw std::runtime_error("the picture is no integral image: it needs no wrapper");
  write_wrappers(a.scene, *sheet, a.wrappers);
  std::cout << describe(*sheet, best_way(*sheet), a.stock) << "; written to " << a.wrappers.string()
            << std::endl;
  return kReached;
}

int diff(const Arguments& arguments) {
  if (arguments.seen) return compare_seen(*arguments.seen);
  judge_outputs(arguments);
  if (arguments.stock_alone) return render_stock_alone(arguments);
  if (!arguments.wrappers.empty()) return only_write_wrappers(arguments);
  return compare_and_report(arguments);
}

}  // namespace
}  // namespace lentray::diff

int main(int count, char** words) {
  using namespace lentray::diff;
  return lentray::tool::tool_main({"lentray-diff", kError, true}, count, words, parse_arguments,
                                  usage, diff);
}
