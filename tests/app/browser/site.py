#!/usr/bin/env python3
"""usage: site.py ROOT PICTURES

Builds the site of the pages and uses it in headless Chromium: searches, follows a result, opens the list of pages, on a
wide and on a narrow screen. Screenshots go to PICTURES.
Status 0: it works, 1: it does not, 77: there is no browser or no python3-markdown-it.
"""
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from chromium import browser, expect, media, picture, size, skip, violations
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

ROOT, PICTURES = (pathlib.Path(given).resolve() for given in sys.argv[1:3])


def found(driver):
    return [item.text.split("\n")[0] for item in driver.find_elements(By.CSS_SELECTOR, "#found li")]


def shown(driver):
    return driver.find_element(By.ID, "text").is_displayed()


def use(driver, site, width, height, scheme):
    size(driver, width, height, mobile=width < 500)
    media(driver, scheme=scheme)
    driver.get((site / "docs/web.html").as_uri())
    wide = driver.execute_script("return document.documentElement.scrollWidth")
    expect(wide <= width, f"a page at {width} is {wide} wide")
    picture(driver, PICTURES / f"site_{width}.png", whole=False)
    ActionChains(driver).send_keys("/").send_keys("tie-break no such words").perform()
    said = driver.find_element(By.ID, "found").text
    expect(said == "No page has all of these words.", f"a search without a result says {said!r}")
    box = driver.find_element(By.ID, "search")
    box.clear()
    box.send_keys("How sure")
    expect(found(driver)[:1] == ["Verify the routines and ask each party: How sure is it"], f"found: {found(driver)}")
    expect(not shown(driver), "the page shows below the results")
    driver.find_element(By.CSS_SELECTOR, "#found a").send_keys(Keys.ENTER)
    expect(driver.current_url.endswith("/docs/verify.html#how-sure-is-it"), driver.current_url)
    # A result on the same page shows the page again.
    driver.find_element(By.ID, "search").send_keys("What level 1 compares")
    driver.find_element(By.CSS_SELECTOR, "#found a").click()
    expect(driver.current_url.endswith("#what-level-1-compares") and shown(driver), driver.current_url)
    marked = driver.find_elements(By.CSS_SELECTOR, "nav [aria-current]")
    expect([link.text for link in marked] == ["verify"], "the page is not marked in the list")
    marked[0].click()
    expect(violations(driver) == [], f"the policy blocks {violations(driver)}")
    wrong = [e["message"] for e in driver.get_log("browser") if e["level"] in ("SEVERE", "WARNING")]
    expect(not wrong, f"the console says {wrong}")


with tempfile.TemporaryDirectory() as folder:
    built = subprocess.run([sys.executable, "-B", ROOT / "docs/site/build.py", folder], stdout=subprocess.PIPE, text=True,
                           check=False)
    if built.returncode == 77:
        skip(built.stdout.strip().removeprefix("skipped: "))
    expect(built.returncode == 0, built.stdout)
    window = browser()
    try:
        use(window, pathlib.Path(folder), 1280, 900, "light")
        use(window, pathlib.Path(folder), 360, 740, "dark")
    finally:
        window.quit()
print("the site works on a wide and on a narrow screen")
