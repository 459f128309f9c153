#!/usr/bin/env python3
"""Makes manual pages and shell completions of what programs say of themselves.

  manual.py man  PROGRAM VERSION OUTPUT.1.gz
  manual.py bash OUTPUT PROGRAM...        one file for all of them, and for a povray that is lentray
  manual.py zsh  OUTPUT PROGRAM...

A program's help (--help=all where it knows that, else --help) is the one source. Its form:

  usage: NAME ...                   synopsis, further lines below it
  <blank>
  First sentence. More of it.       the first sentence is the summary
  <blank>
  Title:                            a group of options; Files, Environment, Exit status and Examples
    FORM, FORM  text                  are sections of their own
        more text                   two blanks before an entry, more before what continues it; two or
                                      more between its forms and the text on the same line
"""
import gzip
import os
import re
import subprocess
import sys

OWN_SECTIONS = ("Files", "Environment", "Exit status", "Examples")


class Entry:
    def __init__(self, forms, text):
        self.forms, self.text = forms, text


class Help:
    """The help of a program, taken apart."""

    def __init__(self, program):
        self.name = os.path.basename(program)
        text = ""
        for option in ("--help=all", "--help"):
            run = subprocess.run([program, option], stdin=subprocess.DEVNULL, capture_output=True, text=True)
            text = run.stdout
            if run.returncode == 0 and text:
                break
        else:
            sys.exit(f"manual.py: {program} --help has status {run.returncode}: {run.stderr}")
        blocks = re.split(r"\n\s*\n", text.strip("\n"))
        if not blocks[0].startswith("usage: "):
            sys.exit(f"manual.py: the help of {self.name} does not begin with its usage")
        self.usage = [line[7:] for line in blocks[0].split("\n")]
        self.paragraphs, self.sections = [], []
        for block in blocks[1:]:
            self.add(block.split("\n"))
        self.summary = re.split(r"[.:](?:\s|$)", self.paragraphs[0])[0]
        self.summary = self.summary[0].lower() + self.summary[1:]

    def add(self, lines):
        if not lines[0].startswith(" ") and lines[0].endswith(":") and len(lines) > 1 and lines[1].startswith("  "):
            self.sections.append((lines[0][:-1], []))
            lines = lines[1:]
        elif not lines[0].startswith(" "):
            self.paragraphs.append(" ".join(lines))
            return
        if not self.sections:
            self.sections.append(("", []))
        entries = self.sections[-1][1]
        for line in lines:
            if re.match(r"  \S", line):
                forms, _, text = line[2:].partition("  ")
                entries.append(Entry(forms.strip(), text.strip()))
            else:
                entries[-1].text = (entries[-1].text + " " + line.strip()).strip()

    def options(self):
        return [entry for title, entries in self.sections if title not in OWN_SECTIONS for entry in entries]

    def words(self):
        """What completes a word, and the values of names: {"Width=": [], "Lens_Model=": ["paraxial", ...]}."""
        words = {}
        for entry in self.options():
            for form in re.split(r", | \| ", entry.forms):
                form = form.strip().split(" ")[0]
                if form.startswith(("+", "-")) and not form.startswith("--"):
                    words[re.match(r"[+-][A-Z]*", form)[0]] = []
                elif re.match(r"\w+=", form):
                    name, _, value = form.partition("=")
                    choice = value.split("|") if re.fullmatch(r"\w+(\|\w+)+", value) else []
                    choice = ["On", "Off"] if choice == ["on", "off"] else choice
                    words[name + "="] = [v for v in choice if len(v) > 1 or v != v.lower() or v.isdigit()]
                elif form.startswith("--"):
                    words[form] = []
        words["--help"] = []
        return words


def roff(text):
    text = text.replace("\\", "\\e").replace("-", "\\-").replace("'", "\\(aq")
    return "\\&" + text if text.startswith(".") else text


def man_page(about, version, programs):
    out = [f'.TH {about.name.upper()} 1 "" "Lentray {version}" "User Commands"', ".ad l", ".SH NAME",
           f"{roff(about.name)} \\- {roff(about.summary)}", ".SH SYNOPSIS", ".nf"]
    for line in about.usage:
        name, _, rest = line.partition(" ")
        out.append(f"\\fB{roff(name)}\\fR {roff(rest)}")
    out += [".fi", ".SH DESCRIPTION"]
    late = []
    for paragraph in about.paragraphs:
        if paragraph.startswith("Exit status: "):
            late += [".SH EXIT STATUS", roff(paragraph[13:])]
        else:
            out += [roff(paragraph), ".PP"]
    opened = False
    for title, entries in about.sections:
        if title in OWN_SECTIONS:
            out.append(f".SH {title.upper()}")
        else:
            if not opened:
                out.append(".SH OPTIONS")
                opened = True
            if title:
                out.append(f".SS {roff(title)}")
        for entry in entries:
            forms = roff(entry.forms).replace("|", "|\\:")  # lines may end there
            out += [".TP", f"\\fB{forms}\\fR"]
            if entry.text:
                out.append(roff(entry.text))
    others = ", ".join(f"\\fB{roff(p)}\\fR(1)" for p in sorted(set(programs + ["povray"])) if p != about.name)
    return "\n".join(out + late + [".SH SEE ALSO", others, ""])


BASH = """# Completion of lentray's programs for bash: options, their values, scenes and files.
_lentray_complete() {
  # Words as they stand on the line: bash itself splits them at = too.
  local line=${COMP_LINE:0:COMP_POINT} word words= values= head= file
  word=${line##*[[:space:]]}
  case $2 in *[[:space:]]*) word=$2 ;; esac
  case ${1##*/} in
%s  esac
  COMPREPLY=()
  case $word in
    --*) ;;
    [A-Za-z]*=*) head=${word%%%%=*}=
      case ${1##*/}:$head in
%s      esac
      if [ -n "$values" ]; then
        COMPREPLY=($(compgen -W "$values" -- "${word#*=}"))
      else
        compopt -o filenames
        local IFS=$'\\n'
        COMPREPLY=($(compgen -f -- "${word#*=}"))
      fi
      case $COMP_WORDBREAKS in *=*) ;; *) COMPREPLY=("${COMPREPLY[@]/#/$head}") ;; esac
      return ;;
    [+-][IOLiol]*) head=${word:0:2}
      compopt -o filenames -o nospace
      local IFS=$'\\n'
      COMPREPLY=($(compgen -P "$head" -f -- "${word:2}"))
      return ;;
  esac
  COMPREPLY=($(compgen -W "$words" -- "$word"))
  case ${COMPREPLY[0]-} in
    "") compopt -o filenames 2>/dev/null ;;
    *=|[+-][A-Z]*) compopt -o nospace ;;
  esac
  case $word in [+-]*) return ;; esac
  local IFS=$'\\n'
  for file in $(compgen -f -- "$word"); do
    case $file in
      *.pov|*.ini|*.POV|*.INI|*.png|*.tif|*.tiff|*.exr) COMPREPLY+=("$file") ;;
      *) if [ -d "$file" ]; then COMPREPLY+=("$file"); fi ;;
    esac
  done
}
complete -F _lentray_complete %s
# A povray that is lentray.
case $(readlink -f "$(type -P povray)" 2>/dev/null) in */lentray) complete -F _lentray_complete povray ;; esac
"""


def bash_completion(helps):
    words, values = "", ""
    for about in helps:
        known = about.words()
        names = about.name + ("|povray" if about.name == "lentray" else "")
        words += f"    {names}) words='{' '.join(sorted(known))}' ;;\n"
        for name, choice in sorted(known.items()):
            if choice:
                patterns = "|".join(f"{n}:{name}" for n in names.split("|"))
                values += f"        {patterns}) values='{' '.join(choice)}' ;;\n"
    return BASH % (words, values, " ".join(about.name for about in helps))


ZSH = """#compdef %s
# Completion of lentray's programs for zsh: options, their values, scenes and files.
local -a all
case ${service:t} in
%sesac
if [[ $PREFIX == *=* && $PREFIX != --* ]]; then
  local name=${PREFIX%%%%\\=*}
  local -a values
  case ${service:t}:$name in
%s  esac
  compset -P '*='
  if (( $#values )); then compadd -a values; else _files; fi
elif [[ $PREFIX == [+-][IOLiol]* ]]; then
  compset -P '[+-]?'
  _files
else
  compadd -S '' -a all
  _files -g '*.(pov|ini|png|tif|tiff|exr)(-.)'
fi
"""


def zsh_completion(helps):
    words, values = "", ""
    for about in helps:
        known = about.words()
        names = about.name + ("|povray" if about.name == "lentray" else "")
        words += f"  {names}) all=({' '.join(sorted(known))}) ;;\n"
        for name, choice in sorted(known.items()):
            if choice:
                patterns = "|".join(f"{n}:{name[:-1]}" for n in names.split("|"))
                values += f"    {patterns}) values=({' '.join(choice)}) ;;\n"
    return ZSH % (" ".join(about.name for about in helps), words, values)


def main():
    what, rest = sys.argv[1], sys.argv[2:]
    if what == "man":
        program, version, output, *others = rest
        page = man_page(Help(program), version, others)
        with open(output, "wb") as raw, gzip.GzipFile("", "wb", 9, raw, mtime=0) as packed:
            packed.write(page.encode())
    else:
        helps = [Help(program) for program in rest[1:]]
        text = bash_completion(helps) if what == "bash" else zsh_completion(helps)
        with open(rest[0], "w", encoding="utf-8") as out:
            out.write(text)


if __name__ == "__main__":
    main()
