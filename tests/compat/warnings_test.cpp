// What both programs warn of, and where the warnings go: sloppy scenes with the same options through
// stock and lentray. The wording is each program's own; that a line is warned of is not.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tools/common/process.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;

struct WarningsOutcome {
  int status = 0;
  std::string console;
  std::map<std::string, std::string> files;  ///< those the run made, by name
};

enum class Program { kStock, kLentray };

WarningsOutcome warnings_run(Program program, const std::string& scene,
                             std::vector<std::string> options) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "scene.pov", scene);
  std::vector<std::string> command = {
      program == Program::kStock ? "povray" : LENTRAY_BIN_DIR "/lentray",
      "+Iscene.pov",
      "+Oscene.png",
      "+W4",
      "+H4",
      "-D",
      "-V"};
  command.insert(command.end(), options.begin(), options.end());
  const tool::RunResult result = tool::run_program(command, folder.path(), 60.0);
  WarningsOutcome out{result.status, result.output, {}};
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    const std::string name = entry.path().filename().string();
    const std::string end = entry.path().extension().string();
    if (end == ".txt" || end == ".out") out.files[name] = tool::read_text(entry.path());
  }
  return out;
}

// Lines of the scene that are warned of, 0 for the scene as a whole. Stock breaks lines as it likes,
// and says "File 'scene.pov' line 3: Parse Warning" or, in files, "File: scene.pov  Line: 3".
std::multiset<int> warned(Program program, const std::string& text) {
  static const std::regex stock(
      "(?:File '[^']*' line (\\d+): |File: \\S+\\s+Line: "
      "(\\d+)\\s+)?(?:Parse\\s+Warning|Possible\\s+Parse\\s+Error):");
  static const std::regex ours("(?:scene\\.pov:(\\d+):\\d+|lentray): (warning):");
  std::multiset<int> lines;
  const std::regex& form = program == Program::kStock ? stock : ours;
  for (std::sregex_iterator at(text.begin(), text.end(), form), end; at != end; ++at) {
    const bool first = (*at)[1].matched, second = program == Program::kStock && (*at)[2].matched;
    lines.insert(first ? std::stoi((*at)[1]) : second ? std::stoi((*at)[2]) : 0);
  }
  return lines;
}

constexpr const char* kWarningsHead = "#version 3.7; global_settings { assumed_gamma 1 }\n";

TEST(CompatWarnings, SameLinesAsStock) {
  const std::string head = kWarningsHead;
  const std::vector<std::string> scenes = {
      "sphere { 0, 1 }",                // neither #version nor assumed_gamma
      "#version 3.7; sphere { 0, 1 }",  // no assumed_gamma
      "#version 3.6; sphere { 0, 1 }",
      "#declare A = 1;\n#version 3.7; global_settings { assumed_gamma 1 } sphere { 0, 1 }",
      head + "sphere { 0, 1 scale 0 }",
      head + "sphere { 0, 1\nscale <1, 0, 1> }",
      head +
          "union { sphere { 0, 1 } }\nintersection { box { 0, 1 } }\ndifference { box { 0, 1 } "
          "}\nmerge { box { 0, 1 } }",
      head + "polygon { 3, 0, x, y }\nprism { 0, 1, 3, 0, u, v }",
      head + "triangle { 0, x, x*2 }\nsmooth_triangle { 0, y, x, y, x*2, y }",
      head + "camera { location -z }\ncamera { location -5*z look_at 0 }\nsphere { 0, 1 }",
      head + "camera { up y right x + y direction z }\nsphere { 0, 1 }",
      head + "sphere { 0, 1 pigment { } }",
      head + "sphere { 0, 1\nfinish { ior 1.5 } }",
      head + "sphere { 0, 1\ncolor rgb 1 }",
      head + "intersection { sphere { 0, 1 }\ntriangle { 0, x, y } }",
      head + "light_source { 0 rgb 1 area_light x, y, 2, 2\norient }\nsphere { 0, 1 }",
      head + "global_settings { number_of_waves 0 }\nsphere { 0, 1 }",
      head + "global_settings { max_trace_level 1000 }\nsphere { 0, 1 }",
      head + "global_settings { hf_gray_16 on }\nsphere { 0, 1 }",
      head + "sky_sphere { pigment { rgb 1 } }\nsky_sphere { pigment { rgb 0 } }\nsphere { 0, 1 }",
      head + "#undef Nothing\nsphere { 0, 1 }",
      head + "#warning \"careful\"\nsphere { 0, 1 }",
      head + "#declare A = acos(2);\nsphere { 0, 1 }",
      head + "#declare A = 1/0;\nsphere { 0, 1 }",
      "#version 3.1; global_settings { assumed_gamma 1 }\n#declare A = 1 sphere { 0, 1 }",
      head,  // no objects
  };
  for (const std::string& scene : scenes) {
    const WarningsOutcome stock = warnings_run(Program::kStock, scene, {"+GWw.txt"});
    const WarningsOutcome ours = warnings_run(Program::kLentray, scene, {"+GWw.txt"});
    EXPECT_EQ(stock.status, 0) << scene << stock.console;
    EXPECT_EQ(ours.status, 0) << scene << ours.console;
    const auto wanted = warned(Program::kStock, stock.files.at("w.txt"));
    EXPECT_EQ(warned(Program::kLentray, ours.files.at("w.txt")), wanted)
        << scene << "\n"
        << stock.files.at("w.txt") << "\n"
        << ours.console;
  }
}

// "3.593>1.000" for every isosurface that is told to be steeper than its max_gradient, "1.000<2.000"
// for one whose max_gradient is far more than it needs.
std::multiset<std::string> gradients(Program program, std::string text) {
  static const std::regex space("\\s+");
  text = std::regex_replace(text, space, " ");
  static const std::regex stock(
      R"(gradient found was ([\d.]+), but max_gradient of the isosurface was set to ([\d.]+)\.( The)?)");
  static const std::regex ours(
      R"(max_gradient ([\d.]+) is (too small|more than).*? steep(?:er)? (?:as|than) ([\d.]+\d))");
  std::multiset<std::string> all;
  const bool is_stock = program == Program::kStock;
  for (std::sregex_iterator at(text.begin(), text.end(), is_stock ? stock : ours), end; at != end;
       ++at) {
    const std::string found = (*at)[is_stock ? 1 : 3], given = (*at)[is_stock ? 2 : 1];
    const bool holes = is_stock ? (*at)[3].matched : (*at)[2] == "too small";
    all.insert(found + (holes ? ">" : "<") + given);
  }
  return all;
}

TEST(CompatWarnings, GradientsAreReportedAsInStock) {
  const std::string head =
      std::string(kWarningsHead) +
      "camera { orthographic location -5*z direction z right 8*x up 2*y }\n"
      "#macro Wall(K, G, X) isosurface { function { -K*z } max_gradient G"
      " contained_by { box { <-.9,-2,-1.3>, <.9,2,1.2> } } translate X*x } #end\n";
  const std::string waves =
      "isosurface { function { x*x + y*y*2 + z*z - 1 + .1*sin(x*15)*sin(z*14) } contained_by { box "
      "{ -1.2, 1.2 } }";
  const std::vector<std::string> scenes = {
      head + "Wall(1, .949, -3)\nWall(1, .952, -1)\nWall(10, 11.1, 1)\nWall(10, 10.9, 3)",
      head + "Wall(2, 1.89, -3)\nWall(2, 1.91, -1)\nWall(50, 56, 1)\nWall(50, 54, 3)",
      head + waves + " max_gradient 3 }",
      head + waves + " max_gradient 5 }",
      head + waves + " max_gradient 60 }",
      head + waves + " evaluate 3, 1.2, .8 }"};
  for (const std::string& scene : scenes) {
    const std::vector<std::string> options = {"+W64", "+H16", "+WT1"};
    const WarningsOutcome stock = warnings_run(Program::kStock, scene, options);
    const WarningsOutcome ours = warnings_run(Program::kLentray, scene, options);
    EXPECT_EQ(gradients(Program::kLentray, ours.console), gradients(Program::kStock, stock.console))
        << scene << "\n"
        << stock.console << ours.console;
  }
}

/// Stock is silent about copies of a declared isosurface and about parts of CSG; they can have holes as well.
TEST(CompatWarnings, GradientsOfCopiesAndPartsAreReportedToo) {
  const std::string head = std::string(kWarningsHead) +
                           "camera { orthographic location -5*z direction z right 8*x up 2*y }\n";
  const std::string waves =
      "isosurface { function { x*x + y*y*2 + z*z - 1 + .1*sin(x*15)*sin(z*14) }"
      " contained_by { box { -1.2, 1.2 } } max_gradient 3 }";
  for (const std::string& scene :
       {head + "#declare F = " + waves + " object { F } object { F translate 3*x }",
        head + "#declare U = union { " + waves + " sphere { 9, 1 } } object { U translate x }",
        head + "intersection { sphere { 0, 2 } " + waves + " }"}) {
    const std::vector<std::string> options = {"+W64", "+H16", "+WT1"};
    EXPECT_TRUE(
        gradients(Program::kStock, warnings_run(Program::kStock, scene, options).console).empty())
        << scene;
    EXPECT_FALSE(
        gradients(Program::kLentray, warnings_run(Program::kLentray, scene, options).console)
            .empty())
        << scene;
  }
}

TEST(CompatWarnings, StreamsGoWhereStockSendsThem) {
  const std::string scene =
      "sphere { 0, 1 scale 0 }\n#warning \"careful\\n\"\n#debug \"debugged\\n\"\n"
      "#render concat(\"rend\", \"word\\n\")\n#statistics concat(\"count\", \"ed\\n\")\n";
  const std::vector<std::vector<std::string>> options = {
      {},
      {"-GW"},
      {"+GW"},
      {"-GA"},
      {"+GA"},
      {"-GD"},
      {"-GR"},
      {"-GS"},
      {"-GF"},
      {"+GWw.txt"},
      {"-GWw.txt"},
      {"+GDd.txt"},
      {"-GDd.txt"},
      {"+GRr.txt"},
      {"-GRr.txt"},
      {"+GSs.txt"},
      {"-GSs.txt"},
      {"+GAa.txt"},
      {"-GAa.txt"},
      {"+GFf.txt"},
      {"-GA", "+GW"},
      {"+GW", "-GA"},
      {"-GW", "+GA"},
      {"+GWw.txt", "-GA"},
      {"+GWw.txt", "-GW"},
      {"-GDd.txt", "+GWw.txt", "+GAa.txt"},
      {"Warning_Console=Off"},
      {"All_Console=Off"},
      {"All_Console=Off", "Warning_Console=On"},
      {"Warning_Console=Off", "Warning_File=w.txt"},
      {"Warning_File=true"},
      {"All_File=true"},
      {"Debug_File=true", "Render_File=true", "Statistic_File=true", "Fatal_File=true"}};
  for (const auto& given : options) {
    std::string shown;
    for (const std::string& option : given) shown += option + " ";
    SCOPED_TRACE(shown);
    const WarningsOutcome stock = warnings_run(Program::kStock, scene, given);
    const WarningsOutcome ours = warnings_run(Program::kLentray, scene, given);
    EXPECT_EQ(ours.status, stock.status);
    const auto has = [](const std::string& text) {
      std::string all;
      for (const char* word : {"debugged", "rendword", "counted"}) {
        if (text.find(word) != std::string::npos) all += std::string(word) + " ";
      }
      return all;
    };
    EXPECT_EQ(has(ours.console), has(stock.console));
    EXPECT_EQ(warned(Program::kLentray, ours.console), warned(Program::kStock, stock.console))
        << stock.console << ours.console;
    std::set<std::string> wanted, found;
    for (const auto& [name, text] : stock.files) wanted.insert(name);
    for (const auto& [name, text] : ours.files) found.insert(name);
    ASSERT_EQ(found, wanted);
    for (const auto& [name, text] : stock.files) {
      EXPECT_EQ(has(ours.files.at(name)), has(text)) << name;
      EXPECT_EQ(warned(Program::kLentray, ours.files.at(name)).size(),
                warned(Program::kStock, text).size())
          << name;
    }
  }
}

TEST(CompatWarnings, FilesAreBegunAnewOrGoneOnWith) {
  for (const Program program : {Program::kStock, Program::kLentray}) {
    for (const bool append : {false, true}) {
      const tool::TemporaryFolder folder;
      tool::write_text(folder / "scene.pov", "sphere { 0, 1 scale 0 }");
      tool::write_text(folder / "w.txt", "old\n");
      const std::string name = program == Program::kStock ? "povray" : LENTRAY_BIN_DIR "/lentray";
      tool::run_program(
          {name, "+Iscene.pov", "-F", "+W4", "+H4", "-D", "+GWw.txt", append ? "+GP" : "-GP"},
          folder.path(), 60.0);
      EXPECT_EQ(tool::read_text(folder / "w.txt").rfind("old", 0) == 0, append) << name;
    }
  }
}

TEST(CompatWarnings, ErrorsGoToTheFatalFile) {
  for (const Program program : {Program::kStock, Program::kLentray}) {
    const WarningsOutcome out =
        warnings_run(program, std::string(kWarningsHead) + "sphere { 0, }", {"-GFf.txt"});
    EXPECT_NE(out.status, 0);
    EXPECT_NE(out.files.at("f.txt").find("rror"), std::string::npos) << out.console;
  }
  const WarningsOutcome ours =
      warnings_run(Program::kLentray, std::string(kWarningsHead) + "sphere { 0, }", {"-GA"});
  EXPECT_NE(ours.console.find("scene.pov:2:13: error:"), std::string::npos) << ours.console;
}

}  // namespace
}  // namespace lentray::test
