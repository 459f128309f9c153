#include "tools/lentray-views/arguments.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "camera/lens_sheet.h"
#include "camera/slanted_sheet.h"
#include "parser/options/ini.h"
#include "parser/options/own_option.h"
#include "tools/lentray-views/moving.h"

namespace lentray::views {

using parser::GivenOption;
using parser::OptionError;

namespace {

std::uint32_t whole(const GivenOption& given, std::uint32_t least) {
  return static_cast<std::uint32_t>(parser::whole_number(given, least, 1'000'000));
}

/// Two whole numbers with something between them.
std::optional<std::array<std::uint32_t, 2>> two_numbers(std::string_view text,
                                                        std::string_view mark) {
  std::array<std::uint32_t, 2> out{};
  const std::size_t at = text.find(mark);
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view parts[] = {text.substr(0, at), text.substr(at + mark.size())};
  for (std::size_t i = 0; i < 2; ++i) {
    const char* const end = parts[i].data() + parts[i].size();
    const auto [stop, error] = std::from_chars(parts[i].data(), end, out[i]);
    if (error != std::errc() || stop != end || out[i] > 1'000'000) return std::nullopt;
  }
  return out;
}

void set_range(Arguments& a, const GivenOption& given) {
  const auto ends = two_numbers(given.value, "..");
  if (!ends || (*ends)[1] < (*ends)[0]) {
    parser::refuse(given, "a first and a last view are expected, such as 0..14");
  }
  a.range = Range{(*ends)[0], (*ends)[1]};
}

void set_pair(Arguments& a, const GivenOption& given) {
  const auto both = two_numbers(given.value, ",");
  if (!both) parser::refuse(given, "the left and the right eye's view are expected, such as 9,5");
  a.pair = Range{(*both)[0], (*both)[1]};
}

Size size_in(const GivenOption& given) {
  const auto both = two_numbers(given.value, "x");
  if (!both || (*both)[0] == 0 || (*both)[1] == 0) {
    parser::refuse(given, "a size such as 420x560 is expected");
  }
  return {(*both)[0], (*both)[1]};
}

void set_quilt(Arguments& a, const GivenOption& given) {
  const auto both = two_numbers(given.value, "x");
  if (!both || (*both)[0] == 0 || (*both)[1] == 0 || (*both)[0] > 1000 || (*both)[1] > 1000) {
    parser::refuse(given, "columns x rows of views are expected, such as 8x6");
  }
  a.columns = (*both)[0];
  a.rows = (*both)[1];
}

void set_eye(Arguments& a, const GivenOption& given) {
  const std::size_t comma = given.value.find(',');
  const auto part = [&](std::string text) {
    return parser::number(parser::part_of(given, std::move(text)));
  };
  Eye eye;
  eye.angle = part(given.value.substr(0, comma));
  if (!(std::fabs(eye.angle) < 90.0)) {
    parser::refuse(given, "an angle between -90 and 90 degrees is expected");
  }
  if (comma != std::string::npos) eye.distance = part(given.value.substr(comma + 1));
  if (comma != std::string::npos && !(eye.distance > 0.0)) {
    parser::refuse(given, "the eye's distance must be greater than 0 mm");
  }
  a.eye = eye;
}

void set_filter(Arguments& a, const GivenOption& given) {
  const auto filter = filter_named(given.value);
  if (!filter) parser::refuse(given, "there are " + std::string(kFilterNames));
  a.filter = *filter;
}

void set_model(Arguments& a, const GivenOption& given) {
  for (const auto model :
       {camera::LensModel::kParaxial, camera::LensModel::kPinhole, camera::LensModel::kThick}) {
    if (given.value == camera::name_of(model)) a.sheet.model = model;
  }
  if (!a.sheet.model) parser::refuse(given, "there are paraxial, pinhole and thick");
}

void set_distance(Arguments& a, const GivenOption& given) {
  a.sheet.view_distance = given.value == "inf" ? 0.0 : parser::number(given);
  if (*a.sheet.view_distance < 0.0) parser::refuse(given, "a distance of 0 or more is expected");
}

void set_slant(Arguments& a, const GivenOption& given) {
  a.sheet.slant = camera::tangent_of_slant(given.value);
  if (!a.sheet.slant) parser::refuse(given, camera::kSlantExpected);
}

void set_delay(Arguments& a, const GivenOption& given) {
  a.delay = static_cast<int>(parser::whole_number(given, 10, kLongestDelay));
}

void set_pixels(Arguments& a, const GivenOption& given) {
  a.sheet.pixels = parser::number(given);
  if (*a.sheet.pixels < 1.0) parser::refuse(given, "at least one pixel a lens is expected");
}

void set_profiles(Arguments& a, const GivenOption& given) {
  const auto profiles = tool::profiles_named(given.value);
  if (!profiles) parser::refuse(given, tool::kProfilesExpected);
  a.profiles = *profiles;
}

void set_order(Arguments& a, const GivenOption& given) {
  a.given_order = given.value == "given";
  if (!a.given_order && given.value != "natural") {
    parser::refuse(given, "there are natural and given");
  }
}

/// Reads the command line word by word.
class Reader {
 public:
  Arguments read(const std::vector<std::string>& words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (flag(words[i]) || value(words, i)) continue;
      if (words[i].starts_with("-")) {
        throw OptionError("unknown option '" + words[i].substr(0, words[i].find('=')) +
                          "'; lentray-views --help lists all options");
      } else {
        m_out.pictures.emplace_back(words[i]);
      }
    }
    check();
    return m_out;
  }

 private:
  bool value(const std::vector<std::string>& words, std::size_t& at) {
    static constexpr parser::OwnOption<Reader> kOptions[] = {
        {"View",
         [](Reader& r, const GivenOption& g) {
           r.choose(Task::kViews, "--view");
           const std::uint32_t view = whole(g, 0);
           r.m_out.range = Range{view, view};
         }},
        {"Views",
         [](Reader& r, const GivenOption& g) {
           set_range(r.m_out, g);
           r.m_some_views = true;
         }},
        {"Lens",
         [](Reader& r, const GivenOption& g) {
           r.choose(Task::kLens, "--lens");
           r.m_out.lens = whole(g, 0);
         }},
        {"Quilt",
         [](Reader& r, const GivenOption& g) {
           r.choose(Task::kQuilt, "--quilt");
           set_quilt(r.m_out, g);
         }},
        {"Eye", [](Reader& r, const GivenOption& g) { set_eye(r.m_out, g); }},
        {"Eyes", [](Reader& r, const GivenOption& g) { r.m_out.eyes = parser::positive(g); }},
        {"Pair", [](Reader& r, const GivenOption& g) { set_pair(r.m_out, g); }},
        {"Wiggle",
         [](Reader& r, const GivenOption& g) {
           r.choose(Task::kWiggle, "--wiggle");
           r.m_out.out = parser::file_name(g);
         }},
        {"Delay", [](Reader& r, const GivenOption& g) { set_delay(r.m_out, g); }},
        {"Out", [](Reader& r, const GivenOption& g) { r.m_out.out = parser::file_name(g); }},
        {"Count", [](Reader& r, const GivenOption& g) { r.m_out.count = whole(g, 1); }},
        {"Size", [](Reader& r, const GivenOption& g) { r.m_out.size = size_in(g); }},
        {"Filter", [](Reader& r, const GivenOption& g) { set_filter(r.m_out, g); }},
        {"Like", [](Reader& r, const GivenOption& g) { r.m_out.like = parser::file_name(g); }},
        {"Aspect",
         [](Reader& r, const GivenOption& g) { r.m_out.sheet.aspect = parser::positive(g); }},
        {"Lens_Pixels", [](Reader& r, const GivenOption& g) { set_pixels(r.m_out, g); }},
        {"Lens_Pitch",
         [](Reader& r, const GivenOption& g) { r.m_out.sheet.pitch = parser::positive(g); }},
        {"Lens_Focal_Length",
         [](Reader& r, const GivenOption& g) { r.m_out.sheet.focal_length = parser::positive(g); }},
        {"Lens_IOR",
         [](Reader& r, const GivenOption& g) { r.m_out.sheet.ior = parser::positive(g); }},
        {"Lens_Model", [](Reader& r, const GivenOption& g) { set_model(r.m_out, g); }},
        {"View_Distance", [](Reader& r, const GivenOption& g) { set_distance(r.m_out, g); }},
        {"Lens_Slant", [](Reader& r, const GivenOption& g) { set_slant(r.m_out, g); }},
        {"Preview",
         [](Reader& r, const GivenOption& g) {
           r.choose(Task::kPreview, "--preview");
           r.m_out.out = parser::file_name(g);
         }},
        {"Page_Limit",
         [](Reader& r, const GivenOption& g) { r.m_out.page_limit = parser::positive(g); }},
        {"Profile", [](Reader& r, const GivenOption& g) { set_profiles(r.m_out, g); }},
        {"Order", [](Reader& r, const GivenOption& g) { set_order(r.m_out, g); }},
    };
    return parser::take_own_option(words, at, kOptions, *this);
  }

  bool flag(const std::string& word) {
    if (word == "--all") {
      choose(Task::kViews, "--all");
    } else if (word == "--stereo") {
      choose(Task::kStereo, "--stereo");
    } else if (word == "--interlace") {
      choose(Task::kInterlace, "--interlace");
    } else if (word == "--between") {
      m_out.between = true;
    } else if (word == "--one-zone") {
      m_out.one_zone = true;
    } else if (word == "--from-left") {
      m_out.from_left = true;
    } else if (word == "--square") {
      m_out.square = true;
    } else if (word.starts_with("--anaglyph")) {
      return anaglyph_flag(word);
    } else {
      return false;
    }
    return true;
  }

  bool anaglyph_flag(const std::string& word) {
    choose(Task::kAnaglyph, "--anaglyph");
    if (word == "--anaglyph" || word == "--anaglyph=dubois") return true;
    if (word != "--anaglyph=plain") {
      throw OptionError("'" + word + "': there are --anaglyph=dubois and --anaglyph=plain");
    }
    m_out.anaglyph = Anaglyph::kPlain;
    return true;
  }

  void choose(Task task, const std::string& name) {
    if (!m_task.empty() && m_task != name) {
      throw OptionError(m_task + " and " + name + " are two tasks: give one of them");
    }
    m_task = name;
    m_out.task = task;
  }

  /// What the options can only be judged on together.
  void check() {
    Arguments& a = m_out;
    if (a.pictures.empty()) {
      throw OptionError("no picture is given; lentray-views --help lists all options");
    }
    if (m_some_views && a.task == Task::kDescribe) a.task = Task::kViews;
    if (m_some_views && (m_task == "--view" || m_task == "--all")) {
      throw OptionError("--views and " + m_task + " contradict each other: give one of them");
    }
    if (m_some_views && a.task != Task::kViews && a.task != Task::kWiggle) {
      throw OptionError("--views does not go with " + m_task);
    }
    if (a.eye && a.task == Task::kDescribe) a.task = Task::kEye;
    const bool has_eyes = a.task == Task::kStereo || a.task == Task::kAnaglyph;
    if (a.eye && !has_eyes && a.task != Task::kEye && a.task != Task::kPreview) {
      throw OptionError("--eye does not go with " + m_task);
    }
    if (a.pair && !has_eyes) throw OptionError("--pair is of --stereo and --anaglyph");
    if (a.one_zone && (!has_eyes || a.pair)) {
      throw OptionError("--one-zone is of --stereo and --anaglyph, of eyes before a sheet");
    }
    if (a.pair && a.eye) throw OptionError("--pair and --eye contradict each other");
    if (a.square && a.size) throw OptionError("--square and --size contradict each other");
    const bool is_for_screens = a.task == Task::kWiggle || a.task == Task::kPreview;
    if (a.profiles == tool::Profiles::kKeep && is_for_screens) {
      throw OptionError("--profile keep does not go with " + m_task + ", which has sRGB alone");
    }
    check_interlace();
  }

  void check_interlace() const {
    const Arguments& a = m_out;
    const bool one = a.task == Task::kViews || a.task == Task::kLens || a.task == Task::kEye ||
                     a.task == Task::kDescribe || a.task == Task::kPreview;
    if (one && a.pictures.size() > 1) {
      throw OptionError("'" + a.pictures[1].string() + "': one integral image is expected");
    }
    if (a.task != Task::kInterlace) {
      if (!a.like.empty()) throw OptionError("--like is of --interlace");
      return;
    }
    if (a.pictures.size() < 2) throw OptionError("--interlace wants two pictures or more");
    if (a.like.empty() && !a.sheet.pixels) {
      throw OptionError("--interlace wants --like IMAGE, or --lens-pixels N");
    }
    if (a.square) throw OptionError("--square is of views, not of --interlace");
  }

  Arguments m_out;
  std::string m_task;
  bool m_some_views = false;
};

}  // namespace

Arguments parse_arguments(const std::vector<std::string>& words) { return Reader().read(words); }

}  // namespace lentray::views
