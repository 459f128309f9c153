// What all pages share: page_frame.html, page_style.css and page_script.js; CMake makes the source file of them.
#pragma once

#include <string_view>

namespace lentray::tool {

extern const std::string_view kFrameHtml, kStyleCss, kScriptJs;

}  // namespace lentray::tool
