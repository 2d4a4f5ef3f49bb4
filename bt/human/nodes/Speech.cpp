#include "bt/human/HumanContext.h"
#include "bt/human/Perception.h"
#include "bt/human/Ports.h"

namespace bt {

namespace {

constexpr double kHold = 1.0;  // words said so long before the listener begins still count [s]

struct Memory {
  std::int64_t startStep;
  std::int64_t lastHeard;  // serial number; kept over rounds: nothing is accepted twice
  int human;
  int target;       // -1 = anyone
  double distance;  // [m]
  double duration;  // [s]
};

/// Ports: 0 agent, 1 time step, 2 distance, 3 duration, 4 the other person.
NodeStatus begin(LeafContext& leaf, std::optional<int> target) {
  const std::optional<int> human = humanOf(leaf).person(leaf, 0);
  const double distance = leaf.require<double>(2);
  const double duration = leaf.require<double>(3);
  if (!human || !target) {
    return NodeStatus::Failure;
  }
  Memory& memory = leaf.memory<Memory>();
  memory = {leaf.step(), memory.lastHeard, *human, *target, distance, duration};
  return NodeStatus::Running;
}

NodeStatus startAnyone(LeafContext& leaf) {
  return begin(leaf, -1);
}
NodeStatus startOne(LeafContext& leaf) {
  return begin(leaf, humanOf(leaf).person(leaf, 4));
}

bool isNews(const LeafContext& leaf, const Memory& memory, const Utterance& words) {
  const double age = static_cast<double>(memory.startStep - words.step) * leaf.dt();
  return words.serial > memory.lastHeard && age <= kHold + kTimeTolerance;
}

bool isHeard(const sim2d::WorldView& view, const Memory& memory, const Utterance& words) {
  const bool isWanted =
      memory.target >= 0 ? words.speaker == memory.target : words.speaker != memory.human;
  return isWanted && view.isPresent(words.speaker) &&
         isAudible(view, memory.human, words.speaker, memory.distance);
}

const Utterance* listen(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const Memory& memory = leaf.memory<Memory>();
  const std::vector<Utterance>& said = context.speech().lastWords();
  if (context.isOriginal(19)) {  // the last words of all, however old
    return !said.empty() && isHeard(context.view(), memory, said.front()) ? &said.front() : nullptr;
  }
  for (const Utterance& words : said) {
    if (isNews(leaf, memory, words) && isHeard(context.view(), memory, words)) {
      return &words;
    }
  }
  return nullptr;
}

NodeStatus run(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  Memory& memory = leaf.memory<Memory>();
  const Utterance* words = listen(leaf);
  if (!words) {
    return untilDuration(leaf, memory.startStep, memory.duration);
  }
  memory.lastHeard = words->serial;
  context.emit(sim2d::EventKind::Heard, memory.human, words->text, words->speaker);
  if (memory.target < 0) {
    leaf.set(4, context.idOf(words->speaker));
  }
  return NodeStatus::Success;
}

NodeStatus say(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  const std::string message(leaf.require<std::string_view>(1));
  if (!human) {
    return NodeStatus::Failure;
  }
  context.speech().say(leaf.step(), *human, message);
  context.emit(sim2d::EventKind::Say, *human, message);
  return NodeStatus::Success;
}

NodeManifest listener(const char* id, const char* description, const char* duration,
                      const PortSpec& other) {
  return humanNode(
      id, "Speech", description,
      {port::agent(), port::timeStep(),
       port::length("distance_threshold", "Voices are heard up to here.").byDefault("5.0"),
       port::duration("duration", "Listens so long before it fails.").byDefault(duration), other},
      NodeKind::Condition);
}

}  // namespace

void addSpeech(NodeLibrary& to) {
  to.addAction(humanNode("SaySomething", "Speech", "Says a sentence, once.",
                         {port::agent(), PortSpec("message", PortType::String, "", "The words.")
                                             .needed()
                                             .suggest("Hello, I am here!")}),
               say);
  to.addStateful<Memory>(
      listener("IsAnyoneSpeaking",
               "Listens until somebody near is heard; walls stop voices. The last speaker counts.",
               "5.0",
               PortSpec("speaker_id", PortType::Int, "", "Takes the id of the speaker.")
                   .directed(PortDirection::Output)
                   .suggest("{speaker_id}")),
      {startAnyone, run, nullptr});
  to.addStateful<Memory>(
      listener("IsSpeaking", "Listens until a certain person is heard; walls stop voices.", "10.0",
               port::person("target_id", "Id of the person to listen to.", "2")),
      {startOne, run, nullptr});
}

}  // namespace bt
