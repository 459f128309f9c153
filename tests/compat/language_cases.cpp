#include "tests/compat/language_cases.h"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

#include "tools/common/process.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;

const char* const kLanguageCasesIncludes = "/usr/share/povray-3.7/include";
const char* const kPrologue =
    "#version 3.7; global_settings { assumed_gamma 1 }\n#fopen Out_ \"out.txt\" write\n"
    "#macro W(Text_) #write(Out_, Text_, \"\\n\") #end\n";

std::string wrapped(const std::string& kind, const std::string& body) {
  if (kind == "p") return "#version 3.7;\n" + body;
  if (kind == "n") return "#write(Out_, str((" + body + "),0,9))";
  if (kind == "s") return "#write(Out_, " + body + ")";
  if (kind.size() == 2 && kind[0] == 'v' && kind[1] >= '2' && kind[1] <= '5') {
    return "#write(Out_, vstr(" + kind.substr(1) + ",(" + body + "),\" \",0,9))";
  }
  throw std::runtime_error("no kind of case: " + kind);
}

std::string mark(std::size_t i) { return "\n@" + std::to_string(i) + "@\n"; }

// SDL of the cases from `first` on, each after its mark.
std::string program(const LanguageCases& cases, std::size_t first) {
  std::string text = kPrologue + cases.setup;
  for (std::size_t i = first; i < cases.cases.size(); ++i) {
    text += "#write(Out_, \"\\n@" + std::to_string(i) + "@\\n\")\n" + cases.cases[i].sdl + "\n";
  }
  return text + "#write(Out_, \"\\n@\")\n";
}

std::vector<std::string> command(Reader reader) {
  const std::string library = std::string("+L") + kLanguageCasesIncludes;
  if (reader == Reader::kStock) {
    return {"povray", "+Iscene.pov", "-F", "+W4", "+H4", "-D", "-GD", "-GR", "-GS", library};
  }
  return {LENTRAY_BIN_DIR "/lentray", "scene.pov", "-F", "+W4", "+H4", "-V", library};
}

// What a program says about its failure, without the banner.
std::string complaint(const std::string& output) {
  std::size_t begin = output.find("Parse Error");
  if (begin == std::string::npos) begin = output.find("error:");
  return begin == std::string::npos ? output.substr(0, 400) : output.substr(begin, 300);
}

// The text between two marks.
std::string between(const std::string& all, std::size_t begin, std::size_t end) {
  return end == std::string::npos ? all.substr(begin) : all.substr(begin, end - begin);
}

}  // namespace

LanguageCases read_cases(const fs::path& file) {
  LanguageCases out;
  std::istringstream in(tool::read_text(file));
  int number = 0;
  std::string* last = nullptr;
  std::string kind, body;
  const auto finish = [&] {
    if (last) *last = wrapped(kind, body);
    last = nullptr;
  };
  bool in_setup = false;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.empty() || line.rfind("//", 0) == 0) continue;
    if (line[0] == ' ') {
      if (in_setup)
        out.setup += line + "\n";
      else
        body += "\n" + line;
      if (!in_setup && !out.cases.empty()) out.cases.back().text += " " + line;
      continue;
    }
    finish();
    const std::size_t space = line.find(' ');
    if (space == std::string::npos) throw std::runtime_error(file.string() + ": no case: " + line);
    kind = line.substr(0, space);
    body = line.substr(space + 1);
    in_setup = kind == "setup";
    if (in_setup) {
      out.setup += body + "\n";
      continue;
    }
    LanguageCase c;
    c.differs = kind[0] == '~';
    if (c.differs) kind.erase(0, 1);
    c.where = file.filename().string() + ":" + std::to_string(number);
    c.text = line;
    out.cases.push_back(c);
    last = &out.cases.back().sdl;
  }
  finish();
  return out;
}

std::vector<std::string> results(Reader reader, const LanguageCases& cases,
                                 std::vector<std::string>* messages) {
  const std::size_t count = cases.cases.size();
  std::vector<std::string> out(count, "NOT REACHED");
  if (messages) messages->assign(count, "");
  for (std::size_t first = 0; first < count;) {
    const tool::TemporaryFolder folder;
    tool::write_text(folder / "scene.pov", program(cases, first));
    const tool::RunResult run = tool::run_program(command(reader), folder.path(), 120.0);
    const std::string all =
        fs::exists(folder / "out.txt") ? tool::read_text(folder / "out.txt") : std::string();
    std::size_t last = count;
    std::size_t at = all.find(mark(first));
    for (std::size_t i = first; i < count && at != std::string::npos; ++i) {
      const std::size_t begin = at + mark(i).size();
      at = i + 1 < count ? all.find(mark(i + 1), begin) : all.find("\n@", begin);
      out[i] = between(all, begin, at);
      last = i;
    }
    if (last == count) {  // not even the first mark
      if (messages) (*messages)[first] = complaint(run.output);
      out[first] = "SETUP FAILED";
      return out;
    }
    if (run.status == 0) return out;
    out[last] = run.timed_out ? "TIMED OUT" : run.status >= 128 ? "CRASHED" : "FAILED";
    if (messages) (*messages)[last] = complaint(run.output);
    first = last + 1;
  }
  return out;
}

void expect_same(const LanguageCases& cases) {
  std::vector<std::string> stock_says, we_say;
  const auto wanted = results(Reader::kStock, cases, &stock_says);
  const auto found = results(Reader::kLentray, cases, &we_say);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const LanguageCase& c = cases.cases[i];
    if (c.differs) {
      EXPECT_NE(found[i], wanted[i]) << c.where << ": no longer differs: " << c.text;
    } else {
      EXPECT_TRUE(found[i] == wanted[i])
          << c.where << ": " << c.text << "\n  lentray: " << found[i] << "  " << we_say[i]
          << "\n  stock:   " << wanted[i] << "  " << stock_says[i];
    }
    EXPECT_NE(found[i], "CRASHED") << c.where;
  }
}

}  // namespace lentray::test
