// What the page has besides what all pages share: page.html, page.css, page.js and page_controls.js; CMake makes the
// source file of them.
#pragma once

#include <string_view>

namespace lentray::views {

extern const std::string_view kPageHtml, kPageCss, kPageJs;

}  // namespace lentray::views
