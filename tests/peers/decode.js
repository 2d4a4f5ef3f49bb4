// node decode.js PEERS FILE: decodes what tst_Definitions has written with the reader of Foxglove,
// by our text of the type and by the type's own, and writes it again.
// FILE: {"cases": [{"type", "definition", "bytes" (hex), "value"}]}; numbers of values are texts.
const fs = require("fs");
const load = require("module").createRequire(process.argv[2] + "/package.json");
const { parse } = load("@foxglove/rosmsg");
const { MessageReader, MessageWriter } = load("@foxglove/rosmsg2-serialization");
const { ros2humble } = load("@foxglove/rosmsg-msgs-common");

// Foxglove reads stamps as {sec, nsec}.
const nsec = { nanosec: "nsec" };

function differs(read, wanted, path) {
  if (typeof wanted === "string" && typeof read !== "string") {
    return String(read) === wanted || Number(read) === Number(wanted) ? "" : `${path}: ${read}`;
  }
  if (Array.isArray(wanted)) {
    if (read.length !== wanted.length) return `${path}: ${read.length} elements`;
    return wanted.map((each, i) => differs(read[i], each, `${path}[${i}]`)).find((d) => d) || "";
  }
  if (wanted !== null && typeof wanted === "object") {
    for (const [name, each] of Object.entries(wanted)) {
      const value = name in read ? read[name] : read[nsec[name]];
      if (value === undefined) return `${path}.${name}: not there`;
      const difference = differs(value, each, `${path}.${name}`);
      if (difference) return difference;
    }
    return "";
  }
  return read === wanted ? "" : `${path}: ${read}, not ${wanted}`;
}

// All definitions that a type of the collection needs, itself first.
function ownDefinitions(name, known = new Map()) {
  const definition = ros2humble[name];
  if (!definition || known.has(name)) return known;
  known.set(name, definition);
  for (const field of definition.definitions) {
    if (field.isComplex) ownDefinitions(field.type, known);
  }
  return known;
}

// Fields (not constants) as one line each, to compare with.
function fieldLines(definition) {
  const lines = definition.definitions
    .filter((field) => !field.isConstant)
    .map((field) => [field.type, field.name, field.isArray ? `[${field.arrayLength ?? ""}]` : "",
                     field.arrayUpperBound ?? "", field.upperBound ?? ""].join(" "));
  return lines.filter((line) => !line.includes("structure_needs_at_least_one_member")).join("\n");
}
function constantLines(definition) {
  return definition.definitions
    .filter((field) => field.isConstant)
    .map((field) => `${field.type} ${field.name}=${field.value}`)
    .sort().join("\n");
}

let wrong = 0;
let own = 0;
const say = (type, text) => { ++wrong; console.log(`${type}: ${text}`); };
const { cases } = JSON.parse(fs.readFileSync(process.argv[3], "utf8"));
for (const { type, definition, bytes, value } of cases) {
  try {
    const data = Buffer.from(bytes, "hex");
    const definitions = parse(definition, { ros2: true });
    let difference = differs(new MessageReader(definitions).readMessage(data), value, "");
    if (difference) say(type, `by our text ${difference}`);
    const written = new MessageWriter(definitions).writeMessage(new MessageReader(definitions).readMessage(data));
    if (Buffer.compare(Buffer.from(written), data) !== 0) say(type, "written again it differs");
    const short = type.replace(/\/(msg|srv|action)\//, "/");
    const theirs = [...ownDefinitions(short).values()];
    if (theirs.length === 0) continue;
    ++own;
    if (fieldLines(definitions[0]) !== fieldLines(theirs[0])) {
      say(type, `fields\n${fieldLines(definitions[0])}\nnot\n${fieldLines(theirs[0])}`);
    }
    if (constantLines(definitions[0]) !== constantLines(theirs[0])) {
      say(type, `constants\n${constantLines(definitions[0])}\nnot\n${constantLines(theirs[0])}`);
    }
    if (fieldLines(theirs[0]) !== "") {
      difference = differs(new MessageReader(theirs).readMessage(data), value, "");
      if (difference) say(type, `by its own text ${difference}`);
    }
  } catch (problem) {
    say(type, problem.stack);
  }
}
console.log(`${cases.length} types, ${own} of them compared with their own text`);
process.exit(wrong > 0 ? 1 : 0);
