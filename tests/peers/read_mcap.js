// node read_mcap.js PEERS FILE: reads an MCAP file with the readers of Foxglove, by its index and as
// a stream, checksums on, and decodes every message by the text that the file holds. Prints JSON:
// {"profile", "topics": {name: {"type", "count", "qos"}}, "begin", "end" (ns as texts),
//  "metadata": {name: [keys]}, "chunks", "way": [[time ns, id, x, y]] of /human_states and
//  /robot_states}.
const fs = require("fs");
const load = require("module").createRequire(process.argv[2] + "/package.json");
const { McapIndexedReader, McapStreamReader } = load("@mcap/core");
const { FileHandleReadable } = load("@mcap/nodejs");
const { parse } = load("@foxglove/rosmsg");
const { MessageReader } = load("@foxglove/rosmsg2-serialization");
const fzstd = load("fzstd");

const decompressHandlers = {
  zstd: (bytes, size) => fzstd.decompress(bytes, new Uint8Array(Number(size))),
};

function decoders() {
  const known = new Map();
  return (schema, data) => {
    if (!known.has(schema.id)) {
      const text = new TextDecoder().decode(schema.data);
      known.set(schema.id, new MessageReader(parse(text, { ros2: true })));
    }
    return known.get(schema.id).readMessage(data);
  };
}

async function byIndex(file, result) {
  const handle = await fs.promises.open(file);
  const reader = await McapIndexedReader.Initialize({
    readable: new FileHandleReadable(handle), decompressHandlers,
  });
  const decode = decoders();
  result.profile = reader.header.profile;
  result.chunks = reader.chunkIndexes.length;
  result.begin = String(reader.statistics.messageStartTime);
  result.end = String(reader.statistics.messageEndTime);
  result.total = Number(reader.statistics.messageCount);
  result.topics = {};
  result.way = [];
  for await (const message of reader.readMessages({ validateCrcs: true })) {
    const channel = reader.channelsById.get(message.channelId);
    const schema = reader.schemasById.get(channel.schemaId);
    const topic = (result.topics[channel.topic] ??= {
      type: schema.name, count: 0, qos: channel.metadata.get("offered_qos_profiles"),
    });
    if (schema.encoding !== "ros2msg" || channel.messageEncoding !== "cdr") throw Error("encoding");
    if (message.sequence !== topic.count) throw Error(`${channel.topic}: sequence`);
    ++topic.count;
    const value = decode(schema, message.data);
    const bodies = channel.topic === "/human_states" ? value.agents
      : channel.topic === "/robot_states" ? [value] : [];
    for (const body of bodies) {
      result.way.push([String(message.logTime), body.id, body.position.position.x,
                       body.position.position.y]);
    }
  }
  result.metadata = {};
  for await (const metadata of reader.readMetadata()) {
    result.metadata[metadata.name] = [...metadata.metadata.keys()];
  }
  let range = 0;  // by time, through the message indexes
  const middle = (reader.statistics.messageStartTime + reader.statistics.messageEndTime) / 2n;
  for await (const message of reader.readMessages({ startTime: middle, topics: ["/tf"] })) {
    if (message.logTime < middle) throw Error("time range");
    ++range;
  }
  result.secondHalfOfTf = range;
  await handle.close();
}

function asStream(file, result) {
  const reader = new McapStreamReader({ validateCrcs: true, decompressHandlers, includeChunks: true });
  reader.append(fs.readFileSync(file));
  let count = 0;
  let indexes = 0;
  for (let record; (record = reader.nextRecord());) {
    count += record.type === "Message" ? 1 : 0;
    indexes += record.type === "MessageIndex" ? 1 : 0;
  }
  if (!reader.done()) throw Error("the stream does not end");
  if (count !== result.total) throw Error(`${count} messages in the stream, ${result.total} told`);
  result.messageIndexes = indexes;
}

(async () => {
  const result = {};
  await byIndex(process.argv[3], result);
  asStream(process.argv[3], result);
  console.log(JSON.stringify(result));
})().catch((problem) => {
  console.log(problem.stack);
  process.exit(1);
});
