// Lens data as shops give them: what follows from any sufficient set, what contradicts, what is said.
#include "camera/lens_data.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "camera/lens_profiles.h"
#include "camera/lens_request.h"

namespace lentray::camera {
namespace {

constexpr double kLensDataInf = std::numeric_limits<double>::infinity();
constexpr double kLensDataNan = std::numeric_limits<double>::quiet_NaN();

std::string lens_data_message(const LensData& data) {
  try {
    (void)solve(data);
  } catch (const CameraError& error) {
    return error.what();
  }
  return {};
}

bool lens_data_notes(const SolvedLens& lens, const std::string& part) {
  for (const std::string& line : lens.notes) {
    if (line.find(part) != std::string::npos) return true;
  }
  return false;
}

/// sin(angle/2) = n sin(t_in), tan(t_in) = P/(2 t): Snell's law at the vertex, by hand.
double lens_data_angle(double pitch, double thickness, double ior) {
  const double inside = std::atan(pitch / (2.0 * thickness));
  return 2.0 * std::asin(ior * std::sin(inside)) * 180.0 / std::numbers::pi;
}

TEST(UnitCameraLensData, NothingIsTheDefaultLens) {
  const SolvedLens lens = solve({});
  EXPECT_EQ(lens.pitch, 1.124);
  EXPECT_EQ(lens.thickness, 3.03);
  EXPECT_EQ(lens.ior, 1.6);
  EXPECT_EQ(lens.radius, 0.0);
  EXPECT_TRUE(lens.notes.empty());
}

TEST(UnitCameraLensData, APitchAloneKeepsTheShape) {
  const SolvedLens lens = solve({.lpi = 40.0});
  EXPECT_NEAR(lens.pitch, 0.635, 1e-15);
  EXPECT_NEAR(lens.thickness / lens.pitch, 3.03 / 1.124, 1e-14);
  EXPECT_TRUE(lens_data_notes(lens, "Thickness 1.712 mm is a guess"));
  EXPECT_EQ(solve({.pitch = 1.124}).thickness, 3.03);
  // Whatever says more is not guessed.
  EXPECT_TRUE(solve({.lpi = 40.0, .thickness = 0.9}).notes.empty());
}

TEST(UnitCameraLensData, ThicknessRadiusAngleAndIndexTellOneAnother) {
  // Thickness alone; angle alone; and the index from both.
  const double angle = lens_data_angle(0.635, 0.9, 1.57);
  EXPECT_NEAR(viewing_angle(0.635, 0.9, 1.57), angle, 1e-12);
  EXPECT_EQ(solve({.pitch = 0.635, .thickness = 0.9, .ior = 1.57}).thickness, 0.9);
  const SolvedLens from_angle = solve({.pitch = 0.635, .ior = 1.57, .angle = angle});
  EXPECT_NEAR(from_angle.thickness, 0.9, 1e-12);
  EXPECT_TRUE(lens_data_notes(from_angle, "Thickness 0.9 mm, from the viewing angle"));
  const SolvedLens index = solve({.pitch = 0.635, .thickness = 0.9, .angle = angle});
  EXPECT_NEAR(index.ior, 1.57, 1e-12);
  EXPECT_TRUE(lens_data_notes(index, "Refractive index 1.57, from the viewing angle"));
  const SolvedLens pitch = solve({.thickness = 0.9, .ior = 1.57, .angle = angle});
  EXPECT_NEAR(pitch.pitch, 0.635, 1e-12);
  EXPECT_TRUE(lens_data_notes(pitch, "Lens pitch 0.635 mm, from thickness and viewing angle"));
  // f = n R/(n - 1).
  const SolvedLens round = solve({.pitch = 0.635, .radius = 0.35, .ior = 1.5});
  EXPECT_NEAR(round.thickness, 1.05, 1e-15);
  EXPECT_EQ(round.radius, 0.0);
  EXPECT_TRUE(lens_data_notes(round, "Thickness 1.05 mm, where a lens of that radius focuses"));
}

TEST(UnitCameraLensData, AThicknessIsWherePixelsLie) {
  // The lens of the article focuses at 1.557 x 0.1905/0.557 = 0.5325 mm, behind its sheet.
  const SolvedLens lens =
      solve({.pitch = 0.33665, .thickness = 0.457, .radius = 0.1905, .ior = 1.557});
  EXPECT_EQ(lens.thickness, 0.457);
  EXPECT_EQ(lens.radius, 0.1905);
  // A focal length beside a thickness says the same as a radius.
  const SolvedLens focal = solve({.pitch = 0.6, .focal_length = 1.2, .thickness = 1.0, .ior = 1.5});
  EXPECT_EQ(focal.thickness, 1.0);
  EXPECT_NEAR(focal.radius, 0.4, 1e-15);
}

TEST(UnitCameraLensData, WikipediasExample) {
  // The article has 64.6 degrees; its formula gives 64.42, Snell's law at the vertex 65.11.
  EXPECT_NEAR(viewing_angle(0.33665, 0.457, 1.557, 0.1905), 64.41662, 1e-5);
  EXPECT_NEAR(viewing_angle(0.33665, 0.457, 1.557), 65.11436, 1e-5);
  const SolvedLens lens =
      solve({.pitch = 0.33665, .thickness = 0.457, .radius = 0.1905, .ior = 1.557, .angle = 64.6});
  EXPECT_TRUE(lens_data_notes(lens,
                              "Viewing angle 64.6 degrees as given; the other data make it "
                              "64.42, 0.2847 % off"))
      << lens.notes.back();
  // Both formulae agree for a narrow lens.
  EXPECT_NEAR(viewing_angle(0.1, 3.0, 1.5, 1.0) / viewing_angle(0.1, 3.0, 1.5), 1.0, 1e-3);
  EXPECT_EQ(viewing_angle(6.0, 3.0, 1.6), 180.0);
}

TEST(UnitCameraLensData, WhatIsSaidTwiceMayDifferALittle) {
  const SolvedLens lens = solve({.pitch = 0.6, .focal_length = 1.21, .radius = 0.4, .ior = 1.5});
  EXPECT_EQ(lens.thickness, 1.21);
  EXPECT_TRUE(lens_data_notes(lens,
                              "Focal length 1.21 mm as given; radius and index make it 1.2 mm, "
                              "0.8333 % off"));
  EXPECT_EQ(solve({.pitch = 0.635, .lpi = 40.0}).pitch, 0.635);
}

TEST(ErrorCameraLensData, ContradictionsNameBothFigures) {
  for (const auto& [data, parts] : std::vector<std::pair<LensData, std::vector<std::string>>>{
           {{.pitch = 0.7, .lpi = 40.0}, {"0.7 mm", "40 lenses an inch (0.635 mm)"}},
           {{.focal_length = 1.3, .radius = 0.4, .ior = 1.5}, {"1.3 mm", "the 1.2 mm that follow"}},
           {{.pitch = 0.6, .thickness = 0.9, .ior = 1.5, .angle = 40.0},
            {"angle of 40 degrees", "the 56.6", "thickness 0.9 mm"}},
           {{.pitch = 0.6, .thickness = 0.9, .angle = 20.0}, {"20 degrees", "0.9 mm", "0.549"}},
           {{.pitch = 0.6, .radius = 0.2}, {"radius of 0.2 mm", "0.6 mm", "0.4 mm wide at most"}},
           {{.pitch = 0.6, .thickness = 0.1, .radius = 0.31},
            {"0.31 mm", "thickness of 0.1 mm", "0.231"}}}) {
    const std::string text = lens_data_message(data);
    EXPECT_NE(text.find("contradict each other"), std::string::npos) << text;
    for (const std::string& part : parts) EXPECT_NE(text.find(part), std::string::npos) << text;
  }
}

/// Whatever the numbers are, there is a message with no nan and no inf in it.
TEST(ErrorCameraLensData, BadNumbers) {
  struct Row {
    std::optional<double> LensData::*member;
    double value;
    const char* text;
  };
  const auto lengths = {std::pair{&LensData::pitch, "lens pitch"},
                        std::pair{&LensData::thickness, "lens thickness"},
                        std::pair{&LensData::radius, "lens radius"},
                        std::pair{&LensData::focal_length, "lens focal length"}};
  std::vector<std::pair<LensData, std::string>> rows;
  for (const auto& [member, name] : lengths) {
    for (const double value : {0.0, -1.0, kLensDataNan, -kLensDataInf}) {
      LensData data;
      data.*member = value;
      rows.emplace_back(data, std::string("the ") + name + " must be greater than 0 mm");
    }
    for (const double value : {1e-300, 1e300, kLensDataInf}) {
      LensData data;
      data.*member = value;
      rows.emplace_back(data, std::string("the ") + name + " must be 1e-6 to 1e6 mm");
    }
  }
  for (const auto& [value, text] :
       std::vector<std::pair<double, const char*>>{{0.0, "greater than 0"},
                                                   {-4.0, "greater than 0"},
                                                   {kLensDataNan, "greater than 0"},
                                                   {1e300, "1e-4 to 1e7"},
                                                   {kLensDataInf, "1e-4 to 1e7"},
                                                   {1e-300, "1e-4 to 1e7"}}) {
    rows.emplace_back(LensData{.lpi = value},
                      std::string("the number of lenses an inch must be ") + text);
  }
  for (const double value : {0.0, -1.0, 180.0, 1e300, kLensDataInf, kLensDataNan}) {
    rows.emplace_back(LensData{.angle = value}, "greater than 0 and less than 180 degrees");
  }
  for (const double value : {0.0, 0.99, -2.0, kLensDataNan}) {
    rows.emplace_back(LensData{.ior = value}, "must be at least 1");
  }
  for (const double value : {1e300, kLensDataInf}) {
    rows.emplace_back(LensData{.ior = value}, "must be 100 at most");
  }
  rows.emplace_back(LensData{.radius = 1.0, .ior = 1.0}, "needs a refractive index greater than 1");
  for (const auto& [data, text] : rows) {
    const std::string message = lens_data_message(data);
    EXPECT_NE(message.find(text), std::string::npos) << text << ": " << message;
    EXPECT_EQ(message.find("nan"), std::string::npos) << message;
    EXPECT_EQ(message.find("inf"), std::string::npos) << message;
  }
}

TEST(UnitCameraLensData, Overriding) {
  const LensData article{
      .pitch = 0.33665, .thickness = 0.457, .radius = 0.1905, .ior = 1.557, .angle = 64.6};
  const auto with = [&article](const LensData& other) {
    LensData out = article;
    out.override_by(other);
    return out;
  };
  const LensData lpi = with({.lpi = 75.0});
  EXPECT_FALSE(lpi.pitch);
  EXPECT_FALSE(lpi.angle);
  EXPECT_EQ(lpi.radius, 0.1905);
  const LensData thick = with({.thickness = 0.5});
  EXPECT_EQ(thick.thickness, 0.5);
  EXPECT_EQ(thick.radius, 0.1905);
  EXPECT_FALSE(thick.angle);
  const LensData focal = with({.focal_length = 0.5});
  EXPECT_FALSE(focal.thickness || focal.radius || focal.angle);
  EXPECT_EQ(focal.ior, 1.557);
  const LensData angle = with({.angle = 50.0});
  EXPECT_FALSE(angle.thickness || angle.radius || angle.focal_length);
  EXPECT_EQ(angle.angle, 50.0);
  LensData scene{.focal_length = 3.0};
  scene.override_by({.thickness = 2.0});
  EXPECT_FALSE(scene.focal_length);
  EXPECT_EQ(with({}).angle, 64.6);
}

TEST(UnitCameraLensProfiles, EveryCommonSheetIsALens) {
  double last = 1e9;
  for (const LensProfile& sheet : common_lens_sheets()) {
    for (const LensModel model : {LensModel::kPinhole, LensModel::kThick}) {
      LensRequest request;
      static_cast<LensData&>(request) = sheet.data;
      request.model = model;
      const LensParameters lens = resolve(request, 600, nullptr);
      EXPECT_EQ(complaint(lens), "") << sheet.name;
      EXPECT_LE(lens.pitch, last) << sheet.name;
      if (model == LensModel::kThick) last = lens.pitch;
      if (!sheet.nominal) continue;
      // As thin as it can be to focus on its back, to 0.01 mm.
      EXPECT_GE(lens.radius(), 0.5 * lens.pitch) << sheet.name;
      EXPECT_LT(lens.focal_length - 0.01, lens.ior * lens.pitch / (2.0 * (lens.ior - 1.0)));
    }
    EXPECT_FALSE(sheet.source.empty()) << sheet.name;
  }
}

LensRequest measured_strips(double lpi) {
  LensRequest request;
  request.print_lpi = lpi;
  request.thickness = 1.9;
  request.ior = 1.57;
  request.view_distance = 400.0;
  return request;
}

TEST(UnitLensRequest, StripsOfAPitchTestTellTheLenses) {
  LensRequest request = measured_strips(39.8);
  const LensParameters lens = resolve(request, 1000, nullptr);
  EXPECT_NEAR(lens.print_pitch(), 25.4 / 39.8, 1e-15);
  EXPECT_NEAR(lens.lenses_per_inch(), 39.8 * (1.0 + 1.9 / (1.57 * 400.0)), 1e-12);
  request.thickness.reset();  // follows from the pitch, which follows from it
  EXPECT_NEAR(resolve(request, 1000, nullptr).print_pitch(), 25.4 / 39.8, 1e-15);
  request.view_distance = 2.0;  // nearer than any eye
  EXPECT_NEAR(resolve(request, 1000, nullptr).print_pitch(), 25.4 / 39.8, 1e-13);
  for (const double far : {0.0, kLensDataInf}) {
    request.view_distance = far;
    EXPECT_DOUBLE_EQ(resolve(request, 1000, nullptr).lenses_per_inch(), 39.8);
  }
}

TEST(UnitLensRequest, StripsReplaceAPitchAndTheOtherWayRound) {
  LensRequest sheet;
  sheet.lpi = 40.0;
  sheet.override_by(measured_strips(39.8));
  EXPECT_FALSE(sheet.lpi);
  EXPECT_EQ(sheet.print_lpi, 39.8);
  LensRequest pitch;
  pitch.pitch = 0.6;
  sheet.override_by(pitch);
  EXPECT_FALSE(sheet.print_lpi);
  EXPECT_EQ(sheet.pitch, 0.6);
}

TEST(UnitLensRequest, BadStripsAreRefused) {
  const auto message = [](const LensRequest& request) -> std::string {
    try {
      resolve(request, 1000, nullptr);
    } catch (const CameraError& error) {
      return error.what();
    }
    return "";
  };
  LensRequest twice = measured_strips(39.8);
  twice.lpi = 40.0;
  EXPECT_EQ(
      message(twice),
      "Print_LPI gives the lenses' pitch, and so does Lens_Pitch or Lens_LPI: give one of them");
  LensRequest nowhere = measured_strips(39.8);
  nowhere.view_distance.reset();
  EXPECT_EQ(message(nowhere),
            "Print_LPI needs a View_Distance: which strips fit depends on it; give the one that "
            "the pitch test was looked at from");
  for (const double bad : {0.0, -1.0, 1e300, kLensDataInf, kLensDataNan}) {
    EXPECT_EQ(message(measured_strips(bad)), "Print_LPI must be 0.0001 to 10000000 strips an inch");
  }
}

}  // namespace
}  // namespace lentray::camera
