#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bt/tree/TreeSpec.h"

/// Predefined behaviour blocks for actions other than walking from goal to goal. These are the ten
/// blocks of HuNavSim's behaviour wizard, built from nodes and ports that HuNavSim's agent manager
/// supports, so that trees with blocks also load there.
namespace bt {

struct BlockParameter {
  enum class Kind { Number, Choice, Text, Person, People, Goal };
  std::string key, label;
  Kind kind = Kind::Number;
  std::string initial;               // value in a new block, as text
  std::string unit;                  // for numbers: "m", "s", "m/s"
  double min = 0.0, max = 0.0;       // for numbers, inclusive
  std::vector<std::string> choices;  // values of Kind::Choice
  std::string mode;                  // used only in this mode; empty: in all
};

struct BlockType {
  std::string id;           // "EngageRobot"; the Sequence is named "EngageRobotBlock"
  std::string title;        // "Robot interaction"
  std::string description;  // one sentence
  std::vector<BlockParameter> parameters;
  /// Node lines by mode ("" if the block has no modes).
  std::map<std::string, std::vector<std::string>> nodes;

  const BlockParameter* parameter(const std::string& key) const;
  /// The children of the Sequence, with "$key" in place of parameter values. `people`: ids for
  /// nodes that are repeated per person.
  std::vector<NodeSpec> children(const std::string& mode,
                                 const std::vector<std::string>& people) const;
};
const std::vector<BlockType>& blockTypes();
const BlockType* blockType(const std::string& id);

enum class BlockRepeat {
  Always,  // whenever its conditions hold
  Once,    // its actions run once; its conditions may fail any number of times before
  Random   // with a probability, drawn each time the block could start
};

struct Block {
  std::string id;
  std::map<std::string, std::string> values;  // by key; absent: initial value; person ids as digits
  BlockRepeat repeat = BlockRepeat::Always;
  double probability = 0.5;  // for Random

  const std::string& value(const std::string& key) const;
};
bool operator==(const Block& a, const Block& b);

NodeSpec blockToNode(const Block& block);
/// Recognises a node as a block; empty for other nodes and for blocks that were edited manually.
/// Also accepts the form of Once that HuNavSim's wizard writes.
std::optional<Block> readBlock(const NodeSpec& node);

/// The blocks directly below the root, in order.
std::vector<Block> blocksOf(const TreeSpec& tree);
/// Replaces the blocks: they follow the SetGoals part and precede reaction and navigation. Returns
/// false, without changes, if the root is not a Fallback.
bool setBlocks(TreeSpec& tree, const std::vector<Block>& blocks);
/// Replaces the goals in the SetGoals part, which is created if missing. Returns false if the root
/// is not a Fallback.
bool setTreeGoals(TreeSpec& tree, const std::vector<int>& goals);

}  // namespace bt
