// node decode.js PEERS FILE: decodes what tst_Definitions has written with the reader of Foxglove,
// by our text of the type and by the type's own in each distribution, and writes it again. Constants
// are those of Jazzy, which include those of the earlier distributions.
// FILE: {"cases": [{"type", "definition", "bytes" (hex), "value"}]}; numbers of values are texts.
const fs = require("fs");
const load = require("module").createRequire(process.argv[2] + "/package.json");
const { parse } = load("@foxglove/rosmsg");
const { MessageReader, MessageWriter } = load("@foxglove/rosmsg2-serialization");
const collections = load("@foxglove/rosmsg-msgs-common");
const distributions = ["ros2humble", "ros2iron", "ros2jazzy"];

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

// All definitions that a type of a collection needs, itself first.
function ownDefinitions(collection, name, known = new Map()) {
  const definition = collection[name];
  if (!definition || known.has(name)) return known;
  known.set(name, definition);
  for (const field of definition.definitions) {
    if (field.isComplex) ownDefinitions(collection, field.type, known);
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
    .sort();
}

// What of our text is not as a distribution has it; reads the message by that, too.
function differsFrom(distribution, ours, short, data, value) {
  const theirs = [...ownDefinitions(collections[distribution], short).values()];
  if (theirs.length === 0) return null;
  if (fieldLines(ours) !== fieldLines(theirs[0])) {
    return `fields\n${fieldLines(ours)}\nnot\n${fieldLines(theirs[0])}`;
  }
  const [mine, their] = [constantLines(ours), constantLines(theirs[0])];
  const isLast = distribution === distributions[distributions.length - 1];
  if (their.some((line) => !mine.includes(line)) || (isLast && mine.length !== their.length)) {
    return `constants\n${mine.join("\n")}\nnot\n${their.join("\n")}`;
  }
  return fieldLines(theirs[0]) === ""
    ? "" : differs(new MessageReader(theirs).readMessage(data), value, "by its own text ");
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
    const found = distributions.map((each) => [each, differsFrom(each, definitions[0], short, data, value)]);
    own += found.some(([, what]) => what !== null) ? 1 : 0;
    found.filter(([, what]) => what).forEach(([each, what]) => say(type, `${each}: ${what}`));
  } catch (problem) {
    say(type, problem.stack);
  }
}
console.log(`${cases.length} types, ${own} of them compared with their own text`);
process.exit(wrong > 0 ? 1 : 0);
