#!/usr/bin/env python3
"""The page of lentray-chart in headless Chromium, opened as a file: the chart that reacts, what it chooses, filters and
sorting, keys, two pictures compared, narrow and wide windows, light and dark.

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
from browser import CONTRAST, ActionChains, Keys, Page, equal, expect, run  # noqa: E402

SETTINGS = 24
FIRST_OF_FRONT = "quality-1"
NARROW, WIDE = 390, 1280


class ChartPage(Page):
    """The page of a chart."""

    def rows(self):
        """Ids of the rows that are shown, in their order."""
        return self.js("""return [...document.querySelectorAll('#settings tbody tr:not([hidden])')]
            .map(e => e.dataset.id)""")

    def shown(self):
        return self.one("#detail-name").text

    def hit(self, name):
        """The circle of a setting in the chart that is seen."""
        return self.js("""return [...document.querySelectorAll(`.hit[data-id='${arguments[0]}']`)]
            .find(e => e.getClientRects().length && e.getBoundingClientRect().width)""", name)

    def hover(self, name):
        hit = self.hit(name)
        self.scroll_to(hit)
        ActionChains(self.driver).move_to_element(hit).perform()

    def click_hit(self, name):
        hit = self.hit(name)
        self.scroll_to(hit)
        ActionChains(self.driver).move_to_element(hit).click().perform()

    def kept(self):
        return self.js("return [...document.querySelectorAll('#settings tr.is-kept')].map(e => e.dataset.id)")

    def type(self, selector, text):
        field = self.one(selector)
        self.scroll_to(field)
        field.clear()
        field.send_keys(text)

    def sort(self, column):
        self.js("document.querySelectorAll('#settings thead button')[arguments[0]].click()", column)


def check_head(page):
    page.open()
    equal(page.driver.title, "a <scene>.pov: speed against accuracy", "title")
    text = page.one("body").text
    for words in ("23 of 24 settings are measured, 1 failed.", "320 × 240", "14.00 s", "converged",
                  "The pictures have random noise: the scene has jitter", "lentray 'a scene.pov' +W320 +H240",
                  "4 samples", "Errors from 0.100 on are distinguished"):
        expect(words in text, f"no '{words}' on the page")
    equal(page.js("return window.harm"), None, "script of a setting's name ran")
    equal(len(page.rows()), SETTINGS, "rows")


def check_hover_shows(page):
    page.open()
    equal(page.shown(), "your options", "at first")
    page.hover("aa-1-3")
    equal(page.shown(), "antialiasing, method 1, 3 x 3 samples", "under the pointer")
    detail = page.one("#detail").text
    for words in ("8.30 s (7.47 s to 9.96 s, 3 runs)", "3.95 ×", "1.10 / 255", "47.3 dB", "5.50 % of the pixels",
                  "on the front", "Butteraugli", "lentray 'a scene.pov' +W320 +H240 +Xaa-1-3"):
        expect(words in detail, f"no '{words}' in {detail}")
    page.wait("const i = document.querySelector('.stage img'); return i.complete && i.naturalWidth === 320",
              "its picture")
    first = page.js("return document.querySelector('.stage img').src")
    for name in ("Difference × 8", "Reference"):
        page.js("""[...document.querySelectorAll('#detail .choice button')]
            .find(e => e.textContent === arguments[0]).click()""", name)
        page.wait("const i = document.querySelector('.stage img'); return i.complete && i.naturalWidth === 320", name)
        expect(page.js("return document.querySelector('.stage img').src") != first, f"{name} is another picture")
    page.hover("area-1")
    equal(page.js("return document.querySelector('#detail .choice [aria-pressed=true]').textContent"), "Reference",
          "what is looked at stays")
    equal(page.kept(), [], "pointing keeps nothing")
    button = page.one("#detail .facts .plain")
    page.scroll_to(button)
    button.click()
    page.wait("return document.querySelector('#detail .facts .plain').textContent === 'Copied'",
              "the command is copied")


def check_click_keeps(page):
    page.open()
    page.click_hit("aa-1-2")
    equal(page.kept(), ["aa-1-2"], "a click keeps")
    equal(page.js("return [left.value, right.value]"), ["aa-1-2", "reference"], "compared with the reference")
    page.click_hit("quality-4")
    equal(sorted(page.kept()), ["aa-1-2", "quality-4"], "two")
    equal(page.js("return [left.value, right.value]"), ["aa-1-2", "quality-4"], "compared with each other")
    equal(page.hash(), "#left=aa-1-2&right=quality-4", "address")
    page.click_hit("media-2")
    equal(sorted(page.kept()), ["media-2", "quality-4"], "the first goes")
    page.click_hit("media-2")
    equal(page.kept(), ["quality-4"], "another click lets it go")
    page.press(Keys.ESCAPE)
    equal(page.kept(), [], "Escape lets all go")


def check_tap(page):
    page.open(width=NARROW, height=800, mobile=True)
    hit = page.hit("aa-1-5")
    page.scroll_to(hit)
    at = page.js("""const r = arguments[0].getBoundingClientRect();
        return [r.left + r.width / 2, r.top + r.height / 2]""", hit)
    for kind, points in (("touchStart", [{"x": at[0], "y": at[1]}]), ("touchEnd", [])):
        page.driver.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
    page.wait("return document.getElementById('detail-name').textContent.includes('5 x 5')", "a tap shows")


def check_keys(page):
    page.open()
    chart = page.js("return document.querySelector('.for-wide .chart')")
    page.js("arguments[0].querySelector('.hit[tabindex=\"0\"]').focus()", chart)
    equal(page.shown(), "quality 1: no shadows", "the focus shows the fastest")
    page.press(Keys.ARROW_RIGHT)
    equal(page.shown(), "quality 4: shadows, no area lights", "the next slower one")
    page.press(Keys.END)
    equal(page.shown(), "antialiasing, method 1, 9 x 9 samples", "the slowest")
    page.press(Keys.ENTER)
    equal(page.kept(), ["aa-1-9"], "Enter keeps")
    page.press(Keys.HOME)
    equal(page.shown(), "quality 1: no shadows", "the fastest again")
    equal(page.js("return arguments[0].querySelectorAll('.hit[tabindex=\"0\"]').length", chart), 1, "one stop for Tab")


def check_choice(page):
    page.open()
    page.type("#budget", "5s")
    chosen = page.one("#chosen").text
    expect("antialiasing, method 1, 2 x 2 samples: 4.60 s, error 2.00 / 255." in chosen, chosen)
    expect("+Xaa-1-2" in chosen, "its command: " + chosen)
    page.type("#budget", "0.1 min")
    expect("method 2, depth 2: 5.20 s" in page.one("#chosen").text, page.one("#chosen").text)
    page.type("#budget", "100ms")
    expect("Nothing is as fast. The fastest, quality 1: no shadows, takes 400 ms." in page.one("#chosen").text,
           page.one("#chosen").text)
    page.type("#budget", "soon")
    expect("A time is expected" in page.one("#chosen").text, page.one("#chosen").text)
    page.one("#budget").clear()
    page.type("#limit", "2.5")
    expect("Within 2.5 / 255" in page.one("#chosen").text and "3.10 s, error 2.40" in page.one("#chosen").text,
           page.one("#chosen").text)
    page.type("#limit", "0.01")
    expect("Nothing is as exact." in page.one("#chosen").text, page.one("#chosen").text)
    page.type("#limit", "0.07")
    expect("does not tell apart" in page.one("#chosen").text, page.one("#chosen").text)
    page.type("#limit", "x")
    expect("An error in 1/255 is expected" in page.one("#chosen").text, page.one("#chosen").text)
    page.open("#budget=5s&error=2.5")
    expect(page.one("#chosen").text.count("Command") == 2, "from the address")


def check_choice_is_the_best(page):
    """Against all settings, for many budgets; exact ones last."""
    page.open()
    known = page.js("""return JSON.parse(document.getElementById('data').textContent).points
        .filter(p => p.choosable).map(p => [p.id, p.seconds, p.error.rms, p.label, p.kind == "exact" && !p.plain])""")
    for budget in (0.4, 0.5, 1.3, 2.0, 2.1, 3.3, 5.0, 9.0, 10.0, 30.0, 100.0):
        page.js("""const f = document.getElementById('budget'); f.value = arguments[0];
            f.dispatchEvent(new Event('input', {bubbles: true}))""", str(budget))
        best = min((p for p in known if p[1] <= budget), key=lambda p: (p[2], p[4], p[1]))
        equal(page.js("return document.querySelector('#chosen .go').textContent"), best[3], f"within {budget} s")


def check_filters(page):
    page.open()
    for key, count in (("front", 16), ("antialiasing", 7), ("exact", 6), ("failed", 1), ("all", SETTINGS)):
        page.click_filter(key)
        equal(len(page.rows()), count, f"rows with the filter {key}")
        equal(page.hash(), "" if key == "all" else f"#kind={key}", "address")
    page.click_filter("antialiasing")
    dim = "return document.querySelectorAll(`.series.is-dim[data-kind='${arguments[0]}']`).length"
    equal(page.js(dim, "antialiasing"), 0, "its symbols stay")
    expect(page.js(dim, "media") > 0, "others stand back")
    page.click_filter("all")
    equal(page.js("return document.querySelectorAll('.series.is-dim').length"), 0, "all are there again")
    page.type("#search", "method 1, 5")
    equal(page.rows(), ["aa-1-5"], "search")
    page.open("#kind=nonsense&left=nothing")
    equal(len(page.rows()), SETTINGS, "an address that says nothing")


def check_sorting(page):
    page.open()
    page.sort(2)
    equal(page.rows()[0], FIRST_OF_FRONT, "the fastest first")
    equal(page.rows()[-1], "failed", "without a time: last")
    page.sort(2)
    equal(page.rows()[0], "aa-1-9", "the slowest first")
    equal(page.rows()[-1], "failed", "without a time: last, too")
    equal(page.js("return document.querySelectorAll('#settings thead th')[2].getAttribute('aria-sort')"), "descending",
          "what is told of it")
    page.sort(3)
    equal(page.rows()[0], "aa-1-9", "the least error first")
    page.sort(1)
    equal(page.rows()[0][:3], "aa-", "by kind")


def check_table_leads_to_the_panel(page):
    page.open()
    page.js("document.querySelector('.go[data-go=lost]').click()")
    equal(page.shown(), "a picture that is not there", "a row's name shows it")
    expect("No picture to show." in page.one("#detail").text, page.one("#detail").text)
    expect("lost.png" in page.one(".stage").text, "and why: " + page.one(".stage").text)
    page.js("document.querySelector('.go[data-go=failed]').click()")
    detail = page.one("#detail").text
    expect("failed" in detail and "<script>window.harm=2</script> is no option" in detail, detail)
    equal(page.js("return document.querySelectorAll('#detail .stage').length"), 0, "no picture of what failed")
    page.js("document.querySelector('.go[data-go=area-16]').click()")
    page.js("[...document.querySelectorAll('#detail .go')][0].click()")
    equal(page.shown(), "a picture that is not there", "to the one that is better")
    rows = page.js("return [...document.querySelectorAll('#settings tr')].map(e => e.textContent).join('\\n')")
    for words in ("on the front", "error not distinguished", "same picture", "NOT the plain picture", "failed: <script>"):
        expect(words in rows, f"no '{words}' in the table")


def check_comparison(page):
    page.open("#left=aa-1-2&right=stock:plain")
    equal(page.js("return [left.value, right.value]"), ["aa-1-2", "stock:plain"], "from the address")
    page.wait("return [...document.querySelectorAll('.rub img')].filter(i => i.naturalWidth === 320).length === 2",
              "two pictures")
    clip = "return document.querySelectorAll('.rub img')[1].style.clipPath"
    equal(page.js(clip), "inset(0px 50% 0px 0px)", "half of the left one")
    rub = page.one("#rub")
    page.scroll_to(rub)
    width = rub.size["width"]
    drag = ActionChains(page.driver).move_to_element(rub).click_and_hold()
    drag.move_by_offset(round(width / 4), 0).release().perform()
    part = float(page.js(clip).split()[1].rstrip("%"))
    expect(23 < part < 27, f"after a drag of a quarter {part} % are hidden")
    split = page.one("#split")
    split.send_keys(Keys.HOME)
    equal(page.js(clip), "inset(0px 100% 0px 0px)", "by keys")
    page.js("document.querySelectorAll('#zoom button')[3].click()")
    equal(rub.size["width"], 4 * 320, "four times")
    equal(page.js("const a = document.querySelector('.rub-around'); return a.scrollWidth > a.clientWidth"), True,
          "it scrolls within its box")
    facts = page.one("#compare-facts").text
    expect("4.60 s, error 2.00 / 255" in facts and "POV-Ray, your options" in facts, facts)


def check_loads_nothing(page):
    page.open()
    time.sleep(0.3)
    loaded = page.js("return performance.getEntriesByType('resource').map(e => e.name)")
    expect(all(name.startswith("data:") for name in loaded), f"loaded: {loaded}")
    complaints = [entry["message"] for entry in page.driver.get_log("browser") if entry["level"] == "SEVERE"]
    equal(complaints, [], "complaints of the browser")


def check_widths(page):
    for width in (320, NARROW, 700, 1000, WIDE, 1920):
        page.open(width=width, height=800, mobile=width < 500)
        equal(page.js("return document.documentElement.scrollWidth"), width, f"it scrolls sideways at {width}")
        charts = page.js("""return [...document.querySelectorAll('.chart')].filter(e => e.getClientRects().length)
            .map(e => Math.round(e.getBoundingClientRect().width))""")
        equal(len(charts), 2, f"charts at {width}")
        expect(all(250 < one <= min(width, 900) for one in charts), f"charts of {charts} pixels at {width}")
        size = page.js("""return Math.min(...[...document.querySelectorAll('.chart')]
            .filter(e => e.getClientRects().length).flatMap(e => [...e.querySelectorAll('text')])
            .map(e => e.getBoundingClientRect().height))""")
        expect(size >= 8.9, f"text of {size} pixels in the chart at {width}")
        beside = page.js("""const a = document.querySelector('.column .box').getBoundingClientRect(),
            b = document.getElementById('detail').getBoundingClientRect(); return b.left >= a.right""")
        equal(beside, width >= 1000, f"the panel beside the chart at {width}")


def check_contrast(page):
    for dark in (False, True):
        for address in ("", "#kind=failed", "#budget=5s&error=0.001"):
            page.open(address, dark=dark)
            if address == "#kind=failed":
                page.js("document.querySelector('.go[data-go=failed]').click()")
            equal(page.js(CONTRAST), [], f"contrast below 4.5 ({'dark' if dark else 'light'}, {address})")
        symbols = page.js("""const channel = (v) => (v /= 255, v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
            const light = (c) => { const n = c.match(/[\\d.]+/g).map(Number);
              return 0.2126 * channel(n[0]) + 0.7152 * channel(n[1]) + 0.0722 * channel(n[2]); };
            const back = light(getComputedStyle(document.querySelector('.box')).backgroundColor);
            return [...document.querySelectorAll('.for-wide .series use')].map(e => {
              const fore = light(getComputedStyle(e).color);
              return [getComputedStyle(e).color, (Math.max(fore, back) + 0.05) / (Math.min(fore, back) + 0.05)]; })
              .filter(([, ratio]) => ratio < 3)""")
        equal(symbols, [], f"symbols of low contrast ({'dark' if dark else 'light'})")


def check_labels(page):
    page.open()
    kinds = "button, a, input, select, [role=button], [role=img], svg.chart"
    script = """return [...document.querySelectorAll(arguments[0])].filter(e => !(e.textContent.trim() &&
        e.tagName !== 'svg') && !e.getAttribute('aria-label') && !e.labels?.length)
        .map(e => e.outerHTML.slice(0, 80))"""
    equal(page.js(script, kinds), [], "controls without a name")
    ids = page.js("return [...document.querySelectorAll('[id]')].map(e => e.id)")
    equal(sorted(ids), sorted(set(ids)), "ids that are there twice")


def write_page(test_program, folder):
    run = subprocess.run([test_program, "--gtest_filter=UnitChartPageForBrowser.Write"], check=False, text=True,
                         env={**os.environ, "LENTRAY_PAGE_FOLDER": str(folder)}, capture_output=True)
    if run.returncode != 0 or not (folder / "index.html").exists():
        sys.exit(f"{test_program} writes no page:\n{run.stdout}{run.stderr}")


def screenshots(page, folder):
    folder.mkdir(parents=True, exist_ok=True)
    for name, width, dark in (("wide", WIDE, False), ("narrow", NARROW, False), ("wide-dark", 1920, True),
                              ("narrow-dark", NARROW, True)):
        page.open("#budget=5s", width, 800, dark, width == NARROW)
        height = page.js("return document.documentElement.scrollHeight")
        page.open("#budget=5s", width, height, dark, width == NARROW)
        time.sleep(0.5)
        page.driver.save_screenshot(str(folder / f"{name}.png"))


def begin(driver, programs, folder):
    write_page(programs / "test_unit", folder)
    return ChartPage(driver, (folder / "index.html").as_uri())


if __name__ == "__main__":
    sys.exit(run(__doc__, globals(), begin, screenshots))
