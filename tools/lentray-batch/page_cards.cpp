#include "tools/lentray-batch/page_cards.h"

#include <algorithm>

namespace lentray::batch {
namespace {

/// A frame's row is named "scene#12".
std::string card_name(const Row& row) {
  const std::size_t mark = row.frame ? row.name.rfind('#') : std::string::npos;
  return row.name.substr(0, mark);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void add(Card& card, const Row& row) {
  // The first of these that a row has is the card's.
  constexpr std::array kOrder{State::failed, State::waiting, State::done, State::skipped};
  card.state = *std::ranges::find_if(
      kOrder, [&](State state) { return state == row.state || state == card.state; });
  card.warnings += row.warnings;
  card.others += row.warnings - static_cast<int>(warnings_of(row.kinds));
  add_kinds(card.kinds, row.kinds);
  card.time += row.wall;
  card.has_left_out |= !row.left_out.empty();
  if (row.verdict && badness(row.verdict->grade) > badness(card.grade))
    card.grade = row.verdict->grade;
}

void finish(Card& card, const std::vector<Row>& rows) {
  if (card.is_animation) {
    std::stable_sort(card.rows.begin(), card.rows.end(),
                     [&](std::size_t a, std::size_t b) { return *rows[a].frame < *rows[b].frame; });
  }
  double ours = 0.0, stock = 0.0;
  for (const std::size_t i : card.rows) {
    if (!rows[i].verdict || rows[i].state != State::done) continue;
    ours += rows[i].cpu;
    stock += rows[i].verdict->stock_cpu;
  }
  if (ours > 0.0 && stock > 0.0) card.ratio = stock / ours;
}

void mark_slow(std::vector<Card>& cards) {
  constexpr double kTimesMedian = 10.0;
  std::vector<double> times;
  for (const Card& card : cards) {
    if (card.state == State::done) times.push_back(card.time);
  }
  if (times.empty()) return;
  const double much = kTimesMedian * median(times);
  std::sort(times.begin(), times.end());
  const std::size_t tenth = times.size() / 10;
  for (Card& card : cards) {
    if (card.state != State::done) continue;
    const bool among_slowest =
        tenth > 0 && card.time >= times[times.size() - tenth] && card.time > times.front();
    card.is_slow = among_slowest || (much > 0.0 && card.time > much);
  }
}

}  // namespace

double rows_to_one(const std::vector<Row>& rows, std::size_t expected) {
  const auto made =
      std::ranges::count_if(rows, [](const Row& row) { return row.state != State::waiting; });
  return std::max(1.0, static_cast<double>(expected) / std::max(1.0, static_cast<double>(made)));
}

int badness(const std::string& grade) {
  const auto at = std::find(kGrades.begin(), kGrades.end(), grade);
  return at == kGrades.end() ? -1 : static_cast<int>(at - kGrades.begin());
}

std::vector<Card> cards_of(const std::vector<Row>& rows) {
  std::vector<Card> cards;
  std::map<std::string, std::size_t> animations;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::string name = card_name(rows[i]);
    std::size_t place = cards.size();
    if (rows[i].frame) place = animations.try_emplace(name, place).first->second;
    if (place == cards.size()) {
      cards.emplace_back().name = std::move(name);
      cards.back().is_animation = rows[i].frame.has_value();
    }
    cards[place].rows.push_back(i);
    add(cards[place], rows[i]);
  }
  for (Card& card : cards) finish(card, rows);
  mark_slow(cards);
  return cards;
}

Summary summary_of(const std::vector<Row>& rows, const std::vector<Card>& cards) {
  Summary sum;
  std::vector<double> ratios;
  sum.cards = cards.size();
  for (const Card& card : cards) {
    sum.done += card.state == State::done;
    sum.failed += card.state == State::failed;
    sum.skipped += card.state == State::skipped;
    sum.waiting += card.state == State::waiting;
    for (const WarningKind& kind : kWarningKinds) {
      const std::string word(kind.word);
      if (card.kinds.contains(word)) ++sum.kinds[word];
    }
    sum.warned += card.warnings > 0;
    sum.slow += card.is_slow;
    sum.differing += is_differing(card);
    if (badness(card.grade) >= 0) ++sum.grades[card.grade];
    if (card.ratio) ratios.push_back(*card.ratio);
  }
  for (const Row& row : rows) {
    sum.made += row.state != State::waiting;
    sum.is_compared |= row.verdict.has_value();
    sum.cpu += row.cpu;
    sum.memory = std::max(sum.memory, row.memory);
  }
  if (!ratios.empty()) sum.median_ratio = median(ratios);
  return sum;
}

}  // namespace lentray::batch
