"""The page of the report in headless Chromium, for check.py: opens it, and says what does not hold."""
import json
import pathlib
import sys

import chromium

try:
    from selenium.webdriver.common.by import By
    from selenium.webdriver.support.ui import WebDriverWait
except ImportError:
    chromium.skip("python3-selenium is not installed")

CASE, FOLDER, PICTURES = sys.argv[1], pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3])
DATA = json.loads((FOLDER / "report.json").read_text())


def open_page(driver, file=None):
    driver.get((file or FOLDER / "report.html").as_uri())
    WebDriverWait(driver, 20).until(
        lambda d: d.execute_script("return document.documentElement.dataset.drawn") == "yes")


def picture(driver, name, whole=True):
    chromium.picture(driver, PICTURES / f"{name}.png", whole)


def expect(holds, what):
    chromium.expect(holds, f"{CASE}: {what}")


def expect_equal(is_, wanted, what):
    expect(is_ == wanted, f"{what}: {is_}, not {wanted}")


def number(driver, selector):
    return len(driver.find_elements(By.CSS_SELECTOR, selector))


def with_data(data, name):
    """The page with other data."""
    head, rest = (FOLDER / "report.html").read_text().split('id="data">', 1)
    file = FOLDER / name
    file.write_text(head + 'id="data">' + json.dumps(data).replace("<", "\\u003c") + rest[rest.index("</script>"):])
    return file
