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

NodeStatus start(LeafContext& leaf, Person target, Person human, double distance, double duration) {
  const std::int64_t lastHeard = leaf.memory<Memory>().lastHeard;
  return begin(leaf, Memory{leaf.step(), lastHeard, human, target, distance, duration});
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

void say(LeafContext& leaf, Person human, std::string_view message) {
  HumanContext& context = humanOf(leaf);
  context.speech().say(leaf.step(), human, std::string(message));
  context.emit(sim2d::EventKind::Say, human, std::string(message));
}

constexpr const char* kNodes = R"(
Action SaySomething|Speech|Says a sentence, once.
agent_id
message text needed suggest Hello, I am here!|The words.
Condition IsAnyoneSpeaking|Speech|Listens until somebody near is heard; walls stop voices. The last speaker counts.
agent_id time_step
distance_threshold length default 5.0|Voices are heard up to here.
duration duration default 5.0|Listens so long before it fails.
speaker_id int output suggest {speaker_id}|Takes the id of the speaker.
Condition IsSpeaking|Speech|Listens until a certain person is heard; walls stop voices.
agent_id time_step distance_threshold
duration duration default 10.0|Listens so long before it fails.
target_id int needed suggest 2|Id of the person to listen to.
)";

}  // namespace

void addSpeech(NodeLibrary& to) {
  const NodeCatalogue nodes = humanManifests(kNodes);
  to.addAction(*nodes.find("SaySomething"), withPorts<say, 0, 1>);
  to.addStateful<Memory>(*nodes.find("IsAnyoneSpeaking"),
                         {withPorts<start, kAnybody, 0, 2, 3>, run});
  to.addStateful<Memory>(*nodes.find("IsSpeaking"), {withPorts<start, 4, 0, 2, 3>, run});
}

}  // namespace bt
