#!/usr/bin/env python3
"""Executes every command of the manual and compares its output with what the page shows.

run_commands.py PROGRAM PAGES OUTPUT [PAGE…]

Each page runs in an empty folder of its own. Code blocks:

  console      lines with "$ " are executed, the lines below are the expected output. "…" stands for any
               text, in a line of its own for any lines. "# exit code N" after a command: it fails so.
  a caption    the block is written to this file first
  sh           not executed; the comment before it says why: <!-- not run: needs ROS 2 -->, or in pages
               that the program writes "(needs …):"

Other blocks are ignored. commands.md, which the program writes, shows commands without their output.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

FENCE = re.compile(r"^```(\S*)[ ]?(\S*)$")
SECONDS = 60.0  # for all commands together


class Block:
    def __init__(self, kind, line, before):
        self.kind, self.line, self.before = kind, line, before
        self.lines, self.caption = [], None


def blocks_of(text):
    """The code blocks of a page in order."""
    block, found, before = None, [], ""
    for number, line in enumerate(text.splitlines(), 1):
        fence = FENCE.match(line)
        if block is not None and line == "```":
            found.append(block)
            block = None
        elif block is not None:
            caption = re.match(r":caption: (\S+)$", line)
            if caption and not block.lines:
                block.caption = caption.group(1)
            elif line or block.lines:
                block.lines.append(line)
        elif fence:
            block = Block(fence.group(2) or fence.group(1), number, before)
        elif line.strip():
            before = line
    return found


def commands_of(block):
    """(command, expected exit code, expected lines)."""
    commands = []
    for line in block.lines:
        if line.startswith("$ "):
            command, _, code = line[2:].partition("  # exit code ")
            commands.append((command, int(code or 0), []))
        elif commands:
            commands[-1][2].append(line)
    return commands


def matches(expected, actual):
    """Whether the output is the expected one; lines that are "…" alone stand for any lines."""
    pattern = ""
    for line in expected:
        if line.strip() == "…":
            pattern += r"(?:.*\n)*?"
        else:
            pattern += ".*".join(re.escape(part) for part in line.split("…")) + "\n"
    return re.fullmatch(pattern, actual if actual.endswith("\n") or not actual else actual + "\n")


def run(command, folder, environment):
    done = subprocess.run(["bash", "-c", command], cwd=folder, env=environment, text=True, timeout=SECONDS,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    return done.returncode, done.stdout


def check_page(page, folder, environment):
    """Executes a page; returns the number of commands and the problems."""
    count, problems = 0, []
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for block in blocks_of(page.read_text(encoding="utf-8")):
        where = f"{page.name}:{block.line}"
        if block.caption:
            (folder / block.caption).write_text("\n".join(block.lines) + "\n", encoding="utf-8")
        if block.kind in ("sh", "bash") and "not run:" not in block.before and "(needs " not in block.before:
            problems.append(f"{where}: a block that is not run needs a reason (<!-- not run: … -->)")
        if block.kind != "console":
            continue
        for command, code, expected in commands_of(block):
            count += 1
            got, output = run(command, folder, environment)
            if got != code:
                problems.append(f"{where}: {command}\nexit code {got}, expected {code}\n{output}")
            elif (expected or page.name != "commands.md") and not matches(expected, output):
                wanted = "\n".join(expected)
                problems.append(f"{where}: {command}\nexpected:\n{wanted}\ngot:\n{output}")
    return count, problems


def main():
    program, pages, output = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    tools = output / "bin"
    shutil.rmtree(output, ignore_errors=True)
    tools.mkdir(parents=True)
    (tools / "hunavsim").symlink_to(program.resolve())
    environment = dict(os.environ, PATH=f"{tools}:{os.environ['PATH']}", QT_QPA_PLATFORM="offscreen",
                       NO_COLOR="1", LC_ALL="C.UTF-8")
    environment.pop("DISPLAY", None)
    begin, count, problems = time.monotonic(), 0, []
    only = sys.argv[4:]
    for page in sorted(pages.glob("*.md")):
        if not only or page.name in only:
            commands, found = check_page(page, output / page.parent.name / page.stem, environment)
            count += commands
            problems += found
    seconds = time.monotonic() - begin
    for problem in problems:
        print(problem + "\n", file=sys.stderr)
    print(f"{count} commands in {seconds:.1f} s, {len(problems)} problems")
    if not only and count < 40:
        sys.exit("too few commands: are the pages there?")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
