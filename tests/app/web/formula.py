"""Formulas that a visitor pastes into the playground: the rule that each follows, or what is wrong with it."""
from inputs import value
from links import choose, write
from page import cells, expect, expect_equal, open_page, text
from selenium.webdriver.common.by import By

# For each operation: formulas and the rules that they follow, worked out by hand. The words are 16.16.
FOLLOWS = {
    "mul": {
        "(a * b + 0x8000) >> 16": "half up",
        "return (int64_t)a * b >> 16;": "down (floor)",
        "a * b / 65536": "toward zero",
        "-(-(a * b) >> 16)": "up (ceiling)",
        "(a * b + 0x7fff + (a * b >> 16 & 1)) >> 16": "half to even",
        "(a * b + (a * b < 0 ? -32768 : 32768)) / 65'536LL": "half away from zero",
    },
    "div": {
        "(a << 16) / b": "toward zero",
        "((a << 16) - ((a << 16) % b + b) % b) / b": "down (floor)",
    },
    "add": {"a + b": "every rule", "-(~a + !0 - b + 0)": "every rule"},
    "sub": {"a - b": "every rule"},
}
# What a formula shows that follows no rule.
WRONG = {
    # The product loses its upper half.
    "((int32_t)(a * b)) >> 16": "It follows no rule.",
    # The fraction of b is lost.
    "a * (b >> 16)": "It follows no rule.",
}
ERRORS = {
    " ": "it ends where a, b or a number should be", "a *": "it ends where a, b or a number should be",
    "(a": "it ends where \u201c)\u201d should be", "a b": "\u201cb\u201d stands where an operator should be",
    "a + c": "\u201cc\u201d stands where a, b or a number should be", "a $ b": "what is \u201c$\u201d?",
    "a ? b": "it ends where \u201c:\u201d should be", "099": "a number is wrong",
}


def verdict(driver):
    return " ".join(text(driver, ".verdict").split())


def formula(driver):
    """A formula follows the rule that it should."""
    open_page(driver, "#view=operation&op=mul")
    for operation, formulas in FOLLOWS.items():
        choose(driver, "Operation", operation)
        for typed, rule in formulas.items():
            write(driver, "Formula", typed)
            expect(verdict(driver).startswith(f"It follows {rule} on all "), f"{operation}, {typed}: {verdict(driver)}")
            if operation != "div":
                expect(verdict(driver).endswith("Out of range, it wraps."), f"{typed}: {verdict(driver)}")
    choose(driver, "Operation", "mul")
    for typed, said in WRONG.items():
        write(driver, "Formula", typed)
        expect(verdict(driver).startswith(said), f"{typed}: {verdict(driver)}")
    for typed, said in ERRORS.items():
        write(driver, "Formula", typed)
        problems = [e.text for e in driver.find_elements(By.CSS_SELECTOR, ".problem")]
        expect_equal(problems, ["", f"The formula: {said}."], typed)
    # A sum that saturates, and one that does neither.
    choose(driver, "Operation", "add")
    write(driver, "Formula", "a + b > 0x7fffffff ? 0x7fffffff : a + b < -0x80000000 ? -0x80000000 : a + b")
    expect(verdict(driver).endswith("Out of range, it saturates."), verdict(driver))
    write(driver, "Formula", "a + b > 0x7fffffff ? 0 : a + b")
    expect(verdict(driver).endswith("Out of range, it neither wraps nor saturates."), verdict(driver))
    # The first case that differs is one, and a click shows it: -1 unit times 0.5 is half a unit below 0.
    choose(driver, "Operation", "mul")
    write(driver, "Formula", "(a * b + 0x8000) >> 16")
    row = next(e for e in driver.find_elements(By.CSS_SELECTOR, "[aria-label='The formula and every rule'] tbody tr")
               if e.text.startswith("half away"))
    row.find_element(By.TAG_NAME, "button").click()
    said, wanted = [e.text for e in row.find_elements(By.TAG_NAME, "td")][2:]
    expect_equal([f"0x{cells(driver, '#view', rule)[1]}" for rule in ("half up", "half away from zero")], [said, wanted],
                 f"the case {value(driver, 'First')} {value(driver, 'Second')}")
    expect(said != wanted, "a case that differs has one word")
    # In another format, the first formula is another one; a typed one stays.
    open_page(driver, "#view=operation&op=mul&in=q8_8&a=1&b=1")
    expect_equal(value(driver, "Formula"), "(a * b + 0x80) >> 8", "the first formula of q8_8")
    for name in ("q8_0", "u0_8", "q1_63", "u0_64"):
        choose(driver, "Format", name)
        expect(verdict(driver).startswith("It follows "), f"{name}: {verdict(driver)}")
