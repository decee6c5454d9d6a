"""Headless Chromium for the tests of pages. Without it, or without Selenium, a test is skipped: status 77."""
import base64
import shutil
import sys


def skip(why):
    print(f"skipped: {why}")
    sys.exit(77)


try:
    from selenium import webdriver
except ImportError:
    skip("python3-selenium is not installed")


def browser(width=1280, height=900):
    if not shutil.which("chromium") or not shutil.which("chromedriver"):
        skip("chromium or chromium-driver is not installed")
    options = webdriver.ChromeOptions()
    options.binary_location = shutil.which("chromium")
    for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                     "--force-device-scale-factor=1", f"--window-size={width},{height}"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    service = webdriver.chrome.service.Service(shutil.which("chromedriver"))
    driver = webdriver.Chrome(service=service, options=options)
    # In every page, before its own scripts; the policy of the page does not apply to it.
    driver.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": """
        window.violations = [];
        document.addEventListener("securitypolicyviolation", (event) => violations.push(
          `${event.effectiveDirective} blocks ${event.blockedURI} at ${event.sourceFile}:${event.lineNumber}`));"""})
    return driver


def violations(driver):
    """What the page's Content-Security-Policy has blocked since the page was opened."""
    return driver.execute_script("return window.violations")


def size(driver, width, height, mobile=False):
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                           {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": mobile})


def media(driver, kind="", scheme="light", motion="no-preference"):
    features = {"prefers-color-scheme": scheme, "prefers-reduced-motion": motion}
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {
        "media": kind, "features": [{"name": name, "value": value} for name, value in features.items()]})


def picture(driver, file, whole=True):
    """The page as it is seen, from its top to its end, as a PNG."""
    file.parent.mkdir(parents=True, exist_ok=True)
    shot = driver.execute_cdp_cmd("Page.captureScreenshot", {"captureBeyondViewport": whole})
    file.write_bytes(base64.b64decode(shot["data"]))


def expect(holds, what):
    if not holds:
        print(what)
        sys.exit(1)
