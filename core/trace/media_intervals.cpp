#include "core/trace/media_intervals.h"

#include <algorithm>

namespace lentray::core {

void IntervalCutter::find_stretches(double length, std::vector<RayPart>& lit) {
  m_stretches.clear();
  if (lit.size() > 1) {
    std::sort(lit.begin(), lit.end(),
              [](const RayPart& a, const RayPart& b) { return a.from < b.from; });
  }
  double end = 0.0;
  for (const RayPart& part : lit) {
    if (part.from > end) {
      m_stretches.push_back({end, part.from, false});
    } else if (!m_stretches.empty()) {
      end = m_stretches.back().to = std::max(end, part.to);
      continue;
    }
    m_stretches.push_back({part.from, part.to, true});
    end = part.to;
  }
  if (end < length || lit.empty()) m_stretches.push_back({end, length, false});
}

void IntervalCutter::split(const Stretch& stretch, std::size_t pieces,
                           std::vector<MediaInterval>& out) {
  const double length = (stretch.to - stretch.from) / static_cast<double>(pieces);
  for (std::size_t i = 0; i < pieces; ++i) {
    out.push_back({stretch.from + length * static_cast<double>(i), length, stretch.lit});
  }
}

void IntervalCutter::cut(const MediumSampling& sampling, bool even, double length,
                         std::vector<RayPart>& lit, std::vector<MediaInterval>& out) {
  out.clear();
  find_stretches(length, lit);
  const std::size_t parts = m_stretches.size();
  const std::size_t wanted = std::max(static_cast<std::size_t>(sampling.intervals), parts);
  if (parts == 1) {
    split(m_stretches.front(), even && !m_stretches.front().lit ? 1 : wanted, out);
    return;
  }
  const auto weight = [&](const Stretch& part) {
    return part.lit ? sampling.ratio : 1.0 - sampling.ratio;
  };
  double sum = 0.0;
  for (const Stretch& part : m_stretches) sum += weight(part);
  std::size_t remaining = wanted;
  for (std::size_t i = 0; i < parts; ++i) {
    const std::size_t most = remaining - (parts - i - 1);
    const auto share =
        static_cast<std::size_t>(weight(m_stretches[i]) / sum * static_cast<double>(wanted)) + 1;
    const std::size_t pieces = std::min(share, most);
    split(m_stretches[i], pieces, out);
    remaining -= pieces;
  }
}

MediaSum sum_of(std::span<const MediaInterval> intervals) {
  MediaSum sum;
  Rgb depth;
  for (const MediaInterval& interval : intervals) {
    const float share = 1.0f / static_cast<float>(interval.samples);
    sum.source += interval.source * share * transmittance(depth);
    depth += interval.depth * share;
  }
  sum.left = transmittance(depth);
  return sum;
}

}  // namespace lentray::core
