// Every file of POV-Ray's own includes, as it is installed: each identifier that it declares is
// used as what it is (its values written, its looks put on a sphere, its objects probed), and each
// macro is invoked with the arguments of tests/compat/includes/*.cases. Stock and lentray must
// write the same. Nothing of the files is kept here: names and kinds are found when the test runs.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "parser/grammar/object_shapes.h"
#include "parser/grammar/productions.h"
#include "parser/read_scene.h"
#include "parser/values/spline.h"
#include "tests/compat/include_names.h"
#include "tests/compat/language_cases.h"
#include "tools/common/process.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;
using parser::Ref;
using parser::Value;

const fs::path kIncludes = "/usr/share/povray-3.7/include";

// What the uses below are written with.
constexpr const char* kTools = R"(
#macro Pigment_(P_)
  #local F_ = function { pigment { P_ } }
  #local I_ = 0;
  #while (I_ < 3) W(vstr(5, F_(.31 + I_, .17 - I_*.4, .23), " ", 0, 3)) #local I_ = I_ + 1; #end
  sphere { 9, 1 pigment { P_ } }
#end
#macro Transform_(T_)
  #local F_ = function { transform { T_ } }
  W(vstr(3, F_(1, 2, 3), " ", 0, 6)) W(vstr(3, F_(0, 0, 0), " ", 0, 6))
  sphere { 9, 1 transform { T_ } }
#end
#macro Rounded_(V_, Size_)
  #write (Out_, " ", str((abs(V_.x) < .0006 ? 0 : V_.x), 0, Size_), " ",
          str((abs(V_.y) < .0006 ? 0 : V_.y), 0, Size_), " ", str((abs(V_.z) < .0006 ? 0 : V_.z), 0, Size_))
#end
#macro Trace_(O_)
  #local N_ = <0, 0, 0>;
  #local P_ = trace(O_, <3.31, 2.12, -7.73>, <-.41, -.255, 1>, N_);
  Rounded_(P_, 3) Rounded_(N_, 2)
  object { O_ }
#end
#macro Patch_(O_)
  #local Object__ = object { O_ }
  Trace_(Object__)
#end
#macro Object_(O_)
  #local Object__ = object { O_ }
  #local I_ = 0;
  #while (I_ < 27)
    #local P_ = <mod(I_, 3)*.61 - .53, mod(int(I_/3), 3)*.59 - .57, int(I_/9)*.63 - .55>;
    #write (Out_, str(inside(Object__, P_), 0, 0))
    #local I_ = I_ + 1;
  #end
  Trace_(Object__)
#end
camera { location <0, 0, -900> look_at <0, 0, -1000> }
)";

const char* kSphere = "p sphere { 9, 1 ";

/// One use of a value of each kind, in the language of the case files.
struct Use {
  std::string name;
  bool is_element = false;

  std::string block(const char* word) const {
    return std::string(kSphere) + word + " { " + name + " } }";
  }
  std::string map(const char* word, const char* of) const {
    return std::string(kSphere) + of + " { wood " + word + " { " + name + " } } }";
  }
  std::string statement(const char* word) const {
    return std::string("p ") + word + " { " + name + " }";
  }
  std::string operator()(std::monostate) const {
    return "p #ifdef (" + name + ") W(\"declared\") #else W(\"not declared\") #end";
  }
  std::string operator()(const parser::Number& x) const {
    return (x.size == 1 ? "n " : "v" + std::to_string(x.size) + " ") + name;
  }
  std::string operator()(const std::string&) const { return "s " + name; }
  std::string operator()(const std::shared_ptr<parser::ArrayValue>& array) const;
  std::string operator()(const std::shared_ptr<const core::Transform>&) const {
    return "p Transform_(" + name + ")";
  }
  std::string operator()(const Ref<parser::FunctionDesc>& f) const {
    std::string call = name + "(";
    for (std::size_t i = 0; i < f->function->parameters(); ++i) {
      call += (i ? ", " : "") + std::to_string(0.31 + 0.27 * static_cast<double>(i % 4));
    }
    const std::size_t results = f->function->results();
    if (results == 1) return "p W(str(" + call + "), 0, 6))";
    return "p W(vstr(" + std::to_string(results) + ", " + call + "), \" \", 0, 3))";
  }
  std::string operator()(const Ref<parser::SplineDesc>& s) const {
    return "v" + std::to_string(std::max(2, s->size)) + " " + name + "(.35)";
  }
  std::string operator()(const Ref<parser::PigmentDesc>&) const {
    return "p Pigment_(" + name + ")";
  }
  std::string operator()(const Ref<parser::NormalDesc>&) const { return block("normal"); }
  std::string operator()(const Ref<parser::FinishDesc>&) const { return block("finish"); }
  std::string operator()(const Ref<parser::TextureDesc>&) const { return block("texture"); }
  std::string operator()(const Ref<parser::InteriorDesc>&) const { return block("interior"); }
  std::string operator()(const Ref<parser::MaterialDesc>&) const { return block("material"); }
  std::string operator()(const Ref<parser::MediaDesc>&) const {
    return std::string(kSphere) + "interior { media { " + name + " } } }";
  }
  std::string operator()(const Ref<parser::DensityDesc>&) const {
    return std::string(kSphere) + "interior { media { density { " + name + " } } } }";
  }
  std::string operator()(const Ref<parser::ObjectDesc>& object) const {
    if (object->is_light()) return statement("object");
    return std::string("p ") + (is_patch(*object) ? "Patch_(" : "Object_(") + name + ")";
  }
  std::string operator()(const Ref<parser::CameraDesc>&) const { return statement("camera"); }
  std::string operator()(const Ref<parser::FogDesc>&) const { return statement("fog"); }
  std::string operator()(const Ref<parser::RainbowDesc>&) const { return statement("rainbow"); }
  std::string operator()(const Ref<parser::SkySphereDesc>&) const {
    return statement("sky_sphere");
  }
  std::string operator()(const Ref<parser::ColourMapDesc>&) const {
    return "p #declare P_ = pigment { wood color_map { " + name + " } } Pigment_(P_)";
  }
  std::string operator()(const Ref<parser::PigmentMapDesc>&) const {
    return map("pigment_map", "pigment");
  }
  std::string operator()(const Ref<parser::NormalMapDesc>&) const {
    return map("normal_map", "normal");
  }
  std::string operator()(const Ref<parser::SlopeMapDesc>&) const {
    return map("slope_map", "normal");
  }
  std::string operator()(const Ref<parser::TextureMapDesc>&) const {
    return map("texture_map", "texture");
  }
  std::string operator()(const Ref<parser::DensityMapDesc>&) const {
    return std::string(kSphere) + "interior { media { density { wood density_map { " + name +
           " } } } } }";
  }
};

std::string use_of(const std::string& name, const Value& value) {
  return std::visit(Use{name}, value);
}

/// The first elements; an array of arrays has its sizes in one.
std::string Use::operator()(const std::shared_ptr<parser::ArrayValue>& array) const {
  constexpr int kMost = 6;
  std::string body = "p W(str(dimension_size(" + name + ", 1), 0, 0))";
  std::string rest;
  for (std::size_t d = 1; d < array->sizes.size(); ++d) rest += "[0]";
  const int stride = static_cast<int>(array->elements.size()) / std::max(1, array->sizes.front());
  for (int i = 0; i < std::min(kMost, array->sizes.front()); ++i) {
    const std::string element = name + "[" + std::to_string(i) + "]" + rest;
    const std::string use = use_of(
        element, array->elements[static_cast<std::size_t>(i) * static_cast<std::size_t>(stride)]);
    const std::string expression = use.substr(use.find(' ') + 1);
    if (use[0] == 's')
      body += " W(" + expression + ")";
    else if (use[0] == 'n')
      body += " W(str(" + expression + ", 0, 6))";
    else if (use[0] == 'v')
      body += " W(vstr(" + use.substr(1, 1) + ", " + expression + ", \" \", 0, 6))";
    else
      body += " " + expression;
  }
  return body;
}

/// The text of a case of this kind as language_cases.h runs it.
LanguageCase make_case(const std::string& where, const std::string& text) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "one.cases", text + "\n");
  LanguageCase made = read_cases(folder / "one.cases").cases.at(0);
  made.where = where;
  return made;
}

/// Some files want others before them, in stock as well.
std::string included(const std::string& file) {
  const bool shapes = file == "shapes2.inc" || file == "shapesq.inc";
  return std::string("#include \"colors.inc\"\n") + (shapes ? "#include \"shapes.inc\"\n" : "") +
         "#include \"" + file + "\"\n#version 3.7;\n";
}

std::string setup_of(const std::string& file) { return included(file) + kTools; }

/// What the names mean once the file has been included, as our own parser knows it.
std::map<std::string, Value> values_of(const std::string& file,
                                       const std::vector<std::string>& names) {
  const tool::TemporaryFolder folder;
  std::string text = "#version 3.7;\n" + included(file) + "End_Of_Include_\n";
  for (const std::string& name : names) text += name + "\n";
  tool::write_text(folder / "scene.pov", text);
  parser::SourceManager sources;
  parser::Diagnostics diagnostics(sources);
  diagnostics.connect(parser::Stream::kWarning, {});
  diagnostics.connect(parser::Stream::kDebug, {});
  parser::ParserOptions options;
  options.library_paths = {kIncludes};
  parser::Grammar grammar;
  parser::Parser parser(sources, diagnostics, options, grammar);
  parser.open(folder / "scene.pov");
  while (!parser.at_end() && !parser.at_word("End_Of_Include_")) parser.next();
  parser.next();
  std::map<std::string, Value> out;
  for (const std::string& name : names) {
    const Value* value = parser.peek_value();
    out[name] = value ? *value : Value();
    parser.next();
  }
  return out;
}

std::vector<std::string> files_of(const std::vector<std::string>& extensions, bool others) {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(kIncludes, none)) {
    const std::string extension = entry.path().extension().string();
    const bool listed =
        std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
    if (listed != others) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// The written cases of a file; empty if it has none.
LanguageCases written_cases(const std::string& file) {
  const fs::path path = fs::path(LENTRAY_SOURCE_DIR) / "tests/compat/includes" /
                        (fs::path(file).stem().string() + ".cases");
  return fs::exists(path) ? read_cases(path) : LanguageCases{};
}

bool is_used(const LanguageCases& cases, const std::string& name) {
  return has_word(cases.setup, name) ||
         std::any_of(cases.cases.begin(), cases.cases.end(),
                     [&](const LanguageCase& c) { return has_word(c.sdl, name); });
}

/// Both programs run them; stock must accept each (but the written ones that say it refuses).
void expect_same_and_accepted(const LanguageCases& cases) {
  std::vector<std::string> stock_says, we_say;
  const auto wanted = results(Reader::kStock, cases, &stock_says);
  const auto found = results(Reader::kLentray, cases, &we_say);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const LanguageCase& c = cases.cases[i];
    EXPECT_TRUE((found[i] == wanted[i]) != c.differs)
        << c.where << ": " << c.text << "\n  lentray: " << found[i] << "  " << we_say[i]
        << "\n  stock:   " << wanted[i] << "  " << stock_says[i];
    const bool refuses = c.sdl.find("\"an error\"") != std::string::npos;
    EXPECT_EQ(stock_says[i].empty(), !refuses)
        << c.where << ": " << c.text << ": " << stock_says[i];
  }
}

class CompatIncludes : public ::testing::TestWithParam<std::string> {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(CompatIncludes);

TEST_P(CompatIncludes, EveryNameIsUsed) {
  const std::string file = GetParam();
  const IncludeNames names = declared_names(tool::read_text(kIncludes / file));
  LanguageCases cases = written_cases(file);
  cases.setup = setup_of(file) + cases.setup;
  for (const std::string& macro : names.macros) {
    EXPECT_TRUE(is_used(cases, macro))
        << "the macro " << macro << " of " << file << " wants a case in tests/compat/includes";
  }
  std::vector<std::string> identifiers;
  for (const std::string& name : names.identifiers) {
    // What is a macro as well as an identifier is invoked by its cases.
    if (std::find(names.macros.begin(), names.macros.end(), name) == names.macros.end()) {
      identifiers.push_back(name);
    }
  }
  // The generated uses come first: written cases may change what the file has declared.
  std::vector<LanguageCase> all;
  for (const auto& [name, value] : values_of(file, identifiers)) {
    all.push_back(make_case(file + ": " + name, use_of(name, value)));
  }
  all.insert(all.end(), cases.cases.begin(), cases.cases.end());
  cases.cases = std::move(all);
  // A file that declares nothing is still read.
  cases.cases.push_back(make_case(file, "p sphere { 0, 1 }"));
  expect_same_and_accepted(cases);
}

std::string test_name(const ::testing::TestParamInfo<std::string>& file) {
  std::string name = file.param;
  for (char& c : name) {
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, CompatIncludes,
                         ::testing::ValuesIn(files_of({".inc", ".map"}, false)), test_name);

// Pictures, fonts and tables that come with them.
TEST(CompatIncludeFiles, PicturesFontsAndTables) {
  LanguageCases cases;
  cases.setup = kTools;
  for (const std::string& file : files_of({".inc", ".map"}, true)) {
    const std::string kind = fs::path(file).extension().string();
    std::string use;
    if (kind == ".png") use = "p Pigment_(pigment { image_map { png \"" + file + "\" } })";
    if (kind == ".df3") use = "p Pigment_(pigment { density_file df3 \"" + file + "\" })";
    if (kind == ".ttf")
      use = "p Object_(text { ttf \"" + file + "\" \"lentray\", .3, 0 translate -x })";
    if (kind == ".pot") use = "p Object_(height_field { pot \"" + file + "\" translate -.5 })";
    if (kind == ".cat") continue;  // a catalogue of fonts for other programs
    ASSERT_NE(use, "") << "what is " << file << "?";
    cases.cases.push_back(make_case(file, use));
  }
  if (cases.cases.empty()) GTEST_SKIP() << "povray-includes is not installed";
  expect_same_and_accepted(cases);
}

TEST(CompatIncludeNames, AreFound) {
  const IncludeNames names = declared_names(
      "/* #declare A = 1; /* nested */ */ // #declare B = 2;\n#declare C=\"#declare D\"; #local "
      "E=1;\n"
      "# declare deprecated once \"use C\" F = 1; #macro G(a) #if (a) #declare H = 1; #end\n"
      "#macro Inner() #undef J #end #end\n#ifndef (I) #macro J() #end #end #declare C = 2;\n"
      "#macro K() #end #undef K");
  EXPECT_EQ(names.macros, (std::vector<std::string>{"G", "J"}));
  EXPECT_EQ(names.identifiers, (std::vector<std::string>{"C", "F", "H", "K"}));
}

}  // namespace
}  // namespace lentray::test
