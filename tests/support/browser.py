"""Pages in headless Chromium, opened as files: what the tests of pages share.

Ends with status 77 where there is no browser to ask. Debian 12: apt install chromium chromium-driver python3-selenium
"""
import argparse
import os
import pathlib
import shutil
import sys
import tempfile
import time

DEBIANS_PYTHON = "/usr/bin/python3"  # which has Debian's modules

try:
    from selenium import webdriver
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
    from selenium.webdriver.chrome.options import Options
    from selenium.webdriver.chrome.service import Service
except ImportError:
    if os.path.exists(DEBIANS_PYTHON) and os.path.realpath(sys.executable) != os.path.realpath(DEBIANS_PYTHON):
        os.execv(DEBIANS_PYTHON, [DEBIANS_PYTHON, *sys.argv])
    print("there is no python3-selenium")
    sys.exit(77)

ROOT = pathlib.Path(__file__).resolve().parents[2]

# Texts whose contrast with what lies behind them is below 4.5.
CONTRAST = """
const channel = (v) => (v /= 255, v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
const numbers = (c) => c.match(/[\\d.]+/g).map(Number);
const light = (c) => 0.2126 * channel(c[0]) + 0.7152 * channel(c[1]) + 0.0722 * channel(c[2]);
const behind = (e) => { for (; e; e = e.parentElement) {
  const c = numbers(getComputedStyle(e).backgroundColor);
  if (c.length < 4 || c[3] === 1) return c; } return [255, 255, 255]; };
const low = [];
const texts = "h1, h2, h3, p, dt, dd, button, a, .badge, .instead, .time, .folder, .legend li, pre, li";
for (const e of document.querySelectorAll(texts)) {
  if (!e.textContent.trim() || !e.getClientRects().length || e.disabled) continue;
  const a = light(numbers(getComputedStyle(e).color)), b = light(behind(e));
  const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
  if (ratio < 4.5) low.push(`${e.tagName}.${e.className} ${ratio.toFixed(2)}`);
}
return [...new Set(low)];
"""


class Wrong(Exception):
    """What is not as it should be."""


def expect(is_so, what):
    if not is_so:
        raise Wrong(what)


def equal(found, wanted, what):
    expect(found == wanted, f"{what}: {found!r}, not {wanted!r}")


class Page:
    """A page in a browser; times out where something never comes."""

    def __init__(self, driver, url):
        self.driver, self.url = driver, url

    def open(self, address="", width=1280, height=900, dark=False, mobile=False):
        command = self.driver.execute_cdp_cmd
        command("Emulation.setDeviceMetricsOverride",
                {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": mobile})
        scheme = {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}
        command("Emulation.setEmulatedMedia", {"features": [scheme]})
        self.driver.get("about:blank")
        self.driver.get(self.url + address)

    def js(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def one(self, selector):
        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def wait(self, script, what, *arguments):
        for _ in range(60):
            if self.js(script, *arguments):
                return
            time.sleep(0.05)
        raise Wrong(what)

    def hash(self):
        return self.js("return location.hash")

    def press(self, *keys):
        ActionChains(self.driver).send_keys(*keys).perform()

    def click_filter(self, key):
        self.one(f"#filters button[data-key={key}]").click()

    def scroll_to(self, element):
        self.js("arguments[0].scrollIntoView({block: 'center'})", element)


def browser():
    program, server = shutil.which("chromium"), shutil.which("chromedriver")
    if not program or not server:
        print("there is no chromium with chromium-driver")
        sys.exit(77)
    options = Options()
    options.binary_location = program
    for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(service=Service(server), options=options)


def run(about, module, begin, screenshots):
    """Runs every check_NAME(page) of a module, given as its globals(), and gives the exit status. `begin(driver, bin,
    folder)` makes the files and the page; `screenshots(page, folder)` writes pictures to look at."""
    parser = argparse.ArgumentParser(description=about, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("words", nargs="*", metavar="word")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/release/bin")
    parser.add_argument("--screenshots", type=pathlib.Path, metavar="FOLDER")
    args = parser.parse_args()
    checks = {name[6:]: check for name, check in module.items() if name.startswith("check_")}
    failed = 0
    driver = browser()
    try:
        with tempfile.TemporaryDirectory() as folder:
            page = begin(driver, args.bin.resolve(), pathlib.Path(folder))
            for name, check in checks.items():
                if args.words and not any(word in name for word in args.words):
                    continue
                try:
                    check(page)
                    print(f"{name}: good")
                except Exception as error:  # the next check may tell more
                    failed += 1
                    print(f"{name}: {type(error).__name__}: {error}")
            if args.screenshots:
                screenshots(page, args.screenshots)
    finally:
        driver.quit()
    return 1 if failed else 0
