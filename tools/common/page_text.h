// Text for HTML pages that hold everything they need: escaping, links, base64, and the frame that pages share.
//
// A page has style and script in it, loads nothing, and follows the light or dark look that the reader prefers. Its
// text is UTF-8; bytes of names that are none are shown as \xe9. Errors: none. Threads: any number; all functions are pure.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lentray::tool {

/// For the inside of an element or of an attribute in quotes. Control characters become spaces.
std::string html_text(const std::string& text);

/// For the inside of a script element: ASCII, without "<".
std::string script_text(const nlohmann::json& json);

/// A file as a link of a page in `folder`; it begins with "./" or "../", every other byte that has a meaning is
/// escaped.
std::string link_to(const std::string& file, const std::filesystem::path& folder);

/// RFC 4648, with padding.
std::string base64(const std::string& bytes);

/// At a character's beginning, if it is UTF-8, with an ellipsis; as it is where it has at most so many bytes.
std::string cut_text(const std::string& text, std::size_t most);

/// `frame` with each "{{name}}" replaced, once, by what it stands for. Names come in the order of the frame.
std::string filled(std::string_view frame,
                   const std::vector<std::pair<std::string_view, std::string_view>>& parts);

struct PageParts {
  std::string_view generator;    ///< the program's name
  std::string_view title;        ///< HTML, as html_text() gives it
  std::string_view style;        ///< CSS behind the shared one
  std::string_view body;         ///< HTML
  std::string_view data = "{}";  ///< as script_text() gives it, for the script
  std::string_view script;       ///< behind the shared one, in one module with it
};
std::string page_of(const PageParts& parts);

/// Bytes of a page around its parts, the shared style and script with them.
std::size_t bytes_of_frame();

}  // namespace lentray::tool
