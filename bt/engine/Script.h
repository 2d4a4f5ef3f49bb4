#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "bt/engine/Value.h"
#include "sim2d/base/Result.h"

/// The script language of conditions and Script nodes, compiled to instructions for a stack.
/// Numbers are doubles; there is no short-circuit: both sides of && and || are evaluated.
namespace bt {

struct ScriptInstruction {
  enum class Code : std::uint8_t {
    Number,
    Text,
    Load,
    Assign,
    Create,
    AddTo,
    SubtractFrom,
    MultiplyBy,
    DivideBy,
    Add,
    Subtract,
    Multiply,
    Divide,
    Concat,
    And,
    Or,
    BitAnd,
    BitOr,
    BitXor,
    BitNot,
    Not,
    Negate,
    Equal,
    NotEqual,
    Less,
    Greater,
    LessEqual,
    GreaterEqual,
    ChainCompare,
    Select,
    Drop
  };
  Code code = Code::Number;
  std::int32_t index = 0;  // slot or text
  double number = 0.0;
};

struct Script {
  std::string source;
  std::vector<ScriptInstruction> code;
  std::vector<std::string> texts;
  std::vector<std::string> keys;  // by slot operand order, for messages
  int depth = 0;                  // places on the stack
};

/// `slotOf` gives the slot of a blackboard key. The error says what is wrong and at which column.
base::Result<Script> compileScript(std::string_view source,
                                   const std::function<int(const std::string& key)>& slotOf);

}  // namespace bt
