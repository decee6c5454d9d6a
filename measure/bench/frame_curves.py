"""Draws frames per second against vertices, from the JSON of scale_bench: frame_curves.py FRAMES.json OUT.svg

It takes the frames of one thread, and their processor time, so that other programs disturb little."""
import json
import math
import sys

WIDTH, HEIGHT = 740, 420
LEFT, RIGHT, TOP, BOTTOM = 80, 720, 50, 360
VERTICES = 114  # of a ball
X_RANGE, Y_RANGE = (3, 7.2), (0, 5.5)  # powers of ten: vertices, frames per second
CURVES = (("frame<Type>", "q16_16_i386", "#ffb454"), ("frame<double>", "double", "#6cb6ff"))
SCREEN = 60  # frames per second of the original


def x_of(vertices):
    share = (math.log10(vertices) - X_RANGE[0]) / (X_RANGE[1] - X_RANGE[0])
    return LEFT + share * (RIGHT - LEFT)


def y_of(frames):
    share = (math.log10(frames) - Y_RANGE[0]) / (Y_RANGE[1] - Y_RANGE[0])
    return BOTTOM - share * (BOTTOM - TOP)


def text(x, y, words, anchor="middle", fill="#ddd"):
    return f'<text x="{x:.0f}" y="{y:.0f}" fill="{fill}" text-anchor="{anchor}">{words}</text>'


def line(x1, y1, x2, y2, style):
    return f'<path d="M{x1:.1f},{y1:.1f}L{x2:.1f},{y2:.1f}" {style}/>'


def rates(results, name):
    """Balls and frames per second of one thread, in order of the balls."""
    seconds = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3}
    found = []
    for run in results["benchmarks"]:
        fields = run["name"].split("/")
        if fields[0] == name and "threads:1" in fields:
            balls = int(fields[1].removeprefix("objects:"))
            found.append((balls, 1 / (run["cpu_time"] * seconds[run["time_unit"]])))
    return sorted(found)


def picture(results):
    grid = 'stroke="#3a3f4a"'
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" '
             f'height="{HEIGHT}" font-family="sans-serif" font-size="13">',
             f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#14161a"/>']
    for power in range(0, 6):
        y = y_of(10 ** power)
        parts += [line(LEFT, y, RIGHT, y, grid), text(LEFT - 8, y + 4, f"{10 ** power:,}", "end")]
    for balls, _ in rates(results, CURVES[0][0]):
        x = x_of(balls * VERTICES)
        parts += [line(x, TOP, x, BOTTOM, grid), text(x, TOP - 8, f"{balls:,}"),
                  text(x, BOTTOM + 18, f"{balls * VERTICES:,}")]
    parts += [text(LEFT, 20, "frames per second, of one thread, against objects (above) and vertices (below)", "start"),
              line(LEFT, y_of(SCREEN), RIGHT, y_of(SCREEN), 'stroke="#888" stroke-dasharray="4 4"'),
              text(LEFT + 6, y_of(SCREEN) - 5, f"{SCREEN} frames per second", "start", "#aaa")]
    for row, (name, label, color) in enumerate(CURVES):
        points = [(x_of(balls * VERTICES), y_of(rate)) for balls, rate in rates(results, name)]
        parts += [f'<path d="M{"L".join(f"{x:.1f},{y:.1f}" for x, y in points)}" fill="none" stroke="{color}" '
                  'stroke-width="2"/>']
        parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{color}"/>' for x, y in points]
        parts += [text(RIGHT - 120, TOP + 24 + 20 * row, label, "start", color)]
    return "\n".join(parts + ["</svg>"]) + "\n"


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as source:
        drawn = picture(json.load(source))
    with open(sys.argv[2], "w", encoding="utf-8") as out:
        out.write(drawn)
