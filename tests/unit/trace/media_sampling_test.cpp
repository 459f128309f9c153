// The pieces of a way through media and the three methods of sampling them, against integrals.
#include "core/trace/media_sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "core/trace/random_key.h"

namespace lentray::core::test {
namespace {

/// Media given by two functions of the distance, the same in all channels.
class Line final : public MediaProbe {
 public:
  using Function = std::function<double(double)>;
  Line(Function source, Function extinction)
      : m_source(std::move(source)), m_extinction(std::move(extinction)) {}
  MediaPoint at(double distance, bool) override {
    ++calls;
    return {Rgb(static_cast<float>(m_source(distance))),
            Rgb(static_cast<float>(m_extinction(distance)))};
  }
  double random() override { return m_random.next(); }
  int calls = 0;

 private:
  Function m_source, m_extinction;
  RandomSequence m_random{7, RandomSequence::Use::kMedia};
};

MediaSum sampled(const MediumSampling& sampling, double length, MediaProbe& probe) {
  std::vector<RayPart> lit;
  std::vector<MediaInterval> intervals;
  IntervalCutter().cut(sampling, false, length, lit, intervals);
  const std::vector<double> limits = find_variance_limits(sampling);
  const SamplingPlan plan{sampling, sampling.aa_threshold, limits};
  sample_media(plan, probe, intervals);
  return sum_of(intervals);
}

/// By a fine midpoint rule.
double integral(const Line::Function& source, const Line::Function& extinction, double length) {
  constexpr int kSteps = 200000;
  double sum = 0.0, depth = 0.0;
  const double step = length / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    const double t = (i + 0.5) * step;
    depth += 0.5 * extinction(t) * step;
    sum += source(t) * std::exp(-depth) * step;
    depth += 0.5 * extinction(t) * step;
  }
  return sum;
}

TEST(UnitMediaSampling, EvenMediaFollowBeersLaw) {
  for (const int method : {1, 2, 3}) {
    for (const double amount : {0.0, 1e-6, 0.3, 5.0, 200.0}) {
      MediumSampling sampling;
      sampling.method = static_cast<SamplingMethod>(method);
      Line line([](double) { return 0.0; }, [&](double) { return amount; });
      EXPECT_NEAR(sampled(sampling, 2.0, line).left.r, std::exp(-2.0 * amount), 2e-6)
          << method << " " << amount;
    }
  }
}

TEST(UnitMediaSampling, MoreSamplesComeNearerToTheIntegral) {
  const Line::Function source = [](double t) { return 0.5 + 0.5 * std::sin(3.0 * t); };
  const Line::Function extinction = [](double t) { return 0.4 + 0.2 * std::cos(2.0 * t); };
  const double truth = integral(source, extinction, 3.0);
  for (const int method : {1, 2}) {
    MediumSampling sampling;
    sampling.method = static_cast<SamplingMethod>(method);
    sampling.intervals = 64;
    sampling.min_samples = sampling.max_samples = 200;
    Line line(source, extinction);
    EXPECT_NEAR(sampled(sampling, 3.0, line).source.r, truth, 0.01) << method;
  }
  // Method 3 leaves out the end of each interval, and so has an error of its own, which many
  // samples make small.
  MediumSampling sampling;
  double last = std::numeric_limits<double>::max();
  for (const int samples : {4, 16, 64, 256}) {
    sampling.min_samples = samples;
    Line line(source, extinction);
    const double error = std::fabs(sampled(sampling, 3.0, line).source.r - truth);
    EXPECT_LT(error, last) << samples;
    last = error;
  }
  EXPECT_LT(last, 0.02);
}

TEST(UnitMediaSampling, LevelsAddSamplesWhereColoursDiffer) {
  const auto calls = [](int level) {
    MediumSampling sampling;
    sampling.aa_level = level;
    sampling.min_samples = 4;
    Line line([](double t) { return t < 1.1 ? 0.0 : 5.0; }, [](double) { return 0.0; });
    (void)sampled(sampling, 2.0, line);
    return line.calls;
  };
  EXPECT_LT(calls(1), calls(4));
  EXPECT_LT(calls(4), calls(8));
  EXPECT_LT(calls(8), 4 * calls(1));  // only at the step
}

TEST(UnitMediaSampling, SamplesGoOnUntilTheVarianceIsSmall) {
  const auto calls = [](double variance) {
    MediumSampling sampling;
    sampling.method = SamplingMethod::kRandom;
    sampling.min_samples = 3;
    sampling.max_samples = 50;
    sampling.variance = variance;
    Line line([](double t) { return t; }, [](double) { return 0.0; });
    (void)sampled(sampling, 2.0, line);
    return line.calls;
  };
  EXPECT_EQ(calls(1e9), 3);
  EXPECT_GT(calls(0.05), 3);
  EXPECT_EQ(calls(1e-9), 51);  // one more than the most, as in stock
}

TEST(UnitMediaIntervals, CoverTheWay) {
  MediumSampling sampling;
  sampling.intervals = 7;
  for (const std::vector<RayPart>& parts : {std::vector<RayPart>{},
                                            {{1.0, 2.0}},
                                            {{0.0, 2.0}, {1.5, 5.0}},
                                            {{3.0, 9.0}, {0.5, 1.0}},
                                            {{1.0, 9.0}, {2.0, 3.0}},
                                            {{0.0, 10.0}}}) {
    std::vector<RayPart> lit = parts;
    std::vector<MediaInterval> intervals;
    IntervalCutter().cut(sampling, false, 10.0, lit, intervals);
    EXPECT_GE(intervals.size(), 7u - parts.size());
    double at = 0.0;
    for (const MediaInterval& interval : intervals) {
      EXPECT_NEAR(interval.from, at, 1e-12);
      at += interval.length;
      const double middle = interval.from + 0.5 * interval.length;
      bool is_lit = false;
      for (const RayPart& part : parts) is_lit = is_lit || part.holds(middle);
      EXPECT_EQ(interval.lit, is_lit) << middle;
    }
    EXPECT_NEAR(at, 10.0, 1e-12);
  }
}

TEST(UnitMediaIntervals, LitPartsGetTheirShare) {
  MediumSampling sampling;
  sampling.intervals = 10;
  sampling.ratio = 0.9;
  std::vector<RayPart> lit{{4.0, 6.0}};
  std::vector<MediaInterval> intervals;
  IntervalCutter().cut(sampling, false, 10.0, lit, intervals);
  int in_light = 0;
  for (const MediaInterval& interval : intervals) in_light += interval.lit;
  EXPECT_EQ(in_light, 8);
  EXPECT_EQ(intervals.size(), 10u);
}

}  // namespace
}  // namespace lentray::core::test
