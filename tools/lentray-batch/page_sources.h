// The page's own text, from page.html, page.css and page.js; CMake makes the source file of it.
#pragma once

#include <string_view>

namespace lentray::batch {

extern const std::string_view kPageHtml, kPageCss, kPageJs;

}  // namespace lentray::batch
