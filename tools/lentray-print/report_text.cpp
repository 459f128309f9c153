#include "tools/lentray-print/report_text.h"

#include "core/base/formed.h"

namespace lentray::print {

std::string short_number(double value, int decimals) {
  std::string out = core::formed("%.*f", decimals, value);
  out.erase(out.find_last_not_of('0') + 1);
  if (out.back() == '.') out.pop_back();
  return out;
}

std::string size_text(double width, double height) {
  return short_number(width) + " x " + short_number(height) + " mm";
}

}  // namespace lentray::print
