"""The address of the playground: a link restores what each view shows."""
import time
from urllib.parse import parse_qsl, urlencode

from page import button, drawn, expect, expect_equal, open_page, part, text, wait
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import Select


def shown(driver):
    """Returns what the controls hold, the text of the view and its pictures."""
    return driver.execute_script("""
        const view = document.getElementById('view').cloneNode(true);
        view.querySelectorAll('[data-part=fps]').forEach((figure) => figure.remove());
        const held = (e) => e.tagName === 'SELECT' ? e.selectedOptions[0].textContent.trim() : e.value;
        return {controls: [...document.querySelectorAll('#view :is(input, select)')].map(held),
          text: view.textContent.replace(/\\s+/g, ' '),
          pictures: [...document.querySelectorAll('#view canvas')].map((canvas) => canvas.toDataURL())};""")


def choose(driver, name, value):
    Select(driver.find_element(By.CSS_SELECTOR, f"select[name='{name}']")).select_by_value(value)


def write(driver, name, value):
    box = driver.find_element(By.CSS_SELECTOR, f"input[name='{name}']")
    box.clear()
    box.send_keys(value)


def slide(driver, *frames):
    driver.execute_script("""
        const slider = document.querySelector('[data-part=slider]');
        for (const frame of arguments[0]) {
          slider.value = frame;
          slider.dispatchEvent(new Event('input'));
        }""", frames)


def address(driver, *parts):
    """Returns the address behind #, once it holds the parts."""
    wait(driver, f"{parts} in the address", lambda: all(each in driver.current_url for each in parts))
    return driver.current_url.split("#")[1]


def follow(driver, link):
    """Follows a link to a scene that stands still, within the open page, and waits for its frame."""
    driver.execute_script("location.hash = arguments[0]", link)
    frame = dict(parse_qsl(link))["frame"]
    wait(driver, f"the frame of #{link}", lambda: drawn(driver) == "scenes" and part(driver, "frame") == frame)


def changed(link, **changes):
    return urlencode(dict(parse_qsl(link)) | changes)


def restored(driver, link, wanted, what):
    expect_equal(shown(driver)["controls"], wanted["controls"], f"{what}: the controls of #{link}")
    expect_equal(shown(driver), wanted, f"{what}: #{link}")


def views(driver):
    open_page(driver, "#view=number")
    choose(driver, "Format of words", "q8_8")
    write(driver, "Number", "0x0180")
    shows = {(address(driver, "format=q8_8", "text=0x0180"), "0x0180, 1.5"): shown(driver)}
    open_page(driver, "#view=operation")
    choose(driver, "Operation", "div")
    choose(driver, "Format", "q8_8")
    write(driver, "First", "1")
    write(driver, "Second", "3")
    # A third is 85 1/3 units of 8.8.
    shows[address(driver, "op=div", "in=q8_8", "a=1", "b=3"), "0055"] = shown(driver)
    open_page(driver, "#view=trace")
    choose(driver, "Routine", "div")
    choose(driver, "Build", "i8088-off")
    choose(driver, "Beside", "i386-52")
    write(driver, "Dividend", "7")
    write(driver, "Divisor", "2")
    button(driver, "forward").click()
    button(driver, "forward").click()
    shows[address(driver, "i8088-off", "i386-52", "7%3B2", "step=2"), "step 2 of"] = shown(driver)
    for (link, known), wanted in shows.items():
        expect(known in wanted["text"], f"#{link} does not show {known}: {wanted['text']}")
        open_page(driver, f"#{link}")
        restored(driver, link, wanted, "in a new page")


def scene(driver):
    """Scene, arithmetic, comparison, picture and time: chosen by hand, then by a link."""
    open_page(driver, "#view=scenes&play=no")
    choose(driver, "Scene", "lost_carry")
    choose(driver, "Arithmetic", "i8088-on-repaired")
    choose(driver, "Compared with", "i8088-on")
    choose(driver, "On the right", "other")
    slide(driver, 150)
    wait(driver, "frame 150", lambda: part(driver, "frame") == "150")
    wanted = shown(driver)
    expect_equal(wanted["controls"][1:],
                 ["8088, rounded, carry repaired", "8088, rounded", "the other arithmetic", "150"], "the controls")
    link = address(driver, "lost_carry", "arithmetic=i8088-on-repaired", "against=i8088-on", "show=other", "frame=150")
    open_page(driver)
    follow(driver, link)
    restored(driver, link, wanted, "in an open page")
    open_page(driver, f"#{link}")
    wait(driver, "frame 150", lambda: part(driver, "frame") == "150")
    restored(driver, link, wanted, "in a new page")
    time.sleep(0.5)
    expect_equal(part(driver, "frame"), "150", "half a second later")
    # Each part of the link changes the pictures that it should: the scene's own, and the one on the right.
    for changes, pictures in (({"scene": "chapter53"}, [True, True]), ({"arithmetic": "i386-on"}, [True, False]),
                              ({"against": "i386-on"}, [False, True]), ({"show": "difference"}, [False, True]),
                              ({"frame": "100"}, [True, True])):
        follow(driver, changed(link, **changes))
        is_ = [a != b for a, b in zip(shown(driver)["pictures"], wanted["pictures"])]
        expect_equal(is_, pictures, f"{changes} changes the pictures")
    # A link wins over what was chosen by hand.
    for value in ("i8088-on", "i8088-on-repaired", "i386-on"):
        choose(driver, "Arithmetic", value)
    follow(driver, link)
    restored(driver, link, wanted, "after choices by hand")
    driver.execute_script("location.hash = arguments[0]", changed(link, play="yes"))
    wait(driver, "a scene that plays", lambda: int(part(driver, "frame")) > 170)


def odd(driver):
    """Other addresses: the controls show what is computed, and quick changes reach the address."""
    for given, chosen in (("double", "exact (double)"), ("x", "386, rounded"), ("4", "386, rounded")):
        open_page(driver, f"#view=scenes&play=no&arithmetic={given}")
        expect_equal(shown(driver)["controls"][1], chosen, f"arithmetic={given}")
    open_page(driver, "#view=nothing&unknown=1")
    expect_equal(drawn(driver), "number", "an unknown view")
    # Browsers refuse many changes of the address in a short time.
    open_page(driver, "#view=scenes&play=no")
    slide(driver, *range(1000))
    address(driver, "frame=999")
    # While the scene moves to a frame, another comparison does not stop it.
    slide(driver, 20_000)
    choose(driver, "Compared with", "i386-on")
    address(driver, "frame=20000")
    wait(driver, "frame 20000", lambda: part(driver, "frame") == "20000", 60)
    expect_equal(text(driver, '[data-part="busy"]'), "", "at the frame")


def links(driver):
    """A link restores what each view shows; of a scene also its arithmetic, comparison and time."""
    views(driver)
    scene(driver)
    odd(driver)
