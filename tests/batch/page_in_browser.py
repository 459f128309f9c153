#!/usr/bin/env python3
"""The page of lentray-batch in headless Chromium, opened as a file: what it shows, filters, its address,
looking tilted, keys, narrow and wide windows, light and dark.

    page_in_browser.py [--bin build/release/bin] [--screenshots FOLDER] [word ...]

The page is written by test_unit. With words only the checks whose name has one.
Debian 12: apt install chromium chromium-driver python3-selenium
Status: 0 all as it should be, 1 something is not, 77 there is no browser to ask.
"""
import os
import pathlib
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from browser import CONTRAST, By, ActionChains, Keys, Page, Wrong, equal, expect, run  # noqa: E402

# Red of column j in the views of the scene lens/five, from the left eye's view to the right eye's.
REDS = [200, 160, 120, 80, 40]
CARDS = 10


class BatchPage(Page):
    """The page of a batch."""

    def names(self):
        """Of the cards that are shown, in their order."""
        return self.js("return [...document.querySelectorAll('.card:not([hidden]) .caption')].map(e => e.title)")

    def is_open(self):
        return self.js("return document.getElementById('detail').open")

    def card(self, name):
        return self.js("""return [...document.querySelectorAll('.card')]
            .find(e => e.querySelector('.caption').title === arguments[0])""", name)

    def red_of(self, box, wanted, what):
        """The red of the canvas in the middle becomes that."""
        script = """const c = arguments[0].querySelector('canvas'); if (!c) return -1;
            return c.getContext('2d').getImageData(c.width >> 1, c.height >> 1, 1, 1).data[0]"""
        for _ in range(60):
            red = self.js(script, box)
            if abs(red - wanted) <= 10:
                return
            time.sleep(0.05)
        raise Wrong(f"{what}: red {red}, not {wanted}")


def check_head_and_cards(page):
    page.open()
    equal(page.driver.title, "Scenes <of> a test", "title")
    equal(len(page.names()), CARDS, "cards")
    head = page.one(".head").text
    for words in ("Scenes <of> a test", "10 scenes, 13 pictures. Stopped: 12 of 13 pictures so far.", "1 of 7 sheets jumps.", "5 min 20 s", "1 differs"):
        expect(words in head, f"no '{words}' in the headline: {head}")
    bad = page.js("return document.querySelector('.card.is-failed').innerText")
    expect("<script>window.harm=2</script> is no scene" in bad, "a failed card tells why: " + bad)
    equal(page.js("return window.harm"), None, "script of a scene's name ran")
    expect("No picture to show" in page.card("plain/gone").text, "a picture that is not there")
    badges = page.card("lens/tall").find_elements(By.CSS_SELECTOR, ".badge")
    equal([(badge.text, badge.get_attribute("title")) for badge in badges],
          [("jumps", "the <b>background</b> moves by 3.1 pixels a view"), ("1 warning", "1 warning")], "badges of kinds")
    expect("not rendered yet" in page.card("plain/later").text, "a picture that waits")
    expect("left out: media" in page.card("compared/one").text, "what is left out")


def check_filters_and_address(page):
    page.open()
    for key, count in (("failed", 1), ("skipped", 1), ("waiting", 1), ("warned", 2), ("jumps", 1), ("slow", 1), ("differs", 1), ("all", CARDS)):
        page.click_filter(key)
        equal(len(page.names()), count, f"cards with the filter {key}")
        equal(page.hash(), "" if key == "all" else f"#filter={key}", "address")
        equal(page.js("return [...document.querySelectorAll('#filters [aria-pressed=true]')].map(e => e.dataset.key)"),
            [key],
              "pressed")
    page.one("#search").send_keys("dull")
    equal(page.names(), ["plain/first scene"], "search in messages")
    equal(page.hash(), "#search=dull", "address of a search")
    page.one("#search").send_keys("xyz")
    expect(page.one("#none").is_displayed(), "nothing fits, and it is said")
    page.one("#reset").click()
    equal(len(page.names()), CARDS, "cards after showing all")


def check_order(page):
    page.open("#sort=time")
    equal(page.names()[0], "plain/slow", "the slowest comes first")
    page.open("#sort=grade")
    equal(page.names()[0], "compared/one", "the worst grade comes first")
    page.open("#sort=name")
    equal(page.names(), sorted(page.names()), "by name")
    page.open("#sort=nonsense&filter=nothing&scene=none")
    equal(len(page.names()), CARDS, "an address that says nothing")


def check_link_opens_scene(page):
    page.open("#filter=slow&scene=moving%2Ffilm&frame=3")
    expect(page.is_open(), "the scene is open")
    equal(page.one("#detail-name").text, "moving/film", "its name")
    expect("film3.png" in page.one(".facts").text, "its frame")
    equal(page.names(), ["plain/slow"], "the filter")
    page.press(Keys.ESCAPE)
    expect(not page.is_open(), "Escape closes")
    equal(page.hash(), "#filter=slow", "address afterwards")


def check_detail_and_keys(page):
    page.open()
    page.one(".card .open").click()
    expect(page.is_open(), "a click opens the scene")
    equal(page.hash(), "#scene=plain%2Ffirst+scene", "address")
    page.wait("""const i = document.querySelector('.stage img');
        return i.complete && i.naturalWidth === 160 && i.src.includes('first%20scene.png')""",
              "the file itself is shown")
    text = page.one("#detail-body").text
    for words in ("first.pov:3: warning: dull", "cd /scenes/plain && lentray 'first scene.pov' +W160 'it'\\''s'",
        "160 × 120 pixels", "1 file"):
        expect(words in text, f"no '{words}' in: {text}")
    page.one("details summary").click()
    page.wait("return document.querySelector('details').innerText.includes('/scenes/plain/first scene.pov')",
        "files on demand")
    page.one("#detail .plain").click()
    page.wait("return document.querySelector('#detail .plain').textContent === 'Copied'", "the command is copied")
    page.press(Keys.ARROW_RIGHT)
    equal(page.one("#detail-name").text, "lens/five", "the next scene")
    page.press(Keys.ARROW_LEFT)
    equal(page.one("#detail-name").text, "plain/first scene", "the one before")
    page.press(Keys.ARROW_LEFT)
    equal(page.one("#detail-name").text, "plain/first scene", "before the first")
    page.press(Keys.ESCAPE)
    expect(not page.is_open(), "Escape closes")
    equal(page.js("return document.activeElement.className"), "open", "the focus is on the card again")
    page.driver.back()
    page.wait("return true", "")
    expect(not page.is_open(), "closed after going back")


def check_tilt_by_pointer(page):
    page.open()
    box = page.js("return arguments[0].querySelector('.tilts')", page.card("lens/five"))
    page.scroll_to(box)
    width = box.size["width"]
    for part, red in ((0.02, REDS[0]), (0.3, REDS[1]), (0.5, REDS[2]), (0.7, REDS[3]), (0.98, REDS[4])):
        ActionChains(page.driver).move_to_element_with_offset(box, round((part - 0.5) * width), 0).perform()
        page.red_of(box, red, f"the pointer at {part} of the width")
    expect(not page.is_open(), "looking opens nothing")


def check_tilt_by_touch(page):
    page.open(width=360, height=740, mobile=True)
    box = page.js("return arguments[0].querySelector('.tilts')", page.card("lens/five"))
    page.scroll_to(box)
    area = page.js("const r = arguments[0].getBoundingClientRect(); return [r.left, r.top + r.height / 2, r.width]",
        box)
    touch = lambda kind, points: page.driver.execute_cdp_cmd("Input.dispatchTouchEvent",
        {"type": kind, "touchPoints": points})
    touch("touchStart", [{"x": area[0] + area[2] / 2, "y": area[1]}])
    for part in (0.6, 0.7, 0.8, 0.95):
        touch("touchMove", [{"x": area[0] + area[2] * part, "y": area[1]}])
    page.red_of(box, REDS[4], "a finger that went right")
    touch("touchEnd", [])
    time.sleep(0.1)
    expect(not page.is_open(), "a drag is no tap")


def check_tilt_by_keys_and_device(page):
    page.open("#scene=lens/five")
    box = page.one(".stage .tilts")
    page.red_of(box, REDS[2], "the middle view at first")
    page.js("arguments[0].focus()", box)
    page.press(Keys.ARROW_LEFT)
    page.red_of(box, REDS[1], "a step to the left")
    equal(box.get_attribute("aria-valuetext"), "view 2 of 5", "what is told of it")
    page.press(Keys.END)
    page.red_of(box, REDS[4], "the last view")
    equal(page.one("#detail-name").text, "lens/five", "the keys stay with the picture")
    turn = "window.dispatchEvent(new DeviceOrientationEvent('deviceorientation', {gamma: arguments[0], beta: 0}))"
    page.js(turn, 30)
    page.red_of(box, REDS[0], "the device turned right")
    page.js(turn, 0)
    page.red_of(box, REDS[2], "the device straight")
    equal(page.js("const r = arguments[0].getBoundingClientRect(); return Math.round(100 * r.width / r.height)", box),
        133, "proportions")
    page.js("document.querySelectorAll('.choice button')[1].click()")
    page.wait("const i = document.querySelector('.stage img'); return i.complete && i.naturalWidth === 400",
        "the integral image itself")


def check_animation(page):
    page.open()
    card = page.card("moving/film")
    page.scroll_to(card)
    slider = card.find_element(By.CSS_SELECTOR, "input[type=range]")
    equal(slider.get_attribute("max"), "3", "the slider's end")
    page.wait("return arguments[0].querySelector('img').src.startsWith('data:')", "the first frame", card)
    before = page.js("return arguments[0].querySelector('img').src", card)
    slider.send_keys(Keys.END)
    expect(page.js("return arguments[0].querySelector('img').src", card) != before, "another frame is shown")
    card.find_element(By.CSS_SELECTOR, ".frames button").click()
    page.wait("return arguments[0].value === '1'", "it plays", slider)
    equal(card.find_element(By.CSS_SELECTOR, ".frames button").get_attribute("aria-label"), "Pause", "the button")


def check_comparison(page):
    page.open("#scene=compared/one")
    text = page.one("#detail-body").text
    for words in ("differs", "31.20 dB", "2.0", "7.00 ×", "stock", "difference", "32 and more"):
        expect(words in text, f"no '{words}' in: {text}")
    page.wait("""return [...document.querySelectorAll('.compared img')]
        .filter(i => i.complete && i.naturalWidth === 160).length === 3""", "three pictures")
    page.js("[...document.querySelectorAll('.choice button')].find(e => e.textContent === 'Difference').click()")
    page.wait("return document.querySelector('.stage img').src.endsWith('difference/one.png')", "the difference, large")


def check_loads_only_files(page):
    page.open("#scene=compared/one")
    time.sleep(0.3)
    loaded = page.js("return performance.getEntriesByType('resource').map(e => e.name)")
    expect(all(name.startswith(("file:", "data:")) for name in loaded), f"loaded: {loaded}")
    complaints = [entry["message"] for entry in page.driver.get_log("browser")
                  if entry["level"] == "SEVERE" and "ERR_FILE_NOT_FOUND" not in entry["message"]]
    equal(complaints, [], "complaints of the browser")


def check_widths(page):
    for width, least, most in ((360, 2, 2), (768, 3, 3), (1920, 7, 8)):
        page.open(width=width, height=800, mobile=width == 360)
        expect(page.js("return document.documentElement.scrollWidth") <= width, f"it scrolls sideways at {width}")
        tops = page.js("""return [...document.querySelectorAll('.card')]
            .map(e => Math.round(e.getBoundingClientRect().top))""")
        expect(least <= tops.count(tops[0]) <= most, f"{tops.count(tops[0])} cards a row at {width}")
        for scene in page.names():
            page.js("location.hash = '#' + new URLSearchParams({scene: arguments[0]})", scene)
            page.wait("return document.getElementById('detail').open", f"{scene} opens")
            inside = page.js("const b = document.getElementById('detail-body'); return b.scrollWidth - b.clientWidth")
            expect(inside <= 0, f"the panel of {scene} scrolls sideways at {width}")
            expect(page.js("return document.documentElement.scrollWidth") <= width,
                f"{scene} makes it scroll at {width}")


def check_contrast(page):
    for dark in (False, True):
        for address in ("", "#scene=compared/one", "#scene=lens/five", "#scene=plain/first+scene", "#filter=failed"):
            page.open(address, dark=dark)
            equal(page.js(CONTRAST), [], f"contrast below 4.5 ({'dark' if dark else 'light'}, {address})")


def check_labels(page):
    page.open("#scene=moving/film")
    script = """return [...document.querySelectorAll('button, a, input, select, [role=slider], [role=img]')].filter(e =>
        !(e.textContent.trim() || e.getAttribute('aria-label') || e.labels?.length)).map(e => e.outerHTML)"""
    equal(page.js(script), [], "controls without a name")


def write_page(test_program, folder):
    run = subprocess.run([test_program, "--gtest_filter=UnitBatchPageForBrowser.Write"], check=False, text=True,
                         env={**os.environ, "LENTRAY_PAGE_FOLDER": str(folder)}, capture_output=True)
    if run.returncode != 0 or not (folder / "index.html").exists():
        sys.exit(f"{test_program} writes no page:\n{run.stdout}{run.stderr}")


def screenshots(page, folder):
    folder.mkdir(parents=True, exist_ok=True)
    for name, address, width, height, dark in (("wide", "", 1920, 1080, False), ("narrow", "", 360, 780, False),
                                               ("wide-dark", "#scene=lens/five", 1920, 1080, True),
                                               ("narrow-dark", "#scene=compared/one", 360, 780, True)):
        page.open(address, width, height, dark, width == 360)
        time.sleep(0.5)
        page.driver.save_screenshot(str(folder / f"{name}.png"))


def begin(driver, programs, folder):
    write_page(programs / "test_unit", folder)
    return BatchPage(driver, (folder / "index.html").as_uri())


if __name__ == "__main__":
    sys.exit(run(__doc__, globals(), begin, screenshots))
