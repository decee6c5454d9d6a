#!/usr/bin/env python3
"""usage: check.py CASE PLAYGROUND.html PICTURES

Opens the playground in headless Chromium and checks one property, CASE. Screenshots go to PICTURES.
Status 0: it holds, 1: it does not, 77: there is no browser.
"""
import http.server
import json
import re
import sys
import threading
import time

sys.dont_write_bytecode = True
from page import (CASE, PAGE, PICTURES, button, cells, drawn, expect, expect_equal, open_page, part, picture, text,
                  wait)
from chromium import browser, media, size, violations
from comfort import comfort
from formula import formula
from inputs import crossing, inputs, met
from links import links
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys


def size_(driver):
    """The page is small and requests nothing from the network."""
    expect(PAGE.stat().st_size < 300_000, f"{PAGE.stat().st_size} bytes")
    open_page(driver)
    started = driver.execute_script("return performance.getEntriesByName('started')[0].startTime")
    print(f"{PAGE.stat().st_size} bytes, drawn after {started:.0f} ms")
    asked = []
    for entry in driver.get_log("performance"):
        message = json.loads(entry["message"])["message"]
        if message["method"] == "Network.requestWillBeSent":
            asked.append(message["params"]["request"]["url"].split("#")[0])
    beyond = [url for url in asked if not url.startswith(("data:", "about:", "blob:"))]
    expect_equal(set(beyond), {PAGE.as_uri()}, "what was requested")
    wrong = [e for e in driver.get_log("browser") if e["level"] in ("SEVERE", "WARNING")]
    expect(not wrong, f"the console says {wrong}")


def injected(name, old, new):
    """Writes the page with a part replaced, and returns its address."""
    page = PAGE.read_text()
    expect(old in page, f"the page has no {old}")
    file = PICTURES / name
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(page.replace(old, new, 1))
    return file.as_uri()


def policy(driver):
    """The policy blocks every script and style that is not the page's own."""
    run = "document.documentElement.dataset.injected = 'yes'"
    wrong = {"script-src-elem": f"<script>{run}</script>", "script-src-attr": f'<svg onload="{run}"></svg>',
                "style-src-elem": "<style>h1 { opacity: 0.5 }</style>",
                "style-src-attr": '<p style="opacity: 0.5">styled</p>', "img-src": '<img src="elsewhere.png" alt="">'}
    for directive, html in wrong.items():
        driver.get(injected("injected.html", "<main", f"{html}<main"))
        wait(driver, "the page", lambda: drawn(driver))
        expect_equal([b.split()[0] for b in violations(driver)], [directive], f"what is blocked of {html}")
        expect_equal(driver.execute_script("return document.documentElement.dataset.injected ?? 'no'"), "no", "ran")


def failures(driver):
    """A page whose module does not start, or stops, says so."""
    driver.get(injected("broken.html", 'id="module">', 'id="module">A'))
    wait(driver, "an alert", lambda: text(driver, "[role=alert]").startswith("The module did not start: "))
    for there in ("nav", "nav a", "#undo", "footer"):
        expect(driver.find_element(By.CSS_SELECTOR, there).is_displayed(), f"{there} is hidden")
    open_page(driver)
    driver.execute_script("dispatchEvent(new ErrorEvent('error', {message: 'unreachable'}))")
    expect_equal(text(driver, "[role=alert]"), "The module stopped: unreachable. Load the page again.", "what it says")


def bits(driver):
    """Text, bits and table agree; arrow keys and the space bar flip a bit; the address keeps the number."""
    open_page(driver, "#view=number&text=1.5")
    expect_equal(cells(driver, "#view", "q16_16")[1:4], ["00018000", "1.5", "0"], "1.5 in q16_16")
    # 1.5 needs a bit that q8_0 does not have, and halves round up.
    expect_equal(cells(driver, "#view", "q8_0")[1:5], ["02", "2", "0.5", "0.5"], "1.5 in q8_0")
    expect("out of range" in cells(driver, "#view", "u0_8")[1], "1.5 in u0_8")
    driver.execute_script("document.querySelector('.bits button').focus()")
    ActionChains(driver).send_keys(Keys.END).send_keys(Keys.ARROW_LEFT).send_keys(Keys.SPACE).perform()
    # 2 units above 1.5, and the words one unit below and above it.
    expect_equal(cells(driver, "#view", "q16_16")[1:],
                 ["00018002", "1.500030517578125", "0", "0", "1.5000152587890625", "1.5000457763671875", "agree"],
                 "bit 1 flipped")
    wait(driver, "the word in the address", lambda: "0x00018002" in driver.current_url)
    box = driver.find_element(By.CSS_SELECTOR, "input[name=Number]")
    box.clear()
    box.send_keys("-32768.00001")
    # This is 0.66 units below the lowest number, so the nearest number would be the one below, which does not exist.
    expect("out of range" in cells(driver, "#view", "q16_16")[1], "below the lowest word")
    box.send_keys("x")
    expect("Not a number" in text(driver, ".problem"), "an error for letters")


def operation(driver):
    """The view of an operation: ranges, roots, and the link to a trace."""
    # 4098/256 times 2047/256 is 32767.99 units of 8.8, of which the highest word has 32767.
    open_page(driver, "#view=operation&op=mul&in=q8_8&a=0x1002&b=0x07ff")
    expect("out of range" in text(driver, ".exact"), "above the highest word")
    expect_equal([cells(driver, "#view", rule)[1] for rule in ("half up", "half up, saturating", "down (floor)")],
                 ["8000", "7fff", "7fff"], "above the highest word")
    # Half a unit below 0.
    open_page(driver, "#view=operation&op=mul&a=0xffffffff&b=0.5")
    expect_equal([cells(driver, "#view", rule)[1] for rule in ("down (floor)", "up (ceiling)")],
                 ["ffffffff", "00000000"], "half a unit below 0")
    # The root of 2 is 362.04 units.
    open_page(driver, "#view=operation&op=sqrt&in=q8_8&a=2")
    rows = driver.find_elements(By.CSS_SELECTOR, "#view tbody tr")
    expect_equal([row.text.split()[:4] for row in rows], [["to", "nearest", "016a", "1.4140625"]], "the root of 2")
    expect_equal(len(driver.find_elements(By.CSS_SELECTOR, "#view input")), 1, "operands of a root")
    open_page(driver, "#view=operation&op=mul&in=q16_16&a=0x0001+8000&b=2")
    driver.find_element(By.LINK_TEXT, "trace").click()
    wait(driver, "the trace", lambda: drawn(driver) == "trace")
    button(driver, "end").click()
    expect_equal(results(driver), ["00030000"], "the trace of 1.5 times 2")


def results(driver):
    """Returns the words that the recorded runs return, or how they end."""
    return driver.execute_script("""
        return [...document.querySelectorAll('.run .ending')].map((e) =>
          [...e.querySelectorAll('.code')].map((c) => c.textContent).join(' ') || e.textContent.trim())""")


def instruction(driver, mark):
    """Returns the instructions with this mark, one of each listing that has one."""
    return driver.execute_script("""
        return [...document.querySelectorAll('.listing ' + arguments[0])].map((row) =>
          row.lastElementChild.textContent.trim().replace(/^[0-9]+ +/, ''))""", mark)


def changed(driver, part):
    """Returns the registers or the words in memory that the last instruction changed."""
    return driver.execute_script("""
        return [...document.querySelectorAll(arguments[0] + ' .changed')].map((e) => e.textContent.trim())""", part)


def memory(driver, kind):
    """Returns the bytes or words of this kind that each run shows, in order of their addresses."""
    return driver.execute_script("""
        return [...document.querySelectorAll('.memory')].map((panel) =>
          [...panel.querySelectorAll(arguments[0])].map((cell) => cell.textContent.trim().split(' ')[1]))""", kind)


def pixels(driver):
    return memory(driver, "[title=pixel]")


followed = []


def follow(driver, name):
    """Opens a famous case by the keyboard."""
    followed.append(name)
    open_page(driver, "#view=cases")
    driver.execute_script("""
        [...document.querySelectorAll('.cases a')].find((a) => a.textContent === arguments[0]).focus()""", name)
    ActionChains(driver).send_keys(Keys.ENTER).perform()
    wait(driver, name, lambda: drawn(driver) != "cases" and driver.execute_script("return scrollY") == 0)


def builds(driver):
    """Returns the words of the builds of FIXED.ASM in the view of an operation. All parties must agree."""
    expect(not driver.find_elements(By.CSS_SELECTOR, "#view .differs"), "the parties differ")
    rows = driver.find_elements(By.CSS_SELECTOR, "#view [aria-label='Build of FIXED.ASM'] tbody tr")
    return [row.find_elements(By.TAG_NAME, "td")[0].text for row in rows]


def cases(driver):
    """Every famous case shows the words that docs/findings.md has."""
    size(driver, 800, 900)
    none = "no result: divide error"
    operations = {
        "The fault that disappears": ["80010000", none, none, none],
        "Halves that split two builds": ["00000000", "ffffffff", "ffffffff", "00000000"],
        "A divisor loses its fraction": ["00008000", "00007fff", "0000ffff", "0000ffff"],
        "Too small to divide by": ["00010001", "00010001", none, none],
        "Half a unit, and less": ["00000001", "00000000", "00000001", "00000000"],
        # Without rounding, half a unit below 160 is one unit below it.
        "Width, or half the width": ["00a00000", "009fffff", "00a00000", "009fffff"]}
    for name, words in operations.items():
        follow(driver, name)
        expect_equal(builds(driver), words, name)
    move = "00010000 00000000 00000000 {} 00000000 00010000 00000000 {} 00000000 00000000 00010000 {}"
    traces = {
        "0.5 + 0.5 = 0": [move.format("00000000", *["00000000"] * 2), move.format("00010000", *["00000000"] * 2)],
        "A switch the wrong way round": ["0000aaaa", "0000aaab"],
        "The translation in every column": [
            "00020000 00010000 00010000 00050000 00020000 00030000 00020000 00070000 "
            "00030000 00030000 00040000 00090000",
            move.format("00050000", "00070000", "00090000")]}
    for name, words in traces.items():
        follow(driver, name)
        button(driver, "forward").send_keys(Keys.END)
        expect_equal(results(driver), words, name)
    follow(driver, "0.5 + 0.5 = 0")
    expect_equal(instruction(driver, ".current"), ["add bp, [si+14]", "adc bp, [si+14]"], "where the carry is lost")
    picture(driver, "lost_carry")
    follow(driver, "A carry that means nothing")
    expect("undefined" in results(driver)[0], f"the scan ends so: {results(driver)}")
    expect_equal(results(driver)[1], "00014000", "2.5 / 2")
    follow(driver, "Arguments that change")
    expect_equal(changed(driver, ".memory"), ["0058 4000"], "the argument that changes")
    follow(driver, "Minus one, one unit too high")
    row = cells(driver, "#view", "q16_16")
    expect_equal([row[1], row[5]], ["ffff0001", "-1"], "the word that the macro makes, and the number below it")
    follow(driver, "Not an instruction of the 8088")
    expect_equal([instruction(driver, ".stops"), instruction(driver, ".current")[-1]], [["shl bx, 2"], "shl bx, 1"],
                 "where the 8088 stops, and the instruction in its place")
    expect(driver.execute_script("""
        const list = document.querySelector('.listing');
        const row = list.querySelector('.stops');
        const end = list.scrollTop + list.clientHeight;
        return row.offsetTop >= list.scrollTop && row.offsetTop + row.offsetHeight <= end"""),
           "the instruction where it stops is out of sight")
    expect("does not have" in results(driver)[0], f"the printed CosSin ends so: {results(driver)}")
    follow(driver, "Not in place")
    expect_equal([instruction(driver, ".current"), changed(driver, ".memory")],
                 [["mov [di], ecx"], ["009e 0002"]], "the store of the new x")
    button(driver, "forward").send_keys(Keys.ARROW_RIGHT * 2)
    expect_equal([instruction(driver, ".current"), changed(driver, ".registers")],
                 [["imul dword [bx]"], ["eax00000000", "edx00000001"]], "the old x, read again")
    # The inner loops: registers and pixels of findings 13 to 16 and 21.
    follow(driver, "SHRD in place of SHLD")
    expect_equal([instruction(driver, ".current"), changed(driver, ".registers")],
                 [["shrd ebx, edx, 24", "shld ebx, edx, 24"], ["ebx00123400", "ebx00000012"]], "the depth in BX")
    follow(driver, "A span without pixels")
    expect_equal([instruction(driver, ".current"), changed(driver, ".registers")],
                 [["loop .Pixel", "dec ecx"], ["ecx0000ffff", "ecxffffffff"]], "the count after the first pixel")
    button(driver, "forward").send_keys(Keys.END)
    expect(all("Still draws" in ending for ending in results(driver)), f"the loops end so: {results(driver)}")
    follow(driver, "The odd pixel")
    seven = ["20", "21", "22", "23", "24", "25", "26"]
    expect_equal(pixels(driver), [seven[:6] + ["00"] * 2, seven + ["00"]], "pixels in pairs and one by one")
    follow(driver, "The depth test and its description")
    expect_equal(pixels(driver)[0][:2], ["ff", "00"], "pixels at depth 1 and depth -1")
    expect_equal(memory(driver, ".depth")[0][:2], ["0001", "0000"], "the depth buffer")
    follow(driver, "A step before the fetch")
    expect_equal([instruction(driver, ".current"), changed(driver, ".registers")],
                 [["add edx, ebp"], ["edx00000200"]], "the step after the fetch")
    expect_equal(pixels(driver)[0][:2], ["01", "00"], "the texel that is drawn")
    for name in ("Cubes one unit too far away", "Thirty minutes of drift"):
        follow(driver, name)
        frame = "108000" if "drift" in name else "0"
        wait(driver, f"{name}, frame {frame}", lambda: part(driver, "frame") == frame, 60)
        wrong = int(part(driver, "wrong"))
        expect(1000 < wrong < 76_800, f"{name}: {wrong} pixels differ")
        if "drift" in name:
            picture(driver, "drift")
    open_page(driver, "#view=cases")
    names = [link.text for link in driver.find_elements(By.CSS_SELECTOR, ".cases a")]
    expect_equal(set(followed), set(names), "cases followed")
    for said in driver.find_elements(By.CSS_SELECTOR, ".cases p"):
        expect_equal(said.text.count(". ") + 1, 3, f"sentences of {said.text!r}")


VIEWS = ("number", "operation", "trace", "scenes", "cases")


def keyboard(driver):
    """Tab reaches every control of every view, and the keys of steps and frames work."""
    for view in VIEWS:
        open_page(driver, f"#view={view}&play=no")
        # The rows of a table or listing whose buttons Tab skips have a list or a key that does the same.
        controls = """[...document.querySelectorAll('a, button:not([disabled]), input, select, summary, textarea, [tabindex]')]
            .filter((e) => e.tabIndex >= 0 && e.checkVisibility())"""
        driver.execute_script(f"{controls}.forEach((e, i) => {{ e.dataset.control = i; }}); document.body.focus()")
        wanted = driver.execute_script(f"return {controls}.length")
        reached = set()
        for _ in range(wanted + 12):
            ActionChains(driver).send_keys(Keys.TAB).perform()
            reached.add(driver.execute_script("return document.activeElement.dataset.control"))
        expect_equal(len(reached - {None}), wanted, f"{view}: controls that Tab reaches")
    open_page(driver, "#view=trace&routine=mul&build=i386-on&beside=none&operands=-0.5+1.5")
    button(driver, "forward").send_keys(Keys.ARROW_RIGHT * 5)
    # The registers after ADD EAX, 8000h, as in the trace of README.md.
    expect("eax40008000" in text(driver, ".registers"), text(driver, ".registers"))
    button(driver, "forward").send_keys(Keys.ARROW_LEFT)
    expect("eax40000000" in text(driver, ".registers") and "CF1" in text(driver, ".flags"), "a step back")
    expect("PF?" in text(driver, ".flags"), "an undefined flag")
    wait(driver, "the step in the address", lambda: "step=4" in driver.current_url)
    # The keys still work after a button that leads to the last step.
    button(driver, "end").send_keys(Keys.ENTER)
    driver.execute_async_script("requestAnimationFrame(() => requestAnimationFrame(arguments[0]))")
    ActionChains(driver).send_keys(Keys.ARROW_LEFT).perform()
    expect("step 8 of 9" in text(driver, ".run"), "a step back from the end")
    open_page(driver, "#view=scenes&play=no")
    button(driver, "forward").send_keys(Keys.ENTER)
    wait(driver, "one frame on", lambda: part(driver, "frame") == "1")


def scenes(driver):
    """A scene runs, and a switched arithmetic continues from where it is."""
    # As a visitor opens it: it plays from the first frame, in the time of a clock.
    for _ in range(5):
        open_page(driver, "#view=scenes")
        time.sleep(1)
        expect(0 < int(part(driver, "frame")) <= 200, f"after a second of playing: frame {part(driver, 'frame')}")
    for unknown in ("toString", "constructor", "__proto__", "no"):
        open_page(driver, f"#view={unknown}&toString=1")
        expect_equal(drawn(driver), "number", f"the view of #view={unknown}")
    open_page(driver, "#view=scenes&scene=chapter53&arithmetic=i386-on&against=i386-on")
    wait(driver, "frame 61", lambda: int(part(driver, "frame")) > 60, 60)
    print(part(driver, "fps"), "frames per second")
    expect_equal(part(driver, "wrong"), "0", "pixels that differ in one arithmetic")
    driver.find_element(By.CSS_SELECTOR, "select[name=Arithmetic]").send_keys("8088, not")
    wait(driver, "pixels that differ", lambda: part(driver, "wrong") != "0")
    expect(int(part(driver, "frame")) > 60, "the scene started again")
    # Computed from the first frame in the other arithmetic, this frame has other pixels. Continued, it has not.
    still = "#view=scenes&play=no&scene=chapter53&against=i386-on&frame=61&arithmetic="
    open_page(driver, still + "i8088-off")
    wait(driver, "frame 61 from the first one", lambda: part(driver, "frame") == "61")
    expect(part(driver, "wrong") != "0", "no pixels differ from the first frame on")
    open_page(driver, still + "i386-on")
    wait(driver, "frame 61", lambda: part(driver, "frame") == "61")
    driver.find_element(By.CSS_SELECTOR, "select[name=Arithmetic]").send_keys("8088, not")
    time.sleep(0.5)
    expect_equal((part(driver, "frame"), part(driver, "wrong")), ("61", "0"), "the frame that goes on and its pixels")
    # A person who asks for less motion sees none until Play.
    media(driver, motion="reduce")
    open_page(driver, "#view=scenes")
    for scene in ("chapter53", "phong"):
        driver.execute_script("location.hash = `#view=scenes&scene=${arguments[0]}`", scene)
        time.sleep(1)
        expect_equal(part(driver, "frame"), "0", f"{scene} with less motion")
    button(driver, "play").click()
    wait(driver, "frame 11 after Play", lambda: int(part(driver, "frame")) > 10)


# Returns the texts with a contrast below 4.5 to what is behind them, and the controls whose edge has one below 3.
FAINT = """
    const parts = (color) => color.match(/[\\d.]+/g).map(Number);
    const light = (color) => parts(color).slice(0, 3).map((v) => v / 255)
      .map((v) => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)
      .reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
    const contrast = (a, b) => {
      const [low, high] = [light(a), light(b)].sort((x, y) => x - y);
      return (high + 0.05) / (low + 0.05);
    };
    const ground = (e) => {
      const color = getComputedStyle(e).backgroundColor;
      return parts(color)[3] === 0 && e.parentElement ? ground(e.parentElement) : color;
    };
    const faint = [];
    for (const e of document.querySelectorAll('body, body *:not(script, noscript, option, :disabled)')) {
      const control = e.matches('input, select, button');
      const text = [...e.childNodes].some((n) => n.nodeType === 3 && n.data.trim()) || control;
      if (!text || !e.checkVisibility()) continue;
      const style = getComputedStyle(e);
      const edge = control && e.type !== 'range' ? contrast(style.borderTopColor, ground(e.parentElement)) : 9;
      if (contrast(style.color, ground(e)) < 4.5 || edge < 3) faint.push(`${e.className} ${e.textContent.trim()}`);
    }
    return faint;"""


# Returns what moved, and by how much of the screen.
SHIFTS = """
    const done = arguments[0];
    const moved = [];
    new PerformanceObserver((list) => {
      for (const e of list.getEntries())
        moved.push(`${e.sources.map((s) => `${s.node?.nodeName}.${s.node?.className}`)} by ${e.value}`);
    }).observe({ type: 'layout-shift', buffered: true });
    setTimeout(() => done(moved), 600);"""


def arrival(driver):
    """Nothing moves while the page arrives. The server pauses after each tag."""
    before, body, scripts = re.split(r"(?<=<body>)|(?=<script)", PAGE.read_text(), maxsplit=2)
    pieces = [before, *re.findall(r"[^>]*>", body), scripts]

    class Slow(http.server.BaseHTTPRequestHandler):
        def do_GET(self):
            if self.path != "/":
                self.send_error(404)
                return
            self.send_response(200)
            self.send_header("Content-Type", "text/html")
            self.end_headers()
            try:
                for piece in pieces:
                    self.wfile.write(piece.encode())
                    time.sleep(0.05)
            except ConnectionError:
                pass  # the browser has gone

        def log_message(self, *_):
            pass

    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), Slow) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        try:
            for width in (360, 800, 1600):
                size(driver, width, 900, mobile=width == 360)
                driver.get(f"http://127.0.0.1:{server.server_port}/")
                wait(driver, "the first view", lambda: drawn(driver))
                expect_equal(driver.execute_async_script(SHIFTS), [], f"what moves at {width}")
        finally:
            server.shutdown()


def screens(driver):
    """No view is wider than its screen, nothing moves once it is drawn, and both themes have contrast."""
    for width, height in ((360, 740), (800, 900), (1600, 1000)):
        size(driver, width, height, mobile=width == 360)
        for view in VIEWS:
            scheme = "dark" if width == 800 else "light"
            media(driver, scheme=scheme)
            open_page(driver, f"#view={view}&beside=i8088-on&step=differs&play=no&frame=300")
            shift = driver.execute_async_script(SHIFTS)
            expect(not shift, f"{view} at {width} moves {shift}")
            wide = driver.execute_script("return document.documentElement.scrollWidth")
            expect(wide <= width, f"{view} at {width} is {wide} wide")
            paper, ink = driver.execute_script("""
                const style = getComputedStyle(document.body);
                return [style.backgroundColor, style.color]""")
            light = [sum(map(int, c[c.index("(") + 1:-1].split(",")[:3])) / 765 for c in (paper, ink)]
            expect((light[0] > light[1]) == (scheme == "light") and abs(light[0] - light[1]) > 0.6, f"{ink} on {paper}")
            expect_equal(driver.execute_script(FAINT), [], f"{view} in the {scheme} theme: what is faint")
            picture(driver, f"{view}_{width}")


CASES = {"size": size_, "policy": policy, "failures": failures, "bits": bits, "operation": operation, "cases": cases,
         "keyboard": keyboard, "links": links, "scenes": scenes, "arrival": arrival, "screens": screens,
         "inputs": inputs, "comfort": comfort, "formula": formula, "crossing": crossing,
         "met": lambda driver: met(driver, FAINT)}
driver = browser()
try:
    CASES[CASE](driver)
    if CASE != "policy":
        expect_equal(violations(driver), [], "what the policy blocks of the page itself")
finally:
    driver.quit()
print(f"{CASE}: holds")
