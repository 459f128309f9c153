// What the page has besides what all pages share: page.html, page.css, page.js and page_detail.js; CMake makes the
// source file of them.
#pragma once

#include <string_view>

namespace lentray::batch {

extern const std::string_view kPageHtml, kPageCss, kPageJs;

}  // namespace lentray::batch
