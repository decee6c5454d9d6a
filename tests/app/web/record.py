#!/usr/bin/env python3
"""usage: record.py PLAYGROUND.html OUT.webp

Records the playground as the animated picture of README.md: a visitor types a number, flips a bit, steps, pastes
formulas, follows the lost carry, and watches half an hour of drift. Needs chromium-driver, python3-selenium and
python3-pil. Prints the size. Status 0: written, 1: larger than GitHub's readers should wait for, 77: a tool is missing.
"""
import io
import pathlib
import sys

sys.dont_write_bytecode = True
if len(sys.argv) != 3:
    sys.exit(__doc__)
OUT = pathlib.Path(sys.argv[2])
sys.argv[1:] = ["record", sys.argv[1], str(OUT.parent)]  # what page.py reads
from page import button, open_page, part, wait
from chromium import browser, media, size, skip
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

try:
    from PIL import Image
except ImportError:
    skip("python3-pil is not installed")

WIDTH, HEIGHT = 800, 560
MOST_BYTES = 400_000
COLOURS = 96


class Film:
    def __init__(self, driver):
        self.driver = driver
        self.frames = []
        self.times = []

    def take(self, milliseconds):
        """Adds what the page shows, for a time."""
        shot = Image.open(io.BytesIO(self.driver.get_screenshot_as_png())).convert("RGB")
        self.frames.append(shot)
        self.times.append(milliseconds)

    def type(self, name, text, first=0):
        """Types a text, and takes a frame for every few keys."""
        box = self.driver.find_element(By.CSS_SELECTOR, f"input[name='{name}']")
        box.send_keys(Keys.CONTROL + "a")
        box.send_keys(Keys.DELETE)
        for at in range(0, len(text), 4):
            box.send_keys(text[at:at + 4])
            if at >= first:
                self.take(160)
        self.driver.execute_script("document.activeElement.blur()")

    def show(self, selector):
        self.driver.execute_script(
            "document.querySelector(arguments[0]).scrollIntoView({block: 'start'}); scrollBy(0, -8)", selector)

    def write(self):
        # One small palette for all frames, which nobody sees, saves a third of the bytes.
        sheet = Image.new("RGB", (WIDTH, HEIGHT * len(self.frames)))
        for i, frame in enumerate(self.frames):
            sheet.paste(frame, (0, HEIGHT * i))
        palette = sheet.quantize(COLOURS, method=Image.Quantize.MEDIANCUT)
        frames = [frame.quantize(palette=palette, dither=Image.Dither.NONE).convert("RGB") for frame in self.frames]
        frames[0].save(OUT, save_all=True, append_images=frames[1:], duration=self.times, loop=0, lossless=True,
                       quality=90, method=4)


def number(film):
    open_page(film.driver, "#view=number&text=0")
    film.take(900)
    film.type("Number", "-1.3")
    film.take(1300)
    film.driver.find_element(By.CSS_SELECTOR, ".bits button[title^='bit 15:']").click()
    film.driver.execute_script("document.activeElement.blur()")
    film.take(1100)
    for _ in range(3):
        button(film.driver, "above").click()
        film.take(450)
    film.take(700)


def formulas(film):
    open_page(film.driver, "#view=operation")
    film.take(1300)
    film.show(".formula")
    film.type("Formula", "a * b >> 16")
    film.take(1700)
    film.type("Formula", "(a * b + 0x8000) >> 16")
    film.take(1900)
    film.type("Formula", "(int32_t)(a * b) >> 16")
    film.take(2200)


def carry(film):
    open_page(film.driver, "#view=cases")
    film.driver.find_element(By.LINK_TEXT, "0.5 + 0.5 = 0").click()
    wait(film.driver, "the trace", lambda: film.driver.find_elements(By.CSS_SELECTOR, ".stepper"))
    film.show(".stepper")
    film.take(1600)
    for _ in range(3):
        button(film.driver, "forward").click()
        film.driver.execute_script("document.activeElement.blur()")
        film.take(900)


def drift(film):
    open_page(film.driver, "#view=scenes&arithmetic=i386-off&against=double&show=other&play=no&frame=108000")
    wait(film.driver, "half an hour", lambda: part(film.driver, "frame") == "108000", 60)
    film.show("#stage")
    film.take(2200)


driver = browser()
try:
    size(driver, WIDTH, HEIGHT)
    media(driver, motion="reduce")
    driver.execute_cdp_cmd("Emulation.setScrollbarsHidden", {"hidden": True})
    recorded = Film(driver)
    for scene in (number, formulas, carry, drift):
        scene(recorded)
finally:
    driver.quit()
recorded.write()
print(f"{OUT}: {len(recorded.frames)} frames, {sum(recorded.times) / 1000:.0f} s, {OUT.stat().st_size:,} bytes")
sys.exit(OUT.stat().st_size > MOST_BYTES)
