"""What a compiler says of each of many pieces of code, from one run for all of them.

Starting a compiler and reading the headers takes a hundred times longer than a line of code. So the pieces are compiled
together, each under a file name of its own, and each message goes to the piece that it names. A compiler says only once
what is wrong with a template, however many pieces use it. Whoever misses a message therefore asks again with `alone`.
"""
import dataclasses
import os
import re
import subprocess

MESSAGE = re.compile(r"(?:fatal )?(error|warning): ")
NAME = re.compile(r"\bpiece_(\d+)\b")
# What g++ writes before a message, and clang++ after it in a note.
CONTEXT = re.compile(r"In instantiation of|In substitution of|In function|required (?:from|by)|in .constexpr. expansion")


@dataclasses.dataclass
class Message:
    kind: str  # error or warning
    first: str  # the line with its text
    text: str  # with the lines that explain it


class Compiler:
    """A compiler with flags, and what stands before all pieces. Each piece is in a namespace of its own."""

    def __init__(self, command, flags, head):
        self.command, self.flags, self.head = command, flags, head

    def run(self, pieces):
        """All that the compiler says of the pieces."""
        source = self.head + "".join(
            f'\n#line 1 "piece_{i}"\nnamespace of_{i} {{ {piece}\n}}' for i, piece in enumerate(pieces)) + "\n"
        is_clang = "clang" in os.path.basename(self.command)
        limit = "-ferror-limit=0" if is_clang else "-fmax-errors=0"
        done = subprocess.run([self.command, "-std=c++20", "-fsyntax-only", limit, *self.flags, "-x", "c++", "-"],
                              input=source, env={**os.environ, "LC_ALL": "C"}, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True)
        return done.returncode, done.stdout

    def alone(self, piece):
        """The messages of one piece."""
        return messages_of(self.run([piece])[1])[1]

    def together(self, pieces):
        """A list of messages for each piece, and those that name none."""
        found = {i: [] for i in range(len(pieces))}
        lost = []
        for names, message in zip(*messages_of(self.run(pieces)[1])):
            for name in names:
                found[name].append(message)
            if not names:
                lost.append(message)
        return list(found.values()), lost


def messages_of(said):
    """The numbers of the pieces that each message names, and the messages."""
    names, messages, before = [], [], []
    for line in said.split("\n"):
        named = [int(number) for number in NAME.findall(line)]
        if kind := MESSAGE.search(line):
            messages.append(Message(kind[1], line, "\n".join([*before, line])))
            names.append(named[:1] or [int(number) for number in NAME.findall("\n".join(before))][-1:])
            before = []
        elif CONTEXT.search(line) and "note: " not in line:
            before.append(line)
        elif messages:
            messages[-1].text += "\n" + line
            if not names[-1]:
                names[-1] = named[:1]
    return names, messages
