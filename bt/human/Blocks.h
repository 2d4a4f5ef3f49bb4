#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bt/tree/TreeSpec.h"

/// Ready-made pieces of behaviour: what a person does beside walking from goal to goal. The ten
/// blocks of HuNavSim's behaviour wizard, made of nodes and ports that its manager knows, so that
/// trees with blocks load there too.
namespace bt {

struct BlockParameter {
  enum class Kind { Number, Choice, Text, Person, People, Goal };
  std::string key, label;
  Kind kind = Kind::Number;
  std::string initial;               // text of the value that a new block has
  std::string unit;                  // of numbers: "m", "s", "m/s"
  double min = 0.0, max = 0.0;       // of numbers, both ends included
  std::vector<std::string> choices;  // values of Kind::Choice
  std::string mode;                  // has a meaning in this mode only; empty = always
};

struct BlockKind {
  std::string id;           // "EngageRobot"; the Sequence is called "EngageRobotBlock"
  std::string title;        // "Robot interaction"
  std::string description;  // one sentence
  std::vector<BlockParameter> parameters;
  /// By mode ("" when there is none), see BlockPatterns.cpp.
  std::map<std::string, std::vector<std::string>> nodes;

  const BlockParameter* parameter(const std::string& key) const;
  /// The children of the Sequence, with "$key" where the value of a parameter goes. `people`: ids
  /// for the nodes that stand once per person.
  std::vector<NodeSpec> children(const std::string& mode,
                                 const std::vector<std::string>& people) const;
};
const std::vector<BlockKind>& blockKinds();
const BlockKind* blockKind(const std::string& id);

enum class BlockRepeat {
  Always,  // whenever its conditions hold
  Once,    // its actions run through one time; the conditions may fail before as often as they like
  Random   // with a chance, drawn whenever the block could begin
};

struct Block {
  std::string id;
  std::map<std::string, std::string> values;  // by key; absent = initial; ids of people as numbers
  BlockRepeat repeat = BlockRepeat::Always;
  double probability = 0.5;  // of Random

  const std::string& value(const std::string& key) const;
};
bool operator==(const Block& a, const Block& b);

NodeSpec makeBlock(const Block& block);
/// The block that a node is; nothing for other nodes and for blocks whose nodes were changed by
/// hand. Also reads Once as HuNavSim's wizard writes it.
std::optional<Block> readBlock(const NodeSpec& node);

/// The blocks right below the root, in order.
std::vector<Block> blocksOf(const TreeSpec& tree);
/// Other blocks: behind the setting of goals, before reaction and navigation. False when the root
/// is no Fallback; nothing is done then.
bool setBlocks(TreeSpec& tree, const std::vector<Block>& blocks);
/// Other goals in the part that sets them, put in when there is none; false when the root is no
/// Fallback.
bool setGoalsOf(TreeSpec& tree, const std::vector<int>& goals);

}  // namespace bt
