#!/usr/bin/env python3
"""usage: write_scenes.py SCENE.json... OUT.cpp

Writes the scenes as C++, because a reader of JSON would double the size of the module. It knows only the keys of
these scenes, and ends with status 1 at any other key. The test web.frames compares the frames with those of the
command, which reads the JSON itself.
"""
import json
import pathlib
import re
import sys


def braces(values):
    return "{" + ", ".join(number(v) for v in values) + "}"


def number(value):
    return ("true" if value else "false") if isinstance(value, bool) else repr(value)


def word(kind):
    """Returns a writer of a JSON string as a value of an enumeration."""
    return lambda value: f"{kind}::{value.replace('-', '_')}"


def paint(value):
    if isinstance(value, str):
        value = [int(value[i:i + 2], 16) for i in (1, 3, 5)]
    return f"{{.is_index = false, .color = {braces(value)}}}" if isinstance(value, list) else f"{{.index = {value}}}"


def fields(kind, keys):
    """Returns a writer of a JSON object as an initialiser, in the order of the struct."""
    def write(value):
        unknown = set(value) - set(keys)
        if unknown:
            sys.exit(f"write_scenes.py: {kind} has {', '.join(sorted(unknown))}, which this program does not know")
        return kind + "{" + ", ".join(f".{name} = {keys[name](value[name])}" for name in keys if name in value) + "}"
    return write


SURFACE = fields("Surface", {"kind": word("SurfaceKind"), "ramp": number, "phong": word("PhongForm"),
                             "exact_every": number, "pattern": word("Pattern"), "texels": braces})
SHADING = fields("Shading", {"ambient": number, "diffuse": number})
SPIN = fields("Spin", {"tenths": braces, "delay": braces})
DRIFT = fields("Drift", {"step": braces, "stop_z": number, "bounce_z": lambda v: "Bounds" + braces(v), "delay": braces})
ORBIT = fields("Orbit", {"about": braces, "radius": number, "start_tenths": number, "step_tenths": number,
                         "tilt_tenths": number})
SPOT = fields("Spot", {"on": number, "direction": braces, "intensity": braces})
LIGHTS = fields("Lights", {"ambient_on": number, "ambient": braces,
                           "spots": lambda spots: "{" + ", ".join(map(SPOT, spots)) + "}"})
CAMERA = fields("Camera", {"page": braces, "position": braces, "turn_tenths": braces})
SCENE = {"name": json.dumps, "width": number, "height": number, "frames_per_second": number,
         "conversion": word("Conversion"), "trigonometry": word("Trigonometry"), "depth_key": word("DepthKey"), "palette": word("PaletteKind"),
         "near": number, "restore_every": number, "camera": CAMERA, "lights": LIGHTS}
OBJECT = {"name": json.dumps, "page": braces, "position": braces, "spin": SPIN, "drift": DRIFT, "orbit": ORBIT}
PAINTS = ("paint", "paints", "checks")


def surface(value):
    value = dict(value)
    for pattern, texels in value.pop("bitmap", {}).items():
        value |= {"pattern": pattern, "texels": texels}
    return SURFACE(value)


def write_object(lines, values):
    lines.append("  {\n    ObjectDescription o;")
    values = dict(values)
    (shape, size), = values.pop("shape").items()
    around = 2 * size.get("bands", 0)
    lines.append(f"    o.mesh = {shape}({', '.join(number(v) for v in size.values())});")
    kind, = values.keys() & set(PAINTS)
    given = values.pop(kind)
    if kind == "paint":
        lines.append(f"    o.paints.assign(o.mesh.faces.size(), Paint{paint(given)});")
    elif kind == "paints":
        lines.append(f"    o.paints = {{{', '.join('Paint' + paint(p) for p in given)}}};")
    else:
        lines.append(f"    for (std::size_t f = 0; f < o.mesh.faces.size(); ++f) {{\n"
                     f"      o.paints.push_back((f / {around} + f % {around}) % 2 == 0 ? Paint{paint(given[0])} "
                     f": Paint{paint(given[1])});\n    }}")
    if "shading" in values:
        lines.append(f"    o.shadings.assign(o.mesh.faces.size(), {SHADING(values.pop('shading'))});")
    if "surface" in values:
        lines.append(f"    o.surface = {surface(values.pop('surface'))};")
    for key, value in values.items():
        lines.append(f"    o.{key} = {OBJECT[key](value)};")
    lines.append("    add(scene, std::move(o));\n  }")


def has_paints(values):
    return any(key in values for key in PAINTS)


def write_scene(index, file):
    text = re.sub(r"^\s*//.*", "", pathlib.Path(file).read_text(), flags=re.M)
    values = json.loads(text)
    lines = [f"Scene scene_{index}() {{\n  Scene scene;"]
    defaults = values.pop("defaults", {})
    objects = values.pop("objects")
    values.pop("arithmetic", None)  # the page chooses
    for key, value in values.items():
        lines.append(f"  scene.{key} = {SCENE[key](value)};")
    for number_, each in enumerate(objects):
        kept = {k: v for k, v in defaults.items() if k not in PAINTS or not has_paints(each)}
        write_object(lines, {"name": f"object {number_}"} | kept | each)
    lines.append("  return scene;\n}\n")
    return "\n".join(lines)


def main():
    *files, out = sys.argv[1:]
    text = ("// Written by app/web/write_scenes.py from xsharp/scenes/.\n#include \"app/web/scenes.hpp\"\n\n#include <utility>\n\n"
            "#include \"xsharp/normals.hpp\"\n#include \"xsharp/shapes.hpp\"\n\nnamespace fixproof::web {\n\n"
            "namespace {\n\nusing namespace xsharp;\n\n"
            "/// Adds an object, with the normals that its surface and its shading need.\n"
            "void add(Scene& scene, ObjectDescription object) {\n"
            "  if (needs_normals(object.surface)) object.mesh = with_vertex_normals(std::move(object.mesh));\n"
            "  object.mesh = with_normals(std::move(object.mesh), [&object](std::size_t face) {\n"
            "    return face < object.shadings.size() && object.shadings[face].diffuse;\n  });\n"
            "  scene.objects.push_back(std::move(object));\n}\n\n")
    text += "\n".join(write_scene(i, file) for i, file in enumerate(files))
    names = ", ".join(json.dumps(pathlib.Path(file).stem) for file in files)
    cases = "".join(f"    case {i}:\n      return scene_{i}();\n" for i in range(1, len(files)))
    text += (f"\n}}  // namespace\n\nconst std::array<std::string_view, scene_count> scene_names{{{names}}};\n\n"
             f"Scene scene_at(std::size_t index) {{\n  switch (index) {{\n{cases}"
             "    default:\n      return scene_0();\n  }\n}\n\n}  // namespace fixproof::web\n")
    pathlib.Path(out).write_text(text)


main()
