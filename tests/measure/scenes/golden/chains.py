"""Which edges bound the rows of a polygon, as X-Sharp's fill has them, row by row."""


def chains(points):
    """The first row, and for the left and the right end of every row from there on an edge (the
    numbers of its upper and lower point) and the y at which it is taken."""
    ys = [y for _, y in points]
    top, bottom = min(ys), max(ys)
    if top == bottom:
        return 0, ([], [])
    count = len(points)
    first = last = ys.index(top)
    while ys[first - 1] == top:
        first = (first - 1) % count
    while ys[(last + 1) % count] == top:
        last = (last + 1) % count
    (x, y), after, before = points[first], points[(last + 1) % count], points[first - 1]
    flat = x != points[last][0]
    if flat:
        forward = x > points[last][0]
    else:
        forward = (after[0] - x) * (before[1] - y) < (after[1] - y) * (before[0] - x)
    starts = (last, first) if forward else (first, last)
    steps = (1, -1) if forward else (-1, 1)
    rows = bottom - top - 1 + flat
    sides = []
    for start, step in zip(starts, steps):
        side, upper = [], start
        while upper != ys.index(bottom):
            lower = (upper + step) % count
            side += [(upper, lower, own) for own in range(ys[upper], ys[lower])]
            upper = lower
        sides.append(side[not flat:][:rows])
    return top + (not flat), sides


def spans(points, width, height):
    """The pixels of a polygon on a page: y, the first x and the x after the last."""
    top, (left, right) = chains(points)

    def crossing(upper, lower, own):
        (x0, y0), (x1, y1) = points[upper], points[lower]
        return x0 - (x0 - x1) * (own - y0) // (y1 - y0)

    for y, (one, other) in enumerate(zip(left, right), top):
        first, end = max(crossing(*one), 0), min(crossing(*other), width)
        if 0 <= y < height and first < end:
            yield y, first, end
