// The command line and INI files: precedence, forms, sections, and every message.
#include "parser/options/options.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace lentray::parser {
namespace {

namespace fs = std::filesystem;

/// A folder to write INI files and scenes into; also the current one while the test runs.
class UnitParserOptions : public ::testing::Test {
 protected:
  void SetUp() override {
    m_before = fs::current_path();
    std::string name = (fs::temp_directory_path() / "lentray-options-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    m_folder = name;
    fs::current_path(m_folder);
  }
  void TearDown() override {
    fs::current_path(m_before);
    fs::remove_all(m_folder);
  }
  static void write(const std::string& name, const std::string& text) {
    std::ofstream(name) << text;
  }
  static RenderOptions read(const std::vector<std::string>& arguments,
                            const OptionSources& sources = {}) {
    return read_options(arguments, sources);
  }
  /// The message that these arguments meet, or "" if there is none.
  static std::string message(const std::vector<std::string>& arguments) {
    try {
      (void)read(arguments);
    } catch (const OptionError& error) {
      return error.what();
    }
    return {};
  }
  static void expect_message(const std::vector<std::string>& arguments, const std::string& part) {
    const std::string text = message(arguments);
    EXPECT_NE(text.find(part), std::string::npos) << "got: " << text << "\nwanted: " << part;
  }

 private:
  fs::path m_before, m_folder;
};
using ErrorParserOptions = UnitParserOptions;

TEST_F(UnitParserOptions, DefaultsAreStocks) {
  const RenderOptions o = read({});
  EXPECT_EQ(o.width, 160);
  EXPECT_EQ(o.height, 120);
  EXPECT_EQ(o.quality, 9);
  EXPECT_EQ(o.bits, 8);
  EXPECT_TRUE(o.srgb);
  EXPECT_TRUE(o.output_to_file);
  EXPECT_EQ(o.type, core::FileType::png);
  EXPECT_FALSE(o.lenticular);
}

TEST_F(UnitParserOptions, SwitchesInEitherCaseAndSign) {
  const RenderOptions o = read({"+Ia b.pov", "-W640", "+h480", "+fn16", "+wt3", "+q5", "-V",
                                "-A0.3", "+R4", "-J", "-D", "+P", "+L/tmp", "+L/usr", "+L/tmp"});
  EXPECT_EQ(o.input, "a b.pov");
  EXPECT_EQ(o.width, 640);
  EXPECT_EQ(o.height, 480);
  EXPECT_EQ(o.bits, 16);
  EXPECT_EQ(o.threads, 3);
  EXPECT_EQ(o.quality, 5);
  EXPECT_FALSE(o.verbose);
  EXPECT_EQ(o.library_paths, (std::vector<std::string>{"/tmp", "/usr"}));
}

TEST_F(UnitParserOptions, LaterOptionsOverrideEarlierOnes) {
  write("a.ini", "Width=11\nHeight=12\n");
  EXPECT_EQ(read({"+W5", "a.ini"}).width, 11);
  EXPECT_EQ(read({"a.ini", "+W5"}).width, 5);
  EXPECT_EQ(read({"Width=7", "a", "Width=9"}).width, 9);
  EXPECT_EQ(read({"a.ini", "+W5"}).height, 12);
}

TEST_F(UnitParserOptions, TheFirstDefaultIniIsReadBeforeTheCommandLine) {
  write("first.ini", "Width=11\nReal_Time_Raytracing=on\n");
  write("second.ini", "Width=22\nHeight=33\n");
  OptionSources sources;
  sources.default_ini_files = {"missing.ini", "first.ini", "second.ini"};
  const RenderOptions o = read({"+H44"}, sources);
  EXPECT_EQ(o.width, 11);
  EXPECT_EQ(o.height, 44);
  // What a system-wide file asks for and is not there yet must not stop a run.
  ASSERT_EQ(o.warnings.size(), 1u);
  EXPECT_NE(o.warnings[0].find("first.ini:2: option Real_Time_Raytracing=on: not yet"),
            std::string::npos);
}

TEST_F(UnitParserOptions, IniSections) {
  write("res.ini",
        "; a comment\n"
        "Input_File_Name=\"my scene.pov\" ; trailing\n"
        "+W120 +H100\n"
        "[Low]\n"
        " Width = 80 \n"
        "[Really High]\r\n"
        "+W800 +H600\r\n");
  EXPECT_EQ(read({"res"}).width, 120);
  EXPECT_EQ(read({"res"}).height, 100);
  EXPECT_EQ(read({"res"}).input, "my scene.pov");
  EXPECT_EQ(read({"res.ini[low]"}).width, 80);
  EXPECT_EQ(read({"res.ini[low]"}).height, 100) << "what stands before all sections holds for each";
  EXPECT_EQ(read({"res.ini[low]"}).input, "my scene.pov");
  EXPECT_EQ(read({"res[REALLY HIGH]"}).width, 800);
  const RenderOptions missing = read({"res[medium]"});
  EXPECT_EQ(missing.width, 120);
  ASSERT_EQ(missing.warnings.size(), 1u);
  EXPECT_NE(missing.warnings[0].find("has no section [medium]: there are Low, Really High"),
            std::string::npos);
}

TEST_F(UnitParserOptions, AnIniLineOfSwitchesMayEndInAnOption) {
  write("animated.ini", "+Ia.pov +kf0.5 +kff20 +kc declare=fp=0\n+W64 Library_Path=some folder\n");
  fs::create_directory("some folder");
  const RenderOptions o = read({"animated"});
  ASSERT_EQ(o.declares.size(), 1u);
  EXPECT_EQ(o.declares[0].first, "fp");
  EXPECT_EQ(o.declares[0].second, "0");
  EXPECT_EQ(o.animation.final_frame, 20);
  EXPECT_EQ(o.width, 64);
  ASSERT_FALSE(o.library_paths.empty());
  EXPECT_EQ(o.library_paths.back(), "some folder");
}

TEST_F(UnitParserOptions, IniFilesNestAndLieOnLibraryPaths) {
  fs::create_directory("lib");
  write("lib/more.ini", "Height=77\n[x]\nHeight=78\n");
  write("outer.ini", "Library_Path=lib\nmore\nWidth=9\n");
  write("deep.ini", "Library_Path=lib\nmore[x]\n");
  EXPECT_EQ(read({"outer"}).height, 77);
  EXPECT_EQ(read({"outer"}).width, 9);
  EXPECT_EQ(read({"deep"}).height, 78);
}

TEST_F(UnitParserOptions, ScenesMayBeNamedBare) {
  write("plain.pov", "");
  EXPECT_EQ(read({"missing.POV"}).input, "missing.POV");
  EXPECT_EQ(read({"plain"}).input, "plain.pov");
  EXPECT_EQ(read({"+I-"}).input, "-");
}

TEST_F(UnitParserOptions, Declares) {
  const RenderOptions o =
      read({"Declare=A=1.5", "declare=b_2=-3e2", "Declare=A=7", "Declare=S=\"text\""});
  ASSERT_EQ(o.declares.size(), 3u);
  EXPECT_EQ(o.declares[0], (std::pair<std::string, std::string>("b_2", "-3e2")));
  EXPECT_EQ(o.declares[1], (std::pair<std::string, std::string>("A", "7")));
  EXPECT_EQ(o.declares[2], (std::pair<std::string, std::string>("S", "text")));
}

TEST_F(UnitParserOptions, OutputTypes) {
  EXPECT_EQ(read({"+FE"}).type, core::FileType::exr);
  EXPECT_EQ(read({"Output_File_Type=TIFF"}).type, core::FileType::tiff);
  EXPECT_EQ(read({"+FN16"}).bits, 16);
  EXPECT_EQ(read({"Bits_Per_Color=16"}).bits, 16);
  const RenderOptions off = read({"-FN16"});
  EXPECT_FALSE(off.output_to_file);
  EXPECT_EQ(off.bits, 16);
  EXPECT_FALSE(read({"Output_to_File=off"}).output_to_file);
  EXPECT_FALSE(read({"File_Gamma=1.0"}).srgb);
  EXPECT_EQ(read({"File_Gamma=1.8"}).file_gamma, 1.8);
  EXPECT_TRUE(read({"File_Gamma=2", "File_Gamma=srgb"}).srgb);
}

TEST_F(UnitParserOptions, LensOptions) {
  const RenderOptions o =
      read({"Lenticular=On", "Lens_Pitch=0.9", "Lens_Focal_Length=2.5", "lens_ior=1.5",
            "Lens_Pixels=7.37", "View_Distance=inf", "Sheet_Distance=12", "Lens_Front=0",
            "Lens_Model=Pinhole", "View=3", "Pixel_Order=Columns", "Shadow_Cache=depth",
            "Accelerator=list", "Statistics_File=s.json", "--dump-rays", "r.txt"});
  EXPECT_TRUE(o.lenticular);
  EXPECT_EQ(o.lens.pitch, 0.9);
  EXPECT_EQ(o.lens.focal_length, 2.5);
  EXPECT_EQ(o.lens.ior, 1.5);
  EXPECT_EQ(o.lens.pixels, 7.37);
  EXPECT_EQ(o.lens.view_distance, 0.0);
  EXPECT_EQ(o.sheet_distance, 12.0);
  EXPECT_EQ(o.lens.front, 0.0);
  EXPECT_EQ(o.lens.model, camera::LensModel::kPinhole);
  EXPECT_FALSE(o.lens.rays.has_value());
  const RenderOptions thick = read({"Lens_Model=Thick", "Lens_Rays=1024"});
  EXPECT_EQ(thick.lens.model, camera::LensModel::kThick);
  EXPECT_EQ(thick.lens.rays, 1024u);
  EXPECT_EQ(o.view, 3u);
  EXPECT_EQ(o.pixel_order, "columns");
  EXPECT_EQ(read({"Pixel_Order=Strips(4,8)"}).pixel_order, "strips(4,8)");
  EXPECT_FALSE(o.shadow_log);
  EXPECT_TRUE(read({"Shadow_Log=On"}).shadow_log);
  EXPECT_EQ(o.shadow_cache, "depth");
  EXPECT_EQ(o.accelerator, "list");
  EXPECT_EQ(o.statistics_file, "s.json");
  EXPECT_EQ(o.dump_rays, "r.txt");
  EXPECT_EQ(read({"Lens_LPI=20", "Print_DPI=300"}).lens.lpi, 20.0);
  EXPECT_EQ(read({"--dump-rays=x"}).dump_rays, "x");
}

TEST_F(UnitParserOptions, OutputFiles) {
  using Pair = std::pair<const char*, core::FileType>;
  for (const auto& [given, type] :
       {Pair{"+FN", core::FileType::png}, Pair{"+FT", core::FileType::targa},
        Pair{"+Fc", core::FileType::compressed_targa}, Pair{"+FJ", core::FileType::jpeg},
        Pair{"+FP", core::FileType::ppm}, Pair{"+FB", core::FileType::bmp},
        Pair{"+FE", core::FileType::exr}, Pair{"+FH", core::FileType::radiance},
        Pair{"Output_File_Type=T", core::FileType::targa},
        Pair{"Output_File_Type=TIFF", core::FileType::tiff}}) {
    EXPECT_EQ(read({given}).type, type) << given;
  }
  EXPECT_EQ(read({"+FP10"}).bits, 10);
  EXPECT_EQ(read({"+FN99"}).bits, 16);
  EXPECT_EQ(read({"Bits_Per_Colour=3"}).bits, 5);
  EXPECT_TRUE(read({"+FNg"}).grayscale);
  EXPECT_TRUE(read({"+FP", "Grayscale_Output=on"}).grayscale);
  EXPECT_EQ(read({"Compression=40"}).compression, 40);
  EXPECT_EQ(read({"Display_Gamma=1.8"}).display_gamma, 1.8);
  EXPECT_FALSE(read({"Display_Gamma=1.8"}).display_srgb);
  EXPECT_FALSE(read({}).dither);
  EXPECT_TRUE(read({"+TH"}).dither);
  EXPECT_EQ(read({"+TH"}).dither_type, core::DitherMethod::floyd_steinberg);
  EXPECT_EQ(read({"+THb3"}).dither_type, core::DitherMethod::bayer3);
  EXPECT_FALSE(read({"-THD2"}).dither);
  EXPECT_EQ(read({"-THD2"}).dither_type, core::DitherMethod::plane);
  EXPECT_TRUE(read({"Dither=on", "Dither_Method=D1"}).dither);
}

TEST_F(UnitParserOptions, OutputPaths) {
  fs::create_directory("out");
  const auto path = [](const std::vector<std::string>& arguments) {
    core::FileType type;
    return output_path(read(arguments), type);
  };
  EXPECT_EQ(path({"+Idir/scene.pov"}), "dir/scene.png");
  EXPECT_EQ(path({"+Idir/scene.pov", "+FE"}), "dir/scene.exr");
  EXPECT_EQ(path({"+Idir/scene.pov", "Restrict_IO=On"}), "scene.png");
  EXPECT_EQ(path({"+Idir/scene.pov", "+Ofoo"}), "foo.png");
  EXPECT_EQ(path({"+Iscene.pov", "+Oout/"}), "out/scene.png");
  EXPECT_EQ(path({"+Idir/scene.pov", "+Oout/.png"}), "out/scene.png");
  EXPECT_EQ(path({"+Iscene.pov", "+O.png"}), "scene.png");
  EXPECT_EQ(path({"+Iscene.pov", "+Oout"}), "out.png");
  EXPECT_EQ(path({"+Iscene.pov", "+Ofoo."}), "foo.png");
  EXPECT_EQ(path({"+Iscene.pov", "+Ofoo.PNG"}), "foo.PNG.png");
  EXPECT_EQ(path({"+Iscene.pov", "+Ofoo.tga"}), "foo.tga.png");
  EXPECT_EQ(path({"+Iscene.pov", "+Ofoo.tga", "+FC"}), "foo.tga");
  EXPECT_EQ(path({"+Iscene.pov", "+Ofoo.jpeg", "+FJ"}), "foo.jpeg.jpg");
  EXPECT_EQ(path({"+Iscene.pov", "+Ofoo.tif", "+FN"}), "foo.tif.png");
  EXPECT_EQ(path({"+Iscene.pov", "+Ofoo.png", "+FB"}), "foo.png.bmp");
  EXPECT_EQ(path({"+Iscene.pov", "+Ofoo", "+FPg"}), "foo.ppm");
  EXPECT_EQ(path({"+Iscene.pov", "+Ofoo", "+FH"}), "foo.hdr");
  EXPECT_EQ(path({"+Iscene.pov", "+Ofoo"}), "foo.png");
  EXPECT_EQ(path({"+Iscene.pov", "+Ofoo.v2"}), "foo.v2.png");
  EXPECT_EQ(path({"+Iscene.pov", "+Ofoo.png", "+FE"}), "foo.png.exr");
  EXPECT_EQ(path({"+Iscene.pov", "+Ofoo.tif"}), "foo.tif");
  EXPECT_EQ(path({"+Iscene.pov", "+Ofoo.exr"}), "foo.exr");
  EXPECT_EQ(path({"+Iscene.pov", "+O/dev/null"}), "/dev/null");
  EXPECT_EQ(path({"+I-"}), "stdin.png");
  EXPECT_EQ(path({"+Iscene.pov", "+O-"}), "-");
  core::FileType type;
  (void)output_path(read({"+Ofoo.EXR"}), type);
  EXPECT_EQ(type, core::FileType::exr);
}

TEST_F(UnitParserOptions, StandardLibrariesComeLast) {
  fs::create_directory("lib");
  OptionSources sources;
  sources.standard_libraries = {"lib", "none"};
  EXPECT_EQ(read({"+Lmine"}, sources).library_paths, (std::vector<std::string>{"mine", "lib"}));
}

TEST_F(ErrorParserOptions, UnknownNames) {
  expect_message({"Witdh=3"}, "unknown option 'Witdh'; did you mean Width?");
  expect_message({"Lens_Pixel=3"}, "did you mean Lens_Pixels?");
  expect_message({"+ZZ"}, "unknown switch '+ZZ'");
  expect_message({"--frobnicate"}, "unknown option '--frobnicate'");
  expect_message({"nothing_here"}, "there is no INI file 'nothing_here' and no scene of that name");
}

TEST_F(UnitParserOptions, NumbersAreCutAsStockCutsThem) {
  EXPECT_EQ(read({"+W64.7"}).width, 64);
  EXPECT_TRUE(read({"Height=183.9952372399585"}).warnings.empty());
  for (const auto& [option, text] : std::vector<std::pair<std::string, std::string>>{
           {"+W40+H30", "option +W40+H30: taken as 40"},
           {"Width=64abc", "taken as 64"},
           {"+Q12", "taken as 11"},
           {"+WT0", "taken as 1"},
           {"+A0.3x", "taken as 0.3"},
           {"+R20", "taken as 9"}}) {
    const RenderOptions o = read({option});
    ASSERT_EQ(o.warnings.size(), 1u) << option;
    EXPECT_NE(o.warnings[0].find(text), std::string::npos) << o.warnings[0];
  }
}

TEST_F(UnitParserOptions, Animation) {
  const RenderOptions o = read({"+KFI2", "+KFF12.9", "Initial_Clock=1", "+KF3.5", "+SF0.25",
                                "Subset_End_Frame=9", "+STP2", "Cyclic_Animation=On", "+UF"});
  EXPECT_EQ(o.animation.initial_frame, 2);
  EXPECT_EQ(o.animation.final_frame, 12);
  EXPECT_EQ(o.animation.initial_clock, 1.0);
  EXPECT_EQ(o.animation.final_clock, 3.5);
  EXPECT_EQ(o.animation.subset_start, 0.25);
  EXPECT_EQ(o.animation.subset_end, 9.0);
  EXPECT_EQ(o.animation.step, 2);
  EXPECT_TRUE(o.animation.cyclic);
  EXPECT_FALSE(read({"+W8"}).clock_given);
  EXPECT_TRUE(read({"+K0"}).clock_given);
}

TEST_F(ErrorParserOptions, BadValues) {
  expect_message({"+Wabc"}, "option +Wabc: a number is expected");
  expect_message({"+W0"}, "a whole number from 1 to 2147483647");
  expect_message({"Height=-3"}, "option Height=-3: a whole number from 1");
  expect_message({"Width=99999999999999999999"}, "a whole number from 1");
  expect_message({"Width="}, "a number is expected");
  expect_message({"+I"}, "a name is expected");
  expect_message({"+L"}, "a folder is expected");
  expect_message({"+FX"}, "unknown output type");
  expect_message({"File_Gamma=0"}, "from 0.001 to 6250");
  expect_message({"Lens_Pitch=-1"}, "greater than 0");
  expect_message({"Lens_IOR=0.5"}, "at least 1");
  expect_message({"Lens_Pixels=0.5"}, "at least one pixel");
  expect_message({"Lens_Model=fancy"},
                 "unknown lens model: there are paraxial, pinhole, thick, auto");
  expect_message({"Lens_Rays=0"}, "a whole number from 1 to 1024 is expected");
  expect_message({"Lens_Rays=1025"}, "a whole number from 1 to 1024 is expected");
  expect_message({"Lens_Rays=2.5"}, "a whole number is expected");
  expect_message({"Shadow_Cache=big"},
                 "unknown shadow cache: there are auto, off, last, depth, "
                 "tree, neighbourhood, grid, cascade");
  expect_message({"View_Distance=near"}, "a number is expected");
  expect_message({"Declare=X"}, "NAME=VALUE");
  expect_message({"Declare=1X=2"}, "cannot be the name");
  expect_message({"Declare=X=abc"}, "a number is expected");
  expect_message({"--dump-rays"}, "needs the name of a file");
}

TEST_F(UnitParserOptions, Antialiasing) {
  const RenderOptions none = read({"+W80"});
  EXPECT_FALSE(none.antialias);
  EXPECT_EQ(none.sampling_method, 1);
  EXPECT_EQ(none.antialias_threshold, 0.3);
  EXPECT_EQ(none.antialias_depth, 3);
  EXPECT_EQ(none.antialias_gamma, 2.5);
  EXPECT_TRUE(none.jitter);
  EXPECT_EQ(none.jitter_amount, 1.0);
  EXPECT_EQ(none.antialias_angles, 1);
  const RenderOptions all = read({"+A0.12", "+AM2", "+R4", "+J0.5", "+AG2.2", "Antialias_Angle=4"});
  EXPECT_TRUE(all.antialias);
  EXPECT_EQ(all.sampling_method, 2);
  EXPECT_EQ(all.antialias_threshold, 0.12);
  EXPECT_EQ(all.antialias_depth, 4);
  EXPECT_EQ(all.antialias_gamma, 2.2);
  EXPECT_EQ(all.jitter_amount, 0.5);
  EXPECT_EQ(all.antialias_angles, 4);
  EXPECT_TRUE(read({"Antialias=On"}).antialias);
  EXPECT_FALSE(read({"+A", "-A"}).antialias);
  EXPECT_FALSE(read({"Jitter=Off"}).jitter);
  EXPECT_FALSE(read({"-J"}).jitter);
  // Cut to what they may be, as in stock.
  EXPECT_EQ(read({"Antialias_Threshold=3"}).antialias_threshold, 1.0);
  EXPECT_EQ(read({"+R20"}).antialias_depth, 9);
  EXPECT_EQ(read({"Jitter_Amount=-1"}).jitter_amount, 0.0);
  EXPECT_EQ(read({"+AM4"}).sampling_method, 2);
  EXPECT_EQ(read({"+AM3.5"}).sampling_method, 2);
  EXPECT_EQ(read({"+AM3"}).sampling_method, 3);  // ours, exactly
  expect_message({"+Afoo"}, "a number is expected");
  expect_message({"Antialias_Angle=0"}, "a whole number from 1 to 64");
  expect_message({"Antialias_Grid=65"}, "a whole number from 0 to 64");
  expect_message({"Max_Trace_Level=0"}, "a whole number from 1 to 256");
  expect_message({"Area_Light_Samples=1"}, "a whole number from 2 to 1000");
  expect_message({"Area_Light_Adaptive=-1"}, "a whole number from 0 to 20");
  expect_message({"Blur_Samples=0"}, "a whole number from 1 to 65536");
  expect_message({"Adc_Bailout=-0.1"}, "a number from 0 on is expected");
  expect_message({"Adc_Bailout=nan"}, "number");
  expect_message({"Radiosity_Count=1601"}, "a whole number from 1 to 1600");
  expect_message({"Radiosity_Error_Bound=0"}, "a number greater than 0 is expected");
  expect_message({"Radiosity_Recursion_Limit=21"}, "a whole number from 1 to 20");
  expect_message({"Photon_Count=0"}, "a whole number from 1 to 1000000000");
  expect_message({"Photon_Gather=-1"}, "a whole number from 1 to 1000000000");
  expect_message({"Subsurface_Samples=0"}, "a whole number from 1 to 1000000");
}

TEST_F(UnitParserOptions, PartsOfThePicture) {
  const RenderOptions o = read({"+SC0.25", "+EC30", "Start_Row=2", "End_Row=0.75"});
  EXPECT_EQ(o.start_column, 0.25);
  EXPECT_EQ(o.end_column, 30.0);
  EXPECT_EQ(o.start_row, 2.0);
  EXPECT_EQ(o.end_row, 0.75);
  expect_message({"+SC-2"}, "a column or row from 1 on");
}

TEST_F(ErrorParserOptions, NotYetByName) {
  expect_message({"+FS"}, "unknown output type");
  expect_message({"+FTg"}, "unknown output type");
  expect_message({"+FE", "Grayscale_Output=on"}, "there is grey in PNG, PPM and TIFF files only");
  expect_message({"+THx"}, "unknown way of dithering");
  EXPECT_EQ(read({"Pixel_Order=Adaptive"}).pixel_order, "adaptive");
  EXPECT_EQ(read({"Accelerator=Grid"}).accelerator, "grid");
  expect_message({"Accelerator=octree"}, "unknown accelerator: there are bvh, grid, list");
}

TEST_F(ErrorParserOptions, CommandsStandInIniFilesOnly) {
  expect_message({"Post_Scene_Command=rm"}, "stand in INI files only");
  expect_message({"Pre_Frame_Return=F"}, "stand in INI files only");
  write("bad.ini", "Pre_Frame_Return=-X\n");
  expect_message({"bad.ini"},
                 "bad.ini:1: option Pre_Frame_Return=-X: I, S, A, Q, U or F, perhaps after - or !");
}

TEST_F(UnitParserOptions, CommandsOfIniFiles) {
  write("a.ini", "Pre_Scene_Command=make \"a b\" %s\nPre_Scene_Return=!s\nUser_Abort_Return = F\n");
  const RenderOptions o = read({"a.ini"});
  const ShellCommand& first = o.commands[static_cast<std::size_t>(CommandKind::kPreScene)];
  EXPECT_EQ(first.text, "make \"a b\" %s");
  EXPECT_EQ(first.action, 'S');
  EXPECT_TRUE(first.on_success);
  const ShellCommand& abort = o.commands[static_cast<std::size_t>(CommandKind::kUserAbort)];
  EXPECT_EQ(abort.text, "");
  EXPECT_EQ(abort.action, 'F');
  EXPECT_FALSE(abort.on_success);
}

// It may have come with a stranger's scene.
TEST_F(UnitParserOptions, RestrictIoLeavesTheFoldersIniAlone) {
  write("povray.ini", "Library_Path=outside\nWidth=33\nRestrict_IO=Off\n");
  write("users.ini", "Height=44\n");
  const OptionSources sources{{"povray.ini", "users.ini"}, {}};
  EXPECT_EQ(read({}, sources).width, 33);
  EXPECT_FALSE(read({}, sources).restrict_io);
  const RenderOptions o = read({"Restrict_IO=On"}, sources);
  EXPECT_TRUE(o.restrict_io);
  EXPECT_TRUE(o.library_paths.empty());
  EXPECT_EQ(o.width, 160);
  EXPECT_EQ(o.height, 44);
  ASSERT_EQ(o.warnings.size(), 1u);
  EXPECT_NE(o.warnings[0].find("povray.ini is not read"), std::string::npos);
  EXPECT_EQ(read({"Restrict_IO=On", "povray.ini", "Restrict_IO=On"}, sources).width, 33)
      << "named, it is the user's";
  write("povray.ini", "Width=33\nRestrict_IO=On\n");
  EXPECT_TRUE(read({}, sources).restrict_io);
  write("povray.ini", "Include_Ini=nowhere.ini\n");
  EXPECT_EQ(read({"Restrict_IO=On"}, sources).height, 44) << "it is not even opened";
  EXPECT_THROW(read({}, sources), OptionError);
}

TEST_F(ErrorParserOptions, IniMessagesNameFileAndLine) {
  write("a.ini", "\n; x\nWidht=3\n");
  expect_message({"a.ini"}, "a.ini:3: unknown option 'Widht'; did you mean Width?");
  write("b.ini", "+W4 +Hx\n");
  expect_message({"b.ini"}, "b.ini:1: option +Hx: a number is expected");
  write("c.ini", "[one]\n[two words]\n");
  EXPECT_NE(read({"c.ini[three]"})
                .warnings.at(0)
                .find("'c.ini' has no section [three]: there are one, two words"),
            std::string::npos);
  write("e.ini", "# a comment\nWidth=20 # another\n#Height=3\nOutput_File_Name=\"a#b.png\"\n");
  EXPECT_EQ(read({"e.ini"}).width, 20);
  EXPECT_EQ(read({"e.ini"}).output, "a#b.png");
  write("d.ini", "[open\n");
  expect_message({"d.ini"}, "d.ini:1: a section label lacks its ]");
  write("self.ini", "self\n");
  expect_message({"self.ini"}, "nested more than 10 deep");
}

TEST_F(ErrorParserOptions, AbsurdSizesNameTheMemory) {
  const auto message = [](std::int64_t width, std::int64_t height, double memory) -> std::string {
    try {
      check_picture_size(width, height, 32.0 * static_cast<double>(width), memory);
    } catch (const OptionError& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_EQ(message(1995, 2000, 1e9), "");
  EXPECT_EQ(message(24000, 24000, 1e9), "") << "only rows need memory";
  EXPECT_EQ(message(2'000'000'000, 4, 16e9),
            "a picture of 2000000000 x 4 pixels needs 64 GB of memory for a row; there are 16 GB");
  EXPECT_EQ(message(1'000'000, 2'000'000, 16e9),
            "a picture of 1000000 x 2000000 pixels is too large: the limit is 1048576 x 1048576");
}

TEST_F(UnitParserOptions, MemoryTakesUnits) {
  EXPECT_EQ(read({}).max_time, 0.0);
  EXPECT_EQ(read({"Max_Time=90"}).max_time, 90.0);
  EXPECT_EQ(read({"max_time=1.5h"}).max_time, 5400.0);
  EXPECT_EQ(read({"Max_Time=10 m"}).max_time, 600.0);
  expect_message({"Max_Time=3d"}, "unknown unit 'd': there are s, m and h");
  expect_message({"Max_Time=0"}, "a number greater than 0 is expected");
  EXPECT_EQ(read({}).max_memory, 0.0);
  EXPECT_EQ(read({"Max_Memory=2G"}).max_memory, 2147483648.0);
  EXPECT_EQ(read({"max_memory=1.5GiB"}).max_memory, 1610612736.0);
  EXPECT_EQ(read({"Max_Memory=300 mb"}).max_memory, 314572800.0);
  EXPECT_EQ(read({"Max_Memory=2048k"}).max_memory, 2097152.0);
  EXPECT_EQ(read({"Max_Memory=123456789"}).max_memory, 123456789.0);
  EXPECT_EQ(read({"Band_Height=7"}).band_height, 7u);
}

TEST_F(ErrorParserOptions, MemoryWithoutSense) {
  expect_message({"Max_Memory=512"}, "less than 1 MB; a unit may stand behind the number");
  expect_message({"Max_Memory=2Q"}, "unknown unit 'Q': there are K, M, G and T");
  expect_message({"Max_Memory=much"}, "a number is expected");
  expect_message({"Max_Memory=-2G"}, "a number greater than 0 is expected");
  EXPECT_EQ(read({}).max_written, 0.0);
  EXPECT_EQ(read({"Max_Written=2G"}).max_written, 2147483648.0);
  expect_message({"Max_Written=512"}, "less than 1 MB; a unit may stand behind the number");
  EXPECT_EQ(read({}).max_pixels, 0.0);
  EXPECT_EQ(read({"Max_Pixels=1.5M"}).max_pixels, 1.5e6);
  EXPECT_EQ(read({"Max_Pixels=100"}).max_pixels, 100.0);
  expect_message({"Max_Pixels=2Q"}, "unknown unit 'Q': there are K, M, G and T");
  EXPECT_EQ(read({}).max_files, 0u);
  EXPECT_EQ(read({"Max_Files=20"}).max_files, 20u);
  expect_message({"Max_Files=0"}, "Max_Files=0");
  expect_message({"Band_Height=0"}, "a whole number from 1 to 2147483647");
}

TEST_F(UnitParserOptions, OddBooleansAreOffWithAWarning) {
  const RenderOptions o = read({"Lenticular=maybe"});
  EXPECT_FALSE(o.lenticular);
  ASSERT_EQ(o.warnings.size(), 1u);
  EXPECT_NE(o.warnings[0].find("neither on nor off, taken as off"), std::string::npos);
}

TEST_F(UnitParserOptions, IncludeIniReadsAFileAtItsPlace) {
  write("in.ini", "Width=77\nHeight=33\n[part]\nWidth=88\n");
  write("out.ini", "Height=11\nInclude_Ini=\"in.ini\"\nWidth=99\n");
  EXPECT_EQ(read({"out.ini"}).width, 99);
  EXPECT_EQ(read({"out.ini"}).height, 33);
  const RenderOptions options = read({"Include_Ini=in[part]", "+H40"});
  EXPECT_EQ(options.width, 88);
  EXPECT_EQ(options.height, 40);
  write("self.ini", "Include_Ini=self.ini\n");
  expect_message({"Include_Ini=self.ini"}, "nested more than 10 deep");
  expect_message({"Include_Ini=nowhere.ini"}, "there is no INI file 'nowhere.ini'");
}

TEST_F(UnitParserOptions, OptionsOfAnimationsThatAreOffDoNothing) {
  EXPECT_NO_THROW((void)read({"Clockless_Animation=off", "Real_Time_Raytracing=off"}));
  expect_message({"Real_Time_Raytracing=on"}, "not yet: real-time raytracing");
  expect_message({"Clockless_Animation=on"}, "not yet: animation without a clock");
}

TEST_F(UnitParserOptions, RadiosityFiles) {
  const RenderOptions none = read({"a.pov"});
  EXPECT_EQ(none.radiosity_file, "object.rca");
  EXPECT_FALSE(none.radiosity_from_file || none.radiosity_to_file);
  const RenderOptions o = read({"+RFI", "+RFO", "-RFI", "+RFa b.rca"});
  EXPECT_FALSE(o.radiosity_from_file);
  EXPECT_TRUE(o.radiosity_to_file);
  EXPECT_EQ(o.radiosity_file, "a b.rca");
  for (const char* name : {"object.rca", "Inside/", "x"}) {
    const RenderOptions named = read({std::string("+RF") + name});
    EXPECT_EQ(named.radiosity_file, name);
    EXPECT_FALSE(named.radiosity_from_file || named.radiosity_to_file);
  }
  EXPECT_EQ(read({"Radiosity_To_File=on", "Radiosity_Samples=7"}).radiosity_samples, 7u);
  expect_message({"+RF"}, "the name of a file or folder is expected");
  expect_message({"Radiosity_Samples=0"}, "Radiosity_Samples");
}

TEST_F(UnitParserOptions, EmptyNamesSayThatThereIsNone) {
  const RenderOptions o = read(
      {"+Ia.pov", "Include_Header=a.inc", "Include_Header=", "Output_File_Name=", "Library_Path="});
  EXPECT_EQ(o.input, "a.pov");
  EXPECT_EQ(o.include_header, "");
  EXPECT_TRUE(o.library_paths.empty());
}

TEST_F(UnitParserOptions, HelpIsShortOrLong) {
  EXPECT_TRUE(read({"--help"}).help);
  EXPECT_FALSE(read({"--help"}).help_all);
  EXPECT_TRUE(read({"--help=all"}).help_all);
  expect_message({"--help=some"}, "unknown option '--help=some'");
}

}  // namespace
}  // namespace lentray::parser
