// Object statements -> descriptions.
#include <filesystem>

#include "tests/unit/parser/scene_text.h"

namespace lentray::parser::test {
namespace {

using core::Vec3;

TEST(UnitParserObject, SphereAndBox) {
  const SceneText s("sphere { <1, 2, 3>, 4 } box { -1, <1, 2, 3> }");
  EXPECT_EQ(s.shape<SphereShape>(0).centre, Vec3(1, 2, 3));
  EXPECT_EQ(s.shape<SphereShape>(0).radius, 4.0);
  EXPECT_EQ(s.shape<BoxShape>(1).corner1, Vec3(-1, -1, -1));
  EXPECT_EQ(s.shape<BoxShape>(1).corner2, Vec3(1, 2, 3));
}

TEST(UnitParserObject, RoundOnes) {
  const SceneText s(
      "cylinder { 0, y*2, .5 open } cone { 0, 1, y, .25 } torus { 2, .5 sturm }"
      "disc { y, <0, 1, 0>, 3, 1 } plane { y*2, -1 }");
  EXPECT_TRUE(s.shape<CylinderShape>(0).open);
  EXPECT_EQ(s.shape<CylinderShape>(0).cap, Vec3(0, 2, 0));
  EXPECT_EQ(s.shape<ConeShape>(1).cap_radius, 0.25);
  EXPECT_FALSE(s.shape<ConeShape>(1).open);
  EXPECT_TRUE(s.object(2).sturm);
  EXPECT_EQ(s.shape<DiscShape>(3).hole, 1.0);
  EXPECT_EQ(s.shape<PlaneShape>(4).distance, -1.0);
}

TEST(UnitParserObject, Flat) {
  const SceneText s(
      "triangle { 0, x, y } smooth_triangle { 0, z, x, z, y, z }"
      "polygon { 4, <0,0>, <1,0>, <1,1>, <0,0> }"
      "quadric { <1,2,3>, <4,5,6>, <7,8,9>, 10 }");
  EXPECT_EQ(s.shape<TriangleShape>(0).p[2], Vec3(0, 1, 0));
  EXPECT_EQ(s.shape<Sparse<SmoothTriangleShape>>(1)->n[1], Vec3(0, 0, 1));
  EXPECT_EQ(s.shape<PolygonShape>(2).points.size(), 4u);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(s.shape<Sparse<QuadricShape>>(3)->c[i], i + 1.0);
}

TEST(UnitParserObject, ADirectiveMayStandBeforeTheBrace) {
  const SceneText s(
      "#local A = #if (1) merge #else union #end { sphere { 0, 1 } sphere { x, 1 } } object { A }");
  EXPECT_EQ(s.shape<CsgShape>().operation, CsgOperation::kMerge);
}

TEST(UnitParserObject, ADirectiveWithoutItsHashEndsADeclaration) {
  const SceneText s(
      "#declare T = texture { pigment { rgb x } } declare S = sphere { 0, 1 texture { T } } object "
      "{ S }");
  EXPECT_EQ(s.object(0).keyword, "sphere");
}

TEST(UnitParserObject, AHashBeforeAStatementMeansNothing) {
  const SceneText s("#sphere { 0, 1 #pigment { rgb 1 } } #declare A = 1; #object { box { 0, A } }");
  EXPECT_EQ(s.object(0).keyword, "sphere");
  EXPECT_EQ(s.object(1).keyword, "box");
}

TEST(UnitParserObject, SplitUnionMeansNothingInAMerge) {
  const SceneText s("merge { sphere { 0, 1 } sphere { x, 1 } split_union off }");
  EXPECT_TRUE(s.shape<CsgShape>().split_union);
}

TEST(UnitParserObject, CsgChildrenInOrder) {
  const SceneText s(
      "#declare A = sphere { 0, 1 } difference { box { 0, 1 } A object { A translate x } }");
  const CsgShape& csg = s.shape<CsgShape>();
  EXPECT_EQ(csg.operation, CsgOperation::kDifference);
  ASSERT_EQ(csg.children->size(), 3u);
  EXPECT_EQ((*csg.children)[0]->keyword, "box");
  EXPECT_TRUE((*csg.children)[1]->transform->is_identity());
  EXPECT_EQ((*csg.children)[2]->transform->point({}), Vec3(1, 0, 0));
}

TEST(UnitParserObject, IdentifierIsCopiedBeforeItChanges) {
  const SceneText s(
      "#declare A = sphere { 0, 1 hollow } object { A translate y hollow off } object { A }");
  EXPECT_EQ(s.object(0).transform->point({}), Vec3(0, 1, 0));
  EXPECT_EQ(s.object(0).hollow, false);
  EXPECT_TRUE(s.object(1).transform->is_identity());
  EXPECT_EQ(s.object(1).hollow, true);
}

TEST(UnitParserObject, IdentifierInsideItsOwnStatement) {
  const SceneText s(
      "#declare A = difference { box { 0, 1 } sphere { 0, .5 } } sphere { A scale 2 } union { A }");
  EXPECT_EQ(s.object(0).csg()->operation, CsgOperation::kDifference);
  EXPECT_EQ(s.object(1).csg()->operation, CsgOperation::kDifference);
}

TEST(UnitParserObject, Flags) {
  const SceneText s(
      "torus { 1, .2 no_shadow no_image no_reflection hollow double_illuminate inverse sturm }"
      "sphere { 0, 1 no_image off inverse inverse hollow no }");
  const ObjectDesc& on = s.object(0);
  EXPECT_TRUE(on.no_shadow && on.no_image && on.no_reflection && on.inverse && on.sturm);
  EXPECT_EQ(on.hollow, true);
  EXPECT_EQ(on.double_illuminate, true);
  const ObjectDesc& off = s.object(1);
  EXPECT_FALSE(off.no_shadow || off.no_image || off.no_reflection || off.inverse);
  EXPECT_EQ(off.hollow, false);
}

TEST(UnitParserObject, TransformsComposeInOrder) {
  const SceneText s("sphere { 0, 1 translate x scale 2 rotate z*90 }");
  expect_near(s.object().transform->point({}), {0, 2, 0});
}

TEST(UnitParserObject, ClipsFollowLaterTransformsOnly) {
  const SceneText s("sphere { 0, 1 translate x clipped_by { plane { y, 0 } } translate y*3 }");
  ASSERT_EQ(s.object().rare->clipped_by.size(), 1u);
  expect_near(s.object().rare->clipped_by[0]->transform->point({}), {0, 3, 0});
}

TEST(UnitParserObject, BoundsLinkedWithClips) {
  const SceneText s(
      "sphere { 0, 1 clipped_by { box { -1, 1 } box { 0, 1 } rotate y*90 } bounded_by { clipped_by "
      "} }"
      "sphere { 0, 1 bounded_by { box { -1, 1 } } clipped_by { bounded_by } }");
  EXPECT_EQ(s.object(0).rare->clipped_by.size(), 2u);
  EXPECT_EQ(s.object(0).rare->bounded_by.size(), 2u);
  expect_near(s.object(0).rare->bounded_by[1]->transform->point({1, 0, 0}), {0, 0, -1});
  EXPECT_EQ(s.object(1).rare->clipped_by.size(), 1u);
  EXPECT_TRUE(s.object(1).bounds_are_clips);
}

TEST(UnitParserObject, Mesh) {
  const SceneText s(
      "mesh { triangle { 0, x, y } smooth_triangle { x, z, y, z, x+y, z uv_vectors <0,0>, <1,0>, "
      "<0,1> }"
      " triangle { 0, 0, x } inside_vector z }");
  const MeshShape& mesh = *s.shape<std::shared_ptr<const MeshShape>>();
  EXPECT_EQ(mesh.faces.size(), 2u);  // the third has no area
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(mesh.normals.size(), 1u);
  EXPECT_EQ(mesh.face_normals[0][0], core::kNoIndex);
  EXPECT_EQ(mesh.face_normals[1][0], 0u);
  EXPECT_TRUE(mesh.face_textures.empty());
  EXPECT_EQ(mesh.uvs.size(), 3u);
  EXPECT_EQ(*mesh.inside_vector, Vec3(0, 0, 1));
}

TEST(UnitParserObject, Mesh2) {
  const SceneText s(
      "mesh2 { vertex_vectors { 4, 0, x, y, x+y } normal_vectors { 4, z, z, z, z }"
      " uv_vectors { 3, <0,0>, <1,0>, <0,1> }"
      " texture_list { 2, texture { pigment { rgb 1 } }, texture { pigment { rgb 0 } } }"
      " face_indices { 2, <0,1,2>, 0, <1,3,2>, 1, 0, 1 } uv_indices { 2, <0,1,2>, <2,1,0> } }");
  const MeshShape& mesh = *s.shape<std::shared_ptr<const MeshShape>>();
  ASSERT_EQ(mesh.faces.size(), 2u);
  EXPECT_EQ(mesh.face_textures[0], (core::MeshTriple{0, 0, 0}));
  EXPECT_EQ(mesh.face_textures[1], (core::MeshTriple{1, 0, 1}));
  EXPECT_EQ(mesh.face_normals[1],
            (core::MeshTriple{1, 3, 2}));  // without normal_indices: the vertices'
  EXPECT_EQ(mesh.face_uvs[1], (core::MeshTriple{2, 1, 0}));
}

TEST(UnitParserObject, PolynomialPutsTermsWherePolyHasThem) {
  const SceneText s(
      "polynomial { 2, xyz(2,0,0): 1, xyz(1,1,0): 2, xyz(0,0,1): 9, xyz(0,0,0): 10 }"
      "poly { 2, <1,2,0,0,0,0,0,0,9,10> }");
  EXPECT_EQ(s.shape<PolyShape>(0).coefficients, s.shape<PolyShape>(1).coefficients);
}

/// Every primitive that is kept for later is read whole, modifiers included.
TEST(UnitParserObject, KeptShapes) {
  ParserOptions options;
  options.library_paths.push_back("/usr/share/povray-3.7/include");  // fonts
  const SceneText s(R"(
    #declare F = function { x*x + y*y + z*z - 1 }
    blob { threshold .6 sphere { 0, 1, 2 pigment { rgb 1 } translate x } cylinder { 0, x, 1, strength 1 } sturm }
    bicubic_patch { type 1 flatness .1 u_steps 3 v_steps 3
      <0,0,0> <1,0,0> <2,0,0> <3,0,0> <0,1,0> <1,1,0> <2,1,0> <3,1,0>
      <0,2,0> <1,2,0> <2,2,0> <3,2,0> <0,3,0> <1,3,0> <2,3,0> <3,3,0> }
    isosurface { function { F(x, y, z) } contained_by { box { -2, 2 } } max_gradient 4 accuracy .01 open }
    isosurface { function { x + y } contained_by { sphere { 0, 2 } } evaluate 1, 2, .7 all_intersections }
    julia_fractal { <-.083, 0, -.83, -.025> quaternion sqr max_iteration 8 precision 15 slice <0,0,0,1>, 0 }
    lathe { cubic_spline 5, <0,0>, <1,0>, <2,1>, <1,2>, <0,3> sturm }
    ovus { 1, .5 }
    parametric { function { u }, function { v }, function { u*v } <0,0>, <1,1>
      contained_by { box { -1, 1 } } precompute 5 x, y, z }
    cubic { <1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1> }
    prism { linear_sweep linear_spline 0, 1, 4, <0,0>, <1,0>, <1,1>, <0,0> open }
    prism { conic_sweep bezier_spline 0, 1, 4, <0,0>, <1,0>, <1,1>, <0,0> }
    sor { 5, <0,0>, <1,0>, <1,1>, <.5,2>, <0,3> open }
    sphere_sweep { b_spline 4, 0, .1, x, .1, y, .2, z, .3 tolerance .1 }
    superellipsoid { <.25, .3> rotate x*20 }
    text { internal 1 "abc" 1, 0 }
    text { ttf "cyrvetic.ttf" "abc" .5, <.1, 0, 0> pigment { rgb 1 } }
    height_field { function 20, 20 { F(x, y, 0) } smooth water_level .1 }
  )",
                    options);
  EXPECT_EQ(s.scene.objects.size(), 17u);
  EXPECT_EQ(s.shape<std::shared_ptr<const BlobShape>>(0)->elements.size(), 2u);
  EXPECT_EQ(s.shape<std::shared_ptr<const BlobShape>>(0)->elements[1].strength, 1.0);
  EXPECT_TRUE(s.shape<Sparse<IsosurfaceShape>>(2)->open);
  EXPECT_TRUE(s.shape<Sparse<IsosurfaceShape>>(3)->container.sphere);
  EXPECT_EQ(s.shape<Sparse<ParametricShape>>(7)->precompute_depth, 5);
  EXPECT_TRUE(s.shape<PrismShape>(10).conic_sweep);
  EXPECT_EQ(s.shape<SphereSweepShape>(12).radii[3], 0.3);
  EXPECT_EQ(std::filesystem::path(s.shape<Sparse<TextShape>>(15)->font.path).filename(),
            "cyrvetic.ttf");
}

TEST(UnitParserObject, ExtentInsideTrace) {
  const SceneText s(R"(
    #declare A = difference { sphere { 0, 2 } box { 0, 3 } translate x*10 }
    #declare Hit = trace(A, <10, 5, -.5>, -y);
    sphere { min_extent(A), max_extent(A).x }
    sphere { Hit, inside(A, <11, 1, 1>) + 10*inside(A, <9, 0, 0>) })");
  expect_near(s.shape<SphereShape>(0).centre, {8, -2, -2}, 1e-6);
  EXPECT_NEAR(s.shape<SphereShape>(0).radius, 12.0, 1e-6);
  expect_near(s.shape<SphereShape>(1).centre, {10, std::sqrt(3.75), -0.5}, 1e-9);
  EXPECT_EQ(s.shape<SphereShape>(1).radius, 10.0);
}

TEST(UnitParserObject, PatchPointsByName) {
  const SceneText s(
      "#declare P = <1, 2, 3>; bicubic_patch { type 0 u_steps 2 v_steps 2"
      " P, P, P, P P, P, P, P P, P, P, P P, P, P, P }");
  EXPECT_EQ(s.shape<std::shared_ptr<const BicubicPatchShape>>()->points[15], Vec3(1, 2, 3));
}

// One message a test ------------------------------------------------------------------------

TEST(ErrorParserObject, UnknownModifier) {
  const std::string m = failure("sphere { 0, 1 banana }");
  EXPECT_NE(m.find("expected one of translate, rotate"), std::string::npos) << m;
  EXPECT_NE(m.find("clipped_by"), std::string::npos) << m;
  EXPECT_NE(m.find("banana"), std::string::npos) << m;
}
TEST(ErrorParserObject, ObjectMissing) {
  const std::string m = failure("object { pigment { rgb 1 } }");
  EXPECT_NE(m.find("expected an object: one of"), std::string::npos) << m;
  EXPECT_NE(m.find("superellipsoid"), std::string::npos) << m;
}
TEST(ErrorParserObject, MissingBrace) {
  EXPECT_NE(failure("sphere 0, 1 }").find("{"), std::string::npos);
}
TEST(ErrorParserObject, UnclosedBlock) {
  EXPECT_NE(failure("sphere { 0, 1").find("}"), std::string::npos);
}
TEST(ErrorParserObject, DegeneratePlane) {
  EXPECT_EQ(failure("plane { 0, 1 }"), "Degenerate plane normal.");
}
TEST(ErrorParserObject, ModifierOfOtherObjects) {
  EXPECT_EQ(failure("sphere { 0, 1 sturm }"),
            "sturm holds for blob, lathe, ovus, poly, prism, sor and torus only.");
}
TEST(ErrorParserObject, DegenerateCylinder) {
  EXPECT_EQ(failure("cylinder { x, x, 1 }"), "Degenerate cylinder, base point = apex point.");
}
TEST(ErrorParserObject, DegenerateCone) {
  EXPECT_EQ(failure("cone { x, 1, x, 0 }"), "Degenerate cone, base point = apex point.");
}
TEST(ErrorParserObject, PolygonTooShort) {
  EXPECT_EQ(failure("polygon { 2, x, y }"), "Polygon needs at least three points.");
}
TEST(ErrorParserObject, InteriorTextureAlone) {
  EXPECT_EQ(failure("sphere { 0, 1 interior_texture { pigment { rgb 1 } } }"),
            "interior_texture requires an exterior texture.");
}
TEST(ErrorParserObject, LongListsAreShownInPart) {
  try {
    SceneText("sphere { 0, 1 pigmnt { rgb 1 } }");
    ADD_FAILURE() << "no error";
  } catch (const ParseError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("expected one of pigment, translate, rotate, scale, matrix, transform, "),
              text.npos)
        << text;
    EXPECT_NE(
        text.find(
            " others or } but found the undeclared identifier 'pigmnt', did you mean 'pigment'?"),
        text.npos)
        << text;
    EXPECT_NE(error.message().find("double_illuminate"), text.npos) << "whole for programs";
  }
}
TEST(ErrorParserObject, SplitUnionElsewhere) {
  EXPECT_EQ(failure("sphere { 0, 1 split_union on }"), "split_union holds for a union only.");
}
TEST(ErrorParserObject, CutawayElsewhere) {
  EXPECT_EQ(failure("union { sphere { 0, 1 } cutaway_textures }"),
            "cutaway_textures holds for intersection and difference only.");
}
TEST(ErrorParserObject, UvMappingAfterTexture) {
  EXPECT_EQ(failure("sphere { 0, 1 pigment { rgb 1 } uv_mapping }"),
            "uv_mapping must be specified before texture.");
}
TEST(ErrorParserObject, OldLightSource) {
  EXPECT_NE(failure("sphere { 0, 1 light_source { 0 rgb 1 } }").find("looks_like"),
            std::string::npos);
}
TEST(ErrorParserObject, ClipsAfterLinking) {
  EXPECT_EQ(failure("sphere { 0, 1 clipped_by { box { 0, 1 } } bounded_by { clipped_by } "
                    "clipped_by { box { 0, 1 } } }"),
            "Cannot add clips after linking bounds and clips.");
}
TEST(ErrorParserObject, BoundsAfterLinking) {
  EXPECT_EQ(failure("sphere { 0, 1 clipped_by { box { 0, 1 } } bounded_by { clipped_by } "
                    "bounded_by { box { 0, 1 } } }"),
            "Cannot add bounds after linking bounds and clips.");
}
TEST(ErrorParserObject, MeshIndexOutOfRange) {
  EXPECT_EQ(failure("mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0,1,3> } }"),
            "Mesh vertex index 3 is out of range: there are 3.");
}
TEST(ErrorParserObject, MeshWithoutTriangles) {
  EXPECT_NE(failure("mesh { }").find("triangle or smooth_triangle"), std::string::npos);
}
TEST(ErrorParserObject, RadiosityImportance) {
  EXPECT_EQ(failure("sphere { 0, 1 radiosity { importance 2 } }"),
            "Radiosity importance must be greater than 0 and at most 1.");
}
TEST(ErrorParserObject, HeightFieldFileMissing) {
  EXPECT_EQ(failure("height_field { png \"no_such_file.png\" }"),
            "Cannot find the height_field's file \"no_such_file.png\".");
}
TEST(ErrorParserObject, PrismTooShort) {
  EXPECT_EQ(failure("prism { 0, 1, 2, <0,0>, <1,1> }"), "A prism must have at least three points.");
}
TEST(ErrorParserObject, PolyOrder) {
  EXPECT_EQ(failure("poly { 99, <1> }"), "The order of a poly must be 2 to 35.");
}

}  // namespace
}  // namespace lentray::parser::test
