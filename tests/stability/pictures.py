"""Small pictures by stock POV-Ray and by lentray, as lists of pixels, for tests/stability."""
import pathlib
import resource
import struct
import subprocess
import tempfile
import zlib

SECONDS = 20


def read_png(data):
    """(width, height, rows of (r, g, b)) of an RGB or RGBA file of 8 bits."""
    place, packed, size, channels = 8, b"", (0, 0), 3
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place:place + 8])
        body = data[place + 8:place + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colours = struct.unpack(">IIBB", body[:10])
            if depth != 8 or colours not in (2, 6):
                raise ValueError("a PNG of another kind")
            size, channels = (width, height), 3 if colours == 2 else 4
        elif kind == b"IDAT":
            packed += body
        place += 12 + length
    raw, stride = zlib.decompress(packed), size[0] * channels
    above, rows = bytearray(stride), []
    for y in range(size[1]):
        start = y * (stride + 1)
        line = bytearray(raw[start + 1:start + 1 + stride])
        unfilter(raw[start], line, above, channels)
        rows.append([tuple(line[x:x + 3]) for x in range(0, stride, channels)])
        above = line
    return size[0], size[1], rows


def unfilter(kind, line, above, step):
    for i, value in enumerate(line):
        left = line[i - step] if i >= step else 0
        if kind == 1:
            guess = left
        elif kind == 2:
            guess = above[i]
        elif kind == 3:
            guess = (left + above[i]) // 2
        elif kind == 4:
            corner = above[i - step] if i >= step else 0
            to = left + above[i] - corner
            far = [abs(to - left), abs(to - above[i]), abs(to - corner)]
            guess = (left, above[i], corner)[far.index(min(far))]
        else:
            guess = 0
        line[i] = (value + guess) & 255


class Renderer:
    """Pictures of one program; each scene is rendered once."""

    def __init__(self, program, size):
        self.program, self.size, self.known = program, size, {}

    def picture(self, scene):
        """Rows of pixels, or a string that says why there are none."""
        if scene not in self.known:
            self.known[scene] = self.render(scene)
        return self.known[scene]

    def render(self, scene):
        def limit():
            resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 1))

        with tempfile.TemporaryDirectory() as folder:
            where = pathlib.Path(folder)
            (where / "scene.pov").write_text(scene)
            done = subprocess.run([self.program, "+Iscene.pov", "+Oscene.png", f"+W{self.size}",
                                   f"+H{self.size}", "-A", "-D", "+FN8", "+WT1"], cwd=where,
                                  stdin=subprocess.DEVNULL, capture_output=True, check=False,
                                  preexec_fn=limit)
            picture = where / "scene.png"
            if done.returncode < 0:
                return f"stopped after {SECONDS} s"
            if done.returncode != 0 or not picture.is_file():
                text = (done.stdout + done.stderr).decode(errors="replace").strip().splitlines()
                errors = [t for t in text if "rror" in t]
                return (errors or text or [f"status {done.returncode}"])[0][:120]
            return read_png(picture.read_bytes())[2]
