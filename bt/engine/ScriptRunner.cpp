#include <cmath>
#include <utility>

#include "bt/engine/Script.h"
#include "bt/tree/TextValue.h"

namespace bt {
namespace {

using Kind = ScriptExpression::Kind;

constexpr std::size_t kMostText = std::size_t{1} << 20U;  // [B] a script that doubles a text ends

void setNumber(Value& value, double number) {
  value.type = ValueType::Double;
  value.real = number;
  value.text.clear();
}

/// Compares as the original does, which matters for NaN (0 / 0).
template <class T>
bool ordered(ScriptSign sign, const T& left, const T& right) {
  switch (sign) {
    case ScriptSign::Less:
      return !(left >= right);
    case ScriptSign::Greater:
      return !(left <= right);
    case ScriptSign::LessEqual:
      return !(left > right);
    case ScriptSign::GreaterEqual:
      return !(left < right);
    case ScriptSign::NotEqual:
      return left != right;
    default:
      return left == right;
  }
}

bool isOperand(const Value& value) {
  return value.isNumber() || value.type == ValueType::String;
}

std::optional<double> numberOf(const Value& value) {
  if (value.type != ValueType::String) {
    return value.number();
  }
  const bool isWord = value.text == "true" || value.text == "false";
  return isWord ? std::optional<double>(value.text == "true" ? 1.0 : 0.0)
                : doubleFromText(value.text);
}

/// Nothing = text, or a whole number other than 0 and 1.
std::optional<bool> truthOf(const Value& value) {
  return value.isNumber() ? valueAs<bool>(value) : std::nullopt;
}

/// Nothing = text that is not a number compared with a number, or no value.
std::optional<bool> compareValues(ScriptSign sign, const Value& left, const Value& right) {
  if (left.type == ValueType::String && right.type == ValueType::String) {
    return ordered(sign, left.text, right.text);
  }
  if (!isOperand(left) || !isOperand(right)) {
    return std::nullopt;
  }
  const std::optional<double> a = numberOf(left);
  const std::optional<double> b = numberOf(right);
  if (!a || !b) {
    return std::nullopt;
  }
  if (sign == ScriptSign::Equal || sign == ScriptSign::NotEqual) {
    const bool same = std::fabs(*a - *b) <= kScriptTolerance;
    return same == (sign == ScriptSign::Equal);
  }
  return ordered(sign, *a, *b);
}

std::string unfitting(const Slot& slot, const Value& value) {
  const bool isCut = slot.value.isWhole() && value.type == ValueType::Double;
  return "the value '" + value.toText() + "' does not fit the type of the entry" +
         (isCut ? ", which holds a whole number (begin with 1.0 instead of 1)" : "");
}

std::optional<std::int64_t> bitsOf(const Value& value) {
  constexpr double kLargest = 9007199254740992.0;  // 2^53: whole numbers are exact up to it
  const double number = value.number();
  if (!value.isNumber() || !(std::fabs(number) <= kLargest) || number != std::floor(number)) {
    return std::nullopt;
  }
  return static_cast<std::int64_t>(number);
}

}  // namespace

bool ScriptRunner::run() {
  for (const ScriptExpression& statement : script_.statements) {
    if (!evaluate(statement, result_)) {
      return false;
    }
  }
  return true;
}

std::optional<bool> ScriptRunner::truth() const {
  return truthOf(result_);
}

bool ScriptRunner::evaluate(const ScriptExpression& expression, Value& result) {
  switch (expression.kind) {
    case Kind::Constant:
      copyValue(result, expression.constant);
      return true;
    case Kind::Load:
      return load(slots_[expression.slot], result);
    case Kind::Assign:
      return evaluate(expression.parts.front(), result) &&
             assign(slots_[expression.slot], expression.signs.front(), result);
    case Kind::Unary:
      return evaluate(expression.parts.front(), result) && unary(expression.signs.front(), result);
    case Kind::Compare:
      return compare(expression, result);
    case Kind::Choose:
      return choose(expression, result);
    case Kind::Combine:
      return chain(expression, result);
  }
  return false;
}

bool ScriptRunner::chain(const ScriptExpression& expression, Value& result) {
  bool isFine = evaluate(expression.parts.front(), result);
  for (std::size_t i = 0; isFine && i < expression.signs.size(); ++i) {
    Value right;
    isFine =
        evaluate(expression.parts[i + 1], right) && combine(expression.signs[i], result, right);
  }
  return isFine;
}

bool ScriptRunner::load(const Slot& slot, Value& result) {
  copyValue(result, slot.value);
  return slot.exists || fail("a variable of the script has no value");
}

bool ScriptRunner::assign(Slot& slot, ScriptSign sign, Value& value) {
  if (!slot.exists && sign != ScriptSign::Create) {
    return fail("an entry that is assigned does not exist (create it with ':=')");
  }
  if (value.type == ValueType::Unset) {
    return fail("the assigned expression has no value");
  }
  if (sign == ScriptSign::Create || sign == ScriptSign::Assign) {
    const bool isText = value.type == ValueType::String;
    if (!bt::assign(slot, value, isText ? numberOf(value) : std::nullopt)) {
      return fail(unfitting(slot, value));
    }
  } else {
    if (slot.value.type == ValueType::Unset) {
      return fail("an entry that is changed has no value");
    }
    Value changed;
    copyValue(changed, slot.value);
    if (!arithmetic(sign, changed, value)) {
      return false;
    }
    if (!copyInto(slot.value, changed)) {
      return fail(unfitting(slot, changed));
    }
    ++slot.version;
  }
  copyValue(value, slot.value);
  return true;
}

bool ScriptRunner::combine(ScriptSign sign, Value& left, const Value& right) {
  switch (sign) {
    case ScriptSign::Concat:
      return join(left, right);
    case ScriptSign::And:
    case ScriptSign::Or: {
      const std::optional<bool> a = truthOf(left);
      const std::optional<bool> b = truthOf(right);
      if (!a || !b) {
        return fail(
            "'&&' and '||' take neither text nor whole numbers other than 0 and 1 "
            "(compare: 'n != 0')");
      }
      setNumber(left, (sign == ScriptSign::And ? *a && *b : *a || *b) ? 1.0 : 0.0);
      return true;
    }
    case ScriptSign::BitAnd:
    case ScriptSign::BitOr:
    case ScriptSign::BitXor:
      return bits(sign, left, right);
    default:
      return arithmetic(sign, left, right);
  }
}

bool ScriptRunner::join(Value& left, const Value& right) {
  if (!isOperand(left) || !isOperand(right)) {
    return fail("'..' joins something that has no value");
  }
  if (left.isNumber() && right.isNumber()) {
    left = Value();  // as in the original, which reports it where the result is used
    return true;
  }
  if (left.isNumber()) {
    left = Value::of(std::string_view(engineText(left)));
  }
  left.text += engineText(right);
  return left.text.size() <= kMostText || fail("a text of more than 1 MB");
}

bool ScriptRunner::arithmetic(ScriptSign sign, Value& left, const Value& right) {
  if (sign == ScriptSign::Add && left.type == ValueType::String &&
      right.type == ValueType::String) {
    return join(left, right);
  }
  if (!left.isNumber() || !right.isNumber()) {
    return fail("arithmetic with text (join it with '..')");
  }
  const double a = left.number();
  const double b = right.number();
  setNumber(left, sign == ScriptSign::Add        ? a + b
                  : sign == ScriptSign::Subtract ? a - b
                  : sign == ScriptSign::Multiply ? a * b
                                                 : a / b);
  return true;
}

bool ScriptRunner::bits(ScriptSign sign, Value& left, const Value& right) {
  const std::optional<std::int64_t> a = bitsOf(left);
  const std::optional<std::int64_t> b = bitsOf(right);
  if (!a || !b) {
    return fail("bits of something that is no whole number");
  }
  const std::int64_t result = sign == ScriptSign::BitAnd  ? (*a & *b)
                              : sign == ScriptSign::BitOr ? (*a | *b)
                                                          : (*a ^ *b);
  setNumber(left, static_cast<double>(result));
  return true;
}

bool ScriptRunner::unary(ScriptSign sign, Value& value) {
  if (!value.isNumber()) {
    return fail("a sign before text");
  }
  if (sign == ScriptSign::Negate) {
    setNumber(value, -value.number());
  } else if (sign == ScriptSign::Not) {
    setNumber(value, value.number() == 0.0 ? 1.0 : 0.0);
  } else {
    Value whole;
    setNumber(whole, std::trunc(value.number()));
    const std::optional<std::int64_t> number = bitsOf(whole);
    if (!number) {
      return fail("bits of a number that is too large");
    }
    setNumber(value, static_cast<double>(~*number));
  }
  return true;
}

/// What stands behind a comparison that does not hold is not looked at.
bool ScriptRunner::compare(const ScriptExpression& expression, Value& result) {
  if (!evaluate(expression.parts.front(), result)) {
    return false;
  }
  for (std::size_t i = 0; i < expression.signs.size(); ++i) {
    Value next;
    if (!evaluate(expression.parts[i + 1], next)) {
      return false;
    }
    const std::optional<bool> holds = compareValues(expression.signs[i], result, next);
    if (!holds) {
      return fail("text that is no number is compared with a number");
    }
    if (!*holds) {
      setNumber(result, 0.0);
      return true;
    }
    if (i + 1 < expression.signs.size()) {
      result = std::move(next);
    }
  }
  setNumber(result, 1.0);
  return true;
}

bool ScriptRunner::choose(const ScriptExpression& expression, Value& result) {
  if (!evaluate(expression.parts[0], result)) {
    return false;
  }
  const bool isText = result.type == ValueType::String;
  if (isText && result.text.empty()) {
    return fail("an empty text is used as a condition");
  }
  if (!isText && !result.isNumber()) {
    return fail("a condition has no value");
  }
  const bool holds = isText || result.number() != 0.0;  // any text
  return evaluate(expression.parts[holds ? 1 : 2], result);
}

}  // namespace bt
