#include "parser/values/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string_view>

#include "parser/values/arithmetic.h"

namespace lentray::parser {
namespace {

constexpr double kPowers[] = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10};
constexpr int kMostDigits = 10;

// x * 10^digits, x >= 0, to the nearest whole number, halves to the even one: exact, because the
// product and its rounding error are. False if it is too large for that.
bool scaled(double x, int digits, std::int64_t& whole) {
  constexpr double kLargest = 9007199254740992.0 / 2;
  const double power = kPowers[digits];
  const double product = x * power;
  if (!(product < kLargest)) return false;
  const double error = std::fma(x, power, -product);
  whole = static_cast<std::int64_t>(product);
  const double beyond = (product - static_cast<double>(whole) - 0.5) + error;
  if (beyond > 0.0 || (beyond == 0.0 && whole % 2 != 0)) ++whole;
  return true;
}

// Writes whole / 10^digits; returns its end.
char* put_decimal(char* at, std::int64_t whole, int digits) {
  constexpr std::ptrdiff_t kMost = 20;
  if (digits == 0) return std::to_chars(at, at + kMost, whole).ptr;
  // Behind the place of the point; what stands before it is then moved there.
  char* const end = std::to_chars(at + 1, at + 1 + kMost, whole).ptr;
  std::ptrdiff_t before = (end - at - 1) - digits;
  if (before > 0) {
    for (char* const point = at + before; at < point; ++at) *at = at[1];
    *at = '.';
    return end;
  }
  const std::ptrdiff_t zeros = 1 - before;  // the one before the point too
  std::copy_backward(at + 1, end, end + zeros);
  std::fill_n(at, zeros + 1, '0');
  at[1] = '.';
  return end + zeros;
}

void append_padded(std::string& text, const NumberFormat& format, std::string_view number) {
  const auto width = static_cast<std::size_t>(format.width);
  if (width > number.size()) {
    const std::size_t missing = width - number.size();
    if (format.zeros && number[0] == '-') {
      text += '-';
      number.remove_prefix(1);
    }
    text.append(missing, format.zeros ? '0' : ' ');
  }
  text += number;
}

constexpr int kMostOfStr = 254;  // what str() makes at most, as measured on stock
constexpr int kLongest = 1000;   // what width and digits are cut to
constexpr int kUnprintable = std::numeric_limits<int>::max();

// What most numbers need. False, and nothing done, if that may be longer than kMostOfStr.
bool append_short(std::string& text, const NumberFormat& format, double value) {
  if (format.width > kMostOfStr) return false;
  char buffer[kMostOfStr];
  char* end = buffer;
  std::int64_t whole = 0;
  if (format.digits <= kMostDigits && scaled(std::fabs(value), format.digits, whole)) {
    if (std::signbit(value)) *end++ = '-';
    end = put_decimal(end, whole, format.digits);
  } else {
    if (!std::isfinite(value)) return false;
    const auto put = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed,
                                   format.digits);
    if (put.ec != std::errc()) return false;
    end = put.ptr;
  }
  append_padded(text, format, {buffer, static_cast<std::size_t>(end - buffer)});
  return true;
}

// As printf has it (`kind`: f or g); returns the length. Nothing if no such width can be.
int append_printed(std::string& text, const NumberFormat& format, char kind, double value) {
  if (format.width == kUnprintable) return 0;
  char buffer[2 * kLongest];  // 309 digits before the point, kLongest behind it
  const std::string how = std::string(format.zeros ? "%0*.*" : "%*.*") + kind;
  const int length =
      std::snprintf(buffer, sizeof buffer, how.c_str(), format.width, format.digits, value);
  text += buffer;
  return length;
}

}  // namespace

NumberFormat number_format_of(double width, double digits) {
  constexpr int kUsual = 6;
  const int least = to_int(width), behind = to_int(digits);
  const int length =
      least == std::numeric_limits<int>::min() ? kUnprintable : std::min(std::abs(least), kLongest);
  return {length, behind < 0 ? kUsual : std::min(behind, kLongest), least < 0};
}

void append_fixed(std::string& text, const NumberFormat& format, double value) {
  if (append_short(text, format, value)) return;
  const std::size_t start = text.size();
  for (const char kind : {'f', 'g'}) {
    const int length = append_printed(text, format, kind, value);
    if (length > 0 && length <= kMostOfStr) return;
    text.resize(start);
  }
  text += "<invalid>";
}

int vector_text_size(double wanted) { return std::clamp(to_int(wanted), 2, 5); }

void append_vector(std::string& text, const Number& n, int count, const std::string& separator,
                   const NumberFormat& format) {
  const int size = n.keeps_rest ? 3 : n.size;
  for (int i = 0; i < count; ++i) {
    if (i) text += separator;
    const double value = i < size ? n.v[static_cast<std::size_t>(i)] : 0.0;
    if (!append_short(text, format, value)) append_printed(text, format, 'f', value);
  }
}

void append_general(std::string& text, double value) {
  constexpr int kPrecision = 6;
  constexpr double kLeast = 1e-4, kMost = 1e6;  // beyond them it has an exponent
  const double x = std::fabs(value);
  if (x == 0.0) {
    text += std::signbit(value) ? "-0" : "0";
    return;
  }
  if (x >= kLeast && x < kMost) {
    // Six digits stand before the point when it is moved so far.
    int moved = 0;
    while (moved < kMostDigits && x * kPowers[moved] < kMost / 10) ++moved;
    std::int64_t whole = 0;
    if (scaled(x, moved, whole) && whole < static_cast<std::int64_t>(kMost)) {
      for (; moved > 0 && whole % 10 == 0; --moved) whole /= 10;
      return append_fixed(text, {0, moved, false}, value);
    }
  }
  char buffer[64];
  if (std::isfinite(value)) {
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value,
                                   std::chars_format::general, kPrecision);
    text.append(buffer, end.ptr);
  } else {
    std::snprintf(buffer, sizeof buffer, "%g", value);
    text += buffer;
  }
}

}  // namespace lentray::parser
