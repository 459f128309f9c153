// What a run was asked to do: POV-Ray's command line, its INI files, and lentray's own names.
// Switches (`+W640`), `Name=Value` and INI files are read left to right, later ones override
// earlier ones, library paths add up. Letter case of names does not matter.
// Source: reference manual 3.7, "Command-Line and INI-File Options"; measured on stock.
// Errors: OptionError, worded for the user: unknown names (with the nearest one), values that
// cannot be, and what is known but not implemented yet. One thread.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "camera/lens_request.h"
#include "core/image/writer.h"
#include "parser/options/animation.h"
#include "parser/options/ini.h"
#include "parser/options/scene_overrides.h"
#include "parser/options/view_options.h"

namespace lentray::parser {

/// When a program of the user's is run.
enum class CommandKind { kPreScene, kPreFrame, kPostFrame, kPostScene, kUserAbort, kFatalError };
inline constexpr std::size_t kCommands = 6;

/// A command of an INI file, and what its exit status leads to.
struct ShellCommand {
  std::string text;         ///< as written; empty: none
  char action = 'I';        ///< I, S, A, Q, U or F
  bool on_success = false;  ///< the action is for status 0 instead of all others
};

struct RenderOptions {
  // Scene.
  std::string input;                       ///< "-": standard input; empty: none was named
  std::vector<std::string> library_paths;  ///< as given, in order, no doubles
  std::vector<std::pair<std::string, std::string>> declares;
  double clock = 0.0;
  bool clock_given = false;
  AnimationOptions animation;
  std::string frame_digits;  ///< of the frame that is rendered: before the extensions of its files
  std::string include_header;  ///< a file that is included before the scene; empty: none
  int language_version = 0;    ///< x 100; 0: the scene decides

  // Picture.
  std::int64_t width = 160, height = 120;
  bool width_given = false, height_given = false;  ///< not only by a default INI file
  int quality = 9;
  SceneOverrides overrides;
  int threads = 0;     ///< 0: all of the machine
  std::string output;  ///< as given; see output_path()
  bool output_to_file = true;
  core::FileType type = core::FileType::png;
  bool type_given = false;  ///< not only by a default INI file
  int bits = 8;             ///< a channel, 5 to 16, of PNG and PPM; 32: OpenEXR as float, not half
  bool grayscale = false;   ///< Grayscale_Output
  int compression = 0;      ///< JPEG's quality, 2 to 100; 0 and 1: the usual one
  bool dither = false;
  core::DitherMethod dither_type = core::DitherMethod::floyd_steinberg;
  bool srgb = true;         ///< File_Gamma=sRGB
  double file_gamma = 2.2;  ///< unless srgb
  bool display_srgb =
      true;  ///< Display_Gamma=sRGB: what files of scenes without gamma are taken for
  double display_gamma = 2.2;  ///< unless display_srgb
  bool alpha = false;
  bool continues = false;  ///< +C: a picture that was cut off is continued
  /// Columns and rows that are rendered, both ends included, from 1; what is below 1 is a part of the
  /// width or height.
  std::optional<double> start_column, end_column, start_row, end_row;

  // Antialiasing.
  bool antialias = false;
  int sampling_method = 1;  ///< 1: adaptive, 2: recursive, 3: the eye's, of lens sheets; 0: none
  double antialias_threshold = 0.3;  ///< 0..1
  int antialias_depth = 3;           ///< 1..9
  double antialias_gamma = 2.5;      ///< 0: colours are compared as they are
  bool jitter = true;
  double jitter_amount = 1.0;  ///< 0..1
  int antialias_angles = 1;    ///< directions averaged within a pixel of a lens sheet
  int antialias_grid = 0;      ///< n x n samples in every pixel, instead of antialiasing; 0: no

  // Radiosity.
  /// Where samples or whole passes are kept (tools/session/radiosity_store.h); a folder where it ends in '/'.
  std::string radiosity_file = "object.rca";
  bool radiosity_from_file = false, radiosity_to_file = false;
  std::uint64_t radiosity_samples = 0;  ///< at most; 0: as the memory allows

  // Safety.
  bool strict = false;                       ///< what a picture would lack is an error
  bool restrict_io = false;                  ///< rules for what a scene reads and writes
  std::vector<std::string> permitted_paths;  ///< folders that a restricted scene may read besides
  std::vector<std::string> users_libraries;  ///< library paths but for those of a scene's INI file
  std::array<ShellCommand, kCommands> commands;  ///< by CommandKind

  // Messages.
  bool verbose = true;                 ///< progress
  int warning_level = 10;              ///< 0: no warnings
  std::optional<bool> stock_messages;  ///< in POV-Ray's form; none: by the program's name
  bool debug_console = true, warning_console = true, statistic_console = true,
       render_console = true, fatal_console = true;
  std::optional<bool> all_console;  ///< if given, it holds for those five
  std::string debug_file, warning_file, statistic_file, render_file, fatal_file,
      all_file;               ///< that the texts go to as well; empty: none
  bool append_files = false;  ///< what they hold is kept
  bool create_ini = false;    ///< write all options to ini_path()
  std::string ini_file;       ///< empty: the scene's name

  // Lens sheet.
  bool lenticular = false;  ///< make a sheet of the scene's camera
  camera::LensRequest lens;
  std::optional<double> sheet_distance;  ///< scene units
  std::string sheet_at;    ///< an object that the sheet stands at: its name or place; empty: none
  std::string lens_sheet;  ///< the profile that lens data are from; empty: none
  std::optional<double> sheet_width, sheet_height;  ///< mm, of the lens sheet
  std::optional<double> print_dpi_down;  ///< rows an inch, where they are not as the columns
  std::optional<std::uint32_t> view;     ///< that view alone
  ViewOptions views;

  // Ours besides.
  std::string pixel_order = "auto", shadow_cache = "auto", accelerator = "bvh";
  bool specialised_paths = true;  ///< what the scene does not use is left out; rays go together
  bool light_buffer = true;       ///< +UL: shadow rays to point lights look where the light sees
  double max_time = 0.0;          ///< seconds for the whole run; 0: no limit
  double max_memory = 0.0;        ///< bytes; 0: half of the machine's
  double max_pixels = 0.0;        ///< of all pictures of the run; 0: no limit
  double max_written = 0.0;       ///< bytes that the run writes to files; 0: no limit
  std::uint64_t max_files = 0;    ///< that a scene opens; 0: no limit
  std::uint32_t band_height = 0;  ///< rows; 0: as the memory allows
  std::string statistics_file, dump_rays;
  std::string depth_view;    ///< file that --depth-view draws; empty: none
  bool count_tests = true;   ///< tests of bounds and shapes go into the statistics
  std::string view_cameras;  ///< file of the cameras of views; empty: none
  std::string
      dependencies_file;  ///< which files the scene reads, writes and looks for; empty: nowhere
  bool writes_to_disk = true;  ///< what the scene writes; else it stays in memory
  bool shadow_log = false;     ///< runs, blockers and costs of shadow rays go into the statistics
  bool parse_only = false, dump = false, explain = false, depth = false, help = false,
       help_all = false, version = false, list_lens_sheets = false;

  std::string scene_ini_folder;       ///< of --scene-ini
  std::vector<std::string> warnings;  ///< about the options themselves
  /// By their names, for messages: the last time that each was said.
  struct Said {
    std::string text;   ///< "Lens_Radius=0.1"
    std::string where;  ///< "sheet.ini:3"; empty: on the command line
  };
  std::map<std::string, Said, std::less<>> said;
};

/// Where lens_sheets.ini is looked for besides the current folder and the library paths:
/// ~/.config/lentray, and where POV-Ray's own INI files are.
std::vector<std::string> installed_lens_sheet_files();

struct OptionSources {
  /// INI files read before the command line (the first that exists); usually default_ini_files().
  std::vector<std::string> default_ini_files;
  /// Folders that end the list of library paths where they exist: POV-Ray's own include files.
  std::vector<std::string> standard_libraries;
  /// Lens sheets of users (parser/options/lens_sheets.h).
  std::vector<std::string> lens_sheet_files = installed_lens_sheet_files();
  /// With Restrict_IO=On: INI files that came with a scene may lie in the folder of the one that is
  /// named, not only in those of Permitted_Path.
  bool trusts_scene_folder = true;
};

/// The default INI file that whoever sends a scene could send along.
inline constexpr const char* kFolderIni = "povray.ini";

/// POVINI, ./povray.ini, ~/.povray/3.7/povray.ini, /etc/povray/3.7/povray.ini; and where packages
/// put POV-Ray's include files.
OptionSources installed_sources();

/// Whether a word of a command line names a scene, or another file: it is no switch, no INI file and no `Name=Value`.
/// "a=b.pov" is a scene, as any file that is there, where no option is called a.
bool is_scene_word(const std::string& word);

/// argv without the program's name. A lens sheet's size has become columns and rows.
RenderOptions read_options(std::span<const std::string> arguments, const OptionSources& sources);

/// View=, or that of the picture being made where Views= asks for one picture a view: there
/// frame_digits are the view's number.
std::optional<std::uint32_t> rendered_view(const RenderOptions& options);

/// "a.json" of frame 07 is "a07.json".
std::string frame_path(const RenderOptions& options, const std::string& path);

/// Where the picture goes: stock's rules (no name: the scene's, beside the scene, but with
/// Restrict_IO in the current folder; a folder, ending
/// with / : the scene's name there; the type's extension is added unless it is there, letter case
/// distinguished), except that .tif, .tiff and .exr choose the type when no option did.
/// "-": standard output. Sets `type` to what the file will be.
std::string output_path(const RenderOptions& options, core::FileType& type);

/// Throws OptionError if the pictures of the run have more pixels than Max_Pixels.
void check_pixels(const RenderOptions& options);

/// Throws OptionError if a picture has more pixels than can be thought of (2^40), or one row, which
/// takes `bytes_a_row`, does not fit into `memory` bytes.
void check_picture_size(std::int64_t width, std::int64_t height, double bytes_a_row, double memory);

}  // namespace lentray::parser
