#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bt/engine/Value.h"
#include "sim2d/base/Result.h"

/// The script language of conditions and Script nodes, compiled to expressions. Literal numbers are
/// whole (64 bits) or real, computed numbers are real; there is no short-circuit evaluation: both
/// sides of && and || are evaluated.
namespace bt {

enum class ScriptSign : std::uint8_t {
  Create,  // := makes the entry; the other assignments need one that exists
  Assign,
  Add,  // also of +=, as the next three
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
  GreaterEqual
};

struct ScriptExpression {
  enum class Kind : std::uint8_t {
    Constant,  // constant
    Load,      // the value of `slot`
    Assign,    // its operand to `slot`
    Unary,     // a sign before its operand
    Combine,   // a + b - c: operators between the operands, from the left
    Compare,   // a < b < c: all of the comparisons hold
    Choose     // a ? b : c
  };
  Kind kind = Kind::Constant;
  Value constant = {};
  int slot = -1;
  std::vector<ScriptSign> signs;
  std::vector<ScriptExpression> parts;
};

struct Script {
  std::string source;
  std::vector<ScriptExpression> statements;
  std::vector<int> written;  // slots that it assigns
  int cutAt = 0;             // column after a statement without ';': the rest is not run; 0 = none
};

/// `slotOf` gives the slot of a blackboard key. The error says what is wrong and at which column.
base::Result<Script> compileScript(std::string_view source,
                                   const std::function<int(const std::string& key)>& slotOf);

/// Numbers closer than this are equal, as in the original scripts.
constexpr double kScriptTolerance = 1.1920928955078125e-07;  // epsilon of float

/// Runs a script on the slots of one agent.
class ScriptRunner {
 public:
  ScriptRunner(const Script& script, Slot* slots) : script_(script), slots_(slots) {}

  /// False = it stopped with error().
  bool run();
  /// Value of the last statement, after run().
  const Value& result() const { return result_; }
  /// The result as a condition; nothing = text, or a whole number other than 0 and 1.
  std::optional<bool> truth() const;
  const std::string& error() const { return error_; }

 private:
  bool evaluate(const ScriptExpression& expression, Value& result);
  bool chain(const ScriptExpression& expression, Value& result);
  bool load(const Slot& slot, Value& result);
  bool assign(Slot& slot, ScriptSign sign, Value& value);
  bool combine(ScriptSign sign, Value& left, const Value& right);
  bool join(Value& left, const Value& right);
  bool arithmetic(ScriptSign sign, Value& left, const Value& right);
  bool bits(ScriptSign sign, Value& left, const Value& right);
  bool unary(ScriptSign sign, Value& value);
  bool compare(const ScriptExpression& expression, Value& result);
  bool choose(const ScriptExpression& expression, Value& result);
  bool fail(std::string message) {
    error_ = std::move(message);
    return false;
  }

  const Script& script_;
  Slot* slots_;
  Value result_;
  std::string error_;
};

}  // namespace bt
