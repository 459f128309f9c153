// Camera statements: vectors as stock computes them.
#include <cmath>

#include "tests/unit/parser/scene_text.h"

namespace lentray::parser::test {
namespace {

using core::Vec3;

CameraDesc camera_of(const std::string& words, const std::string& before = "") {
  const SceneText s(before + " camera { " + words + " }");
  return s.scene.camera.value();
}

TEST(UnitParserCamera, Defaults) {
  const CameraDesc c = camera_of("");
  EXPECT_EQ(c.kind, CameraKind::kPerspective);
  EXPECT_EQ(c.right, Vec3(1.33, 0, 0));  // not 4/3
  EXPECT_EQ(c.up, Vec3(0, 1, 0));
  EXPECT_EQ(c.direction, Vec3(0, 0, 1));
  EXPECT_EQ(c.location, Vec3(0, 0, 0));
  EXPECT_FALSE(c.has_look_at);
}

TEST(UnitParserCamera, LookAtKeepsLengths) {
  const CameraDesc c =
      camera_of("look_at <3, 4, 1> location <0, 4, -3> direction 2*z right x*1.6 up y*.9");
  expect_near(c.direction, Vec3(3, 0, 4) / 5.0 * 2.0);
  expect_near(c.right, Vec3(4, 0, -3) / 5.0 * 1.6);
  expect_near(c.up, {0, 0.9, 0});
  EXPECT_NEAR(c.look_at_distance(), 5.0, 1e-12);
}

TEST(UnitParserCamera, MirroredRightStaysMirrored) {
  const CameraDesc c = camera_of("right -x*1.33 location -z*5 look_at 0");
  expect_near(c.right, {-1.33, 0, 0});
}

TEST(UnitParserCamera, AngleRescalesDirectionByRight) {
  const CameraDesc c = camera_of("angle 60 right x*2 location -z look_at 0");
  EXPECT_NEAR(length(c.direction), 1.0 / std::tan(M_PI / 6.0), 1e-12);
  EXPECT_NEAR(length(c.right), 2.0, 1e-15);
}

TEST(UnitParserCamera, OrderOfWordsDoesNotMatterFrom35On) {
  const CameraDesc a = camera_of("location <1,2,-3> look_at 0 angle 40 right x*1.5 sky <0,1,1>");
  const CameraDesc b = camera_of("sky <0,1,1> right x*1.5 angle 40 look_at 0 location <1,2,-3>");
  expect_near(a.direction, b.direction);
  expect_near(a.right, b.right);
  expect_near(a.up, b.up);
}

TEST(UnitParserCamera, OrderMattersBefore35) {
  // angle before right: the direction is as long as the default right makes it.
  const CameraDesc c = camera_of("angle 60 right x*2", "#version 3.1;");
  EXPECT_NEAR(length(c.direction), 1.33 / 2.0 / std::tan(M_PI / 6.0), 1e-12);
  const CameraDesc d = camera_of("location -z*5 look_at 0 translate y", "#version 3.1;");
  expect_near(d.location, {0, 1, -5});
}

TEST(UnitParserCamera, LookingAlongTheSkyKeepsRight) {
  const CameraDesc c = camera_of("location y*5 look_at 0");
  expect_near(c.direction, {0, -1, 0});
  expect_near(c.right, {1.33, 0, 0});
  expect_near(c.up, {0, 0, 1});
}

TEST(UnitParserCamera, OrthographicGrowsToLookAtWithoutRightAndUp) {
  const CameraDesc a = camera_of("orthographic location -z*10 look_at 0");
  expect_near(a.right, {13.3, 0, 0});
  expect_near(a.up, {0, 10, 0});
  const CameraDesc b = camera_of("orthographic location -z*10 look_at 0 right x*4 up y*3");
  expect_near(b.right, {4, 0, 0});
  expect_near(b.up, {0, 3, 0});
}

TEST(UnitParserCamera, OrthographicWithAngle) {
  const CameraDesc c = camera_of("orthographic location -z*10 look_at 0 right x*4 up y*3 angle 90");
  expect_near(c.right, {20, 0, 0});  // 2 * 10 * tan(45)
  expect_near(c.up, {0, 15, 0});
}

TEST(UnitParserCamera, ObliqueVectorsStayWithoutLookAt) {
  const CameraDesc c = camera_of("location <1,2,3> direction <.5,0,1> right <2,.1,0> up y");
  EXPECT_EQ(c.direction, Vec3(0.5, 0, 1));
  EXPECT_EQ(c.right, Vec3(2, 0.1, 0));
}

TEST(UnitParserCamera, TransformsComeLast) {
  const CameraDesc c = camera_of("translate <0,1,0> rotate y*90 location -z*5 look_at 0");
  expect_near(c.location, {-5, 1, 0});
  expect_near(c.direction, {1, 0, 0});
  expect_near(c.right, {0, 0, -1.33});
  EXPECT_NEAR(c.look_at_distance(), 5.0, 1e-12);
}

TEST(UnitParserCamera, NamedCameraTakesTransforms) {
  const SceneText s("#declare C = camera { location -z*5 look_at 0 } camera { C translate x }");
  expect_near(s.scene.camera->location, {1, 0, -5});
}

TEST(UnitParserCamera, LastOneWins) {
  const SceneText s("camera { location x } camera { location y }");
  EXPECT_EQ(s.scene.camera->location, Vec3(0, 1, 0));
  EXPECT_TRUE(s.warned("More than one camera"));
}

TEST(UnitParserCamera, DefaultCamera) {
  const SceneText s("#default { camera { right x*2 } } camera { location x }");
  EXPECT_EQ(s.scene.camera->right, Vec3(2, 0, 0));
}

TEST(UnitParserCamera, OtherKindsAreKept) {
  EXPECT_EQ(camera_of("fisheye angle 200").angle, 200.0);
  EXPECT_EQ(camera_of("cylinder 3 angle 90").cylinder_type, 3);
  const CameraDesc c = camera_of("spherical angle 180");
  EXPECT_EQ(c.horizontal_angle, 180.0);
  EXPECT_EQ(c.vertical_angle, 90.0);
  const CameraDesc m = camera_of("mesh_camera { 1 1 mesh { triangle { 0, x, y } } } location 0");
  EXPECT_EQ(m.kind, CameraKind::kMesh);
  EXPECT_EQ(m.meshes.size(), 1u);
}

TEST(UnitParserCamera, FocalBlurIsKept) {
  const CameraDesc c = camera_of("location -z*5 aperture .4 blur_samples 4, 20 focal_point 0");
  EXPECT_EQ(c.blur_samples_min, 4);
  EXPECT_EQ(c.blur_samples, 20);
  EXPECT_NEAR(c.focal_distance, 5.0, 1e-12);
}

TEST(UnitParserCamera, Lenticular) {
  const CameraDesc c = camera_of(
      "lenticular location 1 direction z right x*8 up y*6 lens_pitch 1.124 lens_focal_length 3.03 "
      "lens_ior 1.6 lens_pixels 15 lens_front 50 view_distance 0 lens_model pinhole");
  EXPECT_EQ(c.kind, CameraKind::kLenticular);
  EXPECT_EQ(c.lens.pitch, 1.124);
  EXPECT_EQ(c.lens.focal_length, 3.03);
  EXPECT_EQ(c.lens.ior, 1.6);
  EXPECT_EQ(c.lens.pixels, 15.0);
  EXPECT_EQ(c.lens.front, 50.0);
  EXPECT_EQ(c.lens.view_distance, 0.0);
  EXPECT_EQ(c.lens.model, LensModel::kPinhole);
  EXPECT_FALSE(c.lens.print_dpi.has_value());
  expect_near(c.right, {8, 0, 0});
}

TEST(UnitParserCamera, ThickLens) {
  const CameraDesc c = camera_of("lenticular lens_model thick lens_rays 5");
  EXPECT_EQ(c.lens.model, LensModel::kThick);
  EXPECT_EQ(c.lens.rays, 5);
  EXPECT_FALSE(camera_of("lenticular lens_model thick").lens.rays.has_value());
  EXPECT_EQ(camera_of("lenticular lens_slant -12.5").lens.slant, -12.5);
  EXPECT_FALSE(c.lens.slant.has_value());
}

/// The words of the sheet stay free for identifiers, even where they are used as words.
TEST(UnitParserCamera, LensWordsAreContextual) {
  const CameraDesc c = camera_of("lenticular lens_pitch lens_pitch * 2 lens_model paraxial",
                                 "#declare lens_pitch = .5; #declare lenticular = 3; "
                                 "#declare paraxial = sphere { 0, lenticular }");
  EXPECT_EQ(c.lens.pitch, 1.0);
  EXPECT_EQ(c.lens.model, LensModel::kParaxial);
}

TEST(ErrorParserCamera, UnknownWord) {
  const std::string m = failure("camera { banana }");
  EXPECT_NE(m.find("expected one of perspective"), std::string::npos) << m;
}
TEST(ErrorParserCamera, LensWordWithoutLenticular) {
  EXPECT_NE(failure("camera { lens_pitch 1 }").find("lenticular"), std::string::npos);
}
TEST(ErrorParserCamera, NegativeAngle) {
  EXPECT_EQ(failure("camera { angle -1 }"), "Negative viewing angle.");
}
TEST(ErrorParserCamera, AngleTooWide) {
  EXPECT_EQ(failure("camera { angle 180 }"), "Viewing angle has to be smaller than 180 degrees.");
}
TEST(ErrorParserCamera, LookAtIsLocation) {
  EXPECT_EQ(failure("camera { location x look_at x }"),
            "Camera location and look_at point must be different.");
}
TEST(ErrorParserCamera, CylinderType) {
  EXPECT_EQ(failure("camera { cylinder 5 }"),
            "Invalid cylinder camera type; valid are types 1 to 4.");
}
TEST(ErrorParserCamera, LensModel) {
  EXPECT_NE(failure("camera { lenticular lens_model banana }").find("paraxial, pinhole, thick"),
            std::string::npos);
}
TEST(ErrorParserCamera, LensRays) {
  for (const char* value : {"0", "1.5", "1025", "-3"}) {
    EXPECT_EQ(failure(std::string("camera { lenticular lens_rays ") + value + " }"),
              "lens_rays must be a whole number from 1 to 1024.");
  }
}
TEST(ErrorParserCamera, LensValueOutOfRange) {
  EXPECT_EQ(failure("camera { lenticular lens_pitch 0 }"), "lens_pitch must be greater than 0.");
  EXPECT_EQ(failure("camera { lenticular lens_ior .5 }"), "lens_ior must be at least 1.");
}
TEST(ErrorParserCamera, NamedCameraTakesNothingElse) {
  EXPECT_NE(failure("#declare C = camera { } camera { C location x }").find("camera identifier"),
            std::string::npos);
}
TEST(ErrorParserCamera, BlurSamples) {
  EXPECT_EQ(failure("camera { blur_samples 0 }"), "Illegal number of focal blur samples.");
}

}  // namespace
}  // namespace lentray::parser::test
