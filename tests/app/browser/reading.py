"""What helps to read the page: names, labels, pictures that stand still, tables that are folded."""
import base64
import hashlib
import json
import shutil
import subprocess
import tarfile

from chromium import media, size
from report_page import DATA, PICTURES, expect, expect_equal, open_page, with_data
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

# Elements that have neither a role nor content of their own may have no aria-label.
PROHIBITED = """
    return [...document.querySelectorAll('[aria-label]:not([role])')].filter((e) => e.getAttribute('aria-label') &&
      ['g', 'div', 'span', 'p', 'code', 'path'].includes(e.localName)).map((e) => e.outerHTML.slice(0, 60))"""
AXE = "axe-core-4.10.2.tgz"
AXE_SHA512 = "RE3mdQ7P3FRSe7eqCWoeQ/Z9QXrtniSjp1wUjt5nRC3WIpz5rSCve6o3fsZ2aCpJtrZjSZgjwXAoTO5k4tEI0w=="


def axe_core():
    """Returns the script of axe-core from npm; empty without npm or network."""
    file = PICTURES / AXE
    file.parent.mkdir(parents=True, exist_ok=True)
    if not file.exists() and shutil.which("npm"):
        subprocess.run(["npm", "pack", "--silent", "axe-core@4.10.2"], cwd=file.parent, timeout=60, check=False,
                       stdout=subprocess.DEVNULL)
    if not file.exists():
        print("axe-core could not be fetched")
        return ""
    digest = base64.b64encode(hashlib.sha512(file.read_bytes()).digest()).decode()
    expect_equal(digest, AXE_SHA512, "the digest of axe-core")
    with tarfile.open(file) as packed:
        return packed.extractfile("package/axe.min.js").read().decode()


def labels(driver):
    """Only what may have a name has one, also while a tip is shown; axe-core finds nothing, where npm has it."""
    axe = axe_core()
    for width in (1000, 360):
        size(driver, width, 900, mobile=width == 360)
        open_page(driver)
        driver.execute_script("document.querySelector('#trade .chart > svg').focus({focusVisible: true})")
        ActionChains(driver).send_keys(Keys.ARROW_RIGHT).perform()
        expect_equal(driver.execute_script(PROHIBITED), [], "names that are not allowed")
        if not axe:
            continue
        driver.execute_cdp_cmd("Runtime.evaluate", {"expression": axe})
        found = driver.execute_async_script("""
            const done = arguments[0];
            axe.run().then(({ violations }) => done(violations.map((v) =>
              `${v.id} on ${v.nodes.length} nodes, such as ${v.nodes[0].html.slice(0, 100)}`)),
              (error) => done([String(error)]));""")
        expect_equal(found, [], f"what axe-core finds at {width}")


def named(driver):
    """Every point of speed and accuracy has a number on the chart and a name in the list, on paper too."""
    names = [r["contender"] for r in DATA["host"]["host"] if r["operation"] == "mul"]
    for width in (1000, 360):
        size(driver, width, 900, mobile=width == 360)
        open_page(driver)
        for kind in ("", "print"):
            media(driver, kind=kind)
            listed = [li.text for li in driver.find_elements(By.CSS_SELECTOR, "#trade ol li")]
            expect_equal(sorted(listed), sorted(names), f"the names at {width} {kind}")
            shown = [t.text for t in driver.find_elements(By.CSS_SELECTOR, "#trade .names text")]
            expect_equal([t.split()[0] for t in shown], [str(i + 1) for i in range(len(names))],
                         f"numbers at {width} {kind}")
            for label in shown:
                number, *name = label.split()
                expect(name in ([], listed[int(number) - 1].split()), f"{label!r} is not of {listed}")
        media(driver)
        boxes = driver.execute_script("""
            return [...document.querySelectorAll('#trade .names text')].map((t) => t.getBoundingClientRect())""")
        over = [(i + 1, j + 1) for i, a in enumerate(boxes) for j, b in enumerate(boxes[:i])
                if min(a["right"], b["right"]) - max(a["left"], b["left"]) > 2
                and min(a["bottom"], b["bottom"]) - max(a["top"], b["top"]) > 4]
        expect_equal(over, [], f"labels over labels at {width}")


def still(driver):
    """Pictures stop on request, and stand where less motion is asked for."""
    seen = """return [...document.querySelectorAll('#scenes .scene ' + arguments[0])]
        .filter((e) => e.checkVisibility()).length"""
    count = len(DATA["made"]["scenes"])
    for motion, moving in (("no-preference", True), ("reduce", False)):
        media(driver, motion=motion)
        open_page(driver)
        for click in range(3):
            expect_equal([driver.execute_script(seen, tag) for tag in ("img", "canvas")],
                         [count, 0] if moving else [0, count], f"pictures and stills, {motion}, after {click} clicks")
            if not moving:
                drawn = driver.execute_script("""
                    return [...document.querySelectorAll('#scenes canvas')].every((c) =>
                      c.getContext('2d').getImageData(0, 0, c.width, c.height).data.some((v, i) => i % 4 < 3 && v > 60))""")
                expect(drawn, "a still shows nothing")
            buttons = driver.find_elements(By.CSS_SELECTOR, "#scenes button")
            expect_equal(len(buttons), 1, "buttons that stop and play")
            buttons[0].click()
            moving = not moving


def folded(driver):
    """On a phone the first chart comes soon; a table of equal rows is folded, and one with differences is not."""
    def table():
        return driver.execute_script("return document.querySelector('#verification table').checkVisibility()")

    size(driver, 360, 740, mobile=True)
    open_page(driver)
    expect(not table(), "the table is not folded")
    top = driver.execute_script(
        "return document.querySelector('.chart svg').getBoundingClientRect().top - "
        "document.getElementById('verification').getBoundingClientRect().top")
    expect(top < 2 * 740, f"the first chart begins {top} pixels below the head of the verification")
    rows = len(DATA["verify"]["rows"])
    summary = driver.find_element(By.CSS_SELECTOR, "#verification summary")
    expect_equal(summary.text, f"Show all {rows} rows: {rows} equal", "what is folded")
    summary.click()
    expect(table(), "the table does not open")
    driver.execute_script("arguments[0].click(); dispatchEvent(new Event('beforeprint'))", summary)
    expect(table(), "folded on paper")
    driver.execute_script("dispatchEvent(new Event('afterprint'))")
    expect(not table(), "not folded again")
    data = json.loads(json.dumps(DATA))
    data["verify"]["rows"][0]["mismatches"] = 2
    open_page(driver, with_data(data, "with_difference.html"))
    expect(table(), "a difference is folded")
    expect_equal(driver.find_element(By.CSS_SELECTOR, "#verification summary").text,
                 f"Show all {rows} rows: {rows - 1} equal, 1 with differences", "what differs")
