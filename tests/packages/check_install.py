#!/usr/bin/env python3
"""Installs the build into an empty root and checks the result: places of files, metadata, versions, and that
the program runs from there.

check_install.py CMAKE BUILD ROOT VERSION OUTPUT
"""
import gzip
import os
import pathlib
import re
import shutil
import subprocess
import sys

FILES = [
    "bin/hunavsim",
    "share/applications/hunavsim.desktop",
    "share/metainfo/io.github.hunavsim.desktop.metainfo.xml",
    "share/mime/packages/hunavsim.xml",
    "share/icons/hicolor/scalable/apps/hunavsim.svg",
    "share/man/man1/hunavsim.1.gz",
    "share/bash-completion/completions/hunavsim",
    "share/zsh/vendor-completions/_hunavsim",
    "share/fish/vendor_completions.d/hunavsim.fish",
    "share/doc/hunavsim/copyright",
    "share/doc/hunavsim/CHANGELOG.md",
    "share/hunavsim/maps/corner_cafe/corner_cafe_agents.yaml",
    "share/hunavsim/maps/realism/realism_corner_agents.yaml",
    "share/hunavsim/resources/nav2_params/turtlebot3.yaml",
    "share/hunavsim/resources/planners/follow.py",
    "share/hunavsim/resources/policies/crossing_policy.onnx",
    "share/hunavsim/resources/tuning/parameters.yaml",
    "share/hunavsim/resources/planners/hunavsim_planner.h",
]

problems = []


def expect(is_fine, message):
    if not is_fine:
        problems.append(message)


def output_of(*command, **more):
    done = subprocess.run(command, capture_output=True, text=True, check=False, **more)
    expect(done.returncode == 0, f"{command[:3]}: {done.stdout}{done.stderr}")
    return done.stdout


def check_files(usr, build):
    for file in FILES:
        expect((usr / file).is_file(), f"not installed: {file}")
    if (build / "manual/html").is_dir():
        expect((usr / "share/hunavsim/manual/index.html").is_file(), "not installed: manual")
    others = [path.name for path in usr.parent.iterdir() if path.name != "usr"]
    expect(not others, f"installed outside the prefix: {others}")
    module = build / "lib/hunavsim/hunavsim_onnx.so"  # with OpenCV
    python = usr / "lib/python3"  # with HUNAV_PYTHON
    has_libraries = module.is_file() or python.is_dir()
    tops = sorted(path.name for path in usr.iterdir())
    expect(tops == (["bin", "lib", "share"] if has_libraries else ["bin", "share"]), f"installed into {tops}")
    libraries = [str(path.relative_to(usr)) for path in (usr / "lib").rglob("*")
                 if path.is_file() and python not in path.parents]
    expect(libraries == (["lib/hunavsim/hunavsim_onnx.so"] if module.is_file() else []),
           f"installed libraries: {libraries}")
    for path in usr.rglob("*"):
        is_source = path.suffix in (".cmake", ".qrc") or path.name == "CMakeLists.txt"
        expect(not is_source, f"belongs to the sources: {path}")


def check_versions(usr, build, root, version, program):
    expect(f"hunavsim {version} " in output_of(program, "--version"), "version of the program")
    heading = re.search(r"^## (.*)$", (root / "CHANGELOG.md").read_text(encoding="utf-8"), flags=re.M)
    expect(heading.group(1).startswith(f"{version} ("), f"version of the changelog: {heading.group(1)}")
    citation = (root / "CITATION.cff").read_text(encoding="utf-8")
    expect(f"\nversion: {version}\n" in citation, "version of CITATION.cff")
    date = heading.group(1).partition("(")[2].rstrip(")")
    expect(f"\ndate-released: {date}\n" in citation, f"date of CITATION.cff: not {date}")
    expect(f'CPACK_PACKAGE_VERSION "{version}"' in (build / "CPackConfig.cmake").read_text(encoding="utf-8"),
           "version of the package")
    manual = build / "manual/html/_static/documentation_options.js"
    expect(not manual.is_file() or f"VERSION: '{version}'" in manual.read_text(encoding="utf-8"),
           "version of the manual")
    metadata = (usr / FILES[2]).read_text(encoding="utf-8")
    expect(f'<release version="{version}"' in metadata, "version of the metadata")
    with gzip.open(usr / "share/man/man1/hunavsim.1.gz", "rt", encoding="utf-8") as page:
        expect(f"hunavsim {version}" in page.read(), "version of the manual page")


def check_metadata(usr, output):
    if shutil.which("desktop-file-validate"):
        output_of("desktop-file-validate", str(usr / FILES[1]))
    if shutil.which("appstreamcli"):
        output_of("appstreamcli", "validate", "--no-net", str(usr / FILES[2]))
    if shutil.which("update-mime-database"):
        mime = output / "mime"
        (mime / "packages").mkdir(parents=True)
        shutil.copy(usr / FILES[3], mime / "packages")
        output_of("update-mime-database", str(mime))
        known = (mime / "types").read_text(encoding="utf-8")
        for kind in re.search(r"MimeType=(.*);", (usr / FILES[1]).read_text()).group(1).split(";"):
            expect(kind in known, f"unknown type {kind}")


def check_program(usr, output, program):
    names = output_of(program, "list", "scenarios")
    expect(str(usr) in names and "corner_cafe_agents" in names, "scenarios of the installed program")
    output_of(program, "run", "corner_cafe_agents", "--duration", "1", "-q", "-o", str(output / "run"))
    output_of(program, "run", "crossing_agents", "--duration", "1", "-q", "--planner", "nav2",
              "--nav2-params", "turtlebot3")


def main():
    cmake, version = sys.argv[1], sys.argv[4]
    build, root, output = (pathlib.Path(sys.argv[i]) for i in (2, 3, 5))
    shutil.rmtree(output, ignore_errors=True)
    staging, usr = output / "root", output / "root/usr"
    output.mkdir(parents=True)
    output_of(cmake, "--install", str(build), "--prefix", "/usr", "--strip",
              env=dict(os.environ, DESTDIR=str(staging)))
    if not problems:
        program = str(usr / "bin/hunavsim")
        check_files(usr, build)
        check_versions(usr, build, root, version, program)
        check_metadata(usr, output)
        check_program(usr, output, program)
    for problem in problems:
        print(problem, file=sys.stderr)
    shutil.rmtree(staging, ignore_errors=True)
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
