#include "tools/lentray-batch/verdict.h"

#include <nlohmann/json.hpp>

namespace lentray::batch {

using nlohmann::json;

void take_figures(const json& said, Verdict& v) {
  const json& whole = said.at("whole");
  v.grade = whole.at("grade") == "fails" ? "differs" : whole.at("grade").get<std::string>();
  if (!whole.at("psnr").is_null()) v.psnr = whole.at("psnr").get<double>();
  whole.at("beyond_1").get_to(v.beyond_1);
  whole.at("beyond_2").get_to(v.beyond_2);
  whole.at("largest").get_to(v.largest);
  whole.at("block_rms").get_to(v.block_rms);
  whole.at("bias").get_to(v.bias);
  if (whole.contains("noise_rms")) {
    v.noise_rms = whole.at("noise_rms").get<double>();
    v.noise_bias = whole.at("noise_bias").get<double>();
  }
  v.noise_cpu = said.value("noise_cpu_s", 0.0);
  for (const json& lens : said.value("lenses", json::array()))
    ++v.lens_grades[lens.at("grade").get<std::string>()];
  for (const json& view : said.value("views", json::array()))
    ++v.view_grades[view.at("grade").get<std::string>()];
}

}  // namespace lentray::batch
