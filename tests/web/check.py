#!/usr/bin/env python3
"""usage: check.py CASE PLAYGROUND.html PICTURES

Opens the playground in headless Chromium and looks at one thing, CASE, that must hold; screenshots go to PICTURES.
Status 0: holds, 1: does not, 77: no browser here.
"""
import json
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "browser"))
import chromium
from chromium import browser, violations
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import WebDriverWait

CASE, PAGE, PICTURES = sys.argv[1], pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3])


def open_page(driver, address=""):
    driver.get("about:blank")
    driver.get(PAGE.as_uri() + address)
    WebDriverWait(driver, 20).until(
        lambda d: d.execute_script("return document.documentElement.dataset.drawn ?? ''"))


def picture(driver, name):
    chromium.picture(driver, PICTURES / f"{name}.png", whole=False)


def expect(holds, what):
    chromium.expect(holds, f"{CASE}: {what}")


def expect_equal(is_, wanted, what):
    expect(is_ == wanted, f"{what}: {is_!r}, not {wanted!r}")


def text(driver, selector):
    return driver.find_element(By.CSS_SELECTOR, selector).get_attribute("textContent")


def cells(driver, table, name):
    """The cells of the row with this name."""
    rows = driver.execute_script("""
        return [...document.querySelectorAll(arguments[0] + ' tbody tr')].map(
          (row) => [...row.children].map((cell) => (cell.querySelector('[title]:not(.agrees)')?.title ?? cell.textContent).trim()))""",
                                 table)
    return next(row for row in rows if row[0] == name)


def size_(driver):
    """Small, quick, and nothing asked of the network."""
    expect(PAGE.stat().st_size < 300_000, f"{PAGE.stat().st_size} bytes")
    open_page(driver)
    started = driver.execute_script("return performance.getEntriesByName('started')[0].startTime")
    print(f"{PAGE.stat().st_size} bytes, drawn after {started:.0f} ms")
    expect(started < 1000, f"drawn after {started:.0f} ms")
    asked = []
    for entry in driver.get_log("performance"):
        message = json.loads(entry["message"])["message"]
        if message["method"] == "Network.requestWillBeSent":
            asked.append(message["params"]["request"]["url"].split("#")[0])
    beyond = [url for url in asked if not url.startswith(("data:", "about:", "blob:"))]
    expect_equal(set(beyond), {PAGE.as_uri()}, "what was asked for")
    wrong = [e for e in driver.get_log("browser") if e["level"] in ("SEVERE", "WARNING")]
    expect(not wrong, f"the console says {wrong}")


def policy(driver):
    """The policy blocks every script and style that is not the page's own."""
    run = "document.documentElement.dataset.injected = 'yes'"
    injected = {"script-src-elem": f"<script>{run}</script>", "script-src-attr": f'<svg onload="{run}"></svg>',
                "style-src-elem": "<style>h1 { opacity: 0.5 }</style>",
                "style-src-attr": '<p style="opacity: 0.5">styled</p>', "img-src": '<img src="elsewhere.png" alt="">'}
    page = PAGE.read_text()
    for directive, html in injected.items():
        file = PICTURES / "injected.html"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(page.replace("<main", f"{html}<main", 1))
        driver.get(file.as_uri())
        WebDriverWait(driver, 20).until(lambda d: d.execute_script("return document.documentElement.dataset.drawn ?? ''"))
        expect_equal([b.split()[0] for b in violations(driver)], [directive], f"what is blocked of {html}")
        expect_equal(driver.execute_script("return document.documentElement.dataset.injected ?? 'no'"), "no", "ran")


def bits(driver):
    """Text, bits and table agree; arrow keys and the space bar flip a bit; the address keeps the number."""
    open_page(driver, "#view=number&text=1.5")
    expect_equal(cells(driver, "section:first-of-type", "q16_16")[1:4], ["00018000", "1.5", "0"], "1.5 in q16_16")
    # 1.5 needs a bit that q8_0 does not have: a half goes up.
    expect_equal(cells(driver, "section:first-of-type", "q8_0")[1:5], ["02", "2", "0.5", "0.5"], "1.5 in q8_0")
    expect("out of range" in cells(driver, "section:first-of-type", "u0_8")[1], "1.5 in u0_8")
    driver.execute_script("document.querySelector('.bits button').focus()")
    ActionChains(driver).send_keys(Keys.END).send_keys(Keys.ARROW_LEFT).send_keys(Keys.SPACE).perform()
    # 2 units above 1.5, and one unit below and above that.
    expect_equal(cells(driver, "section:first-of-type", "q16_16")[1:],
                 ["00018002", "1.500030517578125", "0", "0", "1.5000152587890625", "1.5000457763671875", "agree"],
                 "bit 1 flipped")
    expect("0x00018002" in driver.current_url, f"the address is {driver.current_url}")
    box = driver.find_element(By.CSS_SELECTOR, "input[name=Number]")
    box.clear()
    box.send_keys("-32768.00001")
    # 0.66 units below the lowest number is nearer to the number below it, which does not exist.
    expect("out of range" in cells(driver, "section:first-of-type", "q16_16")[1], "below the lowest word")
    box.send_keys("x")
    expect("Not a number" in text(driver, ".problem"), "an error for letters")


CASES = {"size": size_, "policy": policy, "bits": bits}
driver = browser()
try:
    CASES[CASE](driver)
    if CASE != "policy":
        expect_equal(violations(driver), [], "what the policy blocks of the page itself")
finally:
    driver.quit()
print(f"{CASE}: holds")
