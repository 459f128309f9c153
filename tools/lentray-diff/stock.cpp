#include "tools/lentray-diff/stock.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "tools/lentray-diff/process.h"

namespace lentray::diff {

namespace fs = std::filesystem;
using core::StoredImage;

namespace {

/// Stock gets a folder of its own to run in: scenes may write files while they are parsed, and
/// several processes at once must not meet there, nor litter the user's folder.
class Workshop {
 public:
  Workshop(const fs::path& scene, const StockOptions& options) : m_options(options) {
    if (!fs::is_regular_file(scene)) {
      throw std::runtime_error("there is no scene '" + scene.string() + "'");
    }
    m_scene = fs::absolute(scene);
    m_root = options.keep.empty() ? m_temporary.path() : fs::absolute(options.keep);
    fs::create_directories(m_root);
  }

  /// For wrappers: the scene, or a copy without lenticular cameras if there are any. Include files
  /// that hold one get a copy too, which stock finds before the file itself.
  Included included() {
    const std::string text = read_text(m_scene);
    copy_includes(text, 0);
    bool changed = false;
    const std::string readable = without_lenticular(text, changed);
    if (!changed) return {version_directive(text), m_scene.string()};
    const fs::path copy = m_root / ("plain-" + m_scene.filename().string());
    write_text(copy, readable);
    return {version_directive(text), copy.string()};
  }

  StoredImage render_text(const std::string& name, const std::string& text, std::uint32_t width,
                          std::uint32_t height) const {
    const fs::path folder = m_root / name;
    fs::create_directories(folder);
    write_text(folder / (name + ".pov"), text);
    return render(folder, folder / (name + ".pov"), width, height);
  }

  StoredImage render_scene(std::uint32_t width, std::uint32_t height) const {
    const fs::path folder = m_root / "picture";
    fs::create_directories(folder);
    return render(folder, m_scene, width, height);
  }

 private:
  void copy_includes(const std::string& text, int depth) {
    constexpr int deepest = 20;  // files may include themselves under a condition
    for (const std::string& name : included_files(text)) {
      std::vector<fs::path> places{m_scene.parent_path() / name};
      for (const fs::path& p : m_options.library_paths) places.push_back(p / name);
      const auto file = std::find_if(places.begin(), places.end(),
                                     [](const fs::path& p) { return fs::is_regular_file(p); });
      if (file == places.end() || depth > deepest || fs::path(name).is_absolute()) continue;
      const std::string inner = read_text(*file);
      copy_includes(inner, depth + 1);
      bool changed = false;
      const std::string readable = without_lenticular(inner, changed);
      if (!changed) continue;
      fs::create_directories((m_root / name).parent_path());
      write_text(m_root / name, readable);
    }
  }

  StoredImage render(const fs::path& folder, const fs::path& scene, std::uint32_t width,
                     std::uint32_t height) const {
    const fs::path picture = folder / "stock.png";
    // An option file in the folder, for paths with spaces in them.
    std::ostringstream ini;
    ini << "Input_File_Name=\"" << scene.string() << "\"\nOutput_File_Name=\"" << picture.string()
        << "\"\nLibrary_Path=\"" << m_root.string() << "\"\nLibrary_Path=\""
        << m_scene.parent_path().string() << "\"\n";
    for (const fs::path& p : m_options.library_paths) ini << "Library_Path=\"" << p.string() << "\"\n";
    write_text(folder / "stock.ini", ini.str());
    std::vector<std::string> command{m_options.povray,
                                     "stock.ini",
                                     "+W" + std::to_string(width),
                                     "+H" + std::to_string(height),
                                     m_options.bits == 16 ? "+FN16" : "+FN8"};
    command.insert(command.end(), m_options.arguments.begin(), m_options.arguments.end());
    for (const char* fixed : {"-D", "-A", "-J", "-P", "-V", "+WT1"}) command.emplace_back(fixed);
    std::error_code ignored;
    fs::remove(picture, ignored);
    const RunResult result = run(command, folder, m_options.seconds);
    if (result.timed_out) throw std::runtime_error("stock POV-Ray took too long");
    if (result.status != 0 || !fs::exists(picture)) {
      throw std::runtime_error("stock POV-Ray cannot render '" + m_scene.string() + "' (status " +
                               std::to_string(result.status) + "):\n" + last_words(result.output));
    }
    return core::read_image(picture);
  }

  const StockOptions& m_options;
  TemporaryFolder m_temporary;
  fs::path m_scene, m_root;
};

/// Runs job(0) .. job(count - 1), `processes` at a time; throws the first error.
template <class Job>
void in_parallel(std::uint32_t count, int processes, const Job& job) {
  std::atomic<std::uint32_t> next{0};
  std::mutex guard;
  std::exception_ptr error;
  const auto work = [&] {
    for (std::uint32_t i = next++; i < count; i = next++) {
      try {
        job(i);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(guard);
        if (!error) error = std::current_exception();
        next = count;
      }
    }
  };
  std::vector<std::thread> threads;
  const auto wanted = std::min<std::uint32_t>(count, static_cast<std::uint32_t>(std::max(1, processes)));
  for (std::uint32_t i = 0; i < wanted; ++i) threads.emplace_back(work);
  for (std::thread& t : threads) t.join();
  if (error) std::rethrow_exception(error);
}

StoredImage black(std::uint32_t width, std::uint32_t height, int bits) {
  StoredImage image;
  image.width = width;
  image.height = height;
  image.channels = 3;
  image.bits = bits;
  image.samples.assign(std::size_t{3} * width * height, 0.0f);
  return image;
}

/// Image row k >= 1 of POV-Ray 3.7 shows row k - 1 of a mesh_camera; later ones are right.
bool mesh_rows_lag(const StockOptions& options) {
  const std::string said = run({options.povray, "--version"}).output;
  const std::size_t at = said.find("POV-Ray ");
  return at == std::string::npos || said.compare(at + 8, 3, "3.7") == 0;
}

StoredImage mesh_integral(Workshop& shop, const Sheet& sheet, const StockOptions& options) {
  const bool lag = mesh_rows_lag(options);
  const StoredImage rendered = shop.render_text("mesh", mesh_scene(sheet, shop.included()),
                                                sheet.rows, sheet.columns + (lag ? 1 : 0));
  return mesh_picture(rendered, sheet, lag);
}

StoredImage one_view(const Workshop& shop, const Included& scene, const Sheet& sheet,
                     std::uint32_t view, Way way, int bits) {
  const std::uint32_t width = sheet.view_width(view);
  // All lenses show a view alike when V is infinite: then it is dark as a whole or not at all.
  if (way == Way::orthographic_views && !sheet.slope(view)) return black(width, sheet.rows, bits);
  return shop.render_text("view" + std::to_string(view), view_scene(sheet, view, way, scene), width,
                          sheet.rows);
}

}  // namespace

StoredImage stock_picture(const fs::path& scene, std::uint32_t width, std::uint32_t height,
                          const StockOptions& options) {
  return Workshop(scene, options).render_scene(width, height);
}

StoredImage stock_integral(const fs::path& scene, const Sheet& sheet, Way way,
                           const StockOptions& options) {
  Workshop shop(scene, options);
  if (way == Way::mesh_camera) return mesh_integral(shop, sheet, options);
  const Included included = shop.included();
  std::vector<StoredImage> views(std::min(sheet.views(), sheet.columns));
  in_parallel(static_cast<std::uint32_t>(views.size()), options.processes, [&](std::uint32_t j) {
    views[j] = one_view(shop, included, sheet, j, way, options.bits);
  });
  return interlaced(views, sheet.columns);
}

StoredImage stock_view(const fs::path& scene, const Sheet& sheet, std::uint32_t view,
                       const StockOptions& options) {
  Workshop shop(scene, options);
  const Way way = best_way(sheet);
  if (way != Way::mesh_camera) {
    return one_view(shop, shop.included(), sheet, view, way, options.bits);
  }
  if (!sheet.has_views()) throw std::runtime_error("a sheet of fractional N has no views");
  const StoredImage all = mesh_integral(shop, sheet, options);
  StoredImage image = black(sheet.view_width(view), sheet.rows, options.bits);
  for (std::uint32_t r = 0; r < image.height; ++r) {
    for (std::uint32_t i = 0; i < image.width; ++i) {
      for (int c = 0; c < 3; ++c) image.at(i, r, c) = all.at(i * sheet.views() + view, r, c);
    }
  }
  return image;
}

void write_wrappers(const fs::path& scene, const Sheet& sheet, const fs::path& folder) {
  StockOptions options;
  options.keep = folder;
  const Included included = Workshop(scene, options).included();
  write_text(folder / "mesh.pov", mesh_scene(sheet, included));
  const Way way = best_way(sheet);
  if (way == Way::mesh_camera) return;
  for (std::uint32_t j = 0; j < std::min(sheet.views(), sheet.columns); ++j) {
    if (way == Way::orthographic_views && !sheet.slope(j)) continue;
    write_text(folder / ("view" + std::to_string(j) + ".pov"), view_scene(sheet, j, way, included));
  }
}

StoredImage interlaced(const std::vector<StoredImage>& views, std::uint32_t columns) {
  if (views.empty()) throw std::invalid_argument("no views to interlace");
  StoredImage image = black(columns, views[0].height, views[0].bits);
  const auto count = static_cast<std::uint32_t>(views.size());
  for (std::uint32_t r = 0; r < image.height; ++r) {
    for (std::uint32_t k = 0; k < columns; ++k) {
      const StoredImage& view = views[k % count];
      for (int c = 0; c < 3; ++c) {
        image.at(k, r, c) = view.at(k / count, r, view.channels < 3 ? 0 : c);
      }
    }
  }
  return image;
}

std::string last_words(const std::string& output) {
  std::vector<std::string> lines;
  std::istringstream in(output);
  for (std::string line; std::getline(in, line);) {
    if (line.find_first_not_of(" \t\r") != std::string::npos) lines.push_back(line);
  }
  // The message itself stands some lines above the end, behind the banner.
  std::size_t first = lines.size() > 12 ? lines.size() - 12 : 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].find("rror:") != std::string::npos) {
      first = i > 2 ? i - 2 : 0;
      break;
    }
  }
  std::string text;
  for (std::size_t i = first; i < lines.size() && i < first + 14; ++i) text += lines[i] + "\n";
  return text;
}

}  // namespace lentray::diff
