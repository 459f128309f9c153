#include "tools/session/depth_view.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "camera/parallax.h"
#include "camera/text.h"
#include "core/base/formed.h"
#include "tools/common/page_text.h"
#include "tools/session/depth_plan.h"

namespace lentray::tool {
namespace {

using camera::DepthInterval;
using camera::PlanPoint;
using camera::SeenObject;

constexpr std::size_t kMostListed = 24;
constexpr double kRowHeight = 20.0;

std::string svg_number(double value) { return core::formed("%.1f", value); }

std::string svg_text(double x, double y, const std::string& text, const std::string& more = "") {
  return "<text x=\"" + svg_number(x) + "\" y=\"" + svg_number(y) + "\"" +
         (more.empty() ? "" : " " + more) + ">" + html_text(text) + "</text>\n";
}

std::string svg_line(double x0, double y0, double x1, double y1, const char* look) {
  return "<line x1=\"" + svg_number(x0) + "\" y1=\"" + svg_number(y0) + "\" x2=\"" +
         svg_number(x1) + "\" y2=\"" + svg_number(y1) + "\" class=\"" + look + "\"/>\n";
}

std::string svg_dot(double x, double y, double radius, const char* look) {
  return "<circle cx=\"" + svg_number(x) + "\" cy=\"" + svg_number(y) + "\" r=\"" +
         svg_number(radius) + "\" class=\"" + look + "\"/>\n";
}

/// "box at scene.pov:12:1" of "box at /a/long/way/scene.pov:12:1".
std::string short_name(const std::string& name) {
  const std::size_t place = name.rfind(" at ");
  if (place == std::string::npos) return name;
  return name.substr(0, place + 4) +
         std::filesystem::path(name.substr(place + 4)).filename().string();
}

/// An object of the drawing, with what is reported of it.
struct Drawn {
  const SeenObject* object = nullptr;
  double near = 0.0, far = 0.0, most = 0.0;  ///< parallax, pixels a view
};

/// Those that stand out first, then those that take up most of the picture.
std::vector<Drawn> chosen(const camera::Lenticular& sheet, const camera::DepthSurvey& seen) {
  std::vector<Drawn> out;
  for (const SeenObject& object : seen.objects) {
    const double near = camera::parallax(sheet, object.nearest),
                 far = camera::parallax(sheet, object.farthest);
    out.push_back({&object, near, far, std::max(std::fabs(near), std::fabs(far))});
  }
  std::ranges::stable_sort(out, [](const Drawn& a, const Drawn& b) {
    const bool a_sharp = a.most <= camera::kSharpParallax,
               b_sharp = b.most <= camera::kSharpParallax;
    return a_sharp != b_sharp ? b_sharp : a.object->share > b.object->share;
  });
  if (out.size() > kMostListed) out.resize(kMostListed);
  std::ranges::stable_sort(out, {}, [](const Drawn& d) { return d.object->nearest; });
  return out;
}

std::string hue(std::size_t number) {
  constexpr const char* kHues[] = {"#4477aa", "#cc6677", "#228833", "#aa7733", "#66bbcc",
                                   "#aa3377", "#777777", "#999933", "#332288", "#dd9955"};
  return kHues[number % std::size(kHues)];
}

double area_of(const std::vector<PlanPoint>& outline) {
  double twice = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const PlanPoint &a = outline[i], &b = outline[(i + 1) % outline.size()];
    twice += a.x * b.depth - b.x * a.depth;
  }
  return 0.5 * std::fabs(twice);
}

std::string outline_text(const DepthPlan& plan, const std::vector<PlanPoint>& outline,
                         const std::string& colour) {
  std::string points;
  for (const PlanPoint& p : outline)
    points += svg_number(plan.x(p.x)) + "," + svg_number(plan.y(p.depth)) + " ";
  if (points.empty()) return "";
  // Things seen edge on are as thin as a line.
  return "<polygon points=\"" + points + "\" fill=\"" + colour +
         "\" fill-opacity=\"0.18\" stroke=\"" + colour +
         "\" stroke-width=\"1.5\" stroke-linejoin=\"round\"/>\n";
}

/// Outlines, the large ones below, and then their numbers.
std::string objects_text(const DepthPlan& plan, const std::vector<Drawn>& drawn) {
  struct Outline {
    std::vector<PlanPoint> points;
    std::size_t number = 0;
  };
  std::vector<Outline> outlines;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    outlines.push_back({plan.cut(drawn[i].object->outline), i});
  }
  std::ranges::stable_sort(outlines, std::greater<>(),
                           [](const Outline& o) { return area_of(o.points); });
  std::string out, numbers;
  for (const Outline& o : outlines) {
    out += outline_text(plan, o.points, hue(o.number));
    if (o.points.empty()) continue;
    double x = 0.0, y = 0.0;
    for (const PlanPoint& p : o.points) {
      x += plan.x(p.x) / static_cast<double>(o.points.size());
      y += plan.y(p.depth) / static_cast<double>(o.points.size());
    }
    numbers += svg_dot(x, y, 9.0, "number");
    numbers += svg_text(x, y + 4.0, std::to_string(o.number + 1),
                        "text-anchor=\"middle\" style=\"fill:" + hue(o.number) + "\"");
  }
  return out + numbers;
}

std::string range_text(const camera::Lenticular& sheet, const DepthPlan& plan) {
  const DepthInterval sharp = camera::depths_within(sheet, camera::kSharpParallax),
                      calm = camera::depths_within(sheet, camera::kMostParallax);
  const double x0 = plan.x(plan.left()), x1 = plan.x(plan.right());
  const auto inside = [&](double depth) { return depth > plan.near() && depth < plan.far(); };
  const double top = plan.y(std::min(sharp.farthest, plan.far())),
               bottom = plan.y(std::max(sharp.nearest, plan.near()));
  std::string out = "<rect x=\"" + svg_number(x0) + "\" y=\"" + svg_number(top) + "\" width=\"" +
                    svg_number(plan.width()) + "\" height=\"" + svg_number(bottom - top) +
                    "\" class=\"sharp\"/>\n";
  for (const double depth : {calm.nearest, calm.farthest}) {
    if (!inside(depth)) continue;
    out += svg_line(x0, plan.y(depth), x1, plan.y(depth), "jumps");
    out += svg_text(x1 - 6.0, plan.y(depth) + (depth < 0.0 ? 13.0 : -4.0), "jumps beyond",
                    "text-anchor=\"end\" class=\"small\"");
  }
  return out + svg_text(x0 + 6.0, 0.5 * (top + bottom) + 4.0, "sharp", "class=\"small\"");
}

std::string sheet_text(const camera::Lenticular& sheet, const DepthPlan& plan) {
  const double half = 0.5 * sheet.placement().width;
  return svg_line(plan.x(-half), plan.y(0.0), plan.x(half), plan.y(0.0), "sheet") +
         svg_text(plan.x(-half), plan.y(0.0) + 17.0, "lens sheet", "class=\"small\"");
}

std::string viewing_text(const camera::Lenticular& sheet, const DepthPlan& plan) {
  const ViewingPlan viewing = viewing_plan(sheet);
  const double y = plan.y(viewing.depth), middle = viewing.middle;
  std::string out;
  // What the middle view sees.
  for (const double side : {-0.5, 0.5}) {
    const double edge = side * sheet.placement().width;
    const double reach = (plan.far() - viewing.depth) / -viewing.depth;
    out += svg_line(plan.x(middle), y, plan.x(middle + (edge - middle) * reach), plan.y(plan.far()),
                    "sight");
  }
  if (!plan.has_eyes()) return out;
  out += svg_line(plan.x(middle - 0.5 * viewing.zone), y, plan.x(middle + 0.5 * viewing.zone), y,
                  "zone");
  for (const double x : viewing.viewpoints)
    out += svg_line(plan.x(x), y - 5.0, plan.x(x), y + 5.0, "view");
  for (const double side : {-0.5, 0.5}) {
    out += svg_dot(plan.x(middle + side * viewing.eyes_apart), y, 5.0, "eye");
  }
  return out;
}

std::string axes_text(const DepthPlan& plan) {
  const double left = plan.x(plan.left()), bottom = plan.y(plan.near());
  std::string out = "<rect x=\"" + svg_number(left) + "\" y=\"" + svg_number(DepthPlan::kTop) +
                    "\" width=\"" + svg_number(plan.width()) + "\" height=\"" +
                    svg_number(plan.height()) + "\" class=\"frame\"/>\n";
  for (const double depth : round_ticks(plan.near(), plan.far())) {
    out += svg_line(left - 5.0, plan.y(depth), left, plan.y(depth), "axis");
    out += svg_text(left - 8.0, plan.y(depth) + 4.0, camera::brief(depth),
                    "text-anchor=\"end\" class=\"small\"");
  }
  for (const double x : round_ticks(plan.left(), plan.right())) {
    out += svg_line(plan.x(x), bottom, plan.x(x), bottom + 5.0, "axis");
    out += svg_text(plan.x(x), bottom + 18.0, camera::brief(x),
                    "text-anchor=\"middle\" class=\"small\"");
  }
  return out +
         svg_text(left, bottom + 36.0,
                  "Scene units: to the right of the sheet's middle, and upwards behind the sheet",
                  "class=\"small\"");
}

std::string number_text(double value) {
  return std::isfinite(value) ? camera::brief(value) : std::string("no limit");
}

/// The table below the drawing, from `y` on; moves it along.
std::string list_text(const std::vector<Drawn>& drawn, std::size_t more, double& y) {
  const double x = DepthPlan::kLeft;
  std::string out =
      svg_text(x, y, "Parallax from view to view, in pixels of a view", "class=\"head\"");
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    y += kRowHeight;
    const Drawn& d = drawn[i];
    const double share = std::round(1e3 * d.object->share) / 10.0;
    out += svg_text(x + 14.0, y, std::to_string(i + 1),
                    "text-anchor=\"end\" style=\"fill:" + hue(i) + "\"");
    out += svg_text(x + 26.0, y, cut_text(short_name(d.object->name), 64));
    out += svg_text(x + 560.0, y, number_text(d.near) + " to " + number_text(d.far),
                    "text-anchor=\"end\"");
    out += svg_text(x + 640.0, y, camera::brief(share) + " %", "text-anchor=\"end\"");
    const char* said = d.most > camera::kMostParallax    ? "jumps"
                       : d.most > camera::kSharpParallax ? "not sharp"
                                                         : "";
    if (*said) out += svg_text(x + 660.0, y, said);
  }
  if (more == 0) return out;
  y += kRowHeight;
  return out + svg_text(x + 26.0, y, "and " + std::to_string(more) + " more");
}

/// What the signs mean.
std::string key_text(const camera::Lenticular& sheet, const DepthPlan& plan, double& y) {
  std::string out;
  const auto add = [&](const std::string& text) {
    out += svg_text(DepthPlan::kLeft, y, text, "class=\"small\"");
    y += 16.0;
  };
  if (plan.has_eyes()) {
    add("Below: the zone to view the sheet from, the eyes of the views (ticks), two eyes 65 mm "
        "apart "
        "(rings)");
  } else if (sheet.sheet().lens().is_finite()) {
    const ViewingPlan viewing = viewing_plan(sheet);
    add("The eyes are too far away to be drawn: " + camera::brief(-viewing.depth) +
        " before the sheet, in a zone " + camera::brief(viewing.zone) + " wide; two eyes are " +
        camera::brief(viewing.eyes_apart) + " apart");
  } else {
    add("The viewer is infinitely far below");
  }
  const double stretch = plan.stretch();
  if (std::fabs(stretch - 1.0) > 0.01) {
    add("Depth is drawn " + camera::brief(stretch) + " times as large as width");
  }
  return out;
}

constexpr const char* kStyle =
    "<style>text{font:13px sans-serif;fill:#222}"
    ".small{font-size:11px;fill:#555}.head{font-weight:bold}.title{font-size:16px;font-weight:bold}"
    ".frame{fill:none;stroke:#999}.axis{stroke:#999}.sharp{fill:#f4efd6}"
    ".jumps{stroke:#b06000;stroke-dasharray:6 4}.sheet{stroke:#000;stroke-width:4}"
    ".zone{stroke:#36c;stroke-width:2}.view{stroke:#36c}.eye{fill:#fff;stroke:#36c;stroke-width:2}"
    ".sight{stroke:#bbb;stroke-dasharray:2 3}.number{fill:#fff;fill-opacity:.85}</style>\n";

}  // namespace

std::string depth_view(const camera::Lenticular& sheet, const camera::DepthSurvey& seen,
                       const std::string& title) {
  const DepthPlan plan(sheet, seen);
  const std::vector<Drawn> drawn = chosen(sheet, seen);
  std::string inside =
      range_text(sheet, plan) + sheet_text(sheet, plan) + objects_text(plan, drawn);
  if (sheet.sheet().lens().is_finite()) inside += viewing_text(sheet, plan);
  const double left = plan.x(plan.left());
  double y = plan.y(plan.near()) + 56.0;
  std::string below = key_text(sheet, plan, y);
  y += 14.0;
  below += list_text(drawn, seen.objects.size() - drawn.size(), y);
  const std::string width = svg_number(DepthPlan::kLeft + DepthPlan::kWidth + 30.0),
                    height = svg_number(y + 20.0);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
         "\" viewBox=\"0 0 " + width + " " + height + "\">\n" + kStyle +
         "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n<clipPath id=\"area\"><rect x=\"" +
         svg_number(left) + "\" y=\"" + svg_number(DepthPlan::kTop) + "\" width=\"" +
         svg_number(plan.width()) + "\" height=\"" + svg_number(plan.height()) +
         "\"/></clipPath>\n" + svg_text(left, 28.0, cut_text(title, 90), "class=\"title\"") +
         svg_text(left, 47.0, "What the lens sheet shows, seen from above", "class=\"small\"") +
         "<g clip-path=\"url(#area)\">\n" + inside + "</g>\n" + axes_text(plan) + below +
         "</svg>\n";
}

}  // namespace lentray::tool
