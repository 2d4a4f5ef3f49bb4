#pragma once

#include <cstdint>
#include <functional>
#include <optional>
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

/// Numbers closer than this are equal, as in the original scripts.
constexpr double kScriptTolerance = 1.1920928955078125e-07;  // epsilon of float

/// Runs a script on the slots of one agent. `stack` has at least Script::depth places.
class ScriptRunner {
 public:
  ScriptRunner(const Script& script, Slot* slots, Value* stack)
      : script_(script), slots_(slots), stack_(stack) {}

  /// False = it stopped with error().
  bool run();
  /// Value of the last statement, after run().
  const Value& result() const { return *stack_; }
  /// The result as a condition; nothing = it is no number.
  std::optional<bool> truth() const;
  const std::string& error() const { return error_; }

 private:
  using Code = ScriptInstruction::Code;

  bool execute(const ScriptInstruction& instruction);
  bool load(int slot);
  bool assign(const ScriptInstruction& instruction);
  bool binary(Code code);
  bool arithmetic(Code code, Value& left, const Value& right);
  bool bits(Code code, Value& left, const Value& right);
  bool unary(Code code);
  bool compare(const std::vector<Script::Comparison>& chain);
  bool jump(const ScriptInstruction& instruction);
  bool fail(std::string message) {
    error_ = std::move(message);
    return false;
  }
  Value& top(std::size_t below = 0) { return stack_[size_ - 1 - below]; }

  const Script& script_;
  Slot* slots_;
  Value* stack_;
  std::size_t size_ = 0;
  std::size_t next_ = 0;
  std::string error_;
};

}  // namespace bt
