#include "shadow/hit_model/enumeration.h"

#include <cmath>
#include <stdexcept>

#include "shadow/hit_model/runs.h"
#include "shadow/lens_columns.h"

namespace lentray::shadow {
namespace {

constexpr double kClearance = 1e-9;  ///< mm

std::uint32_t columns_of(const camera::LensParameters& lens, std::uint32_t lenses) {
  if (const std::string why = camera::complaint(lens); !why.empty()) {
    throw std::invalid_argument(why);
  }
  if (lens.is_finite()) throw std::invalid_argument("the paper's viewing distance is infinite");
  const double width = std::round(lenses * lens.pixels);
  if (!(width >= 1.0 && width <= 1e6)) {
    throw std::invalid_argument("a sheet must have from 1 to 1000000 columns of pixels");
  }
  return static_cast<std::uint32_t>(width);
}

Runs runs_of(Enumeration::Ray ray) {
  switch (ray) {
    case Enumeration::kOpen: return Runs::open(1);
    case Enumeration::kBlocked: return Runs::blocked(1);
    default: return {};
  }
}

}  // namespace

PaperSheet::PaperSheet(const camera::LensParameters& lens, std::uint32_t lenses, std::uint32_t rows)
    : m_columns(lens, columns_of(lens, lenses)), m_rows(rows > 0 ? rows : m_columns.width()) {}

std::string Style::name() const {
  switch (kind) {
    case Kind::kRows: return "rows";
    case Kind::kViews: return "views";
    case Kind::kColumns: return "columns";
    case Kind::kCombined:
      return is_ideal() ? "combined" : "combined(" + std::to_string(width) + ")";
    default:
      return is_ideal() ? "strips"
                        : "strips(" + std::to_string(width) + "," + std::to_string(height) + ")";
  }
}

const std::vector<Style>& paper_styles() {
  using Kind = Style::Kind;
  static const std::vector<Style> kStyles{
      {Kind::kRows}, {Kind::kViews}, {Kind::kColumns}, {Kind::kCombined}, {Kind::kStrips}};
  return kStyles;
}

double clear_edge(const std::vector<double>& places, double edge, int outwards) {
  for (bool moved = true; moved;) {
    moved = false;
    for (const double place : places) {
      if (std::fabs(place - edge) >= kClearance) continue;
      edge = place + outwards * 1.5 * kClearance;
      moved = true;
    }
  }
  return edge;
}

Enumeration::Enumeration(const PaperSheet& sheet, const ShadowSquare& shadow) : m_sheet(sheet) {
  if (!(shadow.size > 0.0 && std::isfinite(shadow.size))) {
    throw std::invalid_argument("a shadow must be larger than 0 mm");
  }
  if (!(shadow.distance >= 0.0 && std::isfinite(shadow.distance))) {
    throw std::invalid_argument("a shadow's distance must be 0 mm or more");
  }
  std::vector<double> across, down;
  for (std::uint32_t k = 0; k < sheet.width(); ++k) {
    if (!sheet.columns().column(k).dark) across.push_back(sheet.column_place(k, shadow.distance));
  }
  for (std::uint32_t r = 0; r < sheet.rows(); ++r) down.push_back(sheet.row_place(r));
  m_left = clear_edge(across, shadow.x, -1);
  m_right = clear_edge(across, shadow.x + shadow.size, 1);
  m_top = clear_edge(down, shadow.y, -1);
  m_bottom = clear_edge(down, shadow.y + shadow.size, 1);

  std::size_t at = 0;
  for (std::uint32_t k = 0; k < sheet.width(); ++k) {
    if (sheet.columns().column(k).dark) {
      m_columns.push_back(kNone);
      continue;
    }
    const double place = across[at++];
    m_columns.push_back(place >= m_left && place <= m_right ? kBlocked : kOpen);
    if (m_columns.back() == kBlocked) ++m_blocked_columns;
  }
  for (const double place : down) {
    m_rows.push_back(place >= m_top && place <= m_bottom ? kBlocked : kOpen);
    if (m_rows.back() == kBlocked) ++m_blocked_rows;
  }
  m_rays = std::uint64_t{across.size()} * sheet.rows();
}

/// Puts the orders together from columns and rows.
class Enumeration::Counting {
 public:
  explicit Counting(const Enumeration& of) : m_of(of) {}

  /// A row whose columns come in an order.
  Runs rows_of(const Runs& row) const {
    Runs sum;
    for (const Ray r : m_of.m_rows) sum += r == kBlocked ? row : Runs::open(row.length);
    return sum;
  }
  Runs natural_row() const {
    Runs row;
    for (const Ray c : m_of.m_columns) row += runs_of(c);
    return row;
  }
  Runs views() const {
    Runs sum;
    for (const Runs& view : rows_of_lists(1, true)) sum += rows_of(view);
    return sum;
  }
  Runs columns() const {
    Runs column, sum;
    for (const Ray r : m_of.m_rows) column += runs_of(r);
    for (const Ray c : m_of.m_columns) {
      if (c != kNone) sum += c == kBlocked ? column : Runs::open(column.length);
    }
    return sum;
  }
  /// First the strips that fit, lens after lens, then the rest.
  Runs ideal_rows() const {
    Runs row = Runs::blocked(m_of.m_blocked_columns);
    row += Runs::open(m_of.m_rays / m_of.m_rows.size() - m_of.m_blocked_columns);
    return rows_of(row);
  }
  Runs ideal_strips() const {
    Runs all = Runs::blocked(m_of.blocked());
    all += Runs::open(m_of.m_rays - m_of.blocked());
    return all;
  }
  Runs strips(std::uint32_t width, std::uint32_t height) const {
    const std::vector<Runs> rows_of_strips = rows_of_lists(width, false);
    Runs sum;
    for (std::size_t top = 0; top < m_of.m_rows.size(); top += height) {
      const std::size_t bottom = std::min(top + height, m_of.m_rows.size());
      for (const Runs& row : rows_of_strips) {
        for (std::size_t r = top; r < bottom; ++r) {
          sum += m_of.m_rows[r] == kBlocked ? row : Runs::open(row.length);
        }
      }
    }
    return sum;
  }

 private:
  /// A row that is met, by lists of its columns.
  std::vector<Runs> rows_of_lists(std::uint32_t width, bool joined) const {
    const auto columns = static_cast<std::uint32_t>(m_of.m_columns.size());
    const ColumnLists lists = lists_of_strips(lenses_of(columns, &sheet()), width, 0, joined);
    std::vector<Runs> rows(lists.before.size() - 1);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t k = lists.before[i]; k < lists.before[i + 1]; ++k) {
        rows[i] += runs_of(m_of.m_columns[lists.columns[k]]);
      }
    }
    return rows;
  }
  const camera::LensSheet& sheet() const { return m_of.m_sheet.columns(); }
  const Enumeration& m_of;
};

std::uint64_t Enumeration::continuous_hits(const Style& style) const {
  const Counting count(*this);
  switch (style.kind) {
    case Style::Kind::kRows: return count.rows_of(count.natural_row()).longest;
    case Style::Kind::kViews: return count.views().longest;
    case Style::Kind::kColumns: return count.columns().longest;
    case Style::Kind::kCombined:
      if (style.is_ideal()) return count.ideal_rows().longest;
      return count.strips(style.width, 1).longest;
    default:
      if (style.is_ideal()) return count.ideal_strips().longest;
      return count.strips(style.width, style.height).longest;
  }
}

ClosedForm closed_form(const PaperSheet& sheet, const ShadowSquare& shadow, const Style& style,
                       paper::Alpha kind) {
  if (!style.is_ideal()) return {};
  const camera::LensParameters& lens = sheet.lens();
  const paper::Across across{sheet.columns().column(0).axis, sheet.columns().lens_count(), shadow.x,
                             shadow.size, shadow.distance};
  switch (style.kind) {
    case Style::Kind::kRows: return {true, paper::style1_hits(lens, across, kind)};
    case Style::Kind::kViews: return {true, paper::style2_hits(lens, shadow.size)};
    case Style::Kind::kColumns: return {true, paper::style3_hits(lens, shadow.size)};
    case Style::Kind::kCombined: return {true, paper::combined_hits(lens, across, kind)};
    default: return {true, paper::two_dimensional_hits(lens, across, shadow.size, kind)};
  }
}

}  // namespace lentray::shadow
