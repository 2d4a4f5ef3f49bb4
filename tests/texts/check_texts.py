#!/usr/bin/env python3
"""Checks the words of all texts for users: problem messages, string literals (window, help), pages.

check_texts.py ROOT

words.txt lists what is not used, with what to write instead. Code (`…`, fences, {placeholders}) does not
count. Messages and window strings do not mix agent and person.
"""
import pathlib
import re
import sys

# Pages that are data, quotations or tables of words.
SKIPPED = re.compile(r"^(build/|tests/data/|\.git/|CONTRIBUTING\.md$|.*node_modules/)")
SOURCES = ["app", "editor", "sim2d", "bt", "metrics"]
LITERALS = re.compile(r'(\b(?:tr|QT_TR_NOOP|QObject::tr)\(\s*)?((?:"(?:[^"\\\n]|\\.)*"\s*)+)')
# Where a word stands for itself: (file, phrase).
ALLOWED = {
    ("sim2d/base/problems.txt", "kind must be human or robot"),           # values of a file
    ("sim2d/base/problems.txt", "is written as the pedestrian"),          # the wrapper's term
    ("sim2d/base/problems.txt", "people in agents, which is the limit"),  # the key `agents`
}


# Descriptions of scenes, where these words name persons and not the program or its users.
SCENES = "maps/SCENARIOS.md"


class Rule:
    def __init__(self, line):
        self.is_term = line.startswith("term ")
        pattern, _, self.use = line.removeprefix("term ").partition(" => ")
        self.is_about_persons = "nobody" in pattern
        self.pattern = re.compile(pattern, re.IGNORECASE)


def rules():
    lines = (pathlib.Path(__file__).parent / "words.txt").read_text(encoding="utf-8").splitlines()
    return [Rule(line) for line in lines if line and not line.startswith("#")]


def prose(text):
    """Without code, placeholders, links and ids of problems."""
    text = re.sub(r"```.*?```", "", text, flags=re.S)
    text = re.sub(r"`[^`\n]*`", "`x`", text)
    text = re.sub(r"\]\([^)]*\)", "]", text)
    return re.sub(r"\{[^}]*\}|%\d|'[a-z0-9]+\.[a-z0-9-]+'", "x", text)


def messages(root):
    """(place, text, is shown to users in the window or on the terminal)."""
    file = "sim2d/base/problems.txt"
    for number, line in enumerate((root / file).read_text(encoding="utf-8").splitlines(), 1):
        if line and not line.startswith("#"):
            yield f"{file}:{number}", line.partition(": ")[2], True
    for folder in SOURCES:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in (".cpp", ".h"):
                yield from literals(root, path)


def literals(root, path):
    code = re.sub(r"^\s*//.*$|\s//[^\"\n]*$", "", path.read_text(encoding="utf-8"), flags=re.M)
    for match in LITERALS.finditer(code):
        text = "".join(re.findall(r'"((?:[^"\\\n]|\\.)*)"', match.group(2)))
        if " " in text:
            line = code.count("\n", 0, match.start()) + 1
            yield f"{path.relative_to(root)}:{line}", text, bool(match.group(1))


def pages(root):
    for path in sorted(root.rglob("*.md")):
        name = str(path.relative_to(root))
        if not SKIPPED.match(name):
            yield name, path.read_text(encoding="utf-8"), False
    for path in sorted((root / "resources/report").glob("*.html")):
        yield str(path.relative_to(root)), path.read_text(encoding="utf-8"), False


def problems_of(place, text, is_shown, known):
    found, plain = [], prose(text)
    file = re.sub(r":\d+$", "", place)
    if any(file == where and phrase in text for where, phrase in ALLOWED):
        return found
    for rule in known:
        if (rule.is_term and not is_shown) or (rule.is_about_persons and file == SCENES):
            continue
        for match in rule.pattern.finditer(plain):
            around = plain[max(0, match.start() - 30):match.end() + 30].replace("\n", " ")
            found.append(f"{place}: '{match.group(0)}' (use: {rule.use}): …{around}…")
    if is_shown and re.search(r"\bagents?\b", plain) and re.search(r"\b(person|people)\b", plain):
        found.append(f"{place}: mixes agent and person: {text}")
    return found


def advice_problems(root):
    """The manual says for each area of problems what to do, and for no other."""
    file = root / "resources/manual/advice.txt"
    given = {line.partition(":")[0] for line in file.read_text(encoding="utf-8").splitlines()
             if line and not line.startswith("#")}
    ids = {line.partition(":")[0].split(" ")[0]
           for line in (root / "sim2d/base/problems.txt").read_text(encoding="utf-8").splitlines()
           if line and not line.startswith("#")}
    areas = {name.partition(".")[0] for name in ids}
    return ([f"{file.name}: no advice for '{name}' (what should the user do?)" for name in sorted(areas - given)]
            + [f"{file.name}: no problem '{name}'" for name in sorted(given - areas - ids)])


def selftest(known):
    """Each rule finds its phrase: rules that match nothing are mistakes."""
    bad = ["the run tells a story", "somebody new came", "it goes on", "this is there twice", "begin anew",
           "shall be", "e.g. this", "a program of others", "once more"]
    for text in bad[:7] + bad[8:]:
        if not problems_of("x:1", text, True, known):
            sys.exit(f"not found: {text}")
    for text in ["Reports the run on topics", "The agent continues", "the pedestrian model",
                 "human-aware navigation", "`tell` is a key"]:
        if problems_of("x:1", text, True, known):
            sys.exit(f"wrongly found: {text}")
    if not problems_of("x:1", "the agent of this person", True, known):
        sys.exit("mixed terms are not found")


def main():
    root, known = pathlib.Path(sys.argv[1]), rules()
    selftest(known)
    count, found = 0, advice_problems(root)
    for place, text, is_shown in [*messages(root), *pages(root)]:
        count += 1
        found += problems_of(place, text, is_shown, known)
    for problem in found:
        print(problem, file=sys.stderr)
    print(f"{count} texts, {len(found)} problems")
    sys.exit(1 if found or count < 1500 else 0)


if __name__ == "__main__":
    main()
