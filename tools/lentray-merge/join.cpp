#include "tools/lentray-merge/join.h"

#include <algorithm>
#include <memory>
#include <span>
#include <string>

#include "core/image/file_swap.h"
#include "core/image/picture_encoder.h"
#include "core/image/run_files.h"
#include "core/image/writer.h"
#include "parser/options/ini.h"
#include "tools/lentray-merge/png_head.h"
#include "tools/lentray-merge/png_rows.h"

namespace lentray::merge {
namespace {

namespace fs = std::filesystem;
using core::ImageError;
using Bytes = std::span<const png_byte>;

bool is_black(Bytes row) {
  return std::ranges::all_of(row, [](png_byte sample) { return sample == 0; });
}

std::string quoted(const fs::path& path) { return "'" + path.string() + "'"; }

class Joiner {
 public:
  Joiner(const std::vector<Part>& parts, const fs::path& out) : m_out(out), m_parts(parts) {
    m_head = read_head(parts.at(0).path);
    m_spec = spec_of(m_head, parts[0].path);
    m_row_bytes =
        std::size_t{m_spec.width} * static_cast<std::size_t>(m_spec.channels * m_spec.bits / 8);
    for (Part& part : m_parts) {
      const PngHead head = read_head(part.path);
      if (const std::string how = difference(m_head, head); !how.empty()) {
        throw ImageError(quoted(parts[0].path) + " and " + quoted(part.path) +
                         " are not parts of one picture: " + "they differ in their " + how);
      }
      if (!part.rows) part.rows = head.rows;
      if (part.rows && part.rows->last > m_spec.height) {
        throw ImageError(quoted(part.path) + " has " + std::to_string(m_spec.height) +
                         " rows, and cannot have " + text_of({*part.rows}));
      }
      core::note_input(part.path);
      m_readers.push_back(std::make_unique<PngRows>(part.path, m_row_bytes));
    }
    check_rows();
  }

  void write() {
    core::FileSwap swap(m_out);
    fill(swap.temporary());
    if (!m_missing.empty())
      fail_missing("black in every part, or missing: --rows gives the rows of each part");
    if (!difference(m_head, read_head(swap.temporary())).empty()) {
      throw ImageError(quoted(m_parts[0].path) +
                       " is no picture that lentray wrote: it says more of itself");
    }
    swap.commit();
  }

 private:
  /// Where all parts give their rows, what is missing is known before anything is read.
  void check_rows() {
    std::vector<Rows> all;
    for (const Part& part : m_parts) {
      if (!part.rows) return;
      all.push_back(*part.rows);
    }
    m_missing = missing_rows(all, m_spec.height);
    if (!m_missing.empty()) fail_missing("in no part");
  }
  [[noreturn]] void fail_missing(const std::string& why) const {
    const bool one = m_missing.size() == 1 && m_missing[0].first == m_missing[0].last;
    throw ImageError("cannot make " + quoted(m_out) + ": " + text_of(m_missing) +
                     (one ? " is " : " are ") + why);
  }

  void fill(const fs::path& place) {
    try {
      m_encoder = core::make_png_encoder(place, m_spec);
    } catch (const std::exception& e) {
      fail_writing(e.what());
    }
    for (std::uint32_t row = 1; row <= m_spec.height; ++row) put(row);
    guard([&] { m_encoder->close(); });
  }

  void put(std::uint32_t number) {
    Bytes chosen;
    const Part* owner = nullptr;
    for (std::size_t i = 0; i < m_parts.size(); ++i) {
      const Part& part = m_parts[i];
      if (part.rows && !part.rows->holds(number)) continue;
      const Bytes row = m_readers[i]->row(number);
      if (part.rows && part.rows->last == number) m_ended.push_back(i);
      if (!part.rows && is_black(row)) continue;
      if (owner && !std::ranges::equal(chosen, row)) {
        throw ImageError(quoted(owner->path) + " and " + quoted(part.path) + " disagree in " +
                         text_of({Rows{number, number}}));
      }
      chosen = row;
      owner = &part;
    }
    if (!owner) add_missing(number);
    const std::vector<png_byte> black(owner ? 0 : m_row_bytes);
    guard([&] { m_encoder->put(owner ? chosen.data() : black.data(), 1); });
    for (const std::size_t i : m_ended) m_readers[i]->close();
    m_ended.clear();
  }

  void add_missing(std::uint32_t number) {
    if (!m_missing.empty() && m_missing.back().last + 1 == number) {
      m_missing.back().last = number;
    } else {
      m_missing.push_back({number, number});
    }
  }

  [[noreturn]] void fail_writing(const std::string& why) const {
    throw ImageError("cannot write " + core::shown_place(m_out) + ": " + why);
  }
  template <class Work>
  void guard(Work&& work) {
    try {
      work();
    } catch (const std::exception& e) {
      fail_writing(e.what());
    }
  }

  const fs::path m_out;
  std::vector<Part> m_parts;
  PngHead m_head;
  core::PictureSpec m_spec;
  std::size_t m_row_bytes = 0;
  std::vector<std::unique_ptr<PngRows>> m_readers;
  std::unique_ptr<core::PictureEncoder> m_encoder;
  std::vector<std::size_t> m_ended;  ///< parts whose last row this is
  std::vector<Rows> m_missing;
};

}  // namespace

void join(const std::vector<Part>& parts, const fs::path& out) {
  if (!parser::same_word(out.extension().string(), ".png") && out != "-")
    throw ImageError("cannot write " + quoted(out) + ": parts are joined as .png");
  Joiner(parts, out).write();
}

}  // namespace lentray::merge
