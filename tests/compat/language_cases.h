// Language cases in text files, and what stock POV-Ray and lentray make of them.
//
// A case file holds one case a line; a line that begins with a space goes on with the case above,
// `//` begins a comment line, and what `setup` begins is read before all cases. Kinds:
//   n EXPR    a float            v2..v5 EXPR   a vector       s EXPR   a string
//   p SDL     a program, which writes with W(string)
// Expected is what stock does with it, in the same run of the tests: the text it writes, or that
// it fails. A case that begins with ~ is a difference that docs/language.md explains: it must differ.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lentray::test {

struct LanguageCase {
  std::string where;  ///< file:line
  std::string text;   ///< as written
  std::string sdl;    ///< what is run
  bool differs = false;
};

struct LanguageCases {
  std::string setup;
  std::vector<LanguageCase> cases;
};

/// Throws std::runtime_error, also for lines that are no case.
LanguageCases read_cases(const std::filesystem::path& file);

enum class Reader { kStock, kLentray };

/// What each case wrote, or "FAILED". Cases go through one process; one that fails ends it, and
/// the next process begins with the case after it. Cases must not lean on each other. `messages`
/// gets what the program said about cases that failed, by case.
std::vector<std::string> results(Reader reader, const LanguageCases& cases,
                                 std::vector<std::string>* messages = nullptr);

/// Compares both, as test failures.
void expect_same(const LanguageCases& cases);

}  // namespace lentray::test
