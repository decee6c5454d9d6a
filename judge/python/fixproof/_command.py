"""Finds and starts the command `fixproof`."""
import os
import shutil
import subprocess
from contextlib import contextmanager
from typing import IO, Iterator, List, Optional


class Error(Exception):
    """Something could not be judged. The message names the thing, the place and the fix."""

    __module__ = "fixproof"


def command() -> str:
    """Returns the path of the command: that of $FIXPROOF if it is set, else the one on the PATH.

    Raises Error, with what to do, if there is no such program.
    """
    named = os.environ.get("FIXPROOF")
    if named:
        found = shutil.which(named)
        if found is None:
            raise Error(f"FIXPROOF={named}: no such program; set FIXPROOF to the command fixproof, "
                        "such as build/release/fixproof of a clone in which ./run has run")
        return os.path.abspath(found)
    found = shutil.which("fixproof")
    if found is None:
        raise Error("the command fixproof is not on the PATH; set FIXPROOF to it, such as "
                    "FIXPROOF=build/release/fixproof of a clone in which ./run has run")
    return os.path.abspath(found)


def message_of(stderr: bytes, status: int) -> str:
    """Returns what the command says of a failure, in one line."""
    text = " ".join(stderr.decode(errors="replace").split())
    return (text.removeprefix("fixproof: ")
            or f"the command fixproof ended with status {status} and said nothing")


@contextmanager
def started(arguments: List[str], stdin: Optional[int] = None,
            folder: Optional[str] = None) -> Iterator["subprocess.Popen[bytes]"]:
    """Starts the command in `folder`, with pipes. It has ended when the block is left."""
    program = command()
    try:
        process = subprocess.Popen([program, *arguments], stdin=stdin or subprocess.DEVNULL,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   cwd=folder)
    except OSError as error:
        raise Error(f"{program} cannot be started: {error.strerror}; set FIXPROOF to the command "
                    "fixproof") from error
    try:
        yield process
    finally:
        process.kill()
        for pipe in (process.stdin, process.stdout, process.stderr):
            _close(pipe)
        process.wait()


def _close(pipe: Optional[IO[bytes]]) -> None:
    if pipe is None:
        return
    try:
        pipe.close()
    except BrokenPipeError:
        pass  # The command has ended without what is still in the buffer.
