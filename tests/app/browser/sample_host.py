"""Times as `fixproof measure --host --json` writes them, made up: what the page draws from them is known."""


def times(t):
    return {"min": t * 0.9, "median": t, "spread": 0.05} if t else None


def judged(rms):
    return {"cases": 1000, "exceptions": 0,
            "accuracy": {"max": 2 * rms, "mean": 0.0, "rms": rms, "correct": 1.0}}


def row(operation, contender, kind, nanoseconds, chain, rms):
    return {"operation": operation, "contender": contender, "alike": "", "kind": kind, "rounding": "half up",
            "throughput_ns": times(nanoseconds), "chain_ns": times(chain), **judged(rms)}


def vertex(contender, kind, nanoseconds, rms):
    return {"contender": contender, "alike": "", "kind": kind, "rounding": "half up", "ns": times(nanoseconds),
            "per_second": {"most": 1e9 / (nanoseconds * 0.9), "median": 1e9 / nanoseconds}, **judged(rms)}


HOST = {
    "made": {"command": "measure --host", "seed": 1994, "compiler": "none", "date": "2000-01-01T00:00:00Z",
             "flags": "", "processor": "none"},
    "libraries": {"libfixmath": True, "FreeType": True}, "rounds": 9,
    "operands": {"arrays": {"mul": 2048, "div": 2048}, "chains": {"mul": 2048, "div": 2048}},
    "host": [
        row("mul", "q16_16", "type", 0.52, 1.9, 0.289),
        row("mul", "q16_16_i386_unrounded", "type", 0.4, 1.6, 0.577),
        row("mul", "idiom", "plain", 0.51, 1.9, 0.29),
        row("mul", "libfixmath", "library", 10.2, 12.5, 0.289),
        row("mul", "FreeType", "library", 2.69, 4.1, 0.2887),
        row("mul", "float", "floating", 0.19, None, 40.0),
        row("mul", "q16_16_saturating", "type", 0.55, 1.9, 0.4),
        row("mul", "double", "floating", 0.6, 1.7, 0.0),
        row("div", "q16_16", "type", 0.88, 5.0, 0.289),
        row("div", "libfixmath", "library", 49.0, 51.0, 0.2891),
    ],
    "vertices": [vertex("q16_16", "type", 8.5, 0.31)],
}
