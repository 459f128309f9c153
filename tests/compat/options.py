"""POV-Ray's options, one command line after another, by stock POV-Ray and by lentray.

  tests/compat/options.py [--bin FOLDER] [--write-docs] [word ...]     lines that contain a word

Each line runs in both programs in a folder of its own. Compared are the exit status, the names of the files that
are there afterwards, and each picture as a viewer shows it: exact, or the grade that the table asks for. What is
known to differ stands in the table with its reason. The exit status is 1 if anything else differs.
--write-docs writes docs/options.md.
"""
import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENE = """#version 3.7; global_settings { assumed_gamma 1 }
#ifndef (Red) #declare Red = 0.9; #end
camera { location <0.13, 1.07, -5> look_at <0.03, 0.02, 0> right 4/3*x }
light_source { <-5, 8, -6> rgb 1 }
sphere { <clock, 0, 0>, 1 pigment { rgb <Red, 0.5, 0.2> } finish { phong 0.5 reflection 0.1 } }
plane { y, -1 pigment { checker rgb 1, rgb 0.3 } }
background { rgb <0.2, 0.4, 0.7> }
"""
FILES = {
    "scene.pov": SCENE,
    "other.pov": SCENE.replace("0.5, 0.2", "0.1, 0.8"),
    "header.inc": "#declare Red = 0.1;\n",
    "inc/lib.inc": "#declare Red = 0.3;\n",
    "uses.pov": SCENE.replace("#ifndef (Red)", '#include "lib.inc"\n#ifndef (Red)'),
    "old.pov": SCENE.replace("#version 3.7; global_settings { assumed_gamma 1 }", "#version 3.5;"),
    "a.ini": "; a comment\nWidth=40\nHeight=30\nInput_File_Name=scene.pov\n",
    "parts.ini": "Input_File_Name=scene.pov\nHeight=30\n[small]\nWidth=20\n[large]\nWidth=60\n",
    "nested.ini": "a.ini\nWidth=24\n",
    "hash.ini": "# a comment\nWidth=40 ; of the picture\nHeight=30\nInput_File_Name=\"scene.pov\"\n",
    "switches.ini": "+Iscene.pov +W40\n+H30\n-D\n",
    "line.ini": "+Iscene.pov +W40 +H30 Declare=Red=0.2\n",
    "pre.ini": "Input_File_Name=scene.pov\nWidth=40\nHeight=30\nPre_Scene_Command=touch %s-%h-%w.txt\n",
    "fails.ini": "+Iscene.pov +W40 +H30\nPre_Scene_Command=false\nPre_Scene_Return=F\n",
    "quits.ini": "+Iscene.pov +W40 +H30\nPre_Scene_Command=false\nPre_Scene_Return=Q\n",
    "skips.ini": "+Iscene.pov +W40 +H30\nPre_Scene_Command=false\nPre_Scene_Return=S\n",
    "succeeds.ini": "+Iscene.pov +W40 +H30\nPre_Scene_Command=true\nPre_Scene_Return=-F\n",
    "ends.ini": "+Iscene.pov +W40 +H30\nPost_Scene_Command=false\nPost_Scene_Return=F\n",
    "frame_ends.ini": "+Iscene.pov +W40 +H30\nPost_Frame_Command=false\nPost_Frame_Return=!F\n",
    "abort.ini": "+Iscene.pov +W40 +H30\nUser_Abort_Command=false\nUser_Abort_Return=F\n",
    "fatal.ini": "+Imissing.pov +W40 +H30\nFatal_Error_Command=false\nFatal_Error_Return=I\n",
    "frames.ini": "+Iscene.pov +W40 +H30 +KFF3\nPre_Frame_Command=touch a%n-%k.txt\n"
                  "Post_Frame_Command=touch b%n.txt\nPost_Scene_Command=touch %s.txt\n",
    "frame_skips.ini": "+Iscene.pov +W40 +H30 +KFF3\nPre_Frame_Command=test %n != 2\nPre_Frame_Return=S\n",
    "empty.ini": "; nothing\n",
    "crlf.ini": "Width=40\r\nHeight=30\r\nInput_File_Name=scene.pov\r\n",
}
ONE_BLOCK = "+BS4096"  # stock's antialiasing begins anew in each block
GRADES = ["fails", "close", "match", "exact"]

Line = collections.namedtuple("Line", "text grade bare")
GROUPS = {}


def group(title, lines, grade="exact", bare=False):
    """`bare`: nothing is added to the line; else scene and size."""
    for text in lines.strip().splitlines():
        GROUPS.setdefault(title, []).append(Line(text.strip(), grade, bare))


group("Scene", """
+Iother.pov
Input_File_Name=other.pov
+Iother
+Iuses.pov +Linc
+Iuses.pov Library_Path=inc
+Iuses.pov Library_Path="inc"
+Iuses.pov
Include_Ini=a.ini
Clockless_Animation=off
Real_Time_Raytracing=off
Radiosity_From_File=off
BSP_IsectCost=100
Bits_Per_Colour=8
Declare=Red=0.2
Declare=Red=0.2 Declare=Red=0.7
+HIheader.inc
+HIheader
+HIheader.inc +HIother.inc
+HImissing.inc
Include_Header=header.inc
Include_Header=missing.inc
+MV3.5
+MV3.7
Version=3.6
+Imissing.pov
""")
group("Clock and frames", """
+K0.5
-K0.5
Clock=0.5
Clock=-0.25
+KFF3
+KFI2 +KFF4
Initial_Frame=2 Final_Frame=4 Initial_Clock=0.5 Final_Clock=1.5
+KFF3 +KI0.5 +KF1
+KFF4 +KC
+KFF4 Cyclic_Animation=on
+KFF5 +SF2 +EF3
+KFF5 Subset_Start_Frame=0.5
+KFF5 Subset_End_Frame=0.5
+KFF6 +STP2
+KFF6 Frame_Step=3
+KFF12 +SF9 +EF10
+KFI0 +KFF2
+KFF2 +UF
+KFF2 Field_Render=on Odd_Field=on
+KFI1 +KFF1
+KFF2 +Oname
+KFF2 +Oname.png
""")
group("Size and part", """
+W64 +H48
-W64
Width=64.7
Width=64 Height=48.9
+W0
Width=
Width=abc
+SC10
+SC10 +EC20
+SR5 +ER20
+SC0.25 +EC0.75
+SR0.5
Start_Column=10 End_Column=30 Start_Row=5 End_Row=20
Start_Column=0.2 End_Column=0.8 Start_Row=0.1 End_Row=0.9
+SC1 +EC1
+ER10
""")
group("File", """
+Oname
+Oname.png
+Oname.tga
+Oname.jpg
+Oinc/
+Oinc
+Oinc/name
+Onodir/name
Output_File_Name=name
-F
Output_to_File=off
Output_to_File=y
Output_to_File=ok
Output_Alpha=tru
Antialias=t Jitter=off
+F
+FN
+FN16
+FN8
+FN5
+FNg
+FP
+FP16
+FB
+FT
+FC
+FE
+FH
+FS
+FX
Output_File_Type=N
Output_File_Type=P
Output_File_Type=T
Output_File_Type=B
Bits_Per_Color=16
Bits_Per_Color=12
Bits_Per_Color=3
Bits_Per_Color=40
Grayscale_Output=on
Grayscale_Output=off
+UA
-UA
Output_Alpha=on
+UA +FT
+UA +FP
Compression=3
Dither=on
+THB2
+THB4
+THFS
Dither=on Dither_Method=B3
-TH
File_Gamma=1
File_Gamma=2.2
File_Gamma=sRGB
+Iold.pov
+Iold.pov File_Gamma=1
Display_Gamma=2.2
+C
Continue_Trace=on
Continue_Trace=off
Create_Ini=made.ini
Create_Ini=on
+GImade.ini
Create_Ini=off
""")
group("File", "+FJ\nOutput_File_Type=J\n+FJ Compression=40", grade="match")
group("Quality and antialiasing", "\n".join([f"+Q{n}" for n in range(12)] + ["Quality=5", "+QR", "Quality=50"]) + """
+A -J
+A0.1 -J
-A
-A0.1
+A0.0 -J +R2
Antialias=on Jitter=off
Antialias=on Antialias_Threshold=0.05 Jitter=off
+A0.1 +AM2 -J
+A0.1 +AM2 +R4 -J
+A0.1 +AM1 +R5 -J
Antialias=on Sampling_Method=2 Antialias_Depth=2 Jitter=off
+A0.1 +AG1.0 -J
Antialias=on Antialias_Gamma=2.2 Jitter=off
Antialias_Depth=3
Sampling_Method=2
Jitter=on
Jitter_Amount=0.5
""")
group("Quality and antialiasing", """
+A
+A0.1 +J
+A0.1 +J0.5
+A0.1 +AM2 +J
Antialias=on Jitter_Amount=0.3
""", grade="close")
group("How the work is done", """
+WT1
+WT2
Work_Threads=3
+WT0
Work_Threads=9999
+MB
+MB10
-MB
Bounding=off
Bounding_Threshold=5
Bounding_Method=2
+BM1
+BM2
+UL
-UL
Light_Buffer=off
+UV
-UV
Vista_Buffer=off
+UR
-UR
Remove_Bounds=off
+SU
-SU
Split_Unions=on
+UD
Draw_Vistas=on
+BS16
Render_Block_Size=64
+RP2
Render_Pattern=3
+RS4
Render_Block_Step=3
+HR
High_Reproducibility=on
+RVP
Radiosity_Vain_Pretrace=off
+RFO
Max_Image_Buffer_Memory=64
+MI64
BSP_MaxDepth=20
BSP_ISectCost=100
BSP_BaseAccessCost=1
BSP_ChildAccessCost=1
BSP_MissChance=0.2
+X
-X
+X10
Test_Abort=on
Test_Abort_Count=100
+B
+B100
Buffer_Output=on
Buffer_Size=100
""")
group("Display and messages", """
-D
Display=off
+P
-P
Pause_When_Done=off
+SP16
+EP4
Preview_Start_Size=8
Preview_End_Size=2
Video_Mode=1
Palette=3
+V
-V
Verbose=off
+WL0
+WL5
Warning_Level=10
Warning_Level=99
+GA
-GA
+GAall.txt
All_Console=off
All_File=all.txt
All_File=on
All_File=off
+GD
-GD
+GDd.txt
Debug_Console=off
Debug_File=d.txt
Debug_File=true
+GF
-GF
+GFf.txt
Fatal_File=f.txt
+GR
-GR
+GRr.txt
Render_File=r.txt
Render_File=on
+GS
-GS
+GSs.txt
Statistic_File=s.txt
Statistic_File=on
+GW
-GW
+GWw.txt
Warning_File=w.txt
Warning_File=on
+GP
-GP
Append_File=on
Append_File=on All_File=all.txt
""")
group("INI files", """
a.ini
a
a.ini +W20
+W20 a.ini
parts.ini[small]
parts.ini[large]
parts.ini[SMALL]
parts.ini[none]
parts.ini
nested.ini
hash.ini
switches.ini
crlf.ini
missing.ini
line.ini
pre.ini
fails.ini
quits.ini
skips.ini
succeeds.ini
ends.ini
frame_ends.ini
abort.ini
fatal.ini
frames.ini
frame_skips.ini
""", bare=True)
group("Others", "scene.pov\nscene\n+Q9 scene.pov\n--help\n-help\n-h\n-?\n--version\n-version\n--generation\n+ZZ\nNo_Such=1\nWidth\n", bare=True)

# Differences that stay, by line, with the reason.
READ = """## Lines that programs read

With `Stock_Messages=On`, and without that option wherever lentray is called by a name that begins
with `povray` (a link, say), standard error has POV-Ray's form. `tests/compat/reading_callers.py`
reads it as programs do that exist: CueMol, LeoCAD, an extension of Visual Studio Code,
povray-jupyter, Emacs's pov-mode, povrayer, Spack. Each shows the same with stock and with lentray.

| line | in stock's form |
|---|---|
| `Rendered 5760 of 307200 pixels (1%)` | with `+V`, each ended by a carriage return, the last by a new line too; the last tells 100%. The first comes after a second, then five a second. The number is the share of the work, in pixels: pixels cost unequal time. With `+C`, what remains to be done is the whole |
| `Rendering frame 2 of 10` | before each picture of an animation, once; stock tells the first one twice |
| `==== [Parsing...] ====`, `==== [Rendering...] ====` | yes |
| `File 'a.pov' line 3: Parse Error: ...`, `... Parse Warning: ...` | file and line as stock's; the message is lentray's. It stays on one line, where stock breaks it at 80 columns. The lines behind it tell the column (` in column 5`, with the one blank that stock's second lines begin with), the scene's line with a caret, and the includes and macros |
| `Parse Error: ...`, `Parse Warning: ...` | what has no place in the scene, as a missing scene. Once rendering has begun: `Render Error: ...`, `Render Warning: ...` |
| `Possible Parse Error: ...` | no: a missing file is a Parse Error |
| `Fatal error in parser: Cannot parse input.`, `Render failed` | behind an error; while rendering it is `Fatal error in renderer: The picture is not whole.` |
| `Problem with option setting` and the command line | before what is wrong with an option, where lentray is called as povray |
| `Render cancelled by user`, `POV-Ray finished` | the last line, an empty one behind it |
| `File already rendered and continue requested; skipping.` | with `+C` |
| `Parser Options`, `Image Output Options` | `Input file`, `Clock value`, `Image resolution` (rows and columns of whole pictures only), `Output file` (without JPEG's quality), `Continued trace`; no other lines, no `Information Output Options` |
| `Parser Time`, `Render Options`, `Render Statistics`, `Render Time` | times with their threads and CPU seconds, `Quality`, `Antialiasing`, `Image Resolution`, `Pixels`, `Samples`, `Rays` (all but shadow rays), `Reflected Rays`, `Refracted Rays`. `Shadow Rays`, `Shadowed Rays` and `Peak Memory` are lentray's own. No objects, tests of shapes or maximum level |
| the first lines | `POV-Ray 3.7.0 compatible: Lentray`, and that it is not POV-Ray; no authors or libraries |

Exit statuses are stock's: 0, 1 for what failed, 2 for what was stopped. `-V` suppresses the lines of the
first row alone. The five texts of POV-Ray (debug, fatal, render, statistics, warnings) go to the console and
to files as in stock. The lines of the first three rows and those at the end of a run belong to none of the
five: `-GA` does not suppress them, and no file gets them. An error is reported whatever `-GF` and `-GA` say."""

KNOWN = {
    "ends.ini": "status 1, as the manual says; stock has 0",
    "+W0": "refused; stock crashes and leaves its state",
    "+WT0": "one thread; stock renders nothing",
    "Create_Ini=on": "a switch, as the manual says; stock takes the name of a file",
    "Create_Ini=off": "a switch, as the manual says; stock takes the name of a file",
    "All_File=off": "a switch, as the manual says; stock takes the name of a file",
    "+B100": "read and ignored, as older versions' option; stock refuses it",
    "Buffer_Output=on": "read and ignored, as older versions' option; stock refuses it",
    "Buffer_Size=100": "read and ignored, as older versions' option; stock refuses it",
    "scene": "the scene without its extension; stock looks for an INI file only",
    "-h": "refused, as a height without a number; stock prints its help",
    "+RFO": "no file of a scene without radiosity; stock leaves an empty one",
    "Declare=Red=0.2 Declare=Red=0.7": "the last one holds; stock keeps the first",
}


def run(program, line, where):
    for name, text in FILES.items():
        (where / name).parent.mkdir(parents=True, exist_ok=True)
        (where / name).write_text(text)
    words = line.text.split()
    command = [program, *([] if line.bare else ["+Iscene.pov", "+W48", "+H36", ONE_BLOCK]), *words, "-D"]
    try:
        done = subprocess.run(command, cwd=where, stdin=subprocess.DEVNULL, capture_output=True, timeout=120,
                              check=False, env={**os.environ, "POVINI": str(where / "empty.ini")})
        status = done.returncode
    except subprocess.TimeoutExpired:
        status = "no end"
    names = sorted(str(p.relative_to(where)) for p in where.rglob("*") if p.is_file())
    return status, [n for n in names if n not in FILES]


PICTURES = (".png", ".ppm", ".pgm", ".bmp", ".tga", ".exr", ".hdr", ".jpg")


def compare(line, args, folder):
    """What differs; empty: nothing."""
    places = {p: folder / p for p in ("stock", "ours")}
    for place in places.values():
        place.mkdir(parents=True)
    stock, names = run("povray", line, places["stock"])
    ours, our_names = run(args.bin / "lentray", line, places["ours"])
    if stock != ours:
        return f"status {ours} instead of {stock}"
    if names != our_names:
        return f"files {' '.join(our_names) or '-'} instead of {' '.join(names) or '-'}"
    for name in names:
        if not name.endswith(PICTURES):
            continue
        figures = folder / "figures.json"
        figures.unlink(missing_ok=True)
        subprocess.run([args.bin / "lentray-diff", places["ours"] / name, places["stock"] / name, "--no-pictures",
                        "--json", figures], capture_output=True, check=False)
        if not figures.is_file():
            return f"{name} cannot be compared"
        grade = json.loads(figures.read_text())["whole"]["grade"]
        if GRADES.index(grade) < GRADES.index(line.grade):
            return f"{name}: {grade} instead of {line.grade}"
    return ""


def document(results):
    out = ["# Options, line by line", "",
           "For those whose scripts call POV-Ray. Does lentray do the same for this command line?", "",
           "Each line was run by stock POV-Ray 3.7 and by lentray (`tests/compat/options.py`): same exit status, same",
           "files, and pictures that a viewer shows alike (exact, but for jitter and JPEG). What an option means: `lentray",
           "--help=all` or the manual page. Differences that stay have their reason.", ""]
    for title, lines in GROUPS.items():
        out += [f"## {title}", "", "| command line | as stock |", "|---|---|"]
        for line in lines:
            what = results[line]
            note = "yes" if not what else KNOWN.get(line.text, "no") + f" ({what})"
            shown = f"`{line.text.replace('|', chr(92) + '|')}`"
            if line.text.endswith(".ini") and line.text in FILES:
                shown += ", which says `" + FILES[line.text].strip().replace("\r", "").replace("\n", "` `") + "`"
            out.append(f"| {shown} | {note} |")
        out.append("")
    return "\n".join(out + [READ])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("words", nargs="*")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "release" / "bin")
    parser.add_argument("--jobs", type=int, default=2 * (os.cpu_count() or 1))
    parser.add_argument("--write-docs", action="store_true")
    args = parser.parse_args()
    args.bin = args.bin.resolve()
    lines = [x for all_of in GROUPS.values() for x in all_of if not args.words or any(w in x.text for w in args.words)]
    with tempfile.TemporaryDirectory() as name, concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        folder = pathlib.Path(name)
        found = pool.map(lambda item: compare(item[1], args, folder / str(item[0])), enumerate(lines))
        results = dict(zip(lines, found))
    known = {x for x in lines if results[x] and x.text in KNOWN}
    bad = [x for x in lines if results[x] and x not in known]
    for line in bad:
        print(f"{line.text}: {results[line]}")
    print(f"{len(lines)} lines, {len(lines) - len(known) - len(bad)} as stock, {len(known)} known to differ, {len(bad)} others")
    if args.write_docs and not args.words:
        (ROOT / "docs" / "options.md").write_text(document(results) + "\n")
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
