// Every formula of the sheet against values computed apart from the program, with 40 digits, from
// the definitions (sin t = n sin t_in by arcus functions, offsets as differences of lengths).
#include "camera/lens_sheet.h"

#include <gtest/gtest.h>

#include <cmath>

#include "camera/lenticular.h"

namespace lentray::camera {
namespace {

constexpr double kCameraLensSheetInf = LensParameters::kInfinity;

struct Expected {
  LensParameters lens;
  std::uint32_t width;
  double eye_slope;
  std::uint32_t column, lens_index;
  double axis, cell_centre, centre, cell_offset, lens_offset, slope;
};

// A row a case.
// clang-format off
const Expected kColumns[] = {
    {{1.124, 3.03, 1.6, 15, kCameraLensSheetInf, LensModel::kPinhole}, 150, 0, 0, 0,
     -5.058, -5.058, -5.5825333333333333333,
     -0.52453333333333333333, -0.52453333333333333333, -0.28369203019532764489},
    {{1.124, 3.03, 1.6, 15, kCameraLensSheetInf, LensModel::kPinhole}, 150, 0, 1, 0,
     -5.058, -5.058, -5.5076,
     -0.4496, -0.4496, -0.24159790580935154705},
    {{1.124, 3.03, 1.6, 15, kCameraLensSheetInf, LensModel::kPinhole}, 150, 0, 7, 0,
     -5.058, -5.058, -5.058,
     0.0, 0.0, 0.0},
    {{1.124, 3.03, 1.6, 15, kCameraLensSheetInf, LensModel::kPinhole}, 150, 0, 8, 0,
     -5.058, -5.058, -4.9830666666666666667,
     0.074933333333333333333, 0.074933333333333333333, 0.039587646475596155146},
    {{1.124, 3.03, 1.6, 15, kCameraLensSheetInf, LensModel::kPinhole}, 150, 0, 22, 1,
     -3.934, -3.934, -3.934,
     0.0, 0.0, 0.0},
    {{1.124, 3.03, 1.6, 15, kCameraLensSheetInf, LensModel::kPinhole}, 150, 0, 75, 5,
     0.562, 0.562, 0.037466666666666666667,
     -0.52453333333333333333, -0.52453333333333333333, -0.28369203019532764489},
    {{1.124, 3.03, 1.6, 15, kCameraLensSheetInf, LensModel::kPinhole}, 150, 0, 76, 5,
     0.562, 0.562, 0.1124,
     -0.4496, -0.4496, -0.24159790580935154705},
    {{1.124, 3.03, 1.6, 15, kCameraLensSheetInf, LensModel::kPinhole}, 150, 0, 149, 9,
     5.058, 5.058, 5.5825333333333333333,
     0.52453333333333333333, 0.52453333333333333333, 0.28369203019532764489},
    {{1.124, 3.03, 1.6, 15, kCameraLensSheetInf, LensModel::kParaxial}, 150, 0, 0, 0,
     -5.058, -5.058, -5.5825333333333333333,
     -0.52453333333333333333, -0.52453333333333333333, -0.2769812981298129813},
    {{1.124, 3.03, 1.6, 15, kCameraLensSheetInf, LensModel::kParaxial}, 150, 0, 1, 0,
     -5.058, -5.058, -5.5076,
     -0.4496, -0.4496, -0.23741254125412541254},
    {{1.124, 3.03, 1.6, 15, kCameraLensSheetInf, LensModel::kParaxial}, 150, 0, 7, 0,
     -5.058, -5.058, -5.058,
     0.0, 0.0, 0.0},
    {{1.124, 3.03, 1.6, 15, kCameraLensSheetInf, LensModel::kParaxial}, 150, 0, 8, 0,
     -5.058, -5.058, -4.9830666666666666667,
     0.074933333333333333333, 0.074933333333333333333, 0.039568756875687568757},
    {{1.124, 3.03, 1.6, 15, kCameraLensSheetInf, LensModel::kParaxial}, 150, 0, 22, 1,
     -3.934, -3.934, -3.934,
     0.0, 0.0, 0.0},
    {{1.124, 3.03, 1.6, 15, kCameraLensSheetInf, LensModel::kParaxial}, 150, 0, 75, 5,
     0.562, 0.562, 0.037466666666666666667,
     -0.52453333333333333333, -0.52453333333333333333, -0.2769812981298129813},
    {{1.124, 3.03, 1.6, 15, kCameraLensSheetInf, LensModel::kParaxial}, 150, 0, 76, 5,
     0.562, 0.562, 0.1124,
     -0.4496, -0.4496, -0.23741254125412541254},
    {{1.124, 3.03, 1.6, 15, kCameraLensSheetInf, LensModel::kParaxial}, 150, 0, 149, 9,
     5.058, 5.058, 5.5825333333333333333,
     0.52453333333333333333, 0.52453333333333333333, 0.2769812981298129813},
    {{1.124, 3.03, 1.6, 14, 400, LensModel::kParaxial}, 140, 0, 0, 0,
     -5.058, -5.08194646875, -5.6062742790178571429,
     -0.52432781026785714286, -0.54827427901785714286, -0.28951777109853842527},
    {{1.124, 3.03, 1.6, 14, 400, LensModel::kParaxial}, 140, 0, 1, 0,
     -5.058, -5.08194646875, -5.5256084620535714286,
     -0.44366199330357142857, -0.46760846205357142857, -0.24692196016030174446},
    {{1.124, 3.03, 1.6, 14, 400, LensModel::kParaxial}, 140, 0, 7, 0,
     -5.058, -5.08194646875, -5.0416135602678571429,
     0.040332908482142857143, 0.016386439732142857143, 0.0086529054691183404055},
    {{1.124, 3.03, 1.6, 14, 400, LensModel::kParaxial}, 140, 0, 8, 0,
     -5.058, -5.08194646875, -4.9609477433035714286,
     0.12099872544642857143, 0.097052256696428571429, 0.051248716407355021216},
    {{1.124, 3.03, 1.6, 14, 400, LensModel::kParaxial}, 140, 0, 22, 1,
     -3.934, -3.95262503125, -3.8316263058035714286,
     0.12099872544642857143, 0.10237369419642857143, 0.054058716407355021216},
    {{1.124, 3.03, 1.6, 14, 400, LensModel::kParaxial}, 140, 0, 70, 5,
     0.562, 0.56466071875, 0.040332908482142857143,
     -0.52432781026785714286, -0.52166709151785714286, -0.27546777109853842527},
    {{1.124, 3.03, 1.6, 14, 400, LensModel::kParaxial}, 140, 0, 71, 5,
     0.562, 0.56466071875, 0.12099872544642857143,
     -0.44366199330357142857, -0.44100127455357142857, -0.23287196016030174446},
    {{1.124, 3.03, 1.6, 14, 400, LensModel::kParaxial}, 140, 0, 139, 9,
     5.058, 5.08194646875, 5.6062742790178571429,
     0.52432781026785714286, 0.54827427901785714286, 0.28951777109853842527},
    {{0.9, 2.2, 1.5, 14, 350, LensModel::kPinhole}, 140, 0, 0, 0,
     -4.05, -4.0669714285714285714, -4.4865795918367346939,
     -0.41960816326530612245, -0.43657959183673469388, -0.30527643521814427804},
    {{0.9, 2.2, 1.5, 14, 350, LensModel::kPinhole}, 140, 0, 1, 0,
     -4.05, -4.0669714285714285714, -4.4220244897959183673,
     -0.35505306122448979592, -0.37202448979591836735, -0.25831166427739916627},
    {{0.9, 2.2, 1.5, 14, 350, LensModel::kPinhole}, 140, 0, 7, 0,
     -4.05, -4.0669714285714285714, -4.0346938775510204082,
     0.032277551020408163265, 0.015306122448979591837, 0.010436308310771088562},
    {{0.9, 2.2, 1.5, 14, 350, LensModel::kPinhole}, 140, 0, 8, 0,
     -4.05, -4.0669714285714285714, -3.9701387755102040816,
     0.096832653061224489796, 0.079861224489795918367, 0.054495735056013524997},
    {{0.9, 2.2, 1.5, 14, 350, LensModel::kPinhole}, 140, 0, 22, 1,
     -3.15, -3.1632, -3.0663673469387755102,
     0.096832653061224489796, 0.083632653061224489796, 0.057073836134272169458},
    {{0.9, 2.2, 1.5, 14, 350, LensModel::kPinhole}, 140, 0, 70, 5,
     0.45, 0.45188571428571428571, 0.032277551020408163265,
     -0.41960816326530612245, -0.41772244897959183673, -0.29145365733368473481},
    {{0.9, 2.2, 1.5, 14, 350, LensModel::kPinhole}, 140, 0, 71, 5,
     0.45, 0.45188571428571428571, 0.096832653061224489796,
     -0.35505306122448979592, -0.3531673469387755102, -0.24477053585312159603},
    {{0.9, 2.2, 1.5, 14, 350, LensModel::kPinhole}, 140, 0, 139, 9,
     4.05, 4.0669714285714285714, 4.4865795918367346939,
     0.41960816326530612245, 0.43657959183673469388, 0.30527643521814427804},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kPinhole}, 100, 0, 0, 0,
     -3.1924043419267299864, -3.2038642549490310684, -3.4241882893226176808,
     -0.22032403437358661239, -0.2317839473958876944, -0.26350260885092794495},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kPinhole}, 100, 0, 1, 0,
     -3.1924043419267299864, -3.2038642549490310684, -3.355012768326201162,
     -0.15114851337717009359, -0.16260842639947117559, -0.1829702132884658287},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kPinhole}, 100, 0, 7, 1,
     -2.6844043419267299864, -2.6940406652054413248, -2.9399596423477020492,
     -0.24591897714226072435, -0.25555530042097206276, -0.29181672980138681316},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kPinhole}, 100, 0, 8, 1,
     -2.6844043419267299864, -2.6940406652054413248, -2.8707841213512855304,
     -0.17674345614584420555, -0.18637977942455554396, -0.21037005590122867696},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kPinhole}, 100, 0, 22, 3,
     -1.6684043419267299864, -1.6743934857182618377, -1.9023268274014542671,
     -0.22793334168319242946, -0.23392248547472428069, -0.26603467612832113613},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kPinhole}, 100, 0, 50, 6,
     -0.14440434192672998643, -0.1449227164874926069, 0.034587760498208259402,
     0.1795104769857008663, 0.17899210242493824583, 0.20182713291456841356},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kPinhole}, 100, 0, 51, 6,
     -0.14440434192672998643, -0.1449227164874926069, 0.10376328149462477821,
     0.2486859979821173851, 0.24816762342135476464, 0.28297664822327967624},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kPinhole}, 100, 0, 99, 13,
     3.4115956580732700136, 3.4238424117176355982, 3.4241882893226176808,
     0.00034587760498208259402, 0.012592631249347667258, 0.014032602921485005807},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kParaxial}, 100, 0.21, 0, 0,
     -3.1924043419267299864, -3.0154027164874926069, -3.2357267508610792193,
     -0.22032403437358661239, -0.043322408934349232857, -0.048273541383989145183},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kParaxial}, 100, 0.21, 1, 0,
     -3.1924043419267299864, -3.0154027164874926069, -3.1665512298646627005,
     -0.15114851337717009359, 0.025853112062067285948, 0.028807753440589261485},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kParaxial}, 100, 0.21, 7, 1,
     -2.6844043419267299864, -2.5055791267439028633, -2.7514981038861635877,
     -0.24591897714226072435, -0.067093761959433601225, -0.07476162046908315565},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kParaxial}, 100, 0.21, 8, 1,
     -2.6844043419267299864, -2.5055791267439028633, -2.6823225828897470689,
     -0.17674345614584420555, 0.0020817590369829175799, 0.0023196743554952510176},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kParaxial}, 100, 0.21, 22, 3,
     -1.6684043419267299864, -1.4859319472567233761, -1.7138652889399158056,
     -0.22793334168319242946, -0.045460947013185819156, -0.050656483814692769917},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kParaxial}, 100, 0.21, 50, 6,
     -0.14440434192672998643, 0.043538821974045854643, 0.22304929895974672094,
     0.1795104769857008663, 0.36745364088647670737, 0.40944834270207404536},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kParaxial}, 100, 0.21, 51, 6,
     -0.14440434192672998643, 0.043538821974045854643, 0.29222481995616323975,
     0.2486859979821173851, 0.43662916188289322618, 0.48652963752665245203},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kParaxial}, 100, 0.21, 99, 13,
     3.4115956580732700136, 3.6123039501791740598, 3.6126498277841561424,
     0.00034587760498208259402, 0.2010541697108861288, 0.22403178910641597209},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kPinhole}, 100, -0.13, 0, 0,
     -3.1924043419267299864, -3.3205309216156977351, -3.5408549559892843475,
     -0.22032403437358661239, -0.34845061406255436106, -0.40675505593464870342},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kPinhole}, 100, -0.13, 1, 0,
     -3.1924043419267299864, -3.3205309216156977351, -3.4716794349928678287,
     -0.15114851337717009359, -0.27927509306613784226, -0.32046739574135275014},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kPinhole}, 100, -0.13, 7, 1,
     -2.6844043419267299864, -2.8107073318721079915, -3.0566263090143687159,
     -0.24591897714226072435, -0.37222196708763872943, -0.43752268560892983212},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kPinhole}, 100, -0.13, 8, 1,
     -2.6844043419267299864, -2.8107073318721079915, -2.9874507880179521971,
     -0.17674345614584420555, -0.30304644609122221063, -0.34962706493693926938},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kPinhole}, 100, -0.13, 22, 3,
     -1.6684043419267299864, -1.7910601523849285043, -2.0189934940681209338,
     -0.22793334168319242946, -0.35058915214139094736, -0.40949719654545767661},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kPinhole}, 100, -0.13, 50, 6,
     -0.14440434192672998643, -0.26158938315415927356, -0.082078906168458407264,
     0.1795104769857008663, 0.062325435758271579167, 0.06954721192161106622},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kPinhole}, 100, -0.13, 51, 6,
     -0.14440434192672998643, -0.26158938315415927356, -0.01290338517204188846,
     0.2486859979821173851, 0.13150095675468809797, 0.14746519203295828877},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kPinhole}, 100, -0.13, 99, 13,
     3.4115956580732700136, 3.3071757450509689316, 3.3075216226559510142,
     0.00034587760498208259402, -0.10407403541731899941, -0.11643033176054190202},
    {{1.0, 2.0, 1.0, 15, 600, LensModel::kPinhole}, 97, 0, 0, 0,
     -2.7333333333333333333, -2.7424444444444444444, -3.2106666666666666667,
     -0.46822222222222222222, -0.47733333333333333333, -0.23866666666666666667},
    {{1.0, 2.0, 1.0, 15, 600, LensModel::kPinhole}, 97, 0, 1, 0,
     -2.7333333333333333333, -2.7424444444444444444, -3.1437777777777777778,
     -0.40133333333333333333, -0.41044444444444444444, -0.20522222222222222222},
    {{1.0, 2.0, 1.0, 15, 600, LensModel::kPinhole}, 97, 0, 7, 0,
     -2.7333333333333333333, -2.7424444444444444444, -2.7424444444444444444,
     0.0, -0.0091111111111111111111, -0.0045555555555555555556},
    {{1.0, 2.0, 1.0, 15, 600, LensModel::kPinhole}, 97, 0, 8, 0,
     -2.7333333333333333333, -2.7424444444444444444, -2.6755555555555555556,
     0.066888888888888888889, 0.057777777777777777778, 0.028888888888888888889},
    {{1.0, 2.0, 1.0, 15, 600, LensModel::kPinhole}, 97, 0, 22, 1,
     -1.7333333333333333333, -1.7391111111111111111, -1.7391111111111111111,
     0.0, -0.0057777777777777777778, -0.0028888888888888888889},
    {{1.0, 2.0, 1.0, 15, 600, LensModel::kPinhole}, 97, 0, 48, 3,
     0.26666666666666666667, 0.26755555555555555556, 0.0,
     -0.26755555555555555556, -0.26666666666666666667, -0.13333333333333333333},
    {{1.0, 2.0, 1.0, 15, 600, LensModel::kPinhole}, 97, 0, 49, 3,
     0.26666666666666666667, 0.26755555555555555556, 0.066888888888888888889,
     -0.20066666666666666667, -0.19977777777777777778, -0.099888888888888888889},
    {{1.0, 2.0, 1.0, 15, 600, LensModel::kPinhole}, 97, 0, 96, 6,
     3.2666666666666666667, 3.2775555555555555556, 3.2106666666666666667,
     -0.066888888888888888889, -0.056, -0.028},
};
// clang-format on

TEST(UnitCameraLensSheet, ColumnsFollowTheFormulae) {
  for (const Expected& want : kColumns) {
    const LensSheet sheet(want.lens, want.width, want.eye_slope);
    const LensColumn& got = sheet.column(want.column);
    SCOPED_TRACE("N " + std::to_string(want.lens.pixels) + " column " +
                 std::to_string(want.column));
    EXPECT_EQ(got.lens, want.lens_index);
    EXPECT_NEAR(got.axis, want.axis, 1e-12);
    EXPECT_NEAR(got.cell_centre, want.cell_centre, 1e-12);
    EXPECT_NEAR(got.centre, want.centre, 1e-12);
    EXPECT_NEAR(got.cell_offset, want.cell_offset, 1e-12);
    EXPECT_NEAR(got.lens_offset, want.lens_offset, 1e-12);
    EXPECT_NEAR(got.slope, want.slope, 1e-12);
    EXPECT_FALSE(got.dark);
  }
}

TEST(UnitCameraLensSheet, PrintPitchAndPixelSize) {
  LensParameters lens;
  EXPECT_DOUBLE_EQ(lens.print_pitch(), 1.124);
  EXPECT_NEAR(lens.pixel_size(), 0.07493333333333333, 1e-16);
  lens.view_distance = 400.0;
  // 1.124 (1 + 3.03/640)
  EXPECT_NEAR(lens.print_pitch(), 1.1293214375, 1e-15);
  EXPECT_NEAR(pixels_for_dpi(lens, lens.print_dpi()), 15.0, 1e-13);
}

TEST(UnitCameraLensSheet, APixelCentredOnABoundaryBelongsToTheRight) {
  LensParameters lens;
  lens.pixels = 2.5;  // column 2 is centred at 2.5: exactly between lens 0 and lens 1
  const LensSheet sheet(lens, 10);
  EXPECT_EQ(sheet.column(1).lens, 0u);
  EXPECT_EQ(sheet.column(2).lens, 1u);
  EXPECT_NEAR(sheet.column(2).cell_offset, -0.5 * lens.pitch, 1e-15);
  EXPECT_EQ(sheet.column(7).lens, 3u);
}

TEST(UnitCameraLensSheet, TheLastLensMayBeCut) {
  LensParameters lens;
  lens.pixels = 14.0;
  const LensSheet sheet(lens, 31);
  EXPECT_EQ(sheet.lens_count(), 3u);
  EXPECT_DOUBLE_EQ(sheet.lenses(), 31.0 / 14.0);
  EXPECT_EQ(sheet.views(), 14u);
  EXPECT_EQ(view_width(sheet, 2, 14), 3u);
  EXPECT_EQ(view_width(sheet, 3, 14), 2u);
  EXPECT_EQ(view_column(14.0, 2, 14, 2), 30);
  // The sheet's middle is the middle of all pixels, cut lens included.
  EXPECT_NEAR(sheet.column(15).centre, 0.0, 1e-15);
}

TEST(UnitCameraLensSheet, FractionalPixelsHaveNoViews) {
  LensParameters lens;
  lens.pixels = 7.37;
  EXPECT_EQ(LensSheet(lens, 40).views(), 0u);
}

TEST(UnitCameraLensSheet, OddSheetsLookStraightAheadInTheMiddleView) {
  LensParameters lens;
  for (const double distance : {kCameraLensSheetInf, 300.0}) {
    lens.view_distance = distance;
    lens.model = LensModel::kParaxial;
    const LensSheet sheet(lens, 45);
    EXPECT_NEAR(sheet.column(22).slope, 0.0, 1e-15);
    EXPECT_NEAR(sheet.column(7).slope, sheet.column(7).axis / distance, 1e-15);
  }
}

TEST(UnitCameraLensSheet, TotalReflectionMakesPixelsDark) {
  LensParameters lens;
  lens.pitch = 6.0;
  lens.model = LensModel::kPinhole;
  const LensSheet sheet(lens, 30);
  // Dark beyond o = f/sqrt(n^2-1) = 2.4260...; offsets are multiples of 0.4.
  EXPECT_EQ(sheet.dark_columns(), 4u);
  EXPECT_TRUE(sheet.column(0).dark);
  EXPECT_FALSE(sheet.column(1).dark);
  EXPECT_TRUE(sheet.column(14).dark);
  EXPECT_TRUE(sheet.column(15).dark);
  EXPECT_NEAR(sheet.widest_pitch(), 5.1984461360294359, 1e-12);
  lens.pitch = sheet.widest_pitch() * (1.0 - 1e-12);
  EXPECT_EQ(LensSheet(lens, 30).dark_columns(), 0u);
  lens.pitch = sheet.widest_pitch() * (1.0 + 1e-12);
  EXPECT_GT(LensSheet(lens, 30).dark_columns(), 0u);
  lens.model = LensModel::kParaxial;
  EXPECT_EQ(LensSheet(lens, 30).dark_columns(), 0u);
}

TEST(UnitCameraLensSheet, WidestPitchHoldsForANearAndObliqueEye) {
  LensParameters lens;
  lens.pitch = 7.0;
  lens.view_distance = 200.0;
  const double widest = LensSheet(lens, 60, 0.3).widest_pitch();
  EXPECT_LT(widest, 7.0);
  lens.pitch = widest * (1.0 - 1e-9);
  EXPECT_EQ(LensSheet(lens, 60, 0.3).dark_columns(), 0u);
  lens.pitch = widest * (1.0 + 1e-9);
  EXPECT_EQ(LensSheet(lens, 60, 0.3).dark_columns(), 1u);
}

TEST(UnitCameraLensSheet, OffsetAndSlopeAreInverse) {
  LensParameters lens;
  for (const LensModel model : {LensModel::kParaxial, LensModel::kPinhole}) {
    lens.model = model;
    for (const double offset : {-2.0, -0.5, 0.0, 0.3, 1.7}) {
      double slope = 0.0;
      ASSERT_TRUE(slope_of(lens, offset, slope));
      EXPECT_NEAR(offset_of(lens, slope), offset, 1e-14);
    }
  }
}

TEST(UnitCameraLensSheet, OnlySnellMissesTheEye) {
  LensParameters lens;
  lens.view_distance = 100.0;
  lens.model = LensModel::kParaxial;
  EXPECT_EQ(LensSheet(lens, 600).largest_eye_miss(), 0.0);
  lens.model = LensModel::kPinhole;
  EXPECT_GT(LensSheet(lens, 600).largest_eye_miss(), 0.01);
  // The middle view alone: its eye is at 0, its ray through x_i has o = x_i f/(nV).
  lens.pixels = 1.0;
  const LensSheet one(lens, 41);
  double largest = 0.0;
  for (std::uint32_t i = 0; i < 41; ++i) {
    const double x = (i + 0.5 - 20.5) * lens.pitch;
    const double inside = std::asin(std::sin(std::atan(x / 100.0)) / lens.ior);
    const double miss =
        x * lens.focal_length / (lens.ior * 100.0) - lens.focal_length * std::tan(inside);
    largest = std::max(largest, std::fabs(miss) / lens.print_pitch());
  }
  EXPECT_NEAR(one.largest_eye_miss(), largest, 1e-12);
}

TEST(UnitCameraLensSheet, LeftOfIsTheSameViewAtWholePixels) {
  const LensSheet sheet({1.124, 3.03, 1.6, 5}, 48);
  for (int k = -9; k < 60; ++k) EXPECT_EQ(sheet.left_of(k), k - 5);
}

TEST(UnitCameraLensSheet, LeftOfIsTheNearestOffsetOfTheLensBefore) {
  for (const double pixels : {1.0, 1.3, 2.5, 7.37, 12.4, 15.000001, 1.0 / 0.07}) {
    LensParameters lens;
    lens.pixels = pixels;
    lens.view_distance = 400.0;
    const LensSheet sheet(lens, 200, 0.2);
    for (int k = 0; k < 200; ++k) {
      const std::int64_t left = sheet.left_of(k);
      SCOPED_TRACE("N " + std::to_string(pixels) + " column " + std::to_string(k));
      ASSERT_EQ(sheet.lens_of(left), sheet.lens_of(k) - 1);
      ASSERT_LT(left, k);
      const double offset = sheet.column(k).cell_offset;
      const auto away = [&](std::int64_t column) {
        return std::fabs(sheet.beside(column, 0.0, 0.0).cell_offset - offset);
      };
      for (std::int64_t other = left - 2; other <= left + 2; ++other) {
        if (sheet.lens_of(other) != sheet.lens_of(left)) continue;
        EXPECT_LE(away(left), away(other) + 1e-12) << other;
      }
    }
  }
}

TEST(UnitCameraLensSheet, BadParametersAreNamed) {
  LensParameters lens;
  EXPECT_EQ(complaint(lens), "");
  lens.pitch = 0.0;
  EXPECT_NE(complaint(lens).find("pitch"), std::string::npos);
  lens = {};
  lens.focal_length = -1.0;
  EXPECT_NE(complaint(lens).find("focal length"), std::string::npos);
  lens = {};
  lens.ior = 0.9;
  EXPECT_NE(complaint(lens).find("refractive index"), std::string::npos);
  lens = {};
  lens.pixels = 0.5;
  EXPECT_NE(complaint(lens).find("pixel"), std::string::npos);
  lens = {};
  lens.view_distance = 0.0;
  EXPECT_NE(complaint(lens).find("viewing distance"), std::string::npos);
}

TEST(UnitCameraLensSheet, AbsurdParametersAreNamed) {
  const auto refused = [](double LensParameters::*member, std::initializer_list<double> values) {
    for (const double value : values) {
      LensParameters lens;
      lens.*member = value;
      EXPECT_NE(complaint(lens), "") << value;
    }
  };
  refused(&LensParameters::pitch, {1e-300, 1e-7, 1e7, 1e300});
  refused(&LensParameters::focal_length, {1e-320, 1e-7, 1e7, 1e300});
  refused(&LensParameters::ior, {101.0, 1e300});
  refused(&LensParameters::pixels, {1e7, 1e300});
  refused(&LensParameters::view_distance, {1e-300, 1e13, 1e300});
}

}  // namespace
}  // namespace lentray::camera
