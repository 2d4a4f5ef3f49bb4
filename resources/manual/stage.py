#!/usr/bin/env python3
"""Writes the folder from which Sphinx builds the manual: the pages of this folder, the reference pages
that the program writes from its tables, pages of the repository, and pictures.

stage.py PROGRAM ROOT OUTPUT
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

# Lists that the program writes as Markdown.
LISTS = ["nodes", "metrics", "planners", "models", "robots", "commands", "problems", "scenarios"]

# Pages of the repository that are chapters of the manual, with their names there.
REPOSITORY_PAGES = {
    "sim2d/scenario/LIMITS.md": "limits",
    "sim2d/nav/nav2/NAV2.md": "nav2",
    "app/bridge/ROS2.md": "ros2",
    "sim2d/nav/external/PROTOCOL.md": "planner-protocol",
    "maps/planners/README.md": "planner-study",
}

# Pages of the repository that another page of the manual contains.
CONTAINED = {
    "sim2d/scenario/FORMAT.md": "file-formats.md",
    "metrics/METRICS.md": "metrics.md",
    "sim2d/nav/PLANNERS.md": "planners.md",
    "sim2d/world/MODELS.md": "models.md",
}

PICTURES = ["window-light.png", "window-dark.png", "overlays-light.png", "nav2-light.png", "report.png",
            "leaderboard.png"]

# Pictures of a run: arguments of `render`.
RUN_PICTURES = {
    "first.png": [],
    "zones.png": ["--overlay", "zones", "--at", "5"],
    "gaussian.png": ["--overlay", "gaussian", "--at", "5"],
    "plot.svg": ["--plot", "avg_distance_to_closest_person"],
}


def write(path, text):
    """Writes a file unless it has this text already, so that Sphinx reads only what has changed."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")


def linked(text, page, up=""):
    """Links of a repository page: to the manual where the target is in it, else plain text. `up` leads to
    the folder of the manual."""

    def replace(match):
        label, target = match.group(1), match.group(2)
        if re.match(r"https?://|#", target):
            return match.group(0)
        file, _, anchor = target.partition("#")
        place = os.path.normpath(os.path.join(os.path.dirname(page), file))
        if place in CONTAINED:
            return f"[{label}]({up}{CONTAINED[place]}" + (f"#{anchor})" if anchor else ")")
        if place in REPOSITORY_PAGES:
            return f"[{label}]({up}reference/{REPOSITORY_PAGES[place]}.md)"
        return label

    return re.sub(r"(?<!!)\[([^\]]+)\]\(([^)\s]+)\)", replace, text)


def without_title(text):
    """The text below the first heading, and without notes about how it is written."""
    text = re.sub(r"\A# [^\n]*\n", "", text)
    text = re.sub(r"\nTables and lists are generated: [^\n]*\n", "\n", text)
    text = re.sub(r"\nWritten by `[^`]*`; do not edit by hand\. ?", "\n", text)
    return re.sub(r"<!--.*?-->\n?", "", text, flags=re.S)


def advice(folder):
    lines = (folder / "advice.txt").read_text(encoding="utf-8").splitlines()
    return dict(line.split(": ", 1) for line in lines if line and not line.startswith("#"))


def with_advice(text, known):
    """What to do below the heading of each area of problems, or after a message (tests/texts: all have it)."""
    text = re.sub(r"^## (\S+)\n", lambda m: f"{m.group(0)}\n{known.get(m.group(1), '')}\n", text, flags=re.M)
    return re.sub(r"^(\| `([^`]+)` \| .*?)( \|)$",
                  lambda m: m.group(1) + (f" **{known[m.group(2)]}**" if m.group(2) in known else "")
                  + m.group(3), text, flags=re.M)


def lists(program, root):
    """The texts of the reference pages by their names."""
    here, texts = root / "resources/manual", {}
    for name in LISTS:
        text = subprocess.run([program, "list", name, "--format", "markdown"], check=True,
                              capture_output=True, text=True).stdout
        text = without_title(linked(text, {"metrics": "metrics/METRICS.md"}.get(name, "README.md")))
        if name == "problems":
            text = with_advice(text, advice(here))
        texts[name] = text
    page = "sim2d/scenario/FORMAT.md"
    texts["format"] = without_title(linked((root / page).read_text(encoding="utf-8"), page))
    return texts


def stage_pages(root, output, texts):
    here = root / "resources/manual"
    for page in sorted(here.glob("*.md")):
        text = re.sub(r"^```\{include\} generated/(\w+)\.md\n```\n", lambda m: texts[m.group(1)],
                      page.read_text(encoding="utf-8"), flags=re.M)
        write(output / page.name, text)
    write(output / "conf.py", (here / "conf.py").read_text(encoding="utf-8"))
    for page, name in REPOSITORY_PAGES.items():
        text = (root / page).read_text(encoding="utf-8")
        write(output / "reference" / f"{name}.md", "---\norphan: true\n---\n" + linked(text, page, "../"))


def stage_pictures(program, root, output):
    folder = output / "pictures"
    folder.mkdir(parents=True, exist_ok=True)
    for name in PICTURES:
        shutil.copy2(root / "resources/pictures" / name, folder / name)
    stamp = folder / "program.json"
    facts = json.dumps({"size": os.path.getsize(program), "time": os.path.getmtime(program)})
    if stamp.exists() and stamp.read_text() == facts:
        return
    run = folder / "run"
    shutil.rmtree(run, ignore_errors=True)
    subprocess.run([program, "run", "reaction_regular_agents", "--quiet", "-o", run], check=True)
    for name, options in RUN_PICTURES.items():
        (folder / name).unlink(missing_ok=True)
        subprocess.run([program, "render", run, "-o", folder / name, "--force", *options], check=True,
                       stdout=subprocess.DEVNULL)
    shutil.rmtree(run)
    stamp.write_text(facts)


def main():
    program, root, output = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    stage_pages(root, output, lists(program, root))
    stage_pictures(program, root, output)


if __name__ == "__main__":
    main()
