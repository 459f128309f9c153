// The whole way: scenes as integral images by lentray, held against stock POV-Ray lens by lens
// through lentray-diff; and lentray-diff held against mistakes made on purpose.
#include <gtest/gtest.h>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string scene_file(const char* name) { return (source_folder() / "scenes" / name).string(); }

std::string text_of(const json& report, const std::string& output) {
  return output + (report.is_null() ? "" : report["whole"].dump());
}

class Acceptance : public ::testing::Test {
 protected:
  /// Runs lentray-diff; the JSON lands in m_report.
  tool::RunResult compare(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--json", "report.json", "--output", "p"});
    const tool::RunResult result = run_diff(arguments, m_folder.path());
    if (fs::exists(m_folder / "report.json")) {
      m_report = json::parse(tool::read_text(m_folder / "report.json"));
    }
    return result;
  }

  void expect_exact(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--grade", "exact"});
    const tool::RunResult result = compare(std::move(arguments));
    ASSERT_EQ(result.status, 0) << text_of(m_report, result.output);
    EXPECT_EQ(m_report["whole"]["grade"], "exact");
    for (const char* parts : {"lenses", "views"}) {
      EXPECT_FALSE(m_report[parts].empty()) << parts;
      for (const json& part : m_report[parts]) {
        EXPECT_TRUE(part["grade"] == "exact" || part["grade"] == "match") << part.dump();
      }
    }
    for (const char* picture : {"p-ours.png", "p-stock.png", "p-heat.png", "p-side.png"}) {
      EXPECT_TRUE(fs::exists(m_folder / picture)) << picture;
    }
  }

  void expect_exact_balls(const char* height);
  void expect_exact_gears(const char* height);
  void expect_exact_demo(const char* height);

  tool::TemporaryFolder m_folder;
  json m_report;
};

/// The same in whole pictures; the others have fewer rows.
class SlowAcceptance : public Acceptance {};

void Acceptance::expect_exact_balls(const char* height) {
  expect_exact({scene_file("spd_balls.pov"), "Declare=Lenticular_Camera=1", "+W399", height});
  EXPECT_EQ(m_report["lenses"].size(), 27u);
  EXPECT_EQ(m_report["views"].size(), 15u);
}

TEST_F(Acceptance, BallsIntegralIsExact) { expect_exact_balls("+H100"); }
TEST_F(SlowAcceptance, BallsIntegralIsExact) { expect_exact_balls("+H400"); }

void Acceptance::expect_exact_gears(const char* height) {
  expect_exact({scene_file("spd_gears.pov"), "Declare=Lenticular_Camera=1", "+W399", height});
}

TEST_F(Acceptance, GearsIntegralIsExact) { expect_exact_gears("+H100"); }
TEST_F(SlowAcceptance, GearsIntegralIsExact) { expect_exact_gears("+H400"); }

void Acceptance::expect_exact_demo(const char* height) {
  expect_exact({scene_file("demo.pov"), "Lenticular=On", "+W480", height});
  EXPECT_EQ(m_report["way"], "oblique perspective views");
}

TEST_F(Acceptance, DemoFromItsEyeIsExact) { expect_exact_demo("+H120"); }
TEST_F(SlowAcceptance, DemoFromItsEyeIsExact) { expect_exact_demo("+H360"); }

TEST_F(Acceptance, DemoInItsOwnCameraIsExact) {
  const tool::RunResult result =
      compare({scene_file("demo.pov"), "+W240", "+H180", "--grade", "exact"});
  EXPECT_EQ(result.status, 0) << text_of(m_report, result.output);
}

TEST_F(Acceptance, FractionalLensPixels) {
  const tool::RunResult result =
      compare({scene_file("demo.pov"), "Lenticular=On", "Lens_Pixels=7.37", "+W240", "+H180"});
  EXPECT_EQ(result.status, 0) << text_of(m_report, result.output);
  EXPECT_TRUE(m_report["views"].empty());
  EXPECT_EQ(m_report["way"], "mesh_camera");
}

TEST_F(Acceptance, SnellsLawFromAFiniteDistance) {
  const tool::RunResult result =
      compare({scene_file("demo.pov"), "Lenticular=On", "Lens_Model=pinhole", "+W240", "+H180"});
  EXPECT_EQ(result.status, 0) << text_of(m_report, result.output);
  EXPECT_EQ(m_report["way"], "mesh_camera");
}

TEST_F(Acceptance, ViewAlone) {
  const tool::RunResult result = compare({scene_file("demo.pov"), "Lenticular=On", "Lens_Pixels=5",
                                          "View=3", "+W400", "+H60", "--grade", "exact"});
  EXPECT_EQ(result.status, 0) << text_of(m_report, result.output);
  EXPECT_EQ(m_report["width"], 80);
}

/// A scene of Debian's examples, in its own camera and as an integral image.
TEST_F(Acceptance, ExampleScene) {
  const std::string scene = "/usr/share/doc/povray/examples/advanced/sombrero.pov";
  if (!fs::exists(scene)) GTEST_SKIP() << "povray-examples is not installed";
  tool::RunResult result = compare({scene, "+W160", "+H120"});
  EXPECT_EQ(result.status, 0) << text_of(m_report, result.output);
  result = compare({scene, "Lenticular=On", "+W240", "+H180"});
  EXPECT_EQ(result.status, 0) << text_of(m_report, result.output);
}

// Mutations: the picture lentray makes of a sheet that is wrong in one way, against stock's of
// the right one.

class Mutation : public Acceptance {
 protected:
  static constexpr const char* kRight =
      "lens_pitch 1.124 lens_focal_length 3.03 lens_ior 1.6 lens_pixels 15 lens_front 8 "
      "view_distance 500 lens_model paraxial";

  std::string scene(const std::string& right, const std::string& lens) const {
    return "#version 3.7;\n#include \"" + scene_file("demo.pov") +
           "\"\ncamera { lenticular location <0,0.75,0> direction z right " + right + " up 3*y " +
           lens + " }\n";
  }

  void SetUp() override {
    tool::write_text(m_folder / "right.pov", scene("4*x", kRight));
    const tool::RunResult result = compare({"right.pov", "+W300", "+H60"});
    ASSERT_EQ(result.status, 0) << text_of(m_report, result.output);
  }

  /// Exit status of lentray-diff for what lentray makes of a changed sheet.
  int status_for(const std::string& right, const std::string& lens) {
    tool::write_text(m_folder / "wrong.pov", scene(right, lens));
    const tool::RunResult made =
        run_lentray({"+Iwrong.pov", "+Owrong.png", "+W300", "+H60", "-V"}, m_folder.path());
    EXPECT_EQ(made.status, 0) << made.output;
    return run_diff({"wrong.png", "p-stock.png", "Lens_Pixels=15", "--no-pictures"},
                    m_folder.path())
        .status;
  }

  static std::string with(const std::string& from, const std::string& to) {
    std::string text = kRight;
    return text.replace(text.find(from), from.size(), to);
  }
};

TEST_F(Mutation, NothingChanged) { EXPECT_EQ(status_for("4*x", kRight), 0); }
TEST_F(Mutation, RightVectorSwapped) { EXPECT_EQ(status_for("-4*x", kRight), 1); }
TEST_F(Mutation, LensPixelsOneOff) {
  EXPECT_EQ(status_for("4*x", with("lens_pixels 15", "lens_pixels 16")), 1);
}
TEST_F(Mutation, ViewingDistanceForgotten) {
  EXPECT_EQ(status_for("4*x", with("view_distance 500", "view_distance 0")), 1);
}
TEST_F(Mutation, RefractionForgotten) {
  EXPECT_EQ(status_for("4*x", with("lens_ior 1.6", "lens_ior 1")), 1);
}

}  // namespace
}  // namespace lentray::test
