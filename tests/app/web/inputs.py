"""What a visitor types into the playground, and what it says about it."""
from chromium import size
from links import address, choose, write
from page import button, cells, drawn, expect, expect_equal, open_page, text, wait
from selenium.webdriver.common.by import By


def value(driver, name):
    return driver.find_element(By.CSS_SELECTOR, f"input[name='{name}']").get_property("value")


def results(driver):
    return [e.text for e in driver.find_elements(By.CSS_SELECTOR, ".ending .code")]


def forms(driver):
    """Decimal numbers with exponents, other signs and underscores, and negative words."""
    open_page(driver, "#view=number")
    for typed, word in (("1e2", "00640000"), ("\u22121.5", "fffe8000"), ("1_000", "03e80000"), ("-0x8000", "ffff8000"),
                        ("0X0001_8000", "00018000"), ("25e-2", "00004000")):
        write(driver, "Number", typed)
        expect_equal(text(driver, ".problem"), "", f"what is wrong with {typed}")
        expect_equal(cells(driver, "#view", "q16_16")[1:2] + cells(driver, "#view", "q16_16")[-1:], [word, "agree"], typed)
    for view, box in (("number", "Number"), ("operation", "First"), ("trace", "First factor")):
        open_page(driver, f"#view={view}")
        expect_equal(driver.find_elements(By.CSS_SELECTOR, ".stale"), [], f"{view}: a right answer is dim")
        write(driver, box, "1..")
        expect("number" in text(driver, ".problem"), f"{view}: nothing is wrong with '1..'")
        stale = driver.find_elements(By.CSS_SELECTOR, "#view .stale")
        expect_equal(len(stale), 1, f"{view}: answers that are dim")
        expect(float(stale[0].value_of_css_property("opacity")) < 0.6, f"{view}: the old answer is not dim")
        write(driver, box, "2")
        expect_equal(driver.find_elements(By.CSS_SELECTOR, ".stale"), [], f"{view}: the new answer is dim")


def roots(driver):
    """The root of a negative number."""
    open_page(driver, "#view=operation&op=sqrt&a=-4")
    said = " ".join(text(driver, ".exact").split())
    expect(said.startswith("-4 is negative") and "traps" in said and "digits" not in said, said)
    expect_equal(cells(driver, "#view", "wrapping, saturating")[1:3], ["00000000", "0"], "the root of -4")
    expect("throws domain_error" in cells(driver, "#view", "trapping")[1], "the root of -4 under a policy that traps")
    expect("agree" not in text(driver, "tbody"), "parties agree on a root that there is not")


def ranges(driver):
    """Builds of FIXED.ASM whose results wrap have a mark."""
    builds = ("386, rounded", "386, not rounded", "8088, rounded", "8088, not rounded")
    for a, b, marks in (("200", "200", "wraps"), ("-200", "200", "wraps"), ("100", "200", ""), ("-128", "256", "")):
        open_page(driver, f"#view=operation&op=mul&a={a}&b={b}")
        expect_equal([cells(driver, "#view", build)[4] for build in builds], [marks] * 4, f"{a} times {b}")
    # The 8088 divides by 1, so the quotient is 32768; the 386 divides by 1.5.
    open_page(driver, "#view=operation&op=div&a=-32768&b=-1.5")
    expect_equal([cells(driver, "#view", build)[4] for build in builds], ["", "", "wraps", "wraps"], "-32768 / -1.5")


def formats(driver):
    """Another format keeps the value or the bits, as chosen."""
    for view, box, format_box in (("number", "Number", "Format of words"), ("operation", "First", "Format")):
        for keeps, typed, shown in (("value", "0x00018000", "1.5"), ("value", "1.5", "1.5"),
                                    ("bits", "0x00018000", "0x00018000"), ("bits", "1.5", "0x00018000")):
            open_page(driver, f"#view={view}")
            write(driver, box, typed)
            choose(driver, "A new format keeps", keeps)
            choose(driver, format_box, "q8_24")
            expect_equal(value(driver, box), shown, f"{view}: {typed} in q8_24, which keeps the {keeps}")
            expect_equal(text(driver, ".problem"), "", f"{view}: {typed}")
    expect("keep=bits" in address(driver, "keep"), "the choice is not in the address")


def operands(driver):
    """Every operand of a trace has a label and a unit."""
    counts = {"mul": 2, "div": 2, "cossin": 1, "xformvec": 4, "concat": 6, "gouraud": 3, "depth": 3, "texture": 5}
    open_page(driver, "#view=trace")
    for routine, count in counts.items():
        choose(driver, "Routine", routine)
        expect_equal(len(driver.find_elements(By.CSS_SELECTOR, "#view .operands input")), count, f"boxes of {routine}")
        expect_equal(text(driver, ".problem"), "", f"the first operands of {routine}")
        expect(text(driver, ".unit"), f"{routine}: no unit")
    choose(driver, "Routine", "cossin")
    expect_equal(value(driver, "Angle in tenths of a degree"), "300", "the angle")
    choose(driver, "Routine", "xformvec")
    expect_equal(value(driver, "Transform, row 1"), "0.5 0.5 0.5 0", "the first row")
    write(driver, "Point x y z", "1 2")
    expect_equal(text(driver, ".problem"), "Point x y z: type 3 numbers, not 2.", "a point without z")
    write(driver, "Point x y z", "2, 2 2")
    write(driver, "Transform, row 1", "1 0 0 0.5")
    button(driver, "end").click()
    expect_equal(results(driver)[0], "00028000", "2 and a shift of 0.5")
    link = address(driver, "0.5", "step")
    open_page(driver, f"#{link}")
    expect_equal([value(driver, "Transform, row 1"), value(driver, "Point x y z")], ["1 0 0 0.5", "2, 2 2"], link)


def inputs(driver):
    """What a visitor types is taken, or said to be wrong."""
    for check in (forms, roots, ranges, formats, operands):
        check(driver)


# Before the page starts: notes every number that crosses into the module, other than small whole ones.
NOTING = """
    window.crossing = [];
    window.crossed = 0;
    const instantiate = WebAssembly.instantiate;
    WebAssembly.instantiate = async (...given) => {
      const { instance } = await instantiate.apply(WebAssembly, given);
      const noted = (name, call) => typeof call !== 'function' ? call : (...numbers) => {
        crossed += numbers.length;
        for (const n of numbers) if (!Number.isInteger(n) || n < 0 || n > 2 ** 20) crossing.push(`${name}(${numbers})`);
        return call(...numbers);
      };
      const exports = Object.fromEntries(Object.entries(instance.exports).map(([n, c]) => [n, noted(n, c)]));
      return { instance: { exports } };
    };"""
ODD = ("-1", "-0.5", "1e99", "99999999999999999999", "NaN", "Infinity", "0x10", "", "differs", "__proto__")


def crossing(driver):
    """No number that crosses into the module is negative, huge or no whole number."""
    driver.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": NOTING})

    def expect_small(link):
        driver.execute_async_script("requestAnimationFrame(() => requestAnimationFrame(arguments[0]))")
        expect(driver.execute_script("return crossed") > 0, f"#{link}: no number is noted")
        expect_equal(driver.execute_script("return crossing"), [], f"numbers that cross at #{link}")
        expect_equal(driver.find_elements(By.CSS_SELECTOR, "[role=alert]"), [], f"alerts at #{link}")

    for odd in ODD:
        for link in (f"view=scenes&play=no&frame={odd}&scene={odd}&arithmetic={odd}&against={odd}&show={odd}",
                     f"view=trace&step={odd}", f"view=trace&step={odd}&build={odd}&beside={odd}",
                     f"view=trace&routine={odd}", f"view=operation&op={odd}&in={odd}", f"view=number&format={odd}"):
            open_page(driver, f"#{link}")
            expect_small(link)
    open_page(driver, "#view=scenes&play=no")
    for frame in ODD[:6]:
        driver.execute_script("""
            const slider = document.querySelector('[data-part=slider]');
            slider.type = 'text';
            slider.value = arguments[0];
            slider.dispatchEvent(new Event('input'));""", frame)
        expect_small(f"the slider at {frame}")
    for _ in range(3):
        button(driver, "back").click()
    expect_small("a frame before the first")


def met(driver, faint):
    """Every view in the state in which a visitor meets it: by its link, and with nothing in the address."""
    for width, height in ((360, 740), (1280, 900)):
        size(driver, width, height, mobile=width == 360)
        open_page(driver)
        for view in ("operation", "trace", "scenes", "cases", "number"):
            driver.find_element(By.CSS_SELECTOR, f"#views a[href*='view={view}']").click()
            wait(driver, view, lambda v=view: drawn(driver) == v)
            if view == "scenes":
                wait(driver, "a scene that plays", lambda: int(text(driver, "[data-part=frame]")) > 2)
            expect_equal(driver.find_elements(By.CSS_SELECTOR, ".stale, [role=alert]"), [], f"{view}: old answers")
            problems = [e.text for e in driver.find_elements(By.CSS_SELECTOR, ".problem")]
            expect_equal("".join(problems), "", f"{view}: problems")
            wide = driver.execute_script("return document.documentElement.scrollWidth")
            expect(wide <= width, f"{view} at {width} is {wide} wide")
            regions = driver.execute_script(
                "return [...document.querySelectorAll('#view [role=region]')].map((e) => e.getAttribute('aria-label'))")
            expect_equal(len(set(regions)), len(regions), f"{view}: regions of one name: {regions}")
            expect_equal(driver.execute_script(faint), [], f"{view}: what is faint")
    wrong = [e for e in driver.get_log("browser") if e["level"] in ("SEVERE", "WARNING")]
    expect(not wrong, f"the console says {wrong}")
