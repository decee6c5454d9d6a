"""The playground in headless Chromium, for check.py: opens it, reads it, and says what does not hold."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "browser"))
import chromium
from selenium.common.exceptions import TimeoutException
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import WebDriverWait

CASE, PAGE, PICTURES = sys.argv[1], pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3])


def expect(holds, what):
    chromium.expect(holds, f"{CASE}: {what}")


def expect_equal(is_, wanted, what):
    expect(is_ == wanted, f"{what}: {is_!r}, not {wanted!r}")


def wait(driver, what, holds, seconds=20):
    """Waits until holds() is true."""
    try:
        WebDriverWait(driver, seconds).until(lambda d: holds())
    except TimeoutException:
        expect(False, f"{what}: not within {seconds} seconds")


def drawn(driver):
    """Returns the view that is drawn."""
    return driver.execute_script("return document.documentElement.dataset.drawn ?? ''")


def open_page(driver, address=""):
    driver.get("about:blank")
    driver.get(PAGE.as_uri() + address)
    wait(driver, "the first view", lambda: drawn(driver))


def picture(driver, name):
    chromium.picture(driver, PICTURES / f"{name}.png", whole=False)


def text(driver, selector):
    return driver.find_element(By.CSS_SELECTOR, selector).get_attribute("textContent")


def part(driver, name):
    """Returns a figure of the scene."""
    return text(driver, f'[data-part="{name}"]').replace(",", "")


def button(driver, name):
    return driver.find_element(By.CSS_SELECTOR, f"button[name={name}]")


def cells(driver, table, name):
    """Returns the cells of the row with this name."""
    rows = driver.execute_script("""
        const whole = (cell) => (cell.querySelector('[title]:not(.agrees)')?.title ?? cell.textContent).trim();
        return [...document.querySelectorAll(arguments[0] + ' tbody tr')].map((row) => [...row.children].map(whole))""",
                                 table)
    return next(row for row in rows if row[0] == name)
