# SPDX-License-Identifier: BSD-2-Clause
"""Reads the shell examples of Markdown pages.

An example is a block (indented, or fenced without a language or as sh, bash, console) with a line that begins with `soarbox`,
`./dev soarbox`, `./dev run` or `$`. A comment in a separate line before a block has this meaning:

  <!-- not run: REASON -->    it needs a window, a network or another program, or shows a form instead of a command
  <!-- output -->             the lines after `$ COMMAND` are its output; a line `...` matches any number of lines
  <!-- exit N -->             its last command has the exit code N instead of 0
  <!-- file: NAME -->         the block, of any language, is the content of this file, for the examples after it
  <!-- before: COMMAND -->    this command runs first: it creates files that the reader has at this point

These are not examples, even without a comment: a line with [OPTIONAL] or a PLACEHOLDER in capitals, which is a form; servers, which run
until they are ended (tests/app/test_manual.py starts them); and commands of ./dev that build.
"""
import dataclasses
import re

COMMENT = re.compile(r"^\s*<!--\s*(not run|output|exit|file|before)\b:?\s*(.*?)\s*-->\s*$")
FENCE = re.compile(r"^(\s*)```(\w*)\s*$")
SHELL = ("", "sh", "bash", "console")
STARTS = re.compile(r"^(\$ |soarbox\b|\./dev (soarbox|run)\b|cd |echo )")
RUNS = re.compile(r"^(\$ )?(soarbox|\./dev (soarbox|run))\b")
PLACEHOLDER = re.compile(r"(?<![\w./-])[A-Z]{2,}(?![\w.=(])")
FORM = re.compile(r"\[[^\]]*\]|\.\.\.")
SERVES = re.compile(r"^soarbox (serve|kernel|lsp|dap|mcp|help --man)\b|--watch\b|--browser\b")


@dataclasses.dataclass
class Example:
    """One command, with its expected result."""
    line: int
    command: str
    expected: list = dataclasses.field(default_factory=list)  # Lines; compared if `compares`.
    compares: bool = False
    code: int = 0
    files: dict = dataclasses.field(default_factory=dict)  # Written before it.
    before: list = dataclasses.field(default_factory=list)  # Commands that run before it.


def blocks(text):
    """Number of the first line, language, lines and comments of each block of code."""
    lines = text.split("\n")
    comments, at = [], 0
    while at < len(lines):
        line = lines[at]
        comment, fence = COMMENT.match(line), FENCE.match(line)
        if comment:
            comments.append((comment[1], comment[2]))
            at += 1
        elif fence:
            end = next(n for n in range(at + 1, len(lines)) if lines[n].strip() == "```")
            indent = len(fence[1])
            yield at + 2, fence[2], [one[indent:] for one in lines[at + 1:end]], comments
            comments, at = [], end + 1
        elif line.startswith("    ") and (at == 0 or not lines[at - 1].strip()):
            end = at
            while end < len(lines) and (lines[end].startswith("    ") or not lines[end].strip()):
                end += 1
            while not lines[end - 1].strip():
                end -= 1
            indent = min(len(one) - len(one.lstrip()) for one in lines[at:end] if one.strip())
            yield at + 1, "", [one[indent:] for one in lines[at:end]], comments
            comments, at = [], end
        else:
            if line.strip():
                comments = []
            at += 1


def without_comment(command):
    return re.sub(r"\s+#.*$", "", command)


def is_form(command):
    """Whether a line is a form with placeholders instead of a command."""
    bare = re.sub(r"\"[^\"]*\"|'[^']*'", "", without_comment(command))
    return bool(FORM.search(bare) or PLACEHOLDER.search(re.sub(r"\b[A-Z_]+=", "", bare)))


def examples(text):
    """All examples of a page, in order."""
    files, before = {}, []
    for number, language, lines, comments in blocks(text):
        said = dict(comments)
        before += [value for name, value in comments if name == "before"]
        if "file" in said:
            files[said["file"]] = "\n".join(lines) + "\n"
            continue
        if "not run" in said:
            if not said["not run"]:
                raise ValueError(f"line {number}: say why this is not run")
            continue
        if language not in SHELL or not any(RUNS.match(line) for line in lines):
            continue
        made, joined = [], ""
        for offset, line in enumerate(lines):
            if joined or (STARTS.match(line) and line.rstrip().endswith("\\")):
                joined += line.rstrip().rstrip("\\") + " "
                if line.rstrip().endswith("\\"):
                    continue
                line, joined = joined.strip(), ""
            if STARTS.match(line):
                made.append(Example(number + offset, line.removeprefix("$ ").replace("./dev soarbox", "soarbox").replace("./dev run", "soarbox run")))
            elif made and "output" in said:
                made[-1].expected.append(line)
        made = [one for one in made if not is_form(one.command) and not SERVES.search(one.command)]
        for one in made:
            one.compares = "output" in said
        if made:
            made[0].files, made[0].before = dict(files), list(before)
            files, before = {}, []
            made[-1].code = int(said.get("exit") or 0)
        yield from made
