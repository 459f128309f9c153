#include "tools/lentray-print/letters.h"

#include <algorithm>

namespace lentray::print {
namespace {

/// Lines of a letter, separated by blanks. A point is a digit for x (0 to 12: '0' to '<') and a letter for y ('e': the
/// base line, 'm': the height of small letters, 'q': of capitals, 'a': the depth below the base line). A line that
/// begins with '~' is a curve that its points pull.
struct Letter {
  char letter;
  const char* lines;
};

constexpr Letter kLetters[] = {
    {'A', "0e4q8e 1h7h"},
    {'B', "0q0e ~0q5q8q8k5k0k ~0k5k9k9e5e0e"},
    {'C', "~8n8q0q0e8e8h"},
    {'D', "0q0e ~0q5q9q9e5e0e"},
    {'E', "7q0q0e7e 0k6k"},
    {'F', "7q0q0e 0k6k"},
    {'G', "~8n8q0q0e8e8k 8k5k"},
    {'H', "0e0q 8e8q 0k8k"},
    {'I', "0q4q 2q2e 0e4e"},
    {'J', "6q6i ~6i6e0e0i"},
    {'K', "0q0e 8q0j 2l8e"},
    {'L', "0q0e7e"},
    {'M', "0e0q5i:q:e"},
    {'N', "0e0q8e8q"},
    {'O', "~4q0q0e9e9q4q"},
    {'P', "0e0q ~0q5q8q8j5j0j"},
    {'Q', "~4q0q0e9e9q4q 5h9d"},
    {'R', "0e0q ~0q5q8q8j5j0j 4j8e"},
    {'S', "~8o8q0q0k8k8e0e0g"},
    {'T', "0q8q 4q4e"},
    {'U', "0q0j ~0j0e8e8j 8j8q"},
    {'V', "0q4e8q"},
    {'W', "0q3e6o9e<q"},
    {'X', "0q8e 0e8q"},
    {'Y', "0q4k8q 4k4e"},
    {'Z', "0q8q0e8e"},
    {'a', "7m7e ~7k7m0m0e7e7g"},
    {'b', "0q0e ~0k0m7m7e0e0g"},
    {'c', "~7k7m0m0e7e7g"},
    {'d', "7q7e ~7k7m0m0e7e7g"},
    {'e', "0i7i ~7i7m0m0e7e7g"},
    {'f', "~6q3q3n 3n3e 1m6m"},
    {'g', "7m7d ~7k7m0m0e7e7g ~7d7a0a0b"},
    {'h', "0q0e ~0k0m7m7i 7i7e"},
    {'i', "0m0e 0p0q"},
    {'j', "3m3d ~3d3a0a 3p3q"},
    {'k', "0q0e 6m0h 2j6e"},
    {'l', "0q0g ~0g0e2e"},
    {'m', "0m0e ~0k0m5m5i 5i5e ~5k5m:m:i :i:e"},
    {'n', "0m0e ~0k0m7m7i 7i7e"},
    {'o', "~3m0m0e7e7m3m"},
    {'p', "0m0a ~0k0m7m7e0e0g"},
    {'q', "7m7a ~7k7m0m0e7e7g"},
    {'r', "0m0e ~0j0m5m5l"},
    {'s', "~6k6m0m0i6i6e0e0g"},
    {'t', "2q2g ~2g2e5e 0m5m"},
    {'u', "7m7e ~0m0i0e7e7i"},
    {'v', "0m3e6m"},
    {'w', "0m2e5l8e:m"},
    {'x', "0m6e 0e6m"},
    {'y', "0m3e 6m3e1a"},
    {'z', "0m6m0e6e"},
    {'0', "~3q0q0e7e7q3q"},
    {'1', "0n3q3e 0e6e"},
    {'2', "~0n0q7q7m3i0e 0e7e"},
    {'3', "~0o0q7q7k3k ~3k7k7e0e0g"},
    {'4', "5e5q0h7h"},
    {'5', "6q1q0k ~0k1m7m7e0e0g"},
    {'6', "~6q0q0i0e7e7l0l0i"},
    {'7', "0q7q2e"},
    {'8', "~3k0k0q7q7k3k ~3k0k0e7e7k3k"},
    {'9', "~1e7e7m7q0q0j7j7m"},
    {'.', "0e0f"},
    {',', "1f0c"},
    {':', "0e0f 0l0m"},
    {';', "1f0c 1l1m"},
    {'-', "0i5i"},
    {'+', "0i6i 3f3l"},
    {'/', "0c6q"},
    {'(', "~3q0n0f3c"},
    {')', "~0q3n3f0c"},
    {'[', "3q0q0c3c"},
    {']', "0q3q3c0c"},
    {'%', "~1q0q0n3n3q1q 8q0e ~6h5h5e8e8h6h"},
    {'=', "0g6g 0k6k"},
    {'\'', "0n0q"},
    {'"', "0n0q 2n2q"},
    {'!', "0i0q 0e0f"},
    {'?', "~0o0q6q6l3k3h 3e3f"},
    {'_', "0c7c"},
    {'<', "6m0i6e"},
    {'>', "0m6i0e"},
    {'*', "0h6l 0l6h 3f3n"},
    {'|', "0c0q"},
};
constexpr const char* kUnknownLetter = "0e0q6q6e0e";
constexpr double kUnits = 12.0;       ///< in a capital's height
constexpr double kGapUnits = 3.5;     ///< between letters
constexpr double kBlankUnits = 5.0;   ///< a blank's width
constexpr double kLineWidth = 0.115;  ///< of a capital's height

const char* lines_of(char letter) {
  const auto* found = std::ranges::find(kLetters, letter, &Letter::letter);
  return found == std::end(kLetters) ? kUnknownLetter : found->lines;
}

double units_of(char letter) {
  if (letter == ' ') return kBlankUnits;
  double width = 0.0;
  for (const char* c = lines_of(letter); *c != '\0'; ++c) {
    if (*c >= '0' && *c <= '<') width = std::max(width, static_cast<double>(*c - '0'));
  }
  return width + kGapUnits;
}

/// Corners cut three times: nearly the quadratic curve that the points control. The ends stay.
std::vector<Point> rounded(std::vector<Point> points) {
  for (int round = 0; round < 3 && points.size() > 2; ++round) {
    std::vector<Point> next{points.front()};
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const Point a = points[i], b = points[i + 1];
      const bool is_first = i == 0, is_last = i + 2 == points.size();
      if (!is_first) next.push_back({0.75 * a.x + 0.25 * b.x, 0.75 * a.y + 0.25 * b.y});
      if (!is_last) next.push_back({0.25 * a.x + 0.75 * b.x, 0.25 * a.y + 0.75 * b.y});
    }
    next.push_back(points.back());
    points = std::move(next);
  }
  return points;
}

}  // namespace

double text_width(std::string_view text, double height) {
  double units = 0.0;
  for (const char letter : text) units += units_of(letter);
  return text.empty() ? 0.0 : (units - kGapUnits) * height / kUnits;
}

std::vector<Stroke> text_strokes(std::string_view text, Point foot, double height) {
  const double unit = height / kUnits;
  std::vector<Stroke> strokes;
  for (const char letter : text) {
    const char* lines = letter == ' ' ? "" : lines_of(letter);
    bool is_curve = false;
    std::vector<Point> points;
    const auto flush = [&] {
      if (!points.empty()) {
        strokes.push_back(
            {is_curve ? rounded(std::move(points)) : std::move(points), kLineWidth * height});
      }
      points.clear();
      is_curve = false;
    };
    for (const char* c = lines; *c != '\0'; ++c) {
      if (*c == ' ') {
        flush();
      } else if (*c == '~') {
        is_curve = true;
      } else {
        points.push_back({foot.x + (c[0] - '0') * unit, foot.y - (c[1] - 'e') * unit});
        ++c;
      }
    }
    flush();
    foot.x += units_of(letter) * unit;
  }
  return strokes;
}

}  // namespace lentray::print
