#!/usr/bin/env python3
"""usage: check.py CASE FOLDER PICTURES

Opens FOLDER/report.html in headless Chromium and looks at one thing, CASE, that must hold; screenshots go
to PICTURES. Expected figures come from FOLDER/report.json. Status 0: holds, 1: does not, 77: no browser here.
"""
import base64
import json
import sys

sys.dont_write_bytecode = True
import sample_host
from report_page import DATA, FOLDER, PICTURES, CASE, expect, expect_equal, number, open_page, picture, with_data
from chromium import browser, media, size, violations
from reading import folded, labels, named, still
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select


def with_known_host():
    """The page with other times of the host, whose order is known."""
    return with_data(dict(DATA, host=sample_host.HOST), "with_known_host.html")


def figures_of(text):
    """Every number of a text that a person reads."""
    words = text.replace("\u200b", "").replace(",", "").replace("%", " ").split()
    found = []
    for word in words:
        try:
            found.append(float(word))
        except ValueError:
            pass
    return found


def says(text, wanted):
    """Whether the text has the figure, to the four digits that are shown."""
    return any(abs(f - wanted) <= 6e-4 * abs(wanted) for f in figures_of(text))


def tip(driver, part):
    """What the tip says, its lines apart."""
    return driver.execute_script(
        "return [...document.querySelectorAll(arguments[0])].map((t) => t.textContent).join(' ')", f"#{part} .tip tspan")


def quiet(driver):
    """No error, and nothing asked of the network, whatever is chosen."""
    open_page(driver)
    for select in driver.find_elements(By.TAG_NAME, "select"):
        for option in range(len(Select(select).options)):
            Select(select).select_by_index(option)
    wrong = [e for e in driver.get_log("browser") if e["level"] in ("SEVERE", "WARNING")]
    expect(not wrong, f"the console says {wrong}")
    asked = []
    for entry in driver.get_log("performance"):
        message = json.loads(entry["message"])["message"]
        if message["method"] == "Network.requestWillBeSent":
            asked.append(message["params"]["request"]["url"])
    beyond = [url for url in asked if not url.startswith("data:")]
    expect_equal(beyond, [(FOLDER / "report.html").as_uri()], "what was asked for")
    heads = [int(h.tag_name[1]) for h in driver.find_elements(By.CSS_SELECTOR, "h1,h2,h3,h4")]
    expect(all(b <= a + 1 for a, b in zip(heads, heads[1:])), f"headings leave levels out: {heads}")
    expect(all(i.get_attribute("alt") for i in driver.find_elements(By.TAG_NAME, "img")), "a picture without text")
    expect("could not be drawn" not in driver.page_source.split("<script")[0], "a part is not drawn")


def complete(driver):
    """Every chart and table has what the data have."""
    open_page(driver)
    expect_equal(number(driver, "#verification tbody tr"), len(DATA["verify"]["rows"]), "rows of the verification")
    expect(f"{DATA['verify']['cases']:,}" in driver.find_element(By.ID, "verdict").text, "the number of cases")
    for fact in ("commit", "executable"):
        expect(DATA["verify"]["made_by"][0][fact] in driver.find_element(By.ID, "verification").text, fact)
    octaves = sum(o["max"] > 0 for v in DATA["accuracy"]["pixels"]["variants"] for o in v["octaves"])
    expect_equal(number(driver, "#distance .points path, #distance .points circle"), octaves, "points of distance")
    expect_equal(number(driver, "#distance .half line"), 1, "lines of half a pixel")
    crossed = sum(v["safe_from"] > 1 for v in DATA["accuracy"]["pixels"]["variants"])
    expect_equal(number(driver, "#distance .crossing line"), crossed, "crossings")
    rows = DATA["accuracy"]["accuracy"]
    first = [r for r in rows if r["operation"] == rows[0]["operation"] and r["operands"] == rows[0]["operands"]]
    expect_equal(number(driver, "#errors .bars rect"), 16 * len(first), "bars of histograms")
    builds = [c for c in DATA["drift"]["cases"]
              if c["without"] == "nothing" and c["restore_every"] == 0 and not c["from_scratch"]]
    expect_equal(len(builds), 4, "builds")
    expect_equal(number(driver, "#drift .lines path"), 4, "curves of drift")
    expect_equal(number(driver, "#drift .strip svg polygon") > 0, True, "the strip")
    hosts = [r for r in DATA["host"]["host"] if r["operation"] == "mul"]
    expect(len(hosts) > 7, f"contenders: {len(hosts)}")
    expect_equal(number(driver, "#trade .points path, #trade .points circle"), len(hosts), "points of the trade")
    expect_equal(number(driver, "#trade details tbody tr"), len(hosts), "rows of the trade")
    expect_equal(number(driver, "#scenes .scene img"), len(DATA["made"]["scenes"]), "animations")
    expect_equal(number(driver, "#scenes .beside img"), sum("--beside" in c["command"] for c in DATA["commands"]),
                 "pictures beside the exact ones")
    sizes = driver.execute_script("return [...document.querySelectorAll('#scenes img')].map(i => i.naturalWidth)")
    expect(all(s > 0 for s in sizes), f"animations do not show: {sizes}")
    expect_equal(number(driver, "#claims article"), len(DATA["clocks"]["claims"]), "claims")
    expect_equal(number(driver, "#claims li"), sum(len(c["figures"]) for c in DATA["clocks"]["claims"]), "figures of claims")
    expect_equal(number(driver, "#commands tbody tr"), len(DATA["commands"]), "commands")
    picture(driver, "desktop_light")


def hover(driver):
    """A point says the figure of the JSON when the mouse is on it."""
    open_page(driver)
    variant = DATA["accuracy"]["pixels"]["variants"][0]
    for place in (0, 3, 7):
        point = driver.find_elements(By.CSS_SELECTOR, "#distance .points:not(:empty) path, #distance .points circle")[place]
        driver.execute_script("arguments[0].scrollIntoView({block: 'center'})", point)
        ActionChains(driver).move_to_element(point).perform()
        said = tip(driver, "distance")
        expect(says(said, variant["octaves"][place]["max"]), f"point {place}: {said!r} without {variant['octaves'][place]}")
        expect(variant["variant"] in said, f"point {place}: {said!r} names no variant")
    picture(driver, "hover", whole=False)
    counts = DATA["accuracy"]["accuracy"][0]["histogram"]["counts"]
    fullest = counts.index(max(counts))
    bar = driver.find_elements(By.CSS_SELECTOR, "#errors .bars rect")[fullest]
    driver.execute_script("arguments[0].scrollIntoView({block: 'center'})", bar)
    ActionChains(driver).move_to_element(bar).perform()
    said = tip(driver, "errors")
    expect(says(said, counts[fullest]), f"a bar: {said!r} without {counts[fullest]}")


def keyboard(driver):
    """Arrow keys step through a chart, and what it says is read out."""
    open_page(driver)
    svg = driver.find_element(By.CSS_SELECTOR, "#distance .chart > svg")
    driver.execute_script("arguments[0].scrollIntoView({block: 'center'}); arguments[0].focus({focusVisible: true})", svg)
    keys = ActionChains(driver)
    keys.send_keys(Keys.HOME).send_keys(Keys.ARROW_RIGHT).send_keys(Keys.ARROW_RIGHT).perform()
    read = driver.find_element(By.CSS_SELECTOR, "#distance .readout").get_attribute("textContent")
    third = DATA["accuracy"]["pixels"]["variants"][0]["octaves"][2]
    expect(says(read, third["max"]), f"{read!r} without {third}")
    said = tip(driver, "distance")
    expect(says(said, third["max"]), f"no tip for the keyboard: {said!r}")
    picture(driver, "keyboard", whole=False)
    ActionChains(driver).send_keys(Keys.END).perform()
    last = DATA["accuracy"]["pixels"]["variants"][-1]["octaves"][-1]
    read = driver.find_element(By.CSS_SELECTOR, "#distance .readout").get_attribute("textContent")
    expect(says(read, last["max"]), f"{read!r} without {last}")


def choices(driver):
    """What is chosen is what is drawn; times of this machine too."""
    open_page(driver, with_known_host())
    rows = [r for r in sample_host.HOST["host"] if r["operation"] == "mul"]
    expect_equal(number(driver, "#trade .points path, #trade .points circle"), len(rows), "points of the host")
    listed = [t.get_attribute("textContent") for t in driver.find_elements(By.CSS_SELECTOR, "#trade tbody tr")]
    fastest = min(rows, key=lambda r: r["throughput_ns"]["median"])
    expect(fastest["contender"] in listed[0] and str(fastest["throughput_ns"]["median"]) in listed[0],
           f"the fastest is not first: {listed}")
    # On the frontier: more exact, by a hundredth, than whatever is faster.
    caption = driver.find_element(By.CSS_SELECTOR, "#trade figcaption").text
    names = caption.removeprefix("On the line: ").split(".")[0].split("; ")
    for row in rows:
        faster = [o["accuracy"]["rms"] for o in rows if o["throughput_ns"]["median"] < row["throughput_ns"]["median"]]
        on = not faster or row["accuracy"]["rms"] < 0.99 * min(faster)
        expect_equal(row["contender"] in names, on, f"{row['contender']} on the line of {caption!r}")
    fixed = {"q16_16_i386_unrounded", "idiom"}
    expect_equal(set(caption.split("dotted: ")[1].rstrip(".").split("; ")), fixed, "the line of fixed point")
    # Exact stands on the floor of the logarithmic scale.
    floors = driver.execute_script("return [...document.querySelectorAll('#trade .chart svg text')].map((t) => t.textContent)")
    expect("0" in floors, f"no place for what is exact: {floors}")
    picture(driver, "known_host")
    box = driver.find_element(By.ID, "trade")
    Select(box.find_element(By.NAME, "operation")).select_by_value("vertex")
    expect_equal(number(driver, "#trade .points path, #trade .points circle"), 1, "points of vertices")
    Select(box.find_element(By.NAME, "operation")).select_by_value("mul")
    Select(box.find_element(By.NAME, "time")).select_by_value("chain_ns")
    chained = [r for r in rows if r["chain_ns"]]
    expect_equal(number(driver, "#trade .points path, #trade .points circle"), len(chained), "points with a chain")
    Select(box.find_element(By.NAME, "from")).select_by_value("clocks")
    calls = [c for c in DATA["clocks"]["clocks"] if c["routine"] == "mul" and c["chapter"] == 54]
    expect_equal(number(driver, "#trade .points path, #trade .points circle"), len(calls), "listings for a 486")
    Select(box.find_element(By.NAME, "time")).select_by_value("8088")
    expect_equal(number(driver, "#trade .points path, #trade .points circle"), 2, "listings for an 8088")
    errors = driver.find_element(By.ID, "errors")
    Select(errors.find_element(By.NAME, "operation")).select_by_value("cos")
    cosines = [r for r in DATA["accuracy"]["accuracy"] if r["operation"] == "cos"]
    cosines = [r for r in cosines if r["operands"] == cosines[0]["operands"]]
    expect_equal(number(driver, "#errors .bars rect"), 16 * len(cosines), "bars of cosines")
    # Charts that are replaced leave nothing behind.
    window = driver.execute_cdp_cmd("Runtime.evaluate", {"expression": "window"})["result"]["objectId"]
    listeners = driver.execute_cdp_cmd("DOMDebugger.getEventListeners", {"objectId": window})["listeners"]
    expect_equal([e["type"] for e in listeners].count("beforeprint"), 1, "who waits for printing")
    drift = driver.find_element(By.ID, "drift")
    Select(drift.find_element(By.NAME, "group")).select_by_value("sources")
    sources = [c for c in DATA["drift"]["cases"]
               if c["multiply"] == "386 on" and c["restore_every"] == 0 and not c["from_scratch"]]
    expect_equal(number(driver, "#drift .legend li"), len(sources), "sources of error")


def phone(driver):
    """320 pixels wide: nothing to scroll sideways but tables in their own boxes."""
    size(driver, 320, 640, mobile=True)
    open_page(driver)
    wide = driver.execute_script("return document.documentElement.scrollWidth")
    expect(wide <= 320, f"the page is {wide} wide")
    beyond = driver.execute_script("""
        const inBox = (e) => e.closest('.scroll, svg, .readout');
        return [...document.querySelectorAll('main *, header *')].filter((e) => !inBox(e) &&
          e.getBoundingClientRect().right > 321).map((e) => e.tagName + '.' + e.className)""")
    expect(not beyond, f"cut off: {beyond}")
    picture(driver, "phone")


def policy(driver):
    """The page's Content-Security-Policy blocks every script and style that is not the page's own."""
    run = "document.documentElement.dataset.injected = 'yes'"
    injected = {
        "a script": (f"<script>{run}</script>", "script-src-elem"),
        "an event handler": (f'<svg onload="{run}"></svg>', "script-src-attr"),
        "a style": ("<style>h1 { opacity: 0.5 }</style>", "style-src-elem"),
        "a style attribute": ('<p id="styled" style="opacity: 0.5">styled</p>', "style-src-attr"),
        "a picture from elsewhere": ('<img src="elsewhere.png" alt="">', "img-src")}
    page = (FOLDER / "report.html").read_text()
    for name, (html, directive) in injected.items():
        file = FOLDER / "injected.html"
        file.write_text(page.replace("<main>", f"{html}<main>", 1))
        open_page(driver, file)
        blocked = violations(driver)
        expect([b.split()[0] for b in blocked] == [directive], f"{name}: {blocked}, not one of {directive}")
        ran, opacity, styled = driver.execute_script("""
            const opacity = (selector) => getComputedStyle(document.querySelector(selector) ?? document.body).opacity;
            return [document.documentElement.dataset.injected ?? "no", opacity("h1"), opacity("#styled")]""")
        expect_equal([ran, opacity, styled], ["no", "1", "1"], f"{name}: it ran, opacities")
    open_page(driver)
    driver.execute_script("""
        const script = document.createElement("script");
        script.textContent = arguments[0];
        document.body.append(script);""", run)
    expect_equal(driver.execute_script("return document.documentElement.dataset.injected ?? 'no'"), "no",
                 "whether a script that a script adds ran")


def luminance(colour):
    r, g, b = [int(float(c)) for c in colour[colour.index("(") + 1:-1].split(",")[:3]]
    return (0.2126 * r + 0.7152 * g + 0.0722 * b) / 255


def dark(driver):
    """Light on dark where that is asked for."""
    media(driver, scheme="dark")
    open_page(driver)
    paper, ink = driver.execute_script(
        "const s = getComputedStyle(document.body); return [s.backgroundColor, s.color]")
    expect(luminance(paper) < 0.15 and luminance(ink) > 0.8, f"dark mode shows {ink} on {paper}")
    axis = driver.execute_script(
        "return getComputedStyle(document.querySelector('#distance .chart svg text')).fill")
    expect(luminance(axis) > 0.8, f"labels of charts are {axis}")
    picture(driver, "desktop_dark")


def print_(driver):
    """On paper: light, everything there, nothing too wide."""
    media(driver, scheme="dark")
    open_page(driver)
    media(driver, kind="print", scheme="dark")
    paper = driver.execute_script("return getComputedStyle(document.body).backgroundColor")
    expect(luminance(paper) > 0.9, f"prints on {paper}")
    printed = driver.execute_cdp_cmd("Page.printToPDF", {"printBackground": True, "paperWidth": 8.27, "paperHeight": 11.69})
    pdf = base64.b64decode(printed["data"])
    expect(pdf[:5] == b"%PDF-" and len(pdf) > 50_000, f"{len(pdf)} bytes of PDF")
    PICTURES.mkdir(parents=True, exist_ok=True)
    (PICTURES / "print.pdf").write_bytes(pdf)


def readme(driver):
    """No test: the picture of README.md, from a whole report."""
    size(driver, 1000, 900)
    open_page(driver)
    box = driver.execute_script("""
        const top = document.getElementById('errors').getBoundingClientRect().top + scrollY;
        const end = document.querySelector('#distance figcaption').getBoundingClientRect().bottom + scrollY;
        return [top, end]""")
    shot = driver.execute_cdp_cmd("Page.captureScreenshot", {"captureBeyondViewport": True, "clip": {
        "x": 0, "y": box[0], "width": 1000, "height": box[1] - box[0] + 12, "scale": 0.7}})
    (PICTURES / "report.png").write_bytes(base64.b64decode(shot["data"]))


CASES = {"quiet": quiet, "complete": complete, "hover": hover, "keyboard": keyboard, "choices": choices,
         "phone": phone, "policy": policy, "dark": dark, "print": print_,
         "labels": labels, "named": named, "still": still, "folded": folded, "readme": readme}
driver = browser()
try:
    CASES[CASE](driver)
    if CASE != "policy":
        expect_equal(violations(driver), [], "what the page's policy blocks of the page itself")
finally:
    driver.quit()
print(f"{CASE}: holds")
