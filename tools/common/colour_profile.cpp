#include "tools/common/colour_profile.h"

#include <lcms2.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/owned.h"

namespace lentray::tool {
namespace {

using core::StoredImage;

using Profile = core::Owned<void, cmsCloseProfile>;
using Curve = core::Owned<cmsToneCurve, cmsFreeToneCurve>;
using Transform = core::Owned<void, cmsDeleteTransform>;

constexpr cmsUInt32Number kGreys = TYPE_GRAY_FLT, kColours = TYPE_RGB_FLT, kInks = TYPE_CMYK_FLT;
constexpr cmsCIExyY kD65{0.3127, 0.3290, 1.0};

Profile opened(const std::string& bytes) {
  Profile profile(cmsOpenProfileFromMem(bytes.data(), static_cast<cmsUInt32Number>(bytes.size())));
  if (!profile) throw ProfileError("it is broken");
  return profile;
}

std::string bytes_of(const Profile& profile) {
  cmsUInt32Number size = 0;
  if (!profile || !cmsSaveProfileToMem(profile.get(), nullptr, &size)) {
    throw ProfileError("its primary colours are none");
  }
  std::string bytes(size, '\0');
  cmsSaveProfileToMem(profile.get(), bytes.data(), &size);
  return bytes;
}

/// What the samples become: sRGB's curve, or linear.
Profile wanted(bool is_grey, bool is_linear) {
  const std::array<cmsFloat64Number, 5> srgb{2.4, 1.0 / 1.055, 0.055 / 1.055, 1.0 / 12.92, 0.04045};
  constexpr cmsInt32Number kCurveOfSrgb = 4;
  const Curve curve(is_linear ? cmsBuildGamma(nullptr, 1.0)
                              : cmsBuildParametricToneCurve(nullptr, kCurveOfSrgb, srgb.data()));
  if (is_grey) return Profile(cmsCreateGrayProfile(cmsD50_xyY(), curve.get()));
  constexpr cmsCIExyYTRIPLE kPrimaries{{0.64, 0.33, 1.0}, {0.30, 0.60, 1.0}, {0.15, 0.06, 1.0}};
  cmsToneCurve* const curves[] = {curve.get(), curve.get(), curve.get()};
  return Profile(cmsCreateRGBProfile(&kD65, &kPrimaries, curves));
}

Transform transform_from(const std::string& profile, cmsUInt32Number from, cmsUInt32Number to,
                         bool is_linear) {
  const Profile source = opened(profile), target = wanted(to == kGreys, is_linear);
  Transform transform(
      cmsCreateTransform(source.get(), from, target.get(), to, INTENT_RELATIVE_COLORIMETRIC,
                         cmsFLAGS_NOOPTIMIZE | cmsFLAGS_NOCACHE | cmsFLAGS_BLACKPOINTCOMPENSATION));
  if (!transform) throw ProfileError("it lacks what defines its colours");
  return transform;
}

cmsUInt32Number kind_of(int channels) { return channels < 3 ? kGreys : kColours; }

/// Where the colours of all pixels of a row are, without alpha.
class Row {
 public:
  Row(StoredImage& image, std::uint32_t row)
      : m_image(image), m_start(image.place(0, row, 0)),
        m_colours(static_cast<std::size_t>(image.channels) - (image.has_alpha() ? 1 : 0)),
        m_most(image.most()) {}

  void get(std::vector<float>& values) const {
    values.clear();
    each([&](std::size_t at, float alpha) {
      const float value = m_image.samples[at] / m_most;
      values.push_back(alpha > 0.0f ? value / alpha : value);
    });
  }
  void set(const std::vector<float>& values) {
    std::size_t i = 0;
    each([&](std::size_t at, float alpha) {
      const float value = values[i++] * alpha;
      m_image.samples.set(at, m_image.bits == 32
                                  ? value
                                  : std::floor(std::clamp(value, 0.0f, 1.0f) * m_most + 0.5f));
    });
  }

 private:
  /// With the alpha that the sample is multiplied by.
  template <typename Work>
  void each(const Work& work) const {
    const auto channels = static_cast<std::size_t>(m_image.channels);
    for (std::uint32_t x = 0; x < m_image.width; ++x) {
      const std::size_t at = m_start + x * channels;
      const float alpha = m_image.premultiplied && m_colours < channels
                              ? m_image.samples[at + m_colours] / m_most
                              : 1.0f;
      for (std::size_t c = 0; c < m_colours; ++c) work(at + c, alpha);
    }
  }

  StoredImage& m_image;
  const std::size_t m_start, m_colours;
  const float m_most;
};

}  // namespace

std::string profile_of(const core::Chromaticities& c, double gamma) {
  const cmsCIExyY white{c.white_x, c.white_y, 1.0};
  const cmsCIExyYTRIPLE primaries{
      {c.red_x, c.red_y, 1.0}, {c.green_x, c.green_y, 1.0}, {c.blue_x, c.blue_y, 1.0}};
  const Curve curve(cmsBuildGamma(nullptr, gamma));
  cmsToneCurve* const curves[] = {curve.get(), curve.get(), curve.get()};
  return bytes_of(Profile(cmsCreateRGBProfile(&white, &primaries, curves)));
}

std::string adobe_rgb_profile() {
  constexpr double kGamma = 563.0 / 256.0;
  return profile_of({.green_x = 0.21, .green_y = 0.71}, kGamma);
}

bool is_of_inks(const std::string& profile) {
  return cmsGetColorSpace(opened(profile).get()) == cmsSigCmykData;
}

void check_profile(const std::string& profile, int channels) {
  const cmsColorSpaceSignature space = cmsGetColorSpace(opened(profile).get());
  if (space != (channels < 3 ? cmsSigGrayData : cmsSigRgbData)) {
    throw ProfileError(channels < 3 ? "it is not of greys" : "it is not of red, green and blue");
  }
  transform_from(profile, kind_of(channels), kind_of(channels), false);
}

bool is_srgb(const std::string& profile, int channels) {
  constexpr float kHalfLevel = 0.5f / 255.0f;
  constexpr int kSteps = 9;
  const bool is_grey = channels < 3;
  std::vector<float> from;
  for (int i = 0; i < kSteps * kSteps * kSteps; ++i) {
    const int steps[] = {i % kSteps, i / kSteps % kSteps, i / kSteps / kSteps};
    for (const int step : steps) from.push_back(static_cast<float>(step) / (kSteps - 1));
  }
  std::vector<float> to(from.size());
  const auto kind = kind_of(channels);
  const Transform transform = transform_from(profile, kind, kind, false);
  cmsDoTransform(transform.get(), from.data(), to.data(),
                 static_cast<cmsUInt32Number>(from.size() / (is_grey ? 1 : 3)));
  return std::ranges::equal(from, to,
                            [](float a, float b) { return std::fabs(a - b) <= kHalfLevel; });
}

void convert_to_srgb(StoredImage& image, const std::string& profile) {
  check_profile(profile, image.channels);
  const bool is_linear = image.bits == 32;
  const auto kind = kind_of(image.channels);
  const Transform transform = transform_from(profile, kind, kind, is_linear);
  tbb::parallel_for(std::uint32_t{0}, image.height, [&](std::uint32_t y) {
    std::vector<float> values;
    Row row(image, y);
    row.get(values);
    std::vector<float> converted(values.size());
    cmsDoTransform(transform.get(), values.data(), converted.data(), image.width);
    row.set(converted);
  });
  image.gamma = is_linear ? 1.0 : -1.0;
  image.entries.clear();
}

StoredImage srgb_of_inks(const StoredImage& inks, const std::string& profile) {
  constexpr float kAll = 100.0f;  // LittleCMS has inks in percent
  const Transform transform = transform_from(profile, kInks, kColours, false);
  StoredImage out = core::black_rgb(inks.width, inks.height, 8);
  out.gamma = -1.0;
  std::vector<float> values(std::size_t{4} * inks.width), converted(std::size_t{3} * inks.width);
  for (std::uint32_t y = 0; y < inks.height; ++y) {
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = inks.samples[inks.place(0, y, 0) + i] / 255.0f * kAll;
    cmsDoTransform(transform.get(), values.data(), converted.data(), inks.width);
    Row(out, y).set(converted);
  }
  return out;
}

}  // namespace lentray::tool
