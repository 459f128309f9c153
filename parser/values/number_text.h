// Numbers as text: what str(), vstr() and #write print. Correctly rounded, as the C library's.
// Source: reference manual 3.7, "Strings", "#write"; the two formats measured on stock.
// Held to printf by tests/unit/parser/parser_number_text_test.cpp.
#pragma once

#include <string>

#include "parser/values/value.h"

namespace lentray::parser {

/// How str() and vstr() print.
struct NumberFormat {
  int width = 0, digits = 6;  ///< least length; digits behind the point
  bool zeros = false;         ///< in front, instead of spaces
};

/// Of the two numbers that stand for it in SDL: a negative width is for zeros in front.
NumberFormat number_format_of(double width, double digits);

/// As str(): printf's %f; what would be longer than stock's 254 bytes as %g, or else "<invalid>".
void append_fixed(std::string& text, const NumberFormat& format, double value);

/// As vstr(), which has no such limit up to the 1000 that widths and digits are cut to: as many components as vector_text_size() makes of its first argument.
void append_vector(std::string& text, const Number& n, int count, const std::string& separator,
                   const NumberFormat& format);
int vector_text_size(double wanted);

/// As printf's %g: six digits.
void append_general(std::string& text, double value);

}  // namespace lentray::parser
