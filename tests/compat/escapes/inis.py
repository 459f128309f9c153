"""INI files that came with scenes: what they say, and how they come to be read."""
import sys
import pathlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "batch"))
import strangers  # noqa: E402
from escapes.ground import ON, SCENE, SMALL, Attempt, Fifo, Hard, Link  # noqa: E402

FILES = {"strangers/link": Link("../victim/rc"), "strangers/link.inc": Link("../victim/secret.inc"),
         "strangers/link.ini": Link("../victim/more.ini"), "strangers/dangling": Link("../victim/made"),
         "strangers/hard": Hard("victim/rc"), "strangers/pipe": Fifo(), "strangers/more.ini": "Debug_File=../victim/rc\n"}
SAYS = SCENE + '#debug "alias ls=evil\\n"\n#warning "x"\n'
READS = SCENE + '#include "secret.inc"\n'
MORE = ["+I../victim/secret.pov", "Input_File_Name=ROOT/victim/secret.pov", "+O../victim/rc", "+O../victim/", "Output_File_Name=folder/rc",
        "@../victim/more.ini", "+RFI +RF../victim/secret.rca", "+RFO +RF../victim/rc", "Radiosity_File_Name=../victim/rc\nRadiosity_To_File=On",
        "Dependencies_File=../victim/rc", "Statistics_File=hard", "View_Cameras=../victim/rc\nLenticular=On", "Lens_Sheet=mine\nLibrary_Path=../victim",
        "Permitted_Path=../victim\n+L../victim", "Permitted_Path=/", "Scene_Writes=disk", "Restrict_IO=Off", "Restrict_IO=0\n+L../victim",
        "[a.pov]\nDebug_File=../victim/rc", "\ufeffDebug_File=../victim/rc", "Debug_File=../victim/rc\r", " Debug_File = '../victim/rc' ",
        "Width=8 Debug_File=../victim/rc", "Width=8\0Debug_File=../victim/rc", "Display=On\n+GA../victim/rc\n-P", "Create_Ini=../victim/a.ini",
        "Post_Frame_Command=/bin/sh -c 'touch ../victim/touched'\nPost_Frame_Return=S", "Pre_Scene_Command=%s;touch ../victim/touched",
        "Continue_Trace=On\n+O../victim/rc", "Clock=1\nFinal_Frame=2\nOutput_File_Name=../victim/rc"]


def words():
    said = strangers.WRITES + strangers.COMMANDS + strangers.READS + strangers.INIS + strangers.LENTRAYS + MORE
    return [text.replace("a.inc", "secret.inc") for text in said]


def kind_of(text):
    for part, kind in (("_Command", "commands of INI files"), ("Include_Header", "include headers"), ("+HI", "include headers")):
        if part in text:
            return kind
    return "options of INI files"


def attempts():
    for text in words():
        scene = READS if "Library_Path" in text or "+L" in text else SAYS
        files = {**FILES, "strangers/a.pov": scene}
        what = text.replace("\n", " | ")
        kind = kind_of(text)
        for line in ([ON, "--scene-ini", "a.ini"], ["--scene-ini=a.ini", ON]):
            yield Attempt(kind, "beside: " + what, "lentray", ["+Ia.pov", *SMALL, *line], {**files, "strangers/a.ini": text + "\n"})
        yield Attempt(kind, "povray.ini: " + what, "lentray", ["+Ia.pov", *SMALL, ON], {**files, "strangers/povray.ini": text + "\n"})
        yield Attempt(kind, "beside: " + what, "lentray-batch", ["../strangers", "--out", "out", "+W8", "+H6", "--quiet"],
                      {**files, "strangers/a.ini": text + "\n"}, "here")
        yield Attempt(kind, "beside: " + what, "lentray-diff", ["a.pov", "--no-pictures", "+W8", "+H6", ON, "--scene-ini", "a.ini"],
                      {**files, "strangers/a.ini": text + "\n"})
