"""What saves a visitor work in the playground: stepping, copying, undoing, breakpoints, and what the bits mean."""
from inputs import value
from links import choose, write
from page import button, cells, expect, expect_equal, open_page, text, wait
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys


def press(driver, *keys):
    ActionChains(driver).send_keys(*keys).perform()


def chord(driver, key):
    ActionChains(driver).key_down(Keys.CONTROL).send_keys(key).key_up(Keys.CONTROL).perform()


def labelled(driver, label):
    """Returns the button with this text."""
    return driver.find_element(By.XPATH, f"//button[normalize-space()='{label}']")


def places(driver):
    """The bits name their field and their place."""
    open_page(driver, "#view=number&text=1.5&format=q4_4")
    names = [e.get_attribute("aria-label") for e in driver.find_elements(By.CSS_SELECTOR, ".bits button")]
    expect_equal(names, ["bit 7, sign, \u22122 to the power 3", "bit 6, integer, 2 to the power 2",
                         "bit 5, integer, 2 to the power 1", "bit 4, integer, 2 to the power 0",
                         "bit 3, fraction, 2 to the power -1", "bit 2, fraction, 2 to the power -2",
                         "bit 1, fraction, 2 to the power -3", "bit 0, fraction, 2 to the power -4"], "bits of q4_4")
    fields = [e.text for e in driver.find_elements(By.CSS_SELECTOR, ".field")]
    expect_equal(fields, ["sign", "integer", "", "", "fraction", "", "", ""], "fields of q4_4")
    titles = [e.get_attribute("title") for e in driver.find_elements(By.CSS_SELECTOR, ".bits button")]
    expect_equal((titles[0], titles[-1]), ("bit 7: \u22122^3 = \u22128", "bit 0: 2^-4 = 0.0625"), "places of q4_4")


def steps(driver):
    """The next word above and below, by buttons and keys, as far as there is one."""
    open_page(driver, "#view=number&text=7.875&format=q4_4")
    button(driver, "above").click()
    expect_equal((value(driver, "Number"), button(driver, "above").is_enabled()), ("7.9375", False), "the highest q4_4")
    press(driver, Keys.ARROW_UP)
    expect_equal(value(driver, "Number"), "7.9375", "above the highest q4_4")
    driver.find_element(By.CSS_SELECTOR, "input[name=Number]").send_keys(Keys.ARROW_DOWN * 3)
    expect_equal(value(driver, "Number"), "7.75", "three words below")
    write(driver, "Number", "0x00")
    driver.find_element(By.CSS_SELECTOR, ".bits button").send_keys(Keys.ARROW_DOWN)
    expect_equal(value(driver, "Number"), "0xff", "the word below 0")
    expect_equal(cells(driver, "#view", "q4_4")[2], "-0.0625", "its value")


def rows(driver):
    """A row chooses its format, and the chosen one has a mark."""
    open_page(driver, "#view=number&text=1.5")
    chosen = "return [...document.querySelectorAll('tr.chosen')].map((row) => row.firstElementChild.textContent.trim())"
    expect_equal(driver.execute_script(chosen), ["q16_16"], "the chosen row")
    labelled(driver, "q8_24").click()
    expect_equal(driver.execute_script(chosen), ["q8_24"], "the row after a click")
    expect("0x01800000" in text(driver, ".exact"), text(driver, ".exact"))


def copies(driver):
    """The buttons copy the word, the link and a line of C++ that a compiler takes."""
    open_page(driver, "#view=number&text=-1.5")
    driver.execute_script("""
        window.copied = [];
        Object.defineProperty(navigator, 'clipboard',
          { value: { writeText: async (text) => { copied.push(text); } }, configurable: true });""")
    lines = {"q16_16": "constexpr auto x = fixproof::q16_16::from_raw(-98304);  // -1.5",
             "q1_63": "constexpr auto x = fixproof::q1_63::from_raw(INT64_MIN);  // -1",
             "u0_8": "constexpr auto x = fixproof::u0_8::from_raw(0xff);  // 0.99609375"}
    for name, number in (("q16_16", "-1.5"), ("q1_63", "-1"), ("u0_8", "0xff")):
        choose(driver, "Format of words", name)
        write(driver, "Number", number)
        labelled(driver, "Copy C++").click()
        expect_equal(driver.execute_script("return copied.pop()"), lines[name], f"a line of {name}")
        wait(driver, "what is copied", lambda: text(driver, ".copies [role=status]") == f"Copied: {lines[name]}")
    labelled(driver, "Copy word").click()
    labelled(driver, "Copy link").click()
    word, link = driver.execute_script("return copied")
    expect_equal(word, "0xff", "the word")
    expect(link.endswith("playground.html#view=number&text=0xff&format=u0_8"), link)
    # Where the page may not copy, it shows the text.
    driver.execute_script("""
        navigator.clipboard.writeText = async () => { throw new Error(); };
        window.prompt = (_, text) => { copied.push(text); };""")
    labelled(driver, "Copy word").click()
    wait(driver, "a text to copy by hand", lambda: driver.execute_script("return copied[2]") == "0xff")


def undo(driver):
    """Undo and Redo take back changes of every view, by button and key."""
    open_page(driver, "#view=number&text=1")
    undo_, redo = (driver.find_element(By.ID, name) for name in ("undo", "redo"))
    expect_equal((undo_.is_enabled(), redo.is_enabled()), (False, False), "at the start")
    choose(driver, "Format of words", "q8_8")
    button(driver, "above").click()
    expect_equal(value(driver, "Number"), "1.00390625", "one unit of q8_8")
    undo_.click()
    expect_equal(value(driver, "Number"), "1", "after Undo")
    chord(driver, "z")
    expect("q16_16" in text(driver, ".exact"), "the format after two steps back")
    expect_equal((undo_.is_enabled(), redo.is_enabled()), (False, True), "back at the start")
    chord(driver, "y")
    redo.click()
    expect_equal(value(driver, "Number"), "1.00390625", "after Redo")
    driver.find_element(By.LINK_TEXT, "Trace").click()
    wait(driver, "the trace", lambda: driver.find_elements(By.CSS_SELECTOR, ".listing"))
    undo_.click()
    expect_equal(value(driver, "Number"), "1.00390625", "after a link and Undo")
    # A change after Undo leaves nothing to redo.
    button(driver, "below").click()
    expect_equal(redo.is_enabled(), False, "after another change")


def breakpoints(driver):
    """A run stops after an instruction that has a breakpoint, forward and back."""
    open_page(driver, "#view=trace&routine=mul&build=i386-on&beside=none&operands=-0.5+1.5")
    expect_equal(button(driver, "run").is_enabled(), False, "Run without a breakpoint")
    marks = driver.find_elements(By.CSS_SELECTOR, ".break")
    marks[4].click()
    button(driver, "run").click()
    # ADD EAX, 8000h is instruction 4, the fifth step.
    expect("step 5 of 9" in text(driver, ".run"), "the first breakpoint")
    expect("eax40008000" in text(driver, ".registers"), text(driver, ".registers"))
    button(driver, "forward").send_keys(Keys.ARROW_RIGHT * 2 + "b")
    button(driver, "runback").click()
    expect("step 5 of 9" in text(driver, ".run"), "back to the first breakpoint")
    for step in ("step 7 of 9", "step 9 of 9"):
        button(driver, "run").click()
        expect(step in text(driver, ".run"), f"{step}: {text(driver, '.run p')}")
    wait(driver, "breakpoints in the address", lambda: "breaks=0.4_0.6" in driver.current_url)
    marks[4].click()
    pressed = [i for i, mark in enumerate(marks) if mark.get_attribute("aria-pressed") == "true"]
    expect_equal(pressed, [6], "breakpoints that are left")


def code(driver, text):
    box = driver.find_element(By.CSS_SELECTOR, "textarea[name=Code]")
    driver.execute_script("""
        arguments[0].value = arguments[1];
        arguments[0].dispatchEvent(new Event('input'));""", box, text)


def problem(driver):
    return text(driver, "#view .problem")


def returned(driver):
    button(driver, "end").click()
    return [" ".join(e.text.split()) for e in driver.find_elements(By.CSS_SELECTOR, ".ending")]


def editor(driver):
    """Code that a visitor types runs beside the build's own, and what is wrong with it is said."""
    for routine, build in (("mul", "i386-on"), ("div", "i8088-on"), ("cossin", "i386"), ("concat", "i8088-on"),
                           ("xformvec", "i386-off"), ("gouraud", "word-i386-loop"), ("depth", "i386-loop-printed"),
                           ("texture", "i8088-dec-jnz")):
        # The listing, typed again, is the same program: no step differs.
        open_page(driver, "#view=trace")
        choose(driver, "Routine", routine)
        choose(driver, "Build", build)
        choose(driver, "Beside", build)
        driver.find_element(By.CSS_SELECTOR, ".editor summary").click()
        code(driver, driver.execute_script("return document.querySelector('textarea').value + '\\n'"))
        expect_equal(problem(driver), "", f"the listing of {routine}, {build}")
        expect_equal(button(driver, "differs").is_enabled(), False, f"{routine}, {build}, typed again, differs")
        runs = returned(driver)
        expect(len(runs) == 2 and runs[0] == runs[1], f"{routine}, {build}: {runs}")
    open_page(driver, "#view=trace&routine=mul&build=i386-on&beside=i386-on&operands=0xffffffff+0.5")
    driver.find_element(By.CSS_SELECTOR, ".editor summary").click()
    # Without the half unit, the product is rounded down.
    listing = driver.execute_script("return document.querySelector('textarea').value")
    code(driver, "\n".join(line for line in listing.splitlines() if "0x8000" not in line and "adc" not in line))
    expect_equal(returned(driver), ["Returns ffffffff (-0.0000152587890625)", "Returns 00000000 (0)"], "without a half")
    button(driver, "differs").click()
    expect("step 5 of 7" in text(driver, ".run"), f"the first difference: {text(driver, '.run p')}")
    wait(driver, "the code in the address", lambda: "code=" in driver.current_url)
    link = driver.current_url.split("#")[1]
    open_page(driver, f"#{link}")
    expect_equal(returned(driver)[0], "Returns ffffffff (-0.0000152587890625)", "a link to edited code")
    button(driver, "undoedits").click()
    expect_equal(returned(driver)[0], "Returns 00000000 (0)", "as printed")
    # Registers on entry, and a label.
    code(driver, "FixedMul: dec cx\n    jnz .FixedMul\n    sub ax, ax\n    inc cx\n    add ax, cx\n    ret")
    write(driver, "Registers on entry, such as cx=1234 ebx=ffff8000", "cx=3 edx=5")
    expect_equal(returned(driver)[0], "Returns 00050001 (5.0000152587890625)", "a loop of three")
    expect("step 10 of 10" in text(driver, ".run"), text(driver, ".run p"))
    for typed, said in (("jmp .x", "There is no label x."), ("x: jmp .x", ""), ("mov al, [bp+4", "'[bp+4' is no operand"),
                        ("hlt", "the model has no such instruction"), ("mov ax, 7", "no listing for this processor has 'mov r/m16, imm'"),
                        ("mov ax, [ax]", "'[ax]' is no operand")):
        code(driver, typed)
        expect(said in problem(driver) and bool(said) == bool(problem(driver)), f"{typed}: {problem(driver)}")
        if not said:
            expect_equal(returned(driver)[0], "Still runs after 10,000 instructions.", typed)
    code(driver, "ret")
    write(driver, "Registers on entry, such as cx=1234 ebx=ffff8000", "sp=3")
    expect("other than SP" in problem(driver), problem(driver))


def comfort(driver):
    """What saves a visitor work."""
    for check in (places, steps, rows, copies, undo, breakpoints, editor):
        check(driver)
