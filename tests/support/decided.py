"""Questions that a solver or a prover has answered, kept by their digests.

A proof takes minutes and its question rarely changes. So the answer of a question that has been asked is taken from a
list in the tree, and only a changed question is asked again. What stands in a list was answered by the program that its
first line names. `./test nightly` asks every question again.
"""
import hashlib
import sys


def digest(question):
    return hashlib.sha256(question.encode("utf-8")).hexdigest()


class Decided:
    """The list in a file: a line for each question, its digest and what it is about. With `again`, it knows none."""

    def __init__(self, path, again=False):
        self.path, self.used, self.asked = path, {}, set()
        self.known = set()
        if not again:
            with open(path, encoding="utf-8") as file:
                self.known = {line.split()[0] for line in file if line.strip() and not line.startswith("#")}

    def has(self, question, subject):
        """Whether it has been answered. If not, the caller asks it."""
        key = digest(question)
        self.used[key] = subject
        if key in self.known:
            return True
        self.asked.add(key)
        return False

    def check(self):
        """Ends the test if the list has a question that nobody asks any more: a proof may have lost it."""
        if unasked := self.known - self.used.keys():
            sys.exit(f"{self.path}: {len(unasked)} questions are no longer asked; if that is right, --record drops them")

    def write(self, title):
        """Replaces the list by the questions of this run, all of which have been answered."""
        with open(self.path, "w", encoding="utf-8") as file:
            file.write(f"# {title}\n")
            file.writelines(f"{key} {subject}\n" for key, subject in self.used.items())

    def summary(self):
        return f"{len(self.used)} questions, {len(self.asked)} asked, {len(self.used) - len(self.asked)} decided before"
