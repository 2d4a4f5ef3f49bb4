#include "sim2d/scenario/Expectation.h"

#include <algorithm>
#include <map>
#include <optional>

#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"

namespace sim2d {
namespace {

using What = Expectation::What;

constexpr double kLeastStop = 0.5;  // [s], duration of "stands" without a number

/// Words of a sentence; a text in quotation marks is one word that begins with '"'.
std::vector<std::string> wordsOf(const std::string& text) {
  std::vector<std::string> words;
  std::string word;
  bool isQuoted = false;
  const auto finish = [&] {
    if (!word.empty()) {
      words.push_back(word);
    }
    word.clear();
  };
  for (const char c : text) {
    if (c == '"') {
      if (!isQuoted) {
        finish();
        word = "\"";
      } else {
        finish();
      }
      isQuoted = !isQuoted;
    } else if (c == ' ' && !isQuoted) {
      finish();
    } else {
      word += c;
    }
  }
  finish();
  return words;
}

/// Reads words from left to right; after a failure nothing more matches.
class Words {
 public:
  explicit Words(const std::string& text) : words_(wordsOf(text)) {}

  /// Consumes these words if they come next.
  bool take(const std::vector<std::string>& expected) {
    const bool isNext =
        words_.size() - at_ >= expected.size() &&
        std::equal(expected.begin(), expected.end(), words_.begin() + static_cast<long>(at_));
    at_ += isNext ? expected.size() : 0;
    return isNext;
  }
  bool isAtEnd() const { return at_ == words_.size(); }
  /// Any word.
  std::optional<std::string> word() {
    return isAtEnd() ? std::nullopt : std::optional(words_[at_++]);
  }
  /// A number of at least 0.
  std::optional<double> number() {
    const auto value = isAtEnd() ? std::nullopt : base::parseDouble(words_[at_]);
    if (!value || *value < 0.0 || *value > 1e6) {
      return std::nullopt;
    }
    ++at_;
    return value;
  }
  std::optional<int> wholeNumber() {
    const auto value = isAtEnd() ? std::nullopt : base::parseInt(words_[at_]);
    if (!value || *value < 1 || *value > 1'000'000) {
      return std::nullopt;
    }
    ++at_;
    return static_cast<int>(*value);
  }

 private:
  std::vector<std::string> words_;
  std::size_t at_ = 0;
};

/// A name with spaces is quoted.
std::string unquoted(const std::string& word) {
  return !word.empty() && word.front() == '"' ? word.substr(1) : word;
}

bool isTimeWord(const std::string& word) {
  return word == "before" || word == "after" || word == "from" || word == "for";
}

/// A name, or `goal N`; "the" is skipped.
bool readObject(Words& words, Expectation& to) {
  words.take({"the"});
  if (words.take({"goal"})) {
    const auto number = words.wholeNumber();
    to.goal = number.value_or(0);
    return number.has_value();
  }
  const auto name = words.word();
  to.object = unquoted(name.value_or(""));
  return name && !isTimeWord(*name);
}

bool readGoal(Words& words, Expectation& to) {
  return words.take({"goal"}) && (to.goal = words.wholeNumber().value_or(0)) > 0;
}

/// `says` alone, or with a text.
bool readSpeech(Words& words, Expectation& to) {
  Words ahead = words;
  const auto next = ahead.word();
  if (next && next->front() == '"') {
    to.object = next->substr(1);
    words = ahead;
  }
  return true;
}

bool readStop(Words& words, Expectation& to) {
  if (words.take({"at"}) && !readObject(words, to)) {
    return false;
  }
  to.amount = kLeastStop;
  if (!words.take({"for"})) {
    return true;
  }
  const auto duration = words.number();
  to.amount = duration.value_or(0.0);
  return duration && words.take({"s"});
}

bool readDistance(Words& words, Expectation& to) {
  const auto distance = words.number();
  to.amount = distance.value_or(0.0);
  return distance && words.take({"m", "of"}) && readObject(words, to);
}

bool readTouch(Words& words, Expectation& to) {
  return words.take({"anyone"}) || readObject(words, to);
}

bool readNothing(Words& /*words*/, Expectation& /*to*/) {
  return true;
}

struct Form {
  std::vector<std::string> verb;
  What what;
  bool (*read)(Words&, Expectation&);
  const char* usage;  // null: another spelling of the form before
};

const std::vector<Form>& forms() {
  static const std::vector<Form> kForms = {
      {{"reaches"}, What::ReachesGoal, readGoal, "reaches goal N"},
      {{"reach"}, What::ReachesGoal, readGoal, nullptr},
      {{"arrives"}, What::Arrives, readNothing, "arrives"},
      {{"arrive"}, What::Arrives, readNothing, nullptr},
      {{"enters"}, What::Enters, readObject, "enters AREA"},
      {{"enter"}, What::Enters, readObject, nullptr},
      {{"leaves"}, What::Leaves, readNothing, "leaves"},
      {{"leave"}, What::Leaves, readNothing, nullptr},
      {{"says"}, What::Says, readSpeech, "says \"TEXT\""},
      {{"say"}, What::Says, readSpeech, nullptr},
      {{"hears"}, What::Hears, readObject, "hears NAME"},
      {{"hear"}, What::Hears, readObject, nullptr},
      {{"starts"}, What::Starts, readObject, "starts NODE"},
      {{"start"}, What::Starts, readObject, nullptr},
      {{"ends"}, What::Ends, readObject, "ends NODE"},
      {{"end"}, What::Ends, readObject, nullptr},
      {{"stands"}, What::Stands, readStop, "stands [at PLACE] [for S s]"},
      {{"stand"}, What::Stands, readStop, nullptr},
      {{"waits"}, What::Stands, readStop, nullptr},
      {{"yields"}, What::Stands, readStop, nullptr},
      {{"comes", "within"}, What::Nears, readDistance, "comes within D m of PLACE"},
      {{"come", "within"}, What::Nears, readDistance, nullptr},
      {{"touches"}, What::Touches, readTouch, "touches NAME"},
      {{"touch"}, What::Touches, readTouch, nullptr}};
  return kForms;
}

bool readSubject(Words& words, Expectation& to) {
  if (const auto people = words.wholeNumber()) {
    to.people = *people;
    return words.take({"people"}) || words.take({"person"});
  }
  to.subject = unquoted(words.word().value_or(""));
  return !to.subject.empty();
}

bool readPredicate(Words& words, Expectation& to) {
  for (const Form& form : forms()) {
    if (words.take(form.verb)) {
      to.what = form.what;
      return form.read(words, to);
    }
  }
  return false;
}

bool readTime(Words& words, Expectation& to) {
  std::optional<double> time;
  if (words.take({"before"})) {
    time = words.number();
    to.until = time.value_or(0.0);
  } else if (words.take({"after"})) {
    time = words.number();
    to.from = time.value_or(0.0);
  } else if (words.take({"from"})) {
    const auto begin = words.number();
    time = begin && words.take({"to"}) ? words.number() : std::nullopt;
    to.from = begin.value_or(0.0);
    to.until = time.value_or(0.0);
  } else {
    return words.isAtEnd();
  }
  return time && words.take({"s"}) && words.isAtEnd() && to.from < to.until;
}

template <class T>
bool hasName(const std::vector<T>& all, const std::string& name) {
  return base::findBy(all, &T::name, name) != nullptr;
}

bool isPerson(const std::string& name, const Scenario& scenario) {
  const std::size_t end = name.rfind('_');
  const Area* const source = end == std::string::npos
                                 ? nullptr
                                 : base::findBy(scenario.areas, &Area::name, name.substr(0, end));
  const bool isCopy = source != nullptr && source->kind == AreaKind::Source &&
                      base::parseInt(name.substr(end + 1)).has_value();
  return isCopy || hasName(scenario.humans, name);
}

bool isObject(const Expectation& expectation, const Scenario& scenario) {
  const std::string& name = expectation.object;
  const bool isPlace = hasName(scenario.areas, name) || hasName(scenario.doors, name);
  switch (expectation.what) {
    case What::Enters:
      return hasName(scenario.areas, name);
    case What::Hears:
    case What::Touches:
      return isPerson(name, scenario);
    case What::Stands:
      return isPlace;
    case What::Nears:
      return isPlace || isPerson(name, scenario);
    default:
      return true;  // a text, or the name of a node
  }
}

}  // namespace

base::Result<Expectation> parseExpectation(const std::string& text) {
  Words words(text);
  Expectation expectation;
  expectation.text = text;
  if (!readSubject(words, expectation)) {
    return base::error("card.expectation-form", {text, expectationForms()});
  }
  expectation.isDenied = words.take({"never"});
  if (!readPredicate(words, expectation) || !readTime(words, expectation)) {
    return base::error("card.expectation-form", {text, expectationForms()});
  }
  return expectation;
}

std::string expectationForms() {
  std::vector<std::string> usages;
  for (const Form& form : forms()) {
    if (form.usage != nullptr) {
      usages.emplace_back(form.usage);
    }
  }
  return base::join(usages, ", ");
}

std::vector<std::string> unknownNames(const Expectation& expectation, const Scenario& scenario) {
  std::vector<std::string> unknown;
  if (expectation.people == 0 && !isPerson(expectation.subject, scenario)) {
    unknown.push_back(expectation.subject);
  }
  if (expectation.goal > 0 && scenario.goal(expectation.goal) == nullptr) {
    unknown.push_back("goal " + std::to_string(expectation.goal));
  }
  if (!expectation.object.empty() && !isObject(expectation, scenario)) {
    unknown.push_back(expectation.object);
  }
  return unknown;
}

}  // namespace sim2d
