#include "tools/lentray-batch/page.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "tools/common/page_text.h"
#include "tools/lentray-batch/page_cards.h"
#include "tools/lentray-batch/page_data.h"
#include "tools/lentray-batch/page_pictures.h"
#include "tools/lentray-batch/page_sources.h"

namespace lentray::batch {
namespace {

using nlohmann::json;
using tool::script_text;

void put_text(json& out, const char* name, std::string& base64) {
  if (!base64.empty()) out[name] = std::move(base64);
}

void add_pictures(json& data, std::vector<RowPictures> pictures) {
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    json& row = data["rows"][i];
    put_text(row, "picture", pictures[i].picture);
    put_text(row, "tilt", pictures[i].tilt);
    if (pictures[i].tilt_views > 0) row["tilt_views"] = pictures[i].tilt_views;
    put_text(row, "problem", pictures[i].problem);
    if (!row.contains("verdict")) continue;
    put_text(row["verdict"], "stock_picture", pictures[i].stock);
    put_text(row["verdict"], "difference_picture", pictures[i].difference);
  }
}

/// The rows of the page and their text, cut until it leaves half of the room to pictures, or at least fits.
struct Text {
  std::vector<Row> rows;
  std::vector<Card> cards;
  TextLimits limits;
  std::size_t bytes = 0;
};

Text text_within(const std::vector<Row>& rows, const PageOptions& options, std::size_t room) {
  Text text{rows, cards_of(rows), {}, 0};
  for (;;) {
    for (const TextLimits& limits : text_limits()) {
      text.limits = limits;
      text.bytes = script_text(page_data(text.rows, text.cards, options, limits)).size();
      if (text.bytes <= room / 2) return text;
    }
    if (text.bytes <= room || text.rows.empty()) return text;
    // Failed rows stay longest.
    std::stable_sort(text.rows.begin(), text.rows.end(), [](const Row& a, const Row& b) {
      return (a.state == State::failed) > (b.state == State::failed);
    });
    text.rows.resize(text.rows.size() / 2);
    text.cards = cards_of(text.rows);
  }
}

/// Of the text of rows that do not wait.
double bytes_of_made(const Text& text, const PageOptions& options) {
  std::vector<Row> made;
  std::ranges::copy_if(text.rows, std::back_inserter(made),
                       [](const Row& row) { return row.state != State::waiting; });
  if (made.size() == text.rows.size()) return static_cast<double>(text.bytes);
  return static_cast<double>(
      script_text(page_data(made, cards_of(made), options, text.limits)).size());
}

}  // namespace

std::string page(const std::vector<Row>& rows, const PageOptions& options) {
  constexpr std::size_t kReserve = 4096;
  const std::string title = tool::html_text(options.title);
  const std::size_t frame = tool::bytes_of_frame() + kPageHtml.size() + kPageCss.size() +
                            kPageJs.size() + title.size() + kReserve;
  const std::size_t room = options.most_bytes - std::min(options.most_bytes, frame);
  const Text text = text_within(rows, options, room);
  // The text of rows that are to come takes room too.
  const double times = rows_to_one(text.rows, options.expected_rows);
  const double text_room =
      std::min(std::max(static_cast<double>(text.bytes), bytes_of_made(text, options) * times),
               static_cast<double>(text.bytes + room) / 2);
  const auto picture_room =
      static_cast<std::size_t>(std::max(0.0, static_cast<double>(room) - text_room));
  const std::size_t step =
      step_that_fits(text.rows, text.cards, options.expected_rows, picture_room);
  std::string out;
  for (std::size_t s = step; s < picture_steps().size(); ++s) {
    json data = page_data(text.rows, text.cards, options, text.limits);
    data["summary"]["all_rows"] = rows.size();
    add_pictures(data, pictures_of(text.rows, text.cards, options.folder, picture_steps()[s]));
    const std::string text_of_data = script_text(data);
    out = tool::page_of({"lentray-batch", title, kPageCss, kPageHtml, text_of_data, kPageJs});
    if (out.size() <= options.most_bytes) break;
  }
  return out;
}

}  // namespace lentray::batch
