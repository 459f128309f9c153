#include "tests/support/render.h"

#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "tools/lentray-diff/stock.h"

namespace lentray::test {

namespace fs = std::filesystem;
using tool::RunResult;

namespace {

void put_files(const SceneText& scene, const fs::path& folder) {
  tool::write_text(folder / "scene.pov", scene.sdl);
  for (const auto& [name, contents] : scene.files) {
    fs::create_directories((folder / name).parent_path());
    tool::write_text(folder / name, contents);
  }
}

std::vector<std::string> arguments_for(const SceneText& scene, const std::string& picture) {
  std::vector<std::string> arguments{"+Iscene.pov",
                                     "+O" + picture,
                                     "+W" + std::to_string(scene.width),
                                     "+H" + std::to_string(scene.height),
                                     scene.bits == 16 ? "+FN16" : "+FN8",
                                     "-A",
                                     "-J",
                                     "-D",
                                     "-V",
                                     "+WT1"};
  arguments.insert(arguments.end(), scene.arguments.begin(), scene.arguments.end());
  return arguments;
}

StoredImage picture_of(const RunResult& result, const fs::path& picture, const std::string& who) {
  if (result.status != 0 || !fs::exists(picture)) {
    throw std::runtime_error(who + " failed with status " + std::to_string(result.status) +
                             (result.timed_out ? " (took too long)" : "") + ":\n" + result.output);
  }
  return core::read_image(picture);
}

void keep(const SceneText& scene, const StoredImage& ours, const StoredImage& stock) {
  const char* folder = std::getenv("LENTRAY_KEEP");
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  if (folder == nullptr || test == nullptr) return;
  fs::create_directories(folder);
  std::string stem = std::string(test->test_suite_name()) + "." + test->name();
  for (char& c : stem) c = c == '/' ? '.' : c;  // parameterised tests have slashes in their names
  tool::write_text(fs::path(folder) / (stem + ".pov"), scene.sdl);
  core::write_stored(ours, fs::path(folder) / (stem + "-ours.png"));
  core::write_stored(stock, fs::path(folder) / (stem + "-stock.png"));
}

}  // namespace

fs::path source_folder() { return LENTRAY_SOURCE_DIR; }
fs::path program(const std::string& name) { return fs::path(LENTRAY_BIN_DIR) / name; }

StoredImage stock_render(const SceneText& scene) {
  const tool::TemporaryFolder folder;
  put_files(scene, folder.path());
  std::vector<std::string> command = arguments_for(scene, "stock.png");
  command.insert(command.begin(), "povray");
  return picture_of(tool::run_program(command, folder.path(), 300.0), folder / "stock.png",
                    "stock POV-Ray");
}

StoredImage lentray_render(const SceneText& scene, const std::vector<std::string>& more) {
  const tool::TemporaryFolder folder;
  put_files(scene, folder.path());
  std::vector<std::string> arguments = arguments_for(scene, "ours.png");
  arguments.insert(arguments.end(), more.begin(), more.end());
  return picture_of(run_lentray(arguments, folder.path()), folder / "ours.png", "lentray");
}

RunResult run_lentray(const std::vector<std::string>& arguments, const fs::path& folder,
                      double seconds) {
  std::vector<std::string> command{program("lentray").string()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return tool::run_program(command, folder, seconds);
}

RunResult run_diff(const std::vector<std::string>& arguments, const fs::path& folder,
                   double seconds) {
  std::vector<std::string> command{program("lentray-diff").string()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return tool::run_program(command, folder, seconds);
}

nlohmann::json lentray_statistics(const SceneText& scene, const std::vector<std::string>& more) {
  const tool::TemporaryFolder folder;
  put_files(scene, folder.path());
  std::vector<std::string> arguments = arguments_for(scene, "ours.png");
  arguments.insert(arguments.end(), more.begin(), more.end());
  arguments.push_back("Statistics_File=statistics.json");
  picture_of(run_lentray(arguments, folder.path()), folder / "ours.png", "lentray");
  return nlohmann::json::parse(tool::read_text(folder / "statistics.json"));
}

std::string describe(const Comparison& c) {
  std::ostringstream out;
  out << core::name_of(c.grade) << ": largest " << c.largest << "/255, mean " << c.mean
      << "/255, beyond 1/255 " << 100.0 * c.share_beyond_1() << " % (" << c.beyond_1
      << " pixels), beyond 2/255 " << 100.0 * c.share_beyond_2() << " % (" << c.beyond_2
      << " pixels) of " << c.pixels << ", PSNR " << c.psnr << " dB, smoothed " << c.smooth_psnr
      << " dB";
  return out.str();
}

::testing::AssertionResult reaches(const StoredImage& ours, const StoredImage& reference,
                                   Grade asked) {
  if (ours.width != reference.width || ours.height != reference.height) {
    return ::testing::AssertionFailure() << "sizes differ: " << ours.width << " x " << ours.height
                                         << " and " << reference.width << " x " << reference.height;
  }
  const Comparison c = core::compare(ours, reference, core::Columns::all(ours.width));
  if (c.grade >= asked) return ::testing::AssertionSuccess() << describe(c);
  ::testing::AssertionResult failure = ::testing::AssertionFailure();
  failure << "wanted " << core::name_of(asked) << ", got " << describe(c);
  int shown = 0;
  for (std::uint32_t y = 0; y < ours.height && shown < 3; ++y) {
    for (std::uint32_t x = 0; x < ours.width && shown < 3; ++x) {
      if (core::pixel_difference(ours, reference, x, y) <= 1.0) continue;
      const auto p = core::level(ours, x, y), q = core::level(reference, x, y);
      failure << "\n  pixel (" << x << ", " << y << "): ours " << p[0] << " " << p[1] << " " << p[2]
              << ", stock " << q[0] << " " << q[1] << " " << q[2];
      ++shown;
    }
  }
  return failure;
}

::testing::AssertionResult same_as_stock(const SceneText& scene, Grade asked) {
  try {
    const StoredImage stock = stock_render(scene);
    const StoredImage ours = lentray_render(scene);
    keep(scene, ours, stock);
    return reaches(ours, stock, asked);
  } catch (const std::exception& e) {
    return ::testing::AssertionFailure() << e.what();
  }
}

::testing::AssertionResult same_bits(const StoredImage& a, const StoredImage& b) {
  if (a.width != b.width || a.height != b.height || a.channels != b.channels) {
    return ::testing::AssertionFailure() << "the pictures have different shapes";
  }
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.samples.size(); ++i) different += a.samples[i] != b.samples[i];
  if (different == 0) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << different << " of " << a.samples.size() << " samples differ";
}

}  // namespace lentray::test
