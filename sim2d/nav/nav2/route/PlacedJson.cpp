#include "sim2d/nav/nav2/route/PlacedJson.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

#include <nlohmann/json.hpp>

namespace sim2d::nav2 {
namespace {

constexpr std::size_t kMostLevels = 64;

struct Place {
  int line = 1, column = 0;              // of the last character that was read
  int lineBefore = 1, columnBefore = 0;  // of the one before it
};

/// Goes through a text and counts lines and columns.
class PlaceCounter {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  PlaceCounter(const char* at, Place* place) : at_(at), place_(place) {}
  reference operator*() const { return *at_; }
  PlaceCounter& operator++() {
    place_->lineBefore = place_->line;
    place_->columnBefore = place_->column;
    const bool isEnd = *at_ == '\n';
    place_->line += isEnd ? 1 : 0;
    place_->column = isEnd ? 0 : place_->column + 1;
    ++at_;
    return *this;
  }
  bool operator==(const PlaceCounter& other) const { return at_ == other.at_; }
  bool operator!=(const PlaceCounter& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  Place* place_;
};

/// Builds the value as the parser meets its parts.
class Builder : public nlohmann::json_sax<nlohmann::json> {
 public:
  Builder(PlacedJson& root, const Place& place) : root_(root), place_(place) {}

  bool null() override { return put(PlacedJson::Kind::Null) != nullptr; }
  bool boolean(bool value) override {
    put(PlacedJson::Kind::Bool)->isTrue = value;
    return true;
  }
  bool number_integer(number_integer_t value) override {
    return putNumber(static_cast<double>(value));
  }
  bool number_unsigned(number_unsigned_t value) override {
    return putNumber(static_cast<double>(value));
  }
  bool number_float(number_float_t value, const string_t& /*text*/) override {
    return putNumber(value);
  }
  bool string(string_t& value) override {
    put(PlacedJson::Kind::Text)->text = value;
    return true;
  }
  bool binary(binary_t& /*value*/) override { return false; }
  bool start_object(std::size_t /*size*/) override { return open(PlacedJson::Kind::Object); }
  bool start_array(std::size_t /*size*/) override { return open(PlacedJson::Kind::List); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override {
    key_ = name;
    return true;
  }
  bool parse_error(std::size_t /*byte*/, const std::string& /*token*/,
                   const nlohmann::json::exception& /*problem*/) override {
    return false;
  }

 private:
  PlacedJson* put(PlacedJson::Kind kind) {
    PlacedJson* made = &root_;
    if (!open_.empty() && open_.back()->kind == PlacedJson::Kind::List) {
      made = &open_.back()->items.emplace_back();
    } else if (!open_.empty()) {
      made = &open_.back()->members.emplace_back(key_, PlacedJson()).second;
    }
    made->kind = kind;
    made->line = place_.line;
    made->column = std::max(place_.column, 1);
    return made;
  }
  bool putNumber(double value) {
    PlacedJson* const made = put(PlacedJson::Kind::Number);
    made->number = value;
    made->line = place_.lineBefore;  // it ends where another character begins
    made->column = std::max(place_.columnBefore, 1);
    return true;
  }
  bool open(PlacedJson::Kind kind) {
    if (open_.size() >= kMostLevels) {
      return false;
    }
    open_.push_back(put(kind));  // stays where it is until it is closed: nothing is put beside it
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  PlacedJson& root_;
  const Place& place_;
  std::vector<PlacedJson*> open_;
  std::string key_;
};

}  // namespace

const PlacedJson* PlacedJson::find(const std::string& key) const {
  const auto found = std::find_if(members.begin(), members.end(),
                                  [&key](const auto& member) { return member.first == key; });
  return found == members.end() ? nullptr : &found->second;
}

std::optional<PlacedJson> parsePlacedJson(const std::string& text, const std::string& file,
                                          base::Diagnostics& problems) {
  PlacedJson root;
  Place place;
  Builder builder(root, place);
  const char* const end = text.data() + text.size();
  if (!nlohmann::json::sax_parse(PlaceCounter(text.data(), &place), PlaceCounter(end, &place),
                                 &builder)) {
    problems.push_back(
        base::error("route.not-json", {}, file, place.line, std::max(place.column, 1)));
    return std::nullopt;
  }
  return root;
}

}  // namespace sim2d::nav2
