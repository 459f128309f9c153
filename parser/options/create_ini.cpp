#include "parser/options/create_ini.h"

#include <charconv>
#include <filesystem>
#include <string_view>

#include "parser/options/options_table.h"

namespace lentray::parser {
namespace {

/// Shortest text that is read as the same number.
std::string text_of(double value) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

bool is_number(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return !text.empty() && error == std::errc() && end == text.data() + text.size();
}

class Lines {
 public:
  void add(std::string_view name, std::string_view value) {
    m_text.append(name).append("=").append(value).append("\n");
  }
  void add(std::string_view name, bool value) { add(name, std::string_view(value ? "On" : "Off")); }
  void number(std::string_view name, double value) { add(name, text_of(value)); }
  template <typename Number>
  void number(std::string_view name, const std::optional<Number>& value) {
    if (value) number(name, static_cast<double>(*value));
  }
  void name(std::string_view name, const std::string& value) {
    if (!value.empty()) add(name, '"' + value + '"');
  }
  std::string take() { return std::move(m_text); }

 private:
  std::string m_text;
};

void add_views(const ViewOptions& views, Lines& out) {
  out.number("Views", views.count);
  if (views.quilt) {
    out.add("Quilt",
            std::to_string(views.quilt->columns) + "x" + std::to_string(views.quilt->rows));
  }
  if (views.size) {
    out.add("View_Size",
            std::to_string(views.size->width) + "x" + std::to_string(views.size->height));
  }
  out.number("Quilt_Aspect", views.aspect);
  out.number("View_Cone", views.cone);
  if (views.clocks) {
    out.add("View_Clock", text_of(views.clocks->first) + ".." + text_of(views.clocks->second));
  }
}

/// The data of a lens sheet that was named stand for its name.
void add_lens(const RenderOptions& o, Lines& out) {
  out.add("Lenticular", o.lenticular);
  out.number("Lens_Pitch", o.lens.pitch);
  out.number("Lens_LPI", o.lens.lpi);
  out.number("Print_LPI", o.lens.print_lpi);
  out.number("Lens_Thickness", o.lens.thickness);
  out.number("Lens_Radius", o.lens.radius);
  out.number("Lens_IOR", o.lens.ior);
  out.number("Lens_Angle", o.lens.angle);
  out.number("Lens_Focal_Length", o.lens.focal_length);
  out.number("Lens_Pixels", o.lens.pixels);
  if (o.lens.slant) out.add("Lens_Slant", text_of(*o.lens.slant) + "/1");
  if (o.print_dpi_down) {
    out.add("Print_DPI", text_of(*o.lens.print_dpi) + "x" + text_of(*o.print_dpi_down));
  } else {
    out.number("Print_DPI", o.lens.print_dpi);
  }
  out.number("Sheet_Width", o.sheet_width);
  out.number("Sheet_Height", o.sheet_height);
  out.number("Lens_Front", o.lens.front);
  out.number("View_Distance", o.lens.view_distance);
  if (o.lens.model) out.add("Lens_Model", std::string_view(camera::name_of(*o.lens.model)));
  if (o.lens.automatic_model) out.add("Lens_Model", std::string_view("auto"));
  out.number("Lens_Tolerance", o.lens.tolerance);
  out.number("Lens_Rays", o.lens.rays);
  out.number("Sheet_Distance", o.sheet_distance);
  if (o.lens.depth_budget) {
    const camera::DepthBudget& budget = *o.lens.depth_budget;
    out.add("Depth_Budget", text_of(budget.value) + (budget.is_mm ? "mm" : ""));
  }
  out.number("View", o.view);
  add_views(o.views, out);
}

void add_names(const RenderOptions& o, Lines& out) {
  for (const auto& [name, value] : o.declares) {
    out.add("Declare", name + "=" + (is_number(value) ? value : '"' + value + '"'));
  }
  out.name("Include_Header", o.include_header);
  if (o.language_version != 0) out.number("Version", o.language_version / 100.0);
}

/// What light and surfaces are, wherever they are seen from.
void add_light(const RenderOptions& o, Lines& out) {
  out.number("Quality", o.quality);
  const SceneOverrides& instead = o.overrides;
  out.number("Max_Trace_Level", instead.max_trace_level);
  out.number("Adc_Bailout", instead.adc_bailout);
  out.number("Area_Light_Samples", instead.area_light_samples);
  if (instead.area_light_adaptive == -1) {
    out.add("Area_Light_Adaptive", std::string_view("off"));
  } else {
    out.number("Area_Light_Adaptive", instead.area_light_adaptive);
  }
  out.number("Radiosity_Count", instead.radiosity.count);
  out.number("Radiosity_Error_Bound", instead.radiosity.error_bound);
  out.number("Radiosity_Nearest_Count", instead.radiosity.nearest_count);
  out.number("Radiosity_Recursion_Limit", instead.radiosity.recursion_limit);
  out.number("Photon_Count", instead.photons.count);
  out.number("Photon_Gather", instead.photons.gather);
  out.number("Subsurface_Samples", instead.subsurface_samples);
  out.number("Media_Method", o.overrides.media.method);
  out.number("Media_Intervals", o.overrides.media.intervals);
  out.number("Media_Samples", o.overrides.media.samples);
  out.number("Media_Confidence", o.overrides.media.confidence);
  out.add("Output_Alpha", o.alpha);
}

void add_picture(const RenderOptions& o, Lines& out) {
  add_names(o, out);
  // What follows from a lens sheet's size does so again.
  if (!o.sheet_width || o.width_given) out.number("Width", static_cast<double>(o.width));
  if (!o.sheet_height || o.height_given) out.number("Height", static_cast<double>(o.height));
  out.number("Start_Column", o.start_column);
  out.number("End_Column", o.end_column);
  out.number("Start_Row", o.start_row);
  out.number("End_Row", o.end_row);
  add_light(o, out);
  out.number("Blur_Samples", o.overrides.blur_samples);
  out.add("Antialias", o.antialias);
  out.number("Sampling_Method", o.sampling_method);
  out.number("Antialias_Threshold", o.antialias_threshold);
  out.number("Antialias_Depth", o.antialias_depth);
  out.number("Antialias_Gamma", o.antialias_gamma);
  out.add("Jitter", o.jitter);
  out.number("Jitter_Amount", o.jitter_amount);
  out.number("Antialias_Angle", o.antialias_angles);
  out.number("Antialias_Grid", o.antialias_grid);
  add_lens(o, out);
}

void add_animation(const RenderOptions& o, Lines& out) {
  const AnimationOptions& a = o.animation;
  if (o.clock_given) out.number("Clock", o.clock);
  out.number("Initial_Frame", a.initial_frame);
  out.number("Final_Frame", a.final_frame);
  out.number("Initial_Clock", a.initial_clock);
  out.number("Final_Clock", a.final_clock);
  out.number("Subset_Start_Frame", a.subset_start);
  out.number("Subset_End_Frame", a.subset_end);
  out.number("Frame_Step", a.step);
  out.add("Cyclic_Animation", a.cyclic);
}

void add_format(const RenderOptions& o, Lines& out) {
  out.add("Output_File_Type", word_of(o.type));
  out.number("Bits_Per_Color", o.bits);
  out.add("Grayscale_Output", o.grayscale);
  if (o.compression > 0) out.number("Compression", o.compression);
  out.add("Dither", o.dither);
  out.add("Dither_Method", word_of(o.dither_type));
  out.add("Display_Gamma", o.display_srgb ? "sRGB" : text_of(o.display_gamma));
  out.add("File_Gamma", o.srgb ? "sRGB" : text_of(o.file_gamma));
}

void add_file(const RenderOptions& o, Lines& out) {
  out.add("Output_To_File", o.output_to_file);
  out.name("Output_File_Name", o.output);
  add_format(o, out);
  out.add("Continue_Trace", o.continues);
}

void add_texts(const RenderOptions& o, Lines& out) {
  out.add("Verbose", o.verbose);
  out.number("Warning_Level", o.warning_level);
  if (o.stock_messages) out.add("Stock_Messages", *o.stock_messages);
  out.add("Debug_Console", o.debug_console);
  out.add("Fatal_Console", o.fatal_console);
  out.add("Render_Console", o.render_console);
  out.add("Statistic_Console", o.statistic_console);
  out.add("Warning_Console", o.warning_console);
  if (o.all_console) out.add("All_Console", *o.all_console);
  out.name("Debug_File", o.debug_file);
  out.name("Fatal_File", o.fatal_file);
  out.name("Render_File", o.render_file);
  out.name("Statistic_File", o.statistic_file);
  out.name("Warning_File", o.warning_file);
  out.name("All_File", o.all_file);
  out.add("Append_File", o.append_files);
}

void add_commands(const RenderOptions& o, Lines& out) {
  constexpr std::string_view kNames[kCommands] = {"Pre_Scene",  "Pre_Frame",  "Post_Frame",
                                                  "Post_Scene", "User_Abort", "Fatal_Error"};
  for (std::size_t i = 0; i < kCommands; ++i) {
    const ShellCommand& command = o.commands[i];
    if (command.text.empty()) continue;
    out.add(std::string(kNames[i]) + "_Command", command.text);
    out.add(std::string(kNames[i]) + "_Return",
            std::string(command.on_success ? "-" : "") + command.action);
  }
}

/// How the work is done, which no picture shows.
void add_work(const RenderOptions& o, Lines& out) {
  if (o.threads > 0) out.number("Work_Threads", o.threads);
  out.add("Pixel_Order", o.pixel_order);
  out.add("Shadow_Cache", o.shadow_cache);
  out.add("Accelerator", o.accelerator);
  out.add("Specialised_Paths", o.specialised_paths);
  out.add("Light_Buffer", o.light_buffer);
  out.name("Radiosity_File_Name", o.radiosity_file);
  out.add("Radiosity_From_File", o.radiosity_from_file);
  out.add("Radiosity_To_File", o.radiosity_to_file);
  if (o.radiosity_samples > 0)
    out.number("Radiosity_Samples", static_cast<double>(o.radiosity_samples));
  if (o.max_time > 0.0) out.number("Max_Time", o.max_time);
  if (o.max_memory > 0.0) out.number("Max_Memory", o.max_memory);
  if (o.band_height > 0) out.number("Band_Height", o.band_height);
  out.name("Statistics_File", o.statistics_file);
  out.add("Shadow_Log", o.shadow_log);
  out.add("Count_Tests", o.count_tests);
  out.name("View_Cameras", o.view_cameras);
  out.name("Dependencies_File", o.dependencies_file);
  out.add("Scene_Writes", std::string_view(o.writes_to_disk ? "disk" : "memory"));
  out.add("Restrict_IO", o.restrict_io);
  out.add("Strict", o.strict);
}

}  // namespace

std::string ini_text(const RenderOptions& o) {
  Lines out;
  out.name("Input_File_Name", o.input);
  for (const std::string& folder : o.library_paths) out.name("Library_Path", folder);
  add_picture(o, out);
  add_animation(o, out);
  add_file(o, out);
  add_work(o, out);
  add_texts(o, out);
  add_commands(o, out);
  return out.take();
}

std::string light_lines(const RenderOptions& o) {
  Lines out;
  add_names(o, out);
  add_light(o, out);
  return out.take();
}

std::string picture_lines(const RenderOptions& o) {
  Lines out;
  add_picture(o, out);
  return out.take();
}

std::string file_lines(const RenderOptions& o) {
  Lines out;
  add_format(o, out);
  return out.take();
}

std::string ini_path(const RenderOptions& o) {
  if (!o.create_ini) return "";
  if (!o.ini_file.empty()) return o.ini_file;
  const std::filesystem::path scene = o.input.empty() || o.input == "-" ? "stdin" : o.input;
  return scene.stem().string() + ".ini";
}

}  // namespace lentray::parser
