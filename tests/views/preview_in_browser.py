#!/usr/bin/env python3
"""The page of `lentray-views --preview` in headless Chromium, opened as a file: its pixels beside those of `--eye`,
`--stereo` and `--anaglyph`, drag, touch, keys, the device's tilt, true size, narrow and wide windows, light and dark.

    preview_in_browser.py [--bin build/release/bin] [--screenshots FOLDER] [word ...]

With words only the checks whose name has one.
Debian 12: apt install chromium chromium-driver python3-selenium
Status: 0 all as it should be, 1 something is not, 77 there is no browser to ask.
"""
import base64
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from browser import CONTRAST, ROOT, ActionChains, Keys, Page, equal, expect, run  # noqa: E402

NARROW, WIDE = 320, 1280
SHEETS = {
    # The scene's own eye, whole pixels a lens.
    "near": ["Lens_Pixels=8", "+W480", "+H60", "View_Distance=300"],
    # Parallel views, Snell's law, a fractional number, a last lens that is cut.
    "far": ["Lens_Pixels=7.37", "+W450", "+H60", "View_Distance=inf"],
    # On its side, seen from below to above.
    "across": ["Lens_Pixels=6", "+W80", "+H240", "View_Distance=300", "Lens_Direction=across"],
}
# What the picture of another program needs to be told.
OTHER = ["--lens-pixels", "6", "--lens-pitch", "0.5", "--lens-focal-length", "1.4", "--lens-ior", "1.57",
         "--view-distance", "400", "--aspect", "1.5"]

# The largest difference of a canvas from a PNG file, in 1/255, and how many pixels were compared. `part` of `parts` of
# the file's width.
DIFFERENCE = """
const [selector, link, part, parts] = arguments, done = arguments[arguments.length - 1];
const image = new Image();
image.onload = () => {
  const canvas = document.querySelector(selector), own = document.createElement("canvas");
  const width = image.naturalWidth / parts;
  own.width = width; own.height = image.naturalHeight;
  const context = own.getContext("2d");
  context.fillRect(0, 0, own.width, own.height);
  context.drawImage(image, part * width, 0, width, own.height, 0, 0, width, own.height);
  if (canvas.width !== own.width || canvas.height !== own.height) {
    return done([`${canvas.width} x ${canvas.height}, not ${own.width} x ${own.height}`, 0]);
  }
  const a = canvas.getContext("2d").getImageData(0, 0, own.width, own.height).data;
  const b = context.getImageData(0, 0, own.width, own.height).data;
  let most = 0;
  for (let i = 0; i < a.length; ++i) most = Math.max(most, Math.abs(a[i] - b[i]));
  done([most, a.length / 4]);
};
image.src = link;
"""


class PreviewPage(Page):
    """The page of a preview, and the programs beside it."""

    def __init__(self, driver, bin_folder, folder):
        super().__init__(driver, "")
        self.bin, self.folder = bin_folder, folder

    def program(self, name, *words, status=0):
        run = subprocess.run([self.bin / name, *map(str, words)], cwd=self.folder, text=True, capture_output=True,
                             check=False)
        equal(run.returncode, status, f"status of {name} {words}: {run.stdout}{run.stderr}")
        return run.stdout + run.stderr

    def show(self, name, address="", **window):
        self.url = (self.folder / f"{name}.html").as_uri()
        self.open(address, **window)
        self.wait("return document.body.dataset.ready === 'yes'", "the picture never came")

    def difference(self, words, canvas="#first", part=0, parts=1):
        """Between a canvas and what lentray-views writes."""
        self.program("lentray-views", *words, "--out", "beside.png")
        link = "data:image/png;base64," + base64.b64encode((self.folder / "beside.png").read_bytes()).decode()
        most, pixels = self.driver.execute_async_script(DIFFERENCE, canvas, link, part, parts)
        expect(isinstance(most, int), f"sizes: {most}")
        expect(pixels > 1000, f"{pixels} pixels compared")
        return most

    def angle(self):
        return self.js("return +document.getElementById('angle').value")

    def settle(self):
        """The picture of what was asked for is drawn in the next frame."""
        self.driver.execute_async_script("""const done = arguments[0];
            requestAnimationFrame(() => requestAnimationFrame(() => done()))""")

    def canvas_text(self):
        return self.js("return document.getElementById('first').toDataURL()")

    def set(self, name, value):
        self.js("""const f = document.getElementById(arguments[0]); f.value = arguments[1];
            f.dispatchEvent(new Event('input', {bubbles: true}))""", name, str(value))
        self.settle()


def check_one_eye(page):
    """Bit for bit: the page computes by the same formula in the same order, and PNG keeps the pixels."""
    for name, distances in (("near", (300, 180, 1000)), ("far", ("inf", 400))):
        page.show(name)
        for distance in distances:
            page.set("distance", distance)
            for angle in (0, 3.7, -9.2, 31, -58.3):
                page.set("angle", angle)
                eye = f"{angle}" if distance == "inf" else f"{angle},{distance}"
                equal(page.difference([f"{name}.png", "--eye", eye]), 0, f"{name} from {eye}")
    expect(page.js("return new Set(new Uint32Array(document.getElementById('first').getContext('2d')"
                   ".getImageData(0, 0, 60, 60).data.buffer)).size") > 1, "something is seen")


def check_two_eyes(page):
    for name in ("near", "far"):
        page.show(name, "#mode=pair&angle=2.5")
        words = [f"{name}.png", "--stereo", "--eye", "2.5"]
        equal(page.difference(words, "#first", 0, 2), 0, f"{name}: left eye on the left")
        equal(page.difference(words, "#second", 1, 2), 0, f"{name}: right eye on the right")
        page.one("#modes [data-mode=crossed]").click()
        page.settle()
        equal(page.difference(words, "#second", 0, 2), 0, f"{name}: cross-eyed, left eye on the right")
        equal(page.js("return [first, second].map(e => e.nextSibling.textContent)"), ["right eye", "left eye"], "names")
        page.set("apart", 30)
        equal(page.difference([*words, "--eyes", 30], "#first", 1, 2), 0, f"{name}: eyes 30 mm apart")
        page.one("#modes [data-mode=anaglyph]").click()
        page.settle()
        # A level: the page rounds sums of double precision, lentray-views of single precision.
        expect(page.difference([f"{name}.png", "--anaglyph", "--eye", "2.5", "--eyes", 30]) <= 1, f"{name}: anaglyph")


def check_lenses_across(page):
    """The picture is upright, and goes up and down; the page's angle is that below."""
    page.show("across")
    for angle in (0, 6.5, -9.2):
        page.set("angle", angle)
        equal(page.difference(["across.png", f"--eye={-angle},300"]), 0, f"from {angle} below")
    expect("9.2° above" in page.one("#said").text, page.one("#said").text)
    expect(not page.one("#modes").is_displayed(), "two eyes see the same")
    page.one("#stage").send_keys(Keys.HOME)
    at = page.angle()
    page.one("#stage").send_keys(Keys.ARROW_DOWN)
    equal(round(page.angle() - at, 3), 1, "an arrow down goes down")


def check_other_programs(page):
    page.show("other")
    for eye in ("0,400", "12,400"):
        page.set("angle", eye.split(",")[0])
        equal(page.difference(["other.png", *OTHER, "--eye", eye]), 0, eye)
    complaint = page.program("lentray-views", "other.png", "--preview", "no.html", "--lens-pixels", 6, status=1)
    expect("give --lens-pitch, --lens-focal-length, --lens-ior, --view-distance" in complaint, complaint)
    complaint = page.program("lentray-views", "other.png", "--preview", "no.html", *OTHER[:-2], status=1)
    expect("give --aspect" in complaint, complaint)
    complaint = page.program("lentray-views", "near.png", "--preview", "no.png", status=1)
    expect("'no.png': a preview is a .html file" in complaint, complaint)
    complaint = page.program("lentray-views", "near.png", "--preview", "no.html", "--page-limit", "0.01", status=1)
    expect("before it has a picture: raise --page-limit" in complaint, complaint)
    frame = int(complaint.split(" kB before")[0].rsplit(" ", 1)[1])
    complaint = page.program("lentray-views", "near.png", "--preview", "no.html", "--page-limit", (frame + 1) / 1000,
                             status=1)
    expect("the picture does not go into a page of that size: raise --page-limit" in complaint, complaint)
    complaint = page.program("lentray-views", "near.png", "near.png", "--preview", "no.html", status=1)
    expect("one integral image is expected" in complaint, complaint)
    expect(not (page.folder / "no.html").exists() and not (page.folder / "no.png").exists(), "files of what failed")


def check_limit(page):
    """Where it does not fit the picture becomes JPEG, then it loses rows. Both is told, and it looks alike."""
    full = page.program("lentray-views", "near.png", "--preview", "full.html")
    expect("the picture's own pixels" in full, full)
    frame = (page.folder / "full.html").stat().st_size
    expect(frame < 20e6, "size")
    for limit, rows, words in ((0.1, 60, "JPEG of quality"), (0.058, None, "60 rows scaled to")):
        told = page.program("lentray-views", "near.png", "--preview", "small.html", "--page-limit", limit)
        expect(words in told, told)
        size = (page.folder / "small.html").stat().st_size
        expect(size <= limit * 1e6, f"{size} bytes, not {limit} MB")
        page.show("small")
        expect(words in page.one("body").text, "the page tells it")
        if rows:
            equal(page.js("return first.height"), rows, "rows")
            # JPEG's blocks over 60 lenses of a scene with hard edges.
            page.program("lentray-views", "near.png", "--eye", "0", "--out", "beside.png")
            mean = page.driver.execute_async_script(MEAN, "data:image/png;base64," + base64.b64encode(
                (page.folder / "beside.png").read_bytes()).decode())
            expect(mean < 4, f"{mean} of 255 off in the mean")


MEAN = """const [link, done] = arguments, image = new Image();
image.onload = () => {
  const own = document.createElement("canvas");
  own.width = image.naturalWidth; own.height = image.naturalHeight;
  own.getContext("2d").drawImage(image, 0, 0);
  const read = (c) => c.getContext("2d").getImageData(0, 0, own.width, own.height).data, a = read(own), b = read(first);
  done(a.reduce((sum, v, i) => sum + Math.abs(v - b[i]), 0) / a.length);
};
image.src = link;"""


def check_drag(page):
    page.show("near")
    stage = page.one("#stage")
    page.scroll_to(stage)
    before = page.canvas_text()
    width = stage.size["width"]
    ActionChains(page.driver).move_to_element(stage).click_and_hold().move_by_offset(width // 10, 0).release().perform()
    zone = page.js("return JSON.parse(document.getElementById('data').textContent).viewing_angle")
    expect(abs(page.angle() - 1.25 * zone / 10) < 0.3, f"a tenth of the width: {page.angle()} of {zone} degrees")
    page.settle()
    expect(page.canvas_text() != before, "another picture")
    at = page.angle()
    ActionChains(page.driver).move_to_element(stage).move_by_offset(20, 0).perform()
    equal(page.angle(), at, "without a button nothing moves")


def check_touch(page):
    page.show("near", width=NARROW, height=700, mobile=True)
    stage = page.one("#stage")
    page.scroll_to(stage)
    x, y = page.js("""const r = arguments[0].getBoundingClientRect();
        return [r.left + r.width / 2, r.top + r.height / 2]""", stage)
    touch = lambda kind, *points: page.driver.execute_cdp_cmd(
        "Input.dispatchTouchEvent", {"type": kind, "touchPoints": [{"x": px, "y": py} for px, py in points]})
    touch("touchStart", (x, y))
    for step in range(1, 7):
        touch("touchMove", (x - 10 * step, y))
    touch("touchEnd")
    page.wait("return +document.getElementById('angle').value < -2", "a finger to the left tilts to the left")


def check_keys(page):
    page.show("near")
    page.one("#stage").click()
    equal(page.angle(), 0, "a click tilts nothing")
    for key, angle in ((Keys.ARROW_RIGHT, 1), (Keys.ARROW_RIGHT, 2), (Keys.ARROW_LEFT, 1), (Keys.PAGE_UP, 6),
                       ("0", 0)):
        page.press(key)
        equal(page.angle(), angle, f"after {key!r}")
    ActionChains(page.driver).key_down(Keys.SHIFT).send_keys(Keys.ARROW_RIGHT).key_up(Keys.SHIFT).perform()
    equal(page.angle(), 0.1, "with Shift")
    page.press(Keys.HOME)
    zone = page.js("return JSON.parse(document.getElementById('data').textContent).viewing_angle")
    expect(abs(page.angle() + zone / 2) < 0.06, f"Home: {page.angle()} of {zone}")
    equal(page.js("return stage.getAttribute('aria-valuetext')"), f"{zone / 2:.1f}° to the left", "what is told")
    width = page.js("return first.getBoundingClientRect().width")
    page.press("+")
    expect(abs(page.js("return first.getBoundingClientRect().width") / width - 1.25) < 0.01, "+ makes it larger")
    page.press("-")
    expect(abs(page.js("return first.getBoundingClientRect().width") / width - 1) < 0.01, "- smaller again")
    page.one("#angle").send_keys(Keys.ARROW_RIGHT)
    expect(page.angle() > -zone / 2, "the slider has keys of its own")


def check_device(page):
    """A screen turned to the right about its upright side is seen from further left; also held upright."""
    page.show("near")
    equal(page.js("return device.hidden"), False, "the button is there")
    for lying, turned in (((0, 0, 0), (0, 0, 12)), ((0, 90, 0), (12, 90, 0)), ((0, 60, 0), (0, 60, 12))):
        page.js("if (device.getAttribute('aria-pressed') === 'true') device.click(); device.click()")
        page.wait("return device.getAttribute('aria-pressed') === 'true'", "it is on")
        for alpha, beta, gamma in (lying, turned):
            page.js("""window.dispatchEvent(new DeviceOrientationEvent('deviceorientation',
                {alpha: arguments[0], beta: arguments[1], gamma: arguments[2]}))""", alpha, beta, gamma)
        expect(abs(page.angle() + 12) < 0.06, f"{lying} to {turned}: {page.angle()}")
    page.one("#front").click()
    equal(page.js("return device.getAttribute('aria-pressed')"), "false", "the button lets go of it")
    page.one("#sway").click()
    page.wait("return Math.abs(+angle.value) > 2", "it sways by itself")
    page.one("#sway").click()
    at = page.angle()
    page.settle()
    equal(page.angle(), at, "until it is stopped")


def check_device_that_tells_nothing(page):
    page.show("near")
    page.js("window.addEventListener('deviceorientation', e => e.stopImmediatePropagation(), true); device.click()")
    page.wait("return document.getElementById('device-said').textContent.includes('https')", "and why")
    equal(page.js("return device.getAttribute('aria-pressed')"), "false", "off again")
    page.js("DeviceOrientationEvent.requestPermission = async () => 'denied'; device.click()")
    page.wait("return document.getElementById('device-said').textContent.includes('does not allow')", "it is forbidden")
    equal(page.js("return device.getAttribute('aria-pressed')"), "false", "still off")


def check_broken_page(page):
    text = (page.folder / "near.html").read_text(encoding="utf-8")
    (page.folder / "broken.html").write_text(text.replace("image/png;base64,iVBOR", "image/png;base64,AAAAA"),
                                             encoding="utf-8")
    page.url = (page.folder / "broken.html").as_uri()
    page.open()
    page.wait("return said.textContent.includes('cannot show the pictures')", "the page says so")


def check_true_size(page):
    page.show("near")
    page.js("localStorage.clear()")
    page.show("near")
    expect("a guess" in page.one("#scale-said").text, page.one("#scale-said").text)
    equal(page.js("return side.value"), "85.60", "side of the card")
    for pixels in (5.0, 3.5):
        page.set("scale", pixels)
        expect(abs(page.js("return card.getBoundingClientRect().width") - 85.6 * pixels) < 0.1, "the bar")
        page.one("#sizes [data-size=true]").click()
        box = page.js("const r = first.getBoundingClientRect(); return [r.width, r.height]")
        wanted = page.js("const d = JSON.parse(document.getElementById('data').textContent);"
                         "return [d.count * d.pitch, d.height_mm]")
        for found, mm in zip(box, wanted):
            expect(abs(found - mm * pixels) < 0.1, f"{box} pixels of {wanted} mm at {pixels}")
    expect("3.50 pixels" in page.one("#scale-said").text and "shown 1.00 times" in page.one("#scale-said").text,
           page.one("#scale-said").text)
    page.show("far")
    equal(page.js("return +scale.value"), 3.5, "kept for other pages")
    page.js("side.value = '53.98'; side.dispatchEvent(new Event('change'))")
    expect(abs(page.js("return card.getBoundingClientRect().width") - 53.98 * 3.5) < 0.1, "the short side")
    page.js("localStorage.clear()")
    page.show("near", width=NARROW, height=700, mobile=True)
    equal(page.js("return side.value"), "53.98", "the short side fits a narrow screen")
    expect(page.js("return card.getBoundingClientRect().width <= innerWidth - 40"), "it fits")


def check_fields(page):
    page.show("near")
    before = page.js("return location.hash")
    for name in ("distance", "apart"):
        for text in ("", "far", "-3", "0", "1e99", "nan"):
            page.set(name, text)
            expect("greater than 0 is expected" in page.one("#field-said").text, f"{name} {text!r} is accepted")
            equal(page.js("return document.getElementById(arguments[0]).getAttribute('aria-invalid')", name), "true",
                  "marked")
    equal(page.js("return location.hash"), before, "nothing changed")
    page.set("distance", "250,5")
    equal(page.one("#field-said").text, "", "the complaint goes")
    page.wait("return location.hash === '#distance=250.5'", "the address")
    page.show("near", "#angle=x&distance=-1&mode=nothing&eyes=0")
    equal(page.js("return [angle.value, distance.value, apart.value]"), ["0", "300", "65"], "an address that says nothing")
    page.show("turned")
    equal(page.js("return [angle.value, distance.value, apart.value]"), ["7", "222", "60"], "from the options")


def check_what_is_told(page):
    page.show("near")
    expect("Seen from 0.0°, 300 mm away. In the middle: pixel" in page.one("#said").text, page.one("#said").text)
    page.show("near", "#mode=pair&distance=60")
    expect("The two eyes are in two zones" in page.one("#zones").text, page.one("#zones").text)
    page.show("near", "#mode=pair&eyes=1&angle=1")
    expect("Both eyes see the same pixels" in page.one("#zones").text, page.one("#zones").text)
    page.show("near", "#mode=pair&eyes=20&distance=300")
    equal(page.js("return zones.hidden"), True, "no warning")
    page.show("near", "#mode=pair&eyes=30000&distance=60")
    expect("nothing, beyond the print" in page.one("#said").text, page.one("#said").text)


def check_widths_and_looks(page):
    for width in (NARROW, 390, 700, WIDE, 1920):
        for address in ("", "#mode=pair"):
            page.show("near", address, width=width, height=800, mobile=width < 500)
            equal(page.js("return document.documentElement.scrollWidth"), width, f"sideways at {width}{address}")
            expect(page.js("return stage.scrollWidth <= stage.clientWidth"), f"it fits at {width}{address}")
    for dark in (False, True):
        page.show("small", "#mode=pair&distance=60", dark=dark)
        equal(page.js(CONTRAST.replace('"h1, ', '"figcaption, label, select, output, h1, ')), [],
              f"contrast below 4.5 ({'dark' if dark else 'light'})")
    script = """return [...document.querySelectorAll("button, input, select, [role]")].filter(e =>
        !e.textContent.trim() && !e.getAttribute('aria-label') && !e.labels?.length && e.role !== 'status')
        .map(e => e.outerHTML.slice(0, 80))"""
    equal(page.js(script), [], "controls without a name")
    ids = page.js("return [...document.querySelectorAll('[id]')].map(e => e.id)")
    equal(sorted(ids), sorted(set(ids)), "ids that are there twice")


def check_loads_nothing(page):
    page.driver.get_log("browser")
    page.show("near")
    loaded = page.js("return performance.getEntriesByType('resource').map(e => e.name)")
    expect(all(name.startswith("data:") for name in loaded), f"loaded: {loaded}")
    complaints = [entry["message"] for entry in page.driver.get_log("browser") if entry["level"] == "SEVERE"]
    equal(complaints, [], "complaints of the browser")
    page.show("<b>")
    equal(page.js("return document.title"), "<b>.png through its lenses", "a name with marks of HTML")


def make_files(page):
    for name, options in SHEETS.items():
        page.program("lentray", ROOT / "scenes/demo.pov", "Lenticular=On", f"+O{name}.png", "-V", *options)
        page.program("lentray-views", f"{name}.png", "--preview", f"{name}.html")
    page.program("lentray-views", "near.png", "--preview", "turned.html", "--eye", "7,222", "--eyes", 60)
    page.program("lentray-views", "near.png", "--preview", "small.html", "--page-limit", "0.1")
    (page.folder / "<b>.png").write_bytes((page.folder / "near.png").read_bytes())
    page.program("lentray-views", "<b>.png", "--preview", "<b>.html")
    # Without a word of its sheet: a picture of pixels alone.
    page.program("lentray-views", *["near.png"] * 2, "--interlace", "--take-any", "--lens-pixels", 2, "--size", "240x90",
                 "--out", "words.png")
    head, bytes_ = b"\x89PNG\r\n\x1a\n", (page.folder / "words.png").read_bytes()[8:]
    while bytes_:
        length = int.from_bytes(bytes_[:4], "big") + 12
        head += bytes_[:length] if bytes_[4:8] in (b"IHDR", b"IDAT", b"IEND") else b""
        bytes_ = bytes_[length:]
    (page.folder / "other.png").write_bytes(head)
    page.program("lentray-views", "other.png", *OTHER, "--preview", "other.html")


def screenshots(page, folder):
    folder.mkdir(parents=True, exist_ok=True)
    page.program("lentray", ROOT / "scenes/demo.pov", "Lenticular=On", "+Olarge.png", "-V", "Sheet_Width=100mm",
                 "Sheet_Height=75mm", "Lens_LPI=40", "Print_DPI=300", "View_Distance=400")
    print(page.program("lentray-views", "large.png", "--preview", "large.html"))
    for name, address, width, dark in (("wide", "", WIDE, False), ("pair-dark", "#mode=pair", 1600, True),
                                       ("narrow", "#mode=anaglyph&angle=3", NARROW, False),
                                       ("narrow-dark", "#mode=pair&distance=150", 390, True)):
        for height in (800, 0):
            height = height or page.js("return document.documentElement.scrollHeight")
            page.show("large", address, width=width, height=height, dark=dark, mobile=width < 500)
        page.settle()
        page.driver.save_screenshot(str(folder / f"{name}.png"))


def begin(driver, programs, folder):
    page = PreviewPage(driver, programs, folder)
    make_files(page)
    return page


if __name__ == "__main__":
    sys.exit(run(__doc__, globals(), begin, screenshots))
