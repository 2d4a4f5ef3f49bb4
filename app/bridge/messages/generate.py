#!/usr/bin/env python3
"""Writes C++ structs for ROS 2 message definitions.

generate.py DEFINITIONS OUTPUT

Reads the file DEFINITIONS: definitions in the syntax of ROS 2, each after a line
"=== <package>/{msg,srv,action}/<Name>"; constants are integers. <Name>.<Version> is the type of the same
name in another distribution of ROS 2: it becomes the struct <Version><Name>, in which types of its
package have this version if they exist in it. Writes OUTPUT/app/bridge/messages/<package>.h,
AllMessages.h and Definitions.cpp. Ends with a message that names the definition if one is wrong.
"""
import pathlib
import re
import sys

# ROS name -> C++ type, size [bytes] of numbers that are copied as they are (0: others)
PRIMITIVES = {"bool": ("bool", 0), "byte": ("std::byte", 0), "string": ("std::string", 0),
              "float32": ("float", 4), "float64": ("double", 8)}
for bits in (8, 16, 32, 64):
    for kind in ("int", "uint"):
        PRIMITIVES[f"{kind}{bits}"] = (f"std::{kind}{bits}_t", bits // 8)

ENTRY = re.compile(r"(?P<type>[\w/]+)(<=(?P<bound>\d+))?(\[(?P<limit>(<=)?\d*)\])? (?P<name>\w+)"
                   r"( ?= ?(?P<constant>-?\d+)| (?P<default>.+))?")
HEAD = "// Written by generate.py from definitions.txt.\n"
UUID = "unique_identifier_msgs/UUID goal_id"


class Struct:
    """A message, or a service or action with its messages as `parts`."""

    def __init__(self, package, kind, ros_name, version):
        self.package, self.kind, self.ros_name, self.version = package, kind, ros_name, version
        self.name = version + ros_name  # in C++
        self.scope = f"{package}::{self.name}"
        self.top = self
        self.doc, self.constants, self.fields, self.parts = [], [], [], []

    def add_part(self, name):
        part = Struct(self.package, self.kind, f"{self.ros_name}_{name}", self.version)
        part.name, part.scope, part.top = name, f"{self.scope}::{name}", self.top
        self.parts.append(part)
        return part

    def key(self):
        return f"{self.package}/{self.ros_name}" + (f".{self.version}" if self.version else "")

    def messages(self):
        return [each for part in self.parts for each in part.messages()] or [self]


class Field:
    def __init__(self, entry, comment, struct):
        self.name, self.default, self.comment = entry["name"], entry["default"], comment
        self.struct, self.limit = struct, entry["limit"]
        element, self.size = PRIMITIVES.get(entry["type"], (struct and struct.scope, 0))
        ros_type = f"{struct.package}/{struct.ros_name}" if struct else entry["type"]
        if entry["bound"]:
            element, ros_type = f"BoundedString<{entry['bound']}>", f"{ros_type}<={entry['bound']}"
        self.element = self.cpp_type = element
        self.ros_type = ros_type if self.limit is None else f"{ros_type}[{self.limit}]"
        if self.limit == "":
            self.cpp_type = f"std::vector<{element}>"
        elif self.limit and self.limit.startswith("<="):
            self.cpp_type = f"BoundedSequence<{element}, {self.limit[2:]}>"
        elif self.limit:
            self.cpp_type = f"std::array<{element}, {self.limit}>"

    def initializer(self):
        if self.default:
            return f" = {self.default}"
        if self.limit and not self.limit.startswith("<="):
            return "{}"
        is_number = self.limit is None and not self.struct and "string" not in self.ros_type
        return "" if not is_number else " = false" if self.element == "bool" else " = 0"


class Reader:
    """All structs of the definitions by name: "package/Name" or "package/Name.Version"."""

    def __init__(self, text):
        parts = re.split(r"^=== (.+)\n", text, flags=re.MULTILINE)
        self.definitions = {re.sub("/.*/", "/", head): (head, body)
                            for head, body in zip(parts[1::2], parts[2::2])}
        self.structs = {}
        for name in self.definitions:
            self.find(name)

    def find(self, name):
        """The struct of a type, with all types that it contains read before it. None: no such type."""
        if name not in self.structs and name in self.definitions:
            self.read(*self.definitions[name])
        return self.structs.get(name)

    def read(self, path, text):
        package, kind, stem = path.split("/")
        name, _, version = stem.partition(".")
        top = Struct(package, kind, name, version)
        texts = text.split("---\n")
        if top.kind == "msg":
            self.parse(top, path, texts[0])
        elif top.kind == "srv":
            self.read_parts(top, path, Request=texts[0], Response=texts[1])
        else:
            self.read_parts(top, path, Goal=texts[0], Result=texts[1], Feedback=texts[2],
                            FeedbackMessage=f"{UUID}\n{name}_Feedback feedback")
            self.read_parts(top.add_part("SendGoal"), path, Request=f"{UUID}\n{name}_Goal goal",
                            Response="bool accepted\nbuiltin_interfaces/Time stamp")
            self.read_parts(top.add_part("GetResult"), path, Request=UUID,
                            Response=f"int8 status\n{name}_Result result")
        if top.parts:  # the first comment is about all of it
            first = top.messages()[0]
            top.doc, first.doc = first.doc, []
        self.structs[top.key()] = top

    def read_parts(self, outer, path, **texts):
        for name, text in texts.items():
            part = outer.add_part(name)
            self.parse(part, path, text)
            self.structs[part.key()] = part

    def parse(self, struct, path, text):
        for line in text.splitlines():
            content, _, comment = (word.strip() for word in line.partition("#"))
            entry = ENTRY.fullmatch(content)
            if not content:
                struct.doc.append(comment)
            elif not entry:
                sys.exit(f"{path}: neither field nor constant: {line}")
            elif entry["constant"]:
                struct.constants.append((entry["type"], entry["name"], entry["constant"], comment))
            else:
                inner = self.type_of(struct, entry["type"])
                if not inner and entry["type"] not in PRIMITIVES:
                    sys.exit(f"{path}: unknown type: {line}")
                struct.fields.append(Field(entry, comment, inner))

    def type_of(self, struct, name):
        full = name if "/" in name else f"{struct.package}/{name}"
        return self.find(f"{full}.{struct.version}") or self.find(full)


def camel(words):
    return "".join(word[:1].upper() + word[1:].lower() for word in words.split("_"))


def packed_elements(struct):
    """The number types in memory, one each. None: not all fields are numbers of fixed count."""
    elements = []
    for field in struct.fields:
        inner = packed_elements(field.struct) if field.struct else [field] * (field.size > 0)
        if not inner or (field.limit is not None and not field.limit.isdigit()):
            return None
        elements += inner
    return elements if len({element.size for element in elements}) == 1 else None


def body_of(struct):
    """The members of the struct, without indentation."""
    lines = [f'static constexpr const char* kType = "{struct.package}/{struct.kind}/{struct.ros_name}";']
    for part in struct.parts:
        lines += struct_lines(part)
    if struct.parts:
        return lines
    lines.append("static const char* const kDefinition;")
    if elements := packed_elements(struct):
        lines.append(f"using PackedElement = {elements[0].element};")
    for kind, name, value, comment in struct.constants:
        lines.append(f"static constexpr {PRIMITIVES[kind][0]} k{camel(name)} = {value};"
                     + (f"  // {comment}" if comment else ""))
    visits = []
    for field in struct.fields:
        member = field.name[0] + camel(field.name)[1:]
        lines.append(f"{field.cpp_type} {member}{field.initializer()};"
                     + (f"  // {field.comment}" if field.comment else ""))
        visits.append(f'  field("{field.name}", self.{member});')
    return lines + ["template <class Self, class F>",
                    "static void fields([[maybe_unused]] Self& self, [[maybe_unused]] F&& field) {",
                    *visits, "}"]


def struct_lines(struct):
    return [*(f"/// {line}" for line in struct.doc), f"struct {struct.name} {{",
            *(f"  {line}" for line in body_of(struct)), "};"]


def header(package, structs):
    used = {field.struct.package for struct in structs for message in struct.messages()
            for field in message.fields if field.struct} - {package}
    includes = [f'#include "app/bridge/messages/{name}.h"\n' for name in sorted(used)]
    lines = [line for struct in structs for line in ["", *struct_lines(struct)]]
    return (HEAD + "#pragma once\n\n#include <array>\n#include <cstddef>\n#include <cstdint>\n"
            "#include <string>\n#include <vector>\n\n" + "".join(includes)
            + '#include "app/bridge/messages/FieldTraits.h"\n\n'
            + f"namespace bridge::{package} {{\n" + "\n".join(lines)
            + f"\n\n}}  // namespace bridge::{package}\n")


def definition(struct):
    """The text in MCAP's ros2msg format: the message, then each type that it contains once."""
    order = []

    def add(message):
        if message not in order:
            order.append(message)
            for field in message.fields:
                if field.struct:
                    add(field.struct)

    add(struct)
    texts = []
    for message in order:
        lines = [f"{kind} {name}={value}\n" for kind, name, value, _ in message.constants]
        lines += [f"{field.ros_type} {field.name}\n" for field in message.fields]
        if not message.fields:
            lines.append("uint8 structure_needs_at_least_one_member\n")
        head = f"{80 * '='}\nMSG: {message.package}/{message.ros_name}\n" if texts else ""
        texts.append(head + "".join(lines))
    return "".join(texts)


def main(definitions, output):
    structs = list(Reader(pathlib.Path(definitions).read_text()).structs.values())
    tops = [struct for struct in structs if struct.top is struct]
    folder = pathlib.Path(output) / "app/bridge/messages"
    folder.mkdir(parents=True, exist_ok=True)
    packages = sorted({struct.package for struct in tops})
    for package in packages:
        own = [struct for struct in tops if struct.package == package]
        (folder / f"{package}.h").write_text(header(package, own))
    messages = [message for struct in tops for message in struct.messages()]
    names = ",\n    ".join(message.scope for message in messages if not message.version)
    (folder / "AllMessages.h").write_text(
        HEAD + "#pragma once\n\n"
        + "".join(f'#include "app/bridge/messages/{package}.h"\n' for package in packages)
        + "\nnamespace bridge {\n\ntemplate <class... M>\nstruct TypeList {};\n\n"
        "/// Every message, request and response. Types that differ between distributions under the\n"
        "/// same name are listed in their Humble version.\n"
        f"using AllMessages = TypeList<\n    {names}>;\n\n}}  // namespace bridge\n")
    (folder / "Definitions.cpp").write_text(
        HEAD + '#include "app/bridge/messages/AllMessages.h"\n\nnamespace bridge {\n\n'
        + "".join(f'const char* const {message.scope}::kDefinition =\n    R"({definition(message)})";\n'
                  for message in messages)
        + "\n}  // namespace bridge\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
