#include "bt/human/Motions.h"

namespace bt {

namespace {

constexpr double kMaxUtteranceAge =
    1.0;  // utterances up to this time before listening starts are heard [s]

struct Memory {
  std::int64_t startStep;
  std::int64_t lastHeard;  // serial number, kept over restarts: accepted once
  int human;
  int target;       // -1: anyone
  double distance;  // [m]
  double duration;  // [s]
};

NodeStatus start(LeafContext& leaf, AgentIndex target, AgentIndex human, double distance,
                 double duration) {
  const std::int64_t lastHeard = leaf.memory<Memory>().lastHeard;
  return begin(leaf, Memory{leaf.step(), lastHeard, human, target, distance, duration});
}

bool isUnheard(const LeafContext& leaf, const Memory& memory, const Utterance& words) {
  const double age = static_cast<double>(memory.startStep - words.step) * leaf.dt();
  return words.serial > memory.lastHeard && age <= kMaxUtteranceAge + kTimeTolerance;
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
  const std::vector<Utterance>& said = context.speech().audibleUtterances();
  if (context.hasQuirk(19)) {  // the last utterance of all, regardless of its age
    return !said.empty() && isHeard(context.view(), memory, said.front()) ? &said.front() : nullptr;
  }
  for (const Utterance& words : said) {
    if (isUnheard(leaf, memory, words) && isHeard(context.view(), memory, words)) {
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
    return failureAfter(leaf, memory.startStep, memory.duration);
  }
  memory.lastHeard = words->serial;
  context.emit(sim2d::EventKind::Heard, memory.human, words->text, words->speaker);
  if (memory.target < 0) {
    leaf.set(4, context.idOf(words->speaker));
  }
  return NodeStatus::Success;
}

void say(LeafContext& leaf, AgentIndex human, std::string_view message) {
  HumanContext& context = humanOf(leaf);
  context.speech().say(leaf.step(), human, std::string(message));
  context.emit(sim2d::EventKind::Say, human, std::string(message));
}

constexpr const char* kNodes = R"(
Action SaySomething|Speech|Says a sentence, once.
agent_id
message text needed suggest Hello, I am here!|Text of the sentence.
Condition IsAnyoneSpeaking|Speech|Waits until a person nearby is heard; walls block speech. The last speaker is selected.
agent_id time_step
distance_threshold length default 5.0|Maximum distance at which speech is heard.
duration duration default 5.0|Maximum wait; then the node fails.
speaker_id int output suggest {speaker_id}|Id of the speaker.
Condition IsSpeaking|Speech|Waits until a certain person is heard; walls block speech.
agent_id time_step distance_threshold
duration duration default 10.0|Maximum wait; then the node fails.
target_id int needed suggest 2|Id of the speaker.
)";

}  // namespace

void addSpeech(NodeLibrary& to) {
  to.add(humanManifests(kNodes),
         {{"SaySomething", synchronous(withPorts<say, 0, 1>)},
          {"IsAnyoneSpeaking", stateful<Memory>({withPorts<start, kAnyAgent, 0, 2, 3>, run})},
          {"IsSpeaking", stateful<Memory>({withPorts<start, 4, 0, 2, 3>, run})}});
}

}  // namespace bt
