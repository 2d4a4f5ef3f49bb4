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
    Number,  // number
    Text,    // texts[index]
    Load,    // slot `index`
    Create,  // := into slot `index`; the others need an entry that exists
    Assign,
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
    Compare,      // chains[index]
    JumpIfFalse,  // to instruction `index`
    Jump,
    Drop
  };
  Code code = Code::Number;
  std::int32_t index = 0;
  double number = 0.0;
};

struct Script {
  enum class Comparison : std::uint8_t { Equal, NotEqual, Less, Greater, LessEqual, GreaterEqual };

  std::string source;
  std::vector<ScriptInstruction> code;
  std::vector<std::string> texts;
  std::vector<std::vector<Comparison>> chains;  // a < b < c: two comparisons
  std::vector<int> written;                     // slots that it assigns
  std::vector<int> read;
  int depth = 1;  // places on the stack
};

/// `slotOf` gives the slot of a blackboard key. The error says what is wrong and at which column.
base::Result<Script> compileScript(std::string_view source,
                                   const std::function<int(const std::string& key)>& slotOf);

}  // namespace bt
