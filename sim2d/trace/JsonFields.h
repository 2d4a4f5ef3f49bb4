#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim2d/base/Problems.h"
#include "sim2d/base/Result.h"

/// For the sources of this folder only: it shows a third-party type.
namespace sim2d {

using Json = nlohmann::ordered_json;

/// Takes typed members out of objects; every problem is noted with the path of the member.
class JsonFields {
 public:
  JsonFields(std::string file, base::Diagnostics& problems)
      : file_(std::move(file)), problems_(problems) {}

  void error(const std::string& path, std::string_view code, base::ProblemValues values = {}) {
    problems_.push_back(base::within(path, base::error(code, std::move(values), file_)));
  }

  const Json* member(const Json& object, const std::string& path, const char* key) {
    const auto found = object.find(key);
    if (found == object.end()) {
      error(path + key, "trace.missing");
      return nullptr;
    }
    return &*found;
  }

  void read(const Json& object, const std::string& path, const char* key, std::string& value) {
    const Json* json = member(object, path, key);
    if (json != nullptr && !json->is_string()) {
      error(path + key, "trace.no-text");
    } else if (json != nullptr) {
      value = json->get<std::string>();
    }
  }

  void read(const Json& object, const std::string& path, const char* key, bool& value) {
    const Json* json = member(object, path, key);
    if (json != nullptr && !json->is_boolean()) {
      error(path + key, "trace.no-boolean");
    } else if (json != nullptr) {
      value = json->get<bool>();
    }
  }

  void read(const Json& object, const std::string& path, const char* key, double& value) {
    const Json* json = member(object, path, key);
    if (json != nullptr && !finite(*json, value)) {
      error(path + key, "trace.no-number");
    }
  }

  template <class Integer>
  void readInt(const Json& object, const std::string& path, const char* key, Integer& value) {
    const Json* json = member(object, path, key);
    if (json == nullptr) {
      return;
    }
    const bool fits = json->is_number_unsigned()
                          ? json->get<std::uint64_t>() <=
                                static_cast<std::uint64_t>(std::numeric_limits<Integer>::max())
                          : json->is_number_integer() &&
                                json->get<std::int64_t>() >= std::numeric_limits<Integer>::min();
    if (!fits) {
      error(path + key, "trace.no-integer");
    } else {
      value = json->get<Integer>();
    }
  }

  static bool finite(const Json& json, double& value) {
    if (!json.is_number()) {
      return false;
    }
    value = json.get<double>();
    return std::isfinite(value);
  }

  /// Calls `each(element, path)` for the elements of a list.
  template <class Each>
  void forEach(const Json& object, const std::string& path, const char* key, Each each) {
    const Json* json = member(object, path, key);
    if (json == nullptr) {
      return;
    }
    if (!json->is_array()) {
      error(path + key, "trace.no-list");
      return;
    }
    for (std::size_t k = 0; k < json->size(); ++k) {
      each((*json)[k], path + key + "[" + std::to_string(k) + "]");
    }
  }

  /// The same for lists of objects.
  template <class T, class Each>
  void objects(const Json& object, const std::string& path, const char* key, std::vector<T>& to,
               Each each) {
    forEach(object, path, key, [&](const Json& json, const std::string& where) {
      if (!json.is_object()) {
        error(where, "trace.no-object");
        return;
      }
      to.push_back(each(json, where + "."));
    });
  }

  void points(const Json& object, const std::string& path, const char* key, std::vector<Vec2>& to) {
    forEach(object, path, key, [&](const Json& json, const std::string& where) {
      Vec2 point = Vec2::Zero();
      if (json.is_array() && json.size() == 2 && finite(json[0], point.x()) &&
          finite(json[1], point.y())) {
        to.push_back(point);
      } else {
        error(where, "trace.no-point");
      }
    });
  }

 private:
  std::string file_;
  base::Diagnostics& problems_;
};

}  // namespace sim2d
