// Rows of a batch as the page shows them: a card a scene, the frames of an animation on one card, and what the
// headline and the filters count. Times in seconds. Pure functions; errors: none; threads: any number.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/lentray-batch/row.h"

namespace lentray::batch {

struct Card {
  std::string name;
  std::vector<std::size_t> rows;  ///< indices; of an animation by frame
  bool is_animation = false;
  State state = State::skipped;  ///< failed if any of the rows is
  int warnings = 0;              ///< of all rows
  int others = 0;                ///< those that are of no kind
  KindsFound kinds{};            ///< of all rows
  double time = 0.0;             ///< wall clock, of all rows
  bool is_slow = false;          ///< among the slowest tenth, or ten times the median
  bool has_left_out = false;
  std::string grade;            ///< the worst of the rows; empty: none
  std::optional<double> ratio;  ///< processor time, stock's over ours
};

/// In the order of their first rows.
std::vector<Card> cards_of(const std::vector<Row>& rows);

struct Summary {
  std::size_t cards = 0, done = 0, failed = 0, skipped = 0, waiting = 0, warned = 0, slow = 0,
              differing = 0;
  std::size_t made = 0;                      ///< rows that do not wait
  std::map<std::string, std::size_t> kinds;  ///< by word, of cards
  bool is_compared = false;
  std::map<std::string, std::size_t> grades;  ///< of cards
  double cpu = 0.0;
  std::uint64_t memory = 0;  ///< the most that a row held
  std::optional<double> median_ratio;
};
Summary summary_of(const std::vector<Row>& rows, const std::vector<Card>& cards);

/// How many rows the batch will have for one that is there: those that wait are to come.
double rows_to_one(const std::vector<Row>& rows, std::size_t expected);

/// The best first.
inline constexpr std::array<std::string_view, 6> kGrades{"exact", "match",   "noise",
                                                         "close", "differs", "fails"};
/// From exact, 0, to fails, 5; -1: no grade.
int badness(const std::string& grade);
/// Grades that the filter "differs" shows.
inline bool is_differing(const Card& card) { return badness(card.grade) > badness("close"); }

}  // namespace lentray::batch
