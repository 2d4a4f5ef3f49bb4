#!/usr/bin/env python3
"""Checks that the translations of the window are complete: check_translations.py ROOT LUPDATE

Texts are extracted from the sources again, so a text that was added or changed without its
translations fails. Update the files with the target `update_translations`, then translate with
Qt Linguist.
"""
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path

FOLDERS = ["editor", "app/window", "resources/translations"]


def updated(root, lupdate, file, folder):
    """A copy of the file with the texts that the sources have now."""
    copy = Path(folder) / file.name
    shutil.copy(file, copy)
    command = [lupdate, "-silent", "-locations", "none", "-no-obsolete", "-I", "."]
    subprocess.run(command + FOLDERS + ["-ts", str(copy)], cwd=root, check=True,
                   stderr=subprocess.DEVNULL)
    return copy


def mnemonics(text):
    return re.findall(r"&(?=\w)", re.sub(r"&\w+;", "", text))


def problems_of(source, text):
    """What a translation lacks compared with its source."""
    ends = [t.split("\t")[0].rstrip().endswith("…") for t in (source, text)]
    edges = [re.match(r"^(\s*).*?(\s*)$", t, re.S).groups() for t in (source, text)]
    marks = [sorted(re.findall(r"%\d+|%n", t)) for t in (source, text)]
    checks = {
        "other placeholders": marks[0] != marks[1],
        "numbers of the locale (%L)": "%L" in text,
        "another number of shortcut letters (&)": len(mnemonics(source)) != len(mnemonics(text)),
        "an ellipsis in one of them only": ends[0] != ends[1],
        "other spaces at an end": edges[0] != edges[1],
        "other line breaks or tabs": [source.count(c) for c in "\n\t"] != [text.count(c) for c in "\n\t"],
    }
    return [name for name, is_wrong in checks.items() if is_wrong]


def check(file):
    problems = []
    for context in ElementTree.parse(file).getroot().iter("context"):
        for message in context.iter("message"):
            source = message.findtext("source")
            translation = message.find("translation")
            text = "".join(translation.itertext())
            if translation.get("type") == "unfinished" or not text:
                found = ["not translated"]
            else:
                found = problems_of(source, text)
            place = f"{file.name}: {context.findtext('name')}: {source!r}"
            problems += [f"{place}: {each}" for each in found]
    return problems


def main():
    root, lupdate = Path(sys.argv[1]), sys.argv[2]
    files = sorted((root / "resources/translations").glob("hunavsim_*.ts"))
    problems = [] if files else ["no translations"]
    with tempfile.TemporaryDirectory() as folder:
        for file in files:
            problems += check(updated(root, lupdate, file, folder))
    print("\n".join(problems))
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
