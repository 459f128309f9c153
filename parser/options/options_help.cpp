#include "parser/options/options_help.h"

#include <algorithm>

#include "parser/options/ini.h"
#include "parser/options/options_table.h"

namespace lentray::parser {
namespace {

constexpr std::string_view kSwitch = "on|off";
constexpr std::size_t kColumns = 79;

constexpr OptionHelp kScene[] = {
    {"Input_File_Name", "file",
     "The scene; - is standard input. A bare name that ends in .pov means the same."},
    {"Library_Path", "folder",
     "Where include files, fonts, pictures and INI files are looked for besides. May be given "
     "several times."},
    {"Include_Ini", "file", "An INI file, perhaps with [part], that is read at this place."},
    {"Declare", "NAME=VALUE",
     "An identifier that the scene finds declared: a number, or a string in double quotes."},
    {"Version", "n", "The language's version until the scene's own #version, such as 3.7."},
    {"Include_Header", "file", "A file that is included before the scene."},
};
constexpr OptionHelp kAnimation[] = {
    {"Clock", "n", "The scene's clock (0)."},
    {"Initial_Frame", "n", "Number of the first frame (1)."},
    {"Final_Frame", "n", "Number of the last frame (1); more than one frame is an animation."},
    {"Initial_Clock", "n", "The clock in the first frame (0)."},
    {"Final_Clock", "n", "The clock in the last frame (1)."},
    {"Subset_Start_Frame", "n",
     "Render from this frame, or view of Views=, on; a number below 1 is a part of them."},
    {"Subset_End_Frame", "n", "Render up to this frame, or part."},
    {"Frame_Step", "n", "Render every n-th frame."},
    {"Cyclic_Animation", kSwitch, "The last frame does not repeat the first."},
    {"Clockless_Animation", kSwitch, "Not yet but off."},
    {"Real_Time_Raytracing", kSwitch, "Not yet but off."},
    {"Field_Render", kSwitch, "Read and ignored."},
    {"Odd_Field", kSwitch, "Read and ignored."},
};
constexpr OptionHelp kPictures[] = {
    {"Width", "n", "Columns of pixels (160)."},
    {"Height", "n", "Rows of pixels (120)."},
    {"Start_Column", "n",
     "Render from this column on, counted from 1; a number below 1 is a part of the width."},
    {"End_Column", "n", "Render up to this column, or part."},
    {"Start_Row", "n", "Render from this row on, or part of the height."},
    {"End_Row", "n", "Render up to this row, or part."},
    {"Quality", "n",
     "0 to 11 (9). Below 9 the picture gets simpler: without reflection, shadows, textures."},
    {"Max_Trace_Level", "n",
     "How deep reflected and transmitted rays are followed, 1 to 256, whatever the scene says."},
    {"Adc_Bailout", "n", "Share of a pixel below which they are not followed, likewise."},
    {"Area_Light_Samples", "n",
     "Lights along each axis of an area light that has more than one, 2 to 1000, likewise."},
    {"Area_Light_Adaptive", "n|off",
     "Halvings of area lights before samples are left out; off: none is left out. Likewise."},
    {"Blur_Samples", "n",
     "Rays of a sample of focal blur, 1 to 65536: the least and the most, likewise."},
    {"Radiosity_Count", "n",
     "Rays of a sample of radiosity, 1 to 1600, in scenes that have it, whatever they say."},
    {"Radiosity_Error_Bound", "n", "How far off samples of radiosity may be, likewise."},
    {"Radiosity_Nearest_Count", "n", "Samples that a place is to have nearby, 1 to 20, likewise."},
    {"Radiosity_Recursion_Limit", "n", "Bounces of indirect light, 1 to 20, likewise."},
    {"Photon_Count", "n",
     "Photons that are to reach targets, about, in scenes that shoot some, whatever they say."},
    {"Photon_Gather", "n", "Photons that light is gathered from at a point, at most, likewise."},
    {"Subsurface_Samples", "n",
     "Samples of subsurface light, of light scattered once and of light scattered many times, "
     "likewise."},
    {"Media_Method", "1|2|3", "How media are sampled, whatever the scene says."},
    {"Media_Intervals", "n", "Pieces of a ray's way through media, likewise."},
    {"Media_Samples", "n", "Samples in each piece, likewise: the least and the most."},
    {"Media_Confidence", "n",
     "0 to less than 1, likewise: how sure methods 1 and 2 have to be that samples are enough."},
    {"Radiosity_File_Name", "file|folder/",
     "Where radiosity is kept: samples as POV-Ray's where the name ends in .rca, else the whole "
     "pass; "
     "in a folder, each pass under a name of its own (object.rca)."},
    {"Radiosity_From_File", kSwitch, "What is kept there is used."},
    {"Radiosity_To_File", kSwitch,
     "Radiosity is kept there; with Radiosity_From_File, what is not there yet."},
    {"Radiosity_Samples", "n",
     "Samples that radiosity may make before the run ends with a message (as the memory allows)."},
    {"Output_File_Name", "file",
     "The picture, or a folder for it; - is standard output. Without it the picture has the "
     "scene's name and lies beside it."},
    {"Output_to_File", kSwitch,
     "Whether there is a file at all. The switch takes the type as well, and the bits of a channel "
     "behind it, as +FN16.",
     "+F[type], -F"},
    {"Output_File_Type", "N|P|T|C|J|B|E|H|TIFF",
     "N is PNG, P PPM, T and C Targa (C compressed), J JPEG, B BMP, E OpenEXR, H Radiance. Bits "
     "may stand behind it, and behind N and P a g for grey. Without it a name that ends in .tif, "
     ".tiff or .exr decides, else it is PNG."},
    {"Output_Alpha", kSwitch, "Pixels that nothing covers are clear."},
    {"Bits_Per_Color", "n",
     "Bits of a channel in the file, 5 to 16 (8), of PNG and PPM; 32 makes OpenEXR of floats "
     "instead of halves."},
    {"Grayscale_Output", kSwitch, "The file is grey, of 16 bits; PNG and PPM only."},
    {"Bits_Per_Colour", "n", "The same."},
    {"File_Gamma", "n|sRGB", "How the file's values are encoded (sRGB); 1 is linear."},
    {"Compression", "n", "JPEG's quality, 2 to 100 (85)."},
    {"Display_Gamma", "n|sRGB",
     "What the values of scenes before 3.7 without assumed_gamma are taken for (sRGB)."},
    {"Dither", kSwitch, "Rounding errors are spread over pixels, which hides steps of colour.",
     "+TH[method], -TH"},
    {"Dither_Method", "B2|B3|B4|D1|D2|FS",
     "Bayer's matrices, diffusion along the line or the plane, Floyd and Steinberg's (FS)."},
    {"Continue_Trace", kSwitch,
     "Continue what a stopped or killed run did not finish, and keep what is there already."},
    {"Create_Ini", "file",
     "Where to write all options, as an INI file that asks for the same again; on for the scene's "
     "name with .ini."},
};
constexpr OptionHelp kAntialiasing[] = {
    {"Antialias", kSwitch, "Antialiasing; the switch may bring the threshold.", "+A[t], -A"},
    {"Antialias_Threshold", "t", "Colours that differ by more than t, 0 to 1, are refined (0.3)."},
    {"Sampling_Method", "1|2|3",
     "1 refines whole pixels, 2 their quarters (1); 3, for prints of lens sheets, spreads the "
     "samples of pixels that an eye blends: less work for what is seen. To compare with "
     "POV-Ray take 1 or 2, to print 3. Other pictures take 3 as 2, as POV-Ray does."},
    {"Antialias_Depth", "n",
     "1 to 9 (3): rays a pixel with method 1 are n x n, with method 3 n more."},
    {"Antialias_Gamma", "n", "The gamma that colours are compared with (2.5)."},
    {"Jitter", kSwitch, "Rays are shaken (on); the switch may bring the amount.", "+J[n], -J"},
    {"Jitter_Amount", "n", "0 to 1 (1)."},
    {"Antialias_Angle", "n", "Directions averaged within every pixel of a lens sheet (1)."},
    {"Antialias_Grid", "n",
     "Every pixel is the mean of n x n samples without jitter, up to 64 x 64, whatever the other "
     "options for antialiasing say (0: off); with Sampling_Method=3 they are spread, and their "
     "mean "
     "is in linear light. For references."},
};
constexpr OptionHelp kSheet[] = {
    {"Lenticular", kSwitch, "Make an integral image: a lens sheet of the scene's camera."},
    {"Lens_Sheet", "name|n|list",
     "A lens sheet by its name, which stands for the lens data below; they override it. 60 is "
     "60lpi. "
     "list shows all there are."},
    {"Lens_Pitch", "mm",
     "Width of a lens (1.124). All lengths in mm may have a unit behind them: mm, cm, m, um, in or "
     "inch."},
    {"Lens_LPI", "n", "The same as lenses an inch."},
    {"Print_LPI", "n",
     "Instead of a pitch: the strips an inch that a pitch test found, from the distance of "
     "View_Distance."},
    {"Lens_Thickness", "mm", "From the lenses to the print: the sheet's thickness."},
    {"Lens_Radius", "mm", "Of the round surface; says where the lenses focus."},
    {"Lens_IOR", "n", "Refractive index of the material (1.6)."},
    {"Lens_Angle", "degrees", "The full viewing angle; without a thickness it gives that."},
    {"Lens_Focal_Length", "mm",
     "From the lens to the print, in the lens's material; with a thickness, to where it focuses "
     "(3.03; at another pitch, of the same shape)."},
    {"Lens_Pixels", "n", "Pixels a lens (15)."},
    {"Lens_Slant", "degrees|n/n",
     "Slant of the lenses, as an angle or as its tangent (1/6); above 0 their tops lean to the "
     "right "
     "(0)."},
    {"Lens_Direction", "up|across",
     "How the lenses lie in the upright picture: upright, or across it, as for flips that are held "
     "in the hand; the views are then seen from below to above (up)."},
    {"Print_DPI", "n[xn]",
     "The same as the print's resolution in pixels an inch; with x across the lenses and along "
     "them."},
    {"Sheet_Width", "mm",
     "Of the lens sheet. With the height and a resolution it gives the picture its columns and "
     "rows."},
    {"Sheet_Height", "mm", "Of the lens sheet."},
    {"Sheet_Size", "name|WxH",
     "Both at once: 100x75mm, or a paper's: A0 to A6, A3+, letter, legal, tabloid, postcard, "
     "upright, "
     "with -landscape behind it on its side."},
    {"View_Distance", "mm|inf",
     "From the sheet to the eye; without it the distance of the camera's own eye."},
    {"Sheet_Distance", "n",
     "From the camera to the sheet, in scene units; without it the sheet stands where the camera "
     "looks."},
    {"Sheet_At", "object",
     "The sheet stands where this object is seen: its name, or its place FILE:LINE:COLUMN, as "
     "--depth lists them."},
    {"Depth", "print|scene|viewer",
     "Whose eye sees the scene. print: the scene's camera, the sheet where it shows most, and "
     "depth compressed until nothing jumps; scene: the scene's camera, with its true depth; "
     "viewer: an eye at View_Distance. print where data of a print are given, else viewer."},
    {"Depth_Budget", "n|mm",
     "The most that visible points may move from one view to the next: in pixels of a view, or "
     "with a "
     "unit on the print. The eyes of the views are brought closer together until they do."},
    {"Lens_Front", "n", "How far before the sheet rays begin, in scene units."},
    {"Lens_Model", "paraxial|pinhole|thick|auto",
     "Directions linear in the offset, by Snell's law, or of several rays through a round lens. "
     "auto is "
     "paraxial where that is near enough to Snell's law, else pinhole."},
    {"Lens_Tolerance", "n", "How near, in pixels of the print (0.25)."},
    {"Lens_Rays", "n", "Rays a pixel of the model thick (16)."},
    {"View", "j", "That view alone, counted from 0: a quick look, one pixel a lens."},
    {"Views", "M",
     "Pictures of M views at equal steps over a lens's width, each as large as +W +H say and with "
     "the "
     "view's number in its name; with View=j that one alone."},
    {"View_Size", "WxH", "Their size, while +W +H stay those of the integral image."},
    {"View_Clock", "a..b", "The clock of the first and the last of these views (that of +K)."},
    {"Quilt", "CxR|display",
     "One picture of C x R views for a light-field display, the leftmost camera's lower left; the "
     "display's name brings its size and aspect too: portrait, go, 16-portrait, 27-landscape, "
     "27-portrait, 32-landscape, 32-portrait."},
    {"Quilt_Tile", "WxH", "Size of each of its views (of +W +H, which is the whole quilt's)."},
    {"Quilt_Aspect", "n", "Width by height of the display (as the scene's camera)."},
    {"View_Cone", "degrees", "Angle between a quilt's outermost cameras (35)."},
    {"View_Cameras", "file",
     "The cameras of the quilt's tiles or of the sheet's views, as JSON for other programs; with "
     "--explain without rendering."},
};
constexpr OptionHelp kWork[] = {
    {"Work_Threads", "n", "Threads (all of the machine)."},
    {"Max_Time", "n[s|m|h]",
     "How long the run may take; it ends with status 2, and +C goes on (no limit)."},
    {"Max_Memory", "n[M|G]", "How much memory to use (half of the machine's)."},
    {"Max_Pixels", "n[M|G]", "How many pixels all pictures of the run may have (no limit)."},
    {"Max_Written", "n[M|G]", "How much the run may write to files (no limit)."},
    {"Max_Files", "n", "How many files a scene may open (no limit)."},
    {"Band_Height", "n", "Rows that are traced at a time (what fits)."},
    {"Pixel_Order", "auto|rows|views|columns|combined|strips|tiles|serpentine|hilbert|adaptive",
     "In which order pixels are traced; combined(w) and strips(w,h) take the size of a strip."},
    {"Shadow_Cache", "auto|off|last|depth|tree|neighbourhood|grid|cascade",
     "Which occluders shadow rays try first."},
    {"Accelerator", "bvh|grid|list", "How objects are searched."},
    {"Specialised_Paths", kSwitch,
     "What the scene does not use is left out; neighbouring rays go together (on)."},
    {"Light_Buffer", kSwitch,
     "Shadow rays to point lights are looked up where the light sees (on)."},
    {"Statistics_File", "file", "Counts, times and the lens, as JSON."},
    {"Shadow_Log", kSwitch, "More of shadows in that file."},
    {"Count_Tests", kSwitch,
     "Tests of bounds and shapes in that file, which takes a little time (on)."},
    {"Dependencies_File", "file",
     "Files that the scene reads, writes and looks for in vain, as JSON."},
};
constexpr OptionHelp kMessages[] = {
    {"Verbose", kSwitch, "Progress (on)."},
    {"Warning_Level", "n", "0 to 10; 0: no warnings."},
    {"Stock_Messages", kSwitch,
     "Progress, errors and warnings have POV-Ray's form, for programs that read them (off; on "
     "where "
     "lentray is called as povray)."},
    {"All_Console", kSwitch,
     "All five texts below go to the terminal. A switch of these may bring the name of a file that "
     "the text goes to as well, as +GAlog.txt.",
     "+GA[file], -GA[file]"},
    {"Debug_Console", kSwitch, "What #debug says.", "+GD[file], -GD[file]"},
    {"Fatal_Console", kSwitch, "What ends the run.", "+GF[file], -GF[file]"},
    {"Render_Console", kSwitch, "What is rendered.", "+GR[file], -GR[file]"},
    {"Statistic_Console", kSwitch, "Counts and times.", "+GS[file], -GS[file]"},
    {"Warning_Console", kSwitch, "Warnings.", "+GW[file], -GW[file]"},
    {"All_File", "file", "Where all texts go as well."},
    {"Debug_File", "file", "Where that text goes as well; so for the next four."},
    {"Fatal_File", "file"},
    {"Render_File", "file"},
    {"Statistic_File", "file"},
    {"Warning_File", "file"},
    {"Append_File", kSwitch, "Texts are added to what is in these files."},
};
constexpr OptionHelp kCommandLines[] = {
    {"Pre_Scene_Command", "command",
     "In INI files only: runs before the first frame, where povray.conf allows commands. %s is the "
     "scene, %o the picture, %n the frame, %k the clock, %h and %w the size."},
    {"Pre_Frame_Command", "command", "Before every frame."},
    {"Post_Frame_Command", "command", "After every frame."},
    {"Post_Scene_Command", "command", "After the last frame."},
    {"User_Abort_Command", "command", "When the run was stopped."},
    {"Fatal_Error_Command", "command", "When it failed."},
    {"Pre_Scene_Return", "[!]I|S|A|Q|U|F",
     "What a status of that command other than 0 (with !: a status of 0) leads to: ignore it, skip "
     "this, all skip, quit, user abort, fatal error. So for the next five."},
    {"Pre_Frame_Return", "[!]I|S|A|Q|U|F"},
    {"Post_Frame_Return", "[!]I|S|A|Q|U|F"},
    {"Post_Scene_Return", "[!]I|S|A|Q|U|F"},
    {"User_Abort_Return", "[!]I|S|A|Q|U|F"},
    {"Fatal_Error_Return", "[!]I|S|A|Q|U|F"},
};
constexpr OptionHelp kSafety[] = {
    {"Scene_Writes", "disk|memory",
     "Where files that the scene writes are kept; in memory only the scene sees them (disk)."},
    {"Restrict_IO", kSwitch,
     "For strangers' scenes: files only where the rules of POV-Ray's manual permit (security.md)."},
    {"Permitted_Path", "folder",
     "With Restrict_IO=On a folder that scenes may read besides, instead of those of povray.conf. "
     "More than one may be given."},
    {"Strict", kSwitch,
     "A scene that asks for what is not rendered yet is an error before anything is rendered, "
     "instead of a warning."},
    {"--parse-only", "",
     "Reads the scene, says what is wrong with it, renders nothing and leaves nothing behind."},
    {"--dump", "", "Writes what the scene says as JSON; renders nothing."},
    {"--explain", "", "Says what the scene needs of the renderer; renders nothing."},
    {"--depth", "",
     "Says how deep the scene is behind a lens sheet and how much of it the sheet shows sharply; "
     "renders nothing."},
    {"--depth-view", "file", "The same, and draws it as SVG, seen from above."},
    {"--dump-rays", "file", "Writes every camera ray; renders nothing."},
    {"--scene-ini", "file",
     "An INI file that came with the scene: it says what the picture is like, and names no files, "
     "folders and commands but library paths and headers (security.md)."},
    {"--lens-sheets", "", "Lists the lens sheets that there are, as Lens_Sheet=list does."},
    {"--help", "", "The usual options. --help=all: this text."},
    {"--version", "", "The program's version."},
};
constexpr OptionHelp kIgnored[] = {
    {"Radiosity_Vain_Pretrace", kSwitch},
    {"High_Reproducibility", kSwitch, "Radiosity repeats anyway."},
    {"Display", kSwitch, "No picture is shown while it is rendered."},
    {"Video_Mode", "x"},
    {"Palette", "x"},
    {"Pause_When_Done", kSwitch},
    {"Preview_Start_Size", "n"},
    {"Preview_End_Size", "n"},
    {"Draw_Vistas", kSwitch},
    {"Test_Abort", kSwitch},
    {"Test_Abort_Count", "n"},
    {"Buffer_Output", kSwitch},
    {"Buffer_Size", "n"},
    {"Max_Image_Buffer_Memory", "n"},
    {"Render_Block_Size", "n"},
    {"Render_Pattern", "n"},
    {"Render_Block_Step", "n"},
    {"Bounding", kSwitch, "", "+MB[n], -MB"},
    {"Bounding_Threshold", "n"},
    {"Bounding_Method", "n"},
    {"BSP_MaxDepth", "n"},
    {"BSP_BaseAccessCost", "n"},
    {"BSP_ChildAccessCost", "n"},
    {"BSP_IsectCost", "n"},
    {"BSP_MissChance", "n"},
    {"Vista_Buffer", kSwitch},
    {"Remove_Bounds", kSwitch},
    {"Split_Unions", kSwitch},
};

constexpr OptionGroup kGroups[] = {
    {"Scene", kScene},
    {"Animation", kAnimation},
    {"Picture", kPictures},
    {"Antialiasing", kAntialiasing},
    {"Lens sheet", kSheet},
    {"How the work is done", kWork},
    {"Messages", kMessages},
    {"Commands to run", kCommandLines},
    {"Safety, and looks into a scene", kSafety},
    {"Read for POV-Ray's sake, without effect unless it is said", kIgnored},
};

/// Words in lines of kColumns, each behind `indent` blanks.
void add_lines(std::string& out, std::string_view text, std::size_t indent) {
  std::size_t at = 0, column = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    if (column > 0 && column + 1 + (end - at) > kColumns) {
      out += '\n';
      column = 0;
    }
    out.append(column == 0 ? indent : 1, ' ');
    out += text.substr(at, end - at);
    column += (column == 0 ? indent : 1) + (end - at);
    at = end + 1;
  }
  out += '\n';
}

}  // namespace

std::span<const OptionGroup> option_groups() { return kGroups; }

std::string option_forms(const OptionHelp& row) {
  const std::string value(row.value), name(row.name);
  if (name.starts_with("--")) return value.empty() ? name : name + " " + value;
  std::string forms = name + "=" + value;
  if (!row.switches.empty()) return forms + ", " + std::string(row.switches);
  for (const OptionRow& option : option_table()) {
    const std::string letters(option.switch_name);
    if (!same_word(option.name, row.name) || letters.empty()) continue;
    forms += row.value == kSwitch ? ", +" + letters + ", -" + letters : ", +" + letters + value;
  }
  return forms;
}

std::string help_text() {
  return R"(usage: lentray [options] scene.pov

Renders POV-Ray scenes, also as integral images for lenticular sheets. Options
are POV-Ray's, on the command line or in INI files (file.ini, file.ini[part]).

  +Ifile +Ofile           scene and picture; - is standard input and output
  +Wn +Hn                 columns and rows of pixels (160 x 120)
  +SCn +ECn +SRn +ERn     from a column and row to another only
  +A[t] -A                antialiasing, of colours that differ by t (0.3)
  +AMn +Rn +J[n] -J       its method (1, 2; 3 to print), depth (1 to 9), jitter
  +FN16 +FJ +FE -F +UA    PNG of 16 bits, JPEG, OpenEXR, no file; with alpha
  +Lfolder +Qn +WTn -V    include files' folder, quality, threads, no progress
  +KFIn +KFFn +Kn +C      frames and clock of an animation; go on after a stop
  Declare=NAME=VALUE      an identifier of the scene
  Restrict_IO=On          for strangers' scenes: files where the rules permit
  --parse-only            reads the scene and reports; renders nothing
  --help=all --version    all options; the manual page has them too

Lens sheet (lengths in mm, or with cm, in and others behind them):
  Lenticular=On           make a sheet of the camera; View=j Views=M Quilt=CxR
  Sheet_Width= Sheet_Height= | Sheet_Size=  Print_DPI= | Lens_Pixels= for +W +H
  Lens_Sheet=name|list    or Lens_Pitch= | Lens_LPI= Lens_Thickness= Lens_IOR=
  View_Distance=n|inf  Depth=print|scene|viewer  Sheet_At=object (see --depth)
)";
}

std::string full_help_text() {
  std::string out = R"(usage: lentray [options] scene.pov
       lentray [options] file.ini[part]

Renders POV-Ray scenes, also as integral images for lenticular sheets. Options
are POV-Ray's, with the same spelling and meaning: Name=Value or a switch, on
the command line or in INI files. Later ones override earlier ones; letter case
of names does not matter; a value in brackets is what holds without the option.
on|off takes true, yes and 1, false, no and 0 as well, and their beginnings.
Called as povray, it answers --version and --help as POV-Ray does, and what it
says has POV-Ray's form (Stock_Messages).
)";
  for (const OptionGroup& group : kGroups) {
    out += "\n" + std::string(group.title) + ":\n";
    for (const OptionHelp& row : group.rows) {
      add_lines(out, option_forms(row), 2);
      if (!row.text.empty()) add_lines(out, row.text, 6);
    }
  }
  return out + R"(
Files:
  povray.ini
      Options that hold before those of the command line, one a line; part
      titles stand in brackets. The first is taken of $POVINI, ./povray.ini,
      ~/.povray/3.7/povray.ini, /usr/local/etc/povray/3.7/povray.ini and
      /etc/povray/3.7/povray.ini.
  lens_sheets.ini
      Lens sheets for Lens_Sheet=: a section [name] for each, with Lens_LPI,
      Lens_Thickness and other lens data, one a line. It is looked for in the
      current folder, in library paths, in ~/.config/lentray, and where
      povray.ini is.
  povray.conf
      Whether INI files may run commands, and with Restrict_IO=On what scenes
      may read and write: /etc/povray/3.7/povray.conf,
      ~/.povray/3.7/povray.conf.
  /usr/share/povray-3.7/include
      POV-Ray's own include files (Debian's package povray-includes).

Environment:
  POVINI
      An INI file that is read instead of povray.ini.

Exit status:
  0
      The picture is written.
  1
      Something is wrong with the scene, the options or a file.
  2
      The run was stopped.
  3
      An error of the program itself.

Examples:
  lentray scene.pov +W640 +H480 +A0.1
      The scene in its own camera, antialiased, as scene.png.
  lentray scene.pov +W1200 +H900 Lenticular=On
      An integral image of it: 80 lenses of 15 pixels.
  lentray scene.pov +W1200 +H900 Lenticular=On View=7
      The middle one of its views.
)";
}

}  // namespace lentray::parser
