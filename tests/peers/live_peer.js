// Watches a run as Foxglove does, with Foxglove's own client and reader of messages, and with none
// of our code: subscribes to all, decodes each message by the schema it was given, pauses, steps,
// gets and sets parameters, lets the run go to its end. Prints one JSON object.
//
//   node live_peer.js FOLDER URL PROTOCOL [native]
//
// FOLDER has node_modules with @foxglove/ws-protocol, @foxglove/rosmsg,
// @foxglove/rosmsg2-serialization and ws; native: Node's own WebSocket instead of ws.
"use strict";
const path = require("path");
const [folder, url, protocol, how] = process.argv.slice(2);
const load = require("module").createRequire(path.join(folder, "index.js"));
const { FoxgloveClient } = load("@foxglove/ws-protocol");
const { MessageReader, MessageWriter } = load("@foxglove/rosmsg2-serialization");
const { parse } = load("@foxglove/rosmsg");
const WebSocket = how === "native" ? globalThis.WebSocket : load("ws").WebSocket;

const report = { counts: {}, problems: [], statuses: [], updates: [], clocks: [], times: 0 };
const socket = new WebSocket(url, [protocol]);
const client = new FoxgloveClient({ ws: socket });
const readers = new Map();  // by subscription
const calls = new Map();    // by number of the call
const waiting = new Map();  // by id of the request
let services = new Map();   // by name
let lastCall = 0;

function finish(problem) {
  if (problem) {
    report.problems.push(String(problem));
  }
  console.log(JSON.stringify(report, (key, value) =>
    typeof value === "bigint" ? Number(value) : ArrayBuffer.isView(value) ? Array.from(value) : value));
  process.exit(0);
}
setTimeout(() => finish("time is up"), 40000).unref();

function definitions(schema) {
  return parse(schema, { ros2: true });
}

function call(name, request) {
  const service = services.get(name);
  const data = new MessageWriter(definitions(service.request.schema)).writeMessage(request);
  const callId = ++lastCall;
  client.sendServiceCallRequest({ serviceId: service.id, callId, encoding: "cdr", data });
  return new Promise((resolve) => calls.set(callId, { service, resolve }));
}

function parameters(ask, id) {
  ask(id);
  return new Promise((resolve) => waiting.set(id, resolve));
}

function clockAfter(count) {
  return new Promise((resolve) => {
    const look = () => (report.clocks.length > count ? resolve() : setTimeout(look, 5));
    look();
  });
}

async function play() {
  await clockAfter(0);
  report.paused = await call("/hunavsim/pause", { data: true });
  for (let seen = 0; seen !== report.clocks.length; ) {  // what was under way
    seen = report.clocks.length;
    await new Promise((resolve) => setTimeout(resolve, 300));
  }
  const before = report.clocks.length;
  for (let i = 0; i < 3; ++i) {
    report.stepped = await call("/hunavsim/step", {});
    await clockAfter(before + i);
  }
  report.stepClocks = report.clocks.slice(before - 1);
  client.subscribeParameterUpdates(["/hunavsim.paused"]);
  report.all = await parameters((id) => client.getParameters([], id), "all");
  const faster = [{ name: "/hunavsim.real_time_factor", value: 100 }];
  report.set = await parameters((id) => client.setParameters(faster, id), "set");
  client.setParameters([{ name: "/hunavsim.seed", value: 2 }], "no");
  report.goesOn = await call("/hunavsim/pause", { data: false });
}

client.on("error", (error) => finish(error));
client.on("serverInfo", (info) => (report.info = info));
client.on("status", (status) => report.statuses.push(status.message));
client.on("time", () => ++report.times);
client.on("advertise", (channels) => {
  for (const channel of channels) {
    report.counts[channel.topic] = 0;
    const reader = new MessageReader(definitions(channel.schema));
    readers.set(client.subscribe(channel.id), { channel, reader });
  }
});
client.on("advertiseServices", (all) => {
  services = new Map(all.map((service) => [service.name, service]));
  play().catch(finish);
});
client.on("message", ({ subscriptionId, timestamp, data }) => {
  const { channel, reader } = readers.get(subscriptionId);
  try {
    const message = reader.readMessage(data);
    ++report.counts[channel.topic];
    if (channel.topic === "/clock") {
      report.clocks.push(message.clock.sec * 1e9 + message.clock.nanosec);
      if (Number(timestamp) !== report.clocks[report.clocks.length - 1]) {
        report.problems.push("the log time is not the clock");
      }
    } else if (channel.topic === "/human_states") {
      report.people = message.agents.map(({ id, position, yaw }) => ({ id, yaw, ...position.position }));
    } else if (channel.topic === "/map") {
      const { resolution, width, height } = message.info;
      report.map = { resolution, width, height, cells: message.data.length };
    } else if (channel.topic.startsWith("/hunavsim/metrics/")) {
      report.metrics = { ...report.metrics, [channel.topic.slice(18)]: message.data };
    }
  } catch (error) {
    report.problems.push(`${channel.topic}: ${error}`);
  }
});
client.on("serviceCallResponse", ({ callId, data }) => {
  const { service, resolve } = calls.get(callId);
  resolve(new MessageReader(definitions(service.response.schema)).readMessage(data));
});
client.on("parameterValues", ({ parameters: values, id }) => {
  if (waiting.has(id)) {
    waiting.get(id)(values);
  } else if (id === undefined) {
    report.updates.push(...values);
  }
});
client.on("close", (event) => {
  report.code = event.code;
  report.reason = String(event.reason);
  finish();
});
