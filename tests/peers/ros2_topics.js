// node ros2_topics.js PEERS DOMAIN: hears a run as a node of ROS 2 with Foxglove's own RTPS, on the
// loopback, and decodes each message by the standard definition of its type. Prints "ready" when all
// publishers are met, "kept" when each latched topic has said something, "hearing" when each of the
// others has; when its input ends, one JSON object: topic -> {count, last}.
"use strict";
const load = require("module").createRequire(process.argv[2] + "/package.json");
const domain = Number(process.argv[3]);
const { RosNode } = load("@foxglove/ros2");
const { UdpSocketNode } = load("@foxglove/ros2/nodejs");
const { Durability } = load("@foxglove/rtps");
const { parse } = load("@foxglove/rosmsg");
const { ros2humble } = load("@foxglove/rosmsg-msgs-common");

// HuNavSim 2.0 and people_msgs, which the collection does not have.
const rule = "\n" + "=".repeat(80) + "\n";
const agent = `int32 id
uint8 type
uint8 skin
string name
int8 group_id
geometry_msgs/Pose position
float32 yaw
geometry_msgs/Twist velocity
float32 desired_velocity
float32 radius
float32 linear_vel
float32 angular_vel
hunav_msgs/AgentBehavior behavior
geometry_msgs/Pose[] goals
bool cyclic_goals
float32 goal_radius
geometry_msgs/Point[] closest_obs`;
const behavior = `MSG: hunav_msgs/AgentBehavior
uint8 type
uint8 state
uint8 configuration
float32 duration
bool once
float32 vel
float32 dist
float32 social_force_factor
float32 goal_force_factor
float32 obstacle_force_factor
float32 other_force_factor`;
const own = {
  "hunav_msgs/Agent": agent + rule + behavior,
  "hunav_msgs/Agents": "std_msgs/Header header\nhunav_msgs/Agent[] agents" + rule +
    "MSG: hunav_msgs/Agent\n" + agent + rule + behavior,
  "people_msgs/People": "std_msgs/Header header\npeople_msgs/Person[] people" + rule +
    "MSG: people_msgs/Person\nstring name\ngeometry_msgs/Point position\n" +
    "geometry_msgs/Point velocity\nfloat64 reliability\nstring[] tagnames\nstring[] tags",
};

const latched = ["/tf_static", "/map", "/obstacles", "/plan", "/goal_pose"];
const topics = {
  "/clock": "rosgraph_msgs/Clock",
  "/tf": "tf2_msgs/TFMessage",
  "/tf_static": "tf2_msgs/TFMessage",
  "/map": "nav_msgs/OccupancyGrid",
  "/obstacles": "visualization_msgs/MarkerArray",
  "/markers": "visualization_msgs/MarkerArray",
  "/human_states": "hunav_msgs/Agents",
  "/people": "people_msgs/People",
  "/robot_states": "hunav_msgs/Agent",
  "/odom": "nav_msgs/Odometry",
  "/scan": "sensor_msgs/LaserScan",
  "/plan": "nav_msgs/Path",
  "/goal_pose": "geometry_msgs/PoseStamped",
};

// Each definition with those that it needs, itself first.
function withNeeded(name, needed = new Map()) {
  const known = ros2humble[name];
  if (known && !needed.has(name)) {
    needed.set(name, known);
    known.definitions.filter((f) => f.isComplex).forEach((f) => withNeeded(f.type, needed));
  }
  return needed;
}

function definitionOf(type) {
  if (!own[type]) return [...withNeeded(type).values()];
  const parsed = parse(own[type], { ros2: true, skipTypeFixup: true });
  const needed = new Map();
  for (const each of parsed) {
    each.definitions.filter((f) => f.isComplex).forEach((f) => withNeeded(f.type, needed));
  }
  const there = new Set(parsed.map((each) => each.name));
  return [...parsed, ...[...needed].filter(([name]) => !there.has(name)).map(([, each]) => each)];
}

// Of the loopback alone: others are asked at the ports that they take in turn.
const first = 7410 + 250 * domain;
const most = 20;
class Loopback extends UdpSocketNode {
  async bind(options) {
    if (options.port === undefined) return super.bind({ address: "127.0.0.1" });
    for (let k = 0; k < most; ++k) {
      try {
        return await super.bind({ address: "127.0.0.1", port: first + 2 * k, exclusive: true });
      } catch (error) {
        if (error.code !== "EADDRINUSE") throw error;
      }
    }
    throw Error("no port is free");
  }
  async addMembership() {}
  async setMulticastInterface() {}
  async send(data, offset, length, port, address) {
    if (!address.startsWith("239.")) return super.send(data, offset, length, port, address);
    for (let k = 0; k < most; ++k) await super.send(data, offset, length, first + 2 * k, "127.0.0.1");
  }
  static async Create(options) {
    const dgram = require("dgram");
    return new Loopback(dgram.createSocket({ ...options, type: "udp4", reuseAddr: false,
                                             recvBufferSize: 4194304 }));
  }
}

// Its discovery misses others now and then: then it begins anew, as another participant.
const patience = 5000;  // [ms]

async function hear(heard) {
  const node = new RosNode({
    name: "foxglove", domainId: domain, addresses: ["127.0.0.1"], udpSocketCreate: Loopback.Create,
  });
  await node.start();
  const participant = node._participant;
  const subscribe = participant.subscribe.bind(participant);
  participant.subscribe = (options) => subscribe({
    ...options,
    durability: latched.includes(options.topicName.slice(2)) ? Durability.TransientLocal
                                                             : Durability.Volatile,
    history: { ...options.history, depth: 100 },
  });
  const all = Object.entries(topics).map(([topic, type]) => {
    heard[topic] = { count: 0 };
    const subscription = node.subscribe({
      topic, dataType: type.replace("/", "/msg/"), msgDefinition: definitionOf(type),
    });
    subscription.on("message", (time, message) => {
      ++heard[topic].count;
      heard[topic].last = message;
    });
    return subscription;
  });
  for (const begin = Date.now(); Date.now() - begin < patience;) {
    if (all.every((subscription) => subscription.publishers().size > 0)) return true;
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
  await node.shutdown();
  return false;
}

async function main() {
  let heard = {};
  process.stdin.resume();
  process.stdin.on("end", () => {
    const text = JSON.stringify(heard, (key, value) =>
      typeof value === "bigint" ? Number(value) : ArrayBuffer.isView(value) ? Array.from(value) : value);
    process.stdout.write(text + "\n", () => process.exit(0));
  });
  while (!(await hear(heard))) heard = {};
  console.log("ready");
  const sayOnce = (word, wanted) => {
    const look = setInterval(() => {
      if (wanted.every((topic) => heard[topic].count > 0)) {
        clearInterval(look);
        console.log(word);
      }
    }, 20);
  };
  sayOnce("kept", latched);
  sayOnce("hearing", Object.keys(topics).filter((topic) => !latched.includes(topic)));
}
main().catch((problem) => {
  console.log(problem.stack);
  process.exit(1);
});
