// INI files as POV-Ray reads them: one `Name=Value` a line, or switches, perhaps with one
// `Name=Value` behind them, or the name of another INI file; `;` or `#` starts a comment; [labelled]
// sections. The part before the first section is read always, and with a label every section of
// that label as well (letter case ignored).
// Source: tutorial 3.7, "Using INI Files"; measured on stock (.ini is added, quotes, sections, #).
// Errors: OptionError. Pure functions; any number of threads.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace lentray::parser {

/// An option, or a file with options, that cannot be used, worded for the user.
class OptionError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct IniLine {
  enum class Kind { kOption, kSwitch, kNested };
  Kind kind = Kind::kOption;
  int line = 0;
  std::string text;   ///< option: its name; switch: as written; nested: file, perhaps with [label]
  std::string value;  ///< option: without quotes and blanks around it
};

/// "file.ini[label]" taken apart. The label is empty if there is none.
struct IniName {
  std::string file, label;
  bool has_label = false;
};
IniName ini_name(std::string_view text);

/// Of words of a command line: "+A", or "-D"; "file.ini", or "file.ini[label]".
bool is_switch(std::string_view word);
bool is_ini(std::string_view word);

struct IniSection {
  std::vector<IniLine> lines;  ///< of the part before all sections, and of the section
  bool is_there = false;       ///< the section that was asked for; true if none was
};

/// The lines of a section in a text. `file` is for messages.
IniSection ini_lines(std::string_view text, const std::string& file, const IniName& name);

/// The whole file; what it says is an input of the run.
std::string ini_file_text(const std::string& path);
/// ini_lines() of a whole file. As in stock, a section that is not there is no error; a warning names it.
IniSection read_ini(std::string_view text, const std::string& path, const IniName& name,
                    std::vector<std::string>& warnings);

/// Labels of a text's sections, as written.
std::vector<std::string> ini_labels(std::string_view text);

/// Takes away blanks around a text and one pair of equal quotes around what is left.
std::string unquoted(std::string_view text);
/// Equal but for ASCII letter case.
bool same_word(std::string_view a, std::string_view b);

}  // namespace lentray::parser
